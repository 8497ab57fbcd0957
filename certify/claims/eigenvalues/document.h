#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "certify/base/interval.h"
#include "certify/net/document.h"

/// The contents of an eigenvalues file as plain data, member by member as docs/format.md defines them.
///
/// Eigenvalues are those of the Laplacian −Δ, with multiplicity. Without `phases` they are those of functions, without
/// the eigenvalue 0 of the constants: λ₁ ≤ λ₂ ≤ …. With `phases` they are those of the sections of a flat line bundle,
/// all of them: λ₀ ≤ λ₁ ≤ …. A document only states what a file says; nothing here is proved.
namespace epsnet::certify {

/// An eigenvalues file: where the first eigenvalues are, and what proves it.
struct EigenvaluesDocument {
  /// A permutation of the sides or vertices of the halved triangles.
  using Order = std::vector<std::uint32_t>;
  /// By vertex α₀, α₁, β₁, …, α_M, β_M: its function is the sum of the (α_m cos mθ + β_m sin mθ) tanh(ρ/2)^m F_m, in
  /// polar coordinates.
  using Coefficients = std::vector<double>;

  /// The next `count` eigenvalues are in `in`.
  struct Enclosure {
    Interval in{};
    std::uint32_t count = 1;
    bool operator==(const Enclosure&) const = default;
  };

  /// At most `count` eigenvalues are less than `below`: K − `sigma` N, with a row for each side, has at most so many
  /// negative eigenvalues, or one more without `phases`.
  struct AtMost {
    double below = 0;
    std::uint32_t count = 0;
    double sigma = 0;
    bool operator==(const AtMost&) const = default;
  };

  /// At least `count` eigenvalues are less than `below`: K′ − `below` N′, with a row for each vertex, has at least so
  /// many negative eigenvalues, or one more without `phases`.
  struct AtLeast {
    double below = 0;
    std::uint32_t count = 1;
    bool operator==(const AtLeast&) const = default;
  };

  /// At least as many eigenvalues as `functions` are in `in`: functions around the vertices of the net nearly fit
  /// together to so many eigenfunctions.
  struct Eigenfunctions {
    Interval in{};
    double lambda = 0;  ///< Of the functions; in `in`.
    double radius = 0;  ///< Around each vertex its function counts within this distance, more than ε.
    std::vector<Coefficients> functions;
    bool operator==(const Eigenfunctions&) const = default;
  };

  /// A homomorphism of the surface's group to the integers, and a function h on the plane with h(γz) = h(z) + its value
  /// at γ.
  struct Direction {
    std::vector<std::int64_t> steps;  ///< By side of the surface: of h across it.
    std::vector<double> heights;      ///< By vertex of the net: h there, in the vertex's chart.
    bool operator==(const Direction&) const = default;
  };

  /// Characters near that of `phases`: those with the phases θ_s + Σ t_k steps_k(s), t_k real, |t_k| ≤ radius.
  struct Box {
    std::string radius;  ///< In turns: a decimal > 0, exactly as written.
    std::vector<Direction> directions;
    bool operator==(const Box&) const = default;
  };

  NetDocument net;
  /// By side of the surface: a decimal without exponent or a rational, exactly as written, in turns. A section is
  /// multiplied by e^{2πiθ} across a side of phase θ. Empty: functions.
  std::vector<std::string> phases;
  std::optional<Box> box;              ///< What is claimed holds for all characters in it. Only with `phases`.
  std::vector<Enclosure> eigenvalues;  ///< From λ₁ on, or from λ₀ on with `phases`.
  double next = 0;                     ///< All others are at least that.
  std::uint32_t halvings = 0;          ///< So many times triangles of the net are divided into four.
  Order side_order;                    ///< In which rows are eliminated.
  Order vertex_order;
  std::vector<AtMost> at_most;
  std::vector<AtLeast> at_least;
  std::vector<Eigenfunctions> eigenfunctions;
  bool operator==(const EigenvaluesDocument&) const = default;
};

}  // namespace epsnet::certify
