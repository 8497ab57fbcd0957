#pragma once

#include <cstdint>
#include <vector>

#include "certify/base/interval.h"
#include "certify/claims/geodesics/document.h"

/// The contents of an eigenvalues file as plain data, member by member as docs/format.md defines them.
///
/// Eigenvalues are those of the Laplacian −Δ, with multiplicity, without the eigenvalue 0 of the constant functions.
/// A document only states what a file says; nothing here is proved.
namespace epsnet::certify {

/// An eigenvalues file: a spectrum, and what follows from it.
struct EigenvaluesDocument : GeodesicsDocument {
  /// The coefficients c₀, …, c_K of a test function.
  using Coefficients = std::vector<double>;

  /// At most `count` eigenvalues lie in `in`: F₀(c) < (count + 1)·f̂² there.
  struct AtMost {
    Interval in{};
    std::uint32_t count = 0;
    Coefficients coefficients;
    bool operator==(const AtMost&) const = default;
  };

  /// If all eigenvalues in the open interval `in` lie in `within`, there are at least `count`: the sum of P f̂² over all
  /// eigenvalues is more than (count − 1)·P f̂² everywhere in `within`. P is positive in `in` alone.
  struct AtLeast {
    Interval in{};
    Interval within{};
    std::uint32_t count = 1;
    Coefficients coefficients;
    bool operator==(const AtLeast&) const = default;
  };

  /// An eigenvalue lies in `in`: functions around the vertices of the net nearly fit together to an eigenfunction.
  struct Eigenfunction {
    Interval in{};
    double lambda = 0;  ///< Of the functions; in `in`.
    double radius = 0;  ///< Around each vertex its function counts within this distance, more than ε.
    /// By vertex α₀, α₁, β₁, …, α_M, β_M: its function is the sum of the (α_m cos mθ + β_m sin mθ) tanh(ρ/2)^m F_m, in
    /// polar coordinates.
    Coefficients coefficients;
    bool operator==(const Eigenfunction&) const = default;
  };

  /// What is claimed of the eigenvalues in `in`. Where `least` and `most` differ the other two intervals are `in`.
  struct Window {
    Interval in{};
    std::uint32_t least = 1;  ///< There are at least so many, with multiplicity,
    std::uint32_t most = 1;   ///< and at most so many.
    Interval smallest{};      ///< Contains the smallest one, and has the lower end of `in`.
    Interval greatest{};      ///< Contains the greatest one, and has the upper end of `in`.
    bool operator==(const Window&) const = default;
  };

  /// Claims a complete spectrum.
  EigenvaluesDocument() { claim = Claim::spectrum; }

  std::uint32_t order = 8;       ///< n, of the spline.
  std::uint32_t degree = 32;     ///< K.
  double eigenvalues_up_to = 0;  ///< No eigenvalue in (0, eigenvalues_up_to] is outside of the windows.
  std::vector<Window> windows;
  std::vector<AtMost> at_most;
  std::vector<AtLeast> at_least;
  std::vector<Eigenfunction> eigenfunctions;
  bool operator==(const EigenvaluesDocument&) const = default;
};

}  // namespace epsnet::certify
