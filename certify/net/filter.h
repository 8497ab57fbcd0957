#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "certify/base/interval.h"
#include "certify/net/document.h"
#include "certify/net/lifted_triangle.h"
#include "certify/net/structure.h"

/// What the rules `orientation`, `delaunay`, `covering`, `packing` and `thick` ask of one triangle.
namespace epsnet::certify {

/// One bit each: 0 orientation, 1 covering, 2 + i Delaunay and 5 + i length of edge i, asked at the smaller of the two
/// darts of an edge only.
using Questions = std::uint8_t;
inline constexpr Questions kOrientationBit = 1;
inline constexpr Questions kCoveringBit = 2;
[[nodiscard]] constexpr Questions delaunay_bit(std::uint32_t edge) { return static_cast<Questions>(4U << edge); }
inline constexpr Questions kDelaunayBits = delaunay_bit(0) | delaunay_bit(1) | delaunay_bit(2);
[[nodiscard]] constexpr Questions length_bit(std::uint32_t edge) { return static_cast<Questions>(32U << edge); }

}  // namespace epsnet::certify

/// Numbers of binary64 side by side, for compilers that have vectors (g++, clang), whatever their library has.
namespace epsnet::certify::filter {

/// The answers to a question about each of the lanes.
class Mask {
 public:
  using Vector [[gnu::vector_size(16)]] = std::int64_t;  // 0 or −1.

  explicit Mask(Vector answers) : answers_(answers) {}
  [[nodiscard]] bool operator[](std::size_t lane) const { return answers_[lane] != 0; }
  [[nodiscard]] Vector vector() const { return answers_; }

  friend Mask operator&&(const Mask& a, const Mask& b) { return Mask(a.answers_ & b.answers_); }

 private:
  Vector answers_;
};

/// One number in each lane. Operations are those of binary64, lane by lane.
class Lanes {
 public:
  using Vector [[gnu::vector_size(16)]] = double;

  Lanes() = default;
  // NOLINTNEXTLINE(google-explicit-constructor): a number among lanes is the same in all of them.
  Lanes(double number) : numbers_{number, number} {}
  /// The numbers from this one on.
  explicit Lanes(const double* first) { std::memcpy(&numbers_, first, sizeof numbers_); }

  [[nodiscard]] static constexpr std::size_t size() { return sizeof(Vector) / sizeof(double); }
  [[nodiscard]] double operator[](std::size_t lane) const { return numbers_[lane]; }

  friend Lanes operator+(const Lanes& a, const Lanes& b) { return Lanes(a.numbers_ + b.numbers_); }
  friend Lanes operator-(const Lanes& a, const Lanes& b) { return Lanes(a.numbers_ - b.numbers_); }
  friend Lanes operator*(const Lanes& a, const Lanes& b) { return Lanes(a.numbers_ * b.numbers_); }
  friend Lanes operator/(const Lanes& a, const Lanes& b) { return Lanes(a.numbers_ / b.numbers_); }
  friend Mask operator<(const Lanes& a, const Lanes& b) { return Mask(Mask::Vector(a.numbers_ < b.numbers_)); }
  friend Mask operator>(const Lanes& a, const Lanes& b) { return b < a; }

  /// `yes` in the lanes where the mask is true, `no` in the others.
  friend Lanes select(const Mask& mask, const Lanes& yes, const Lanes& no) {
    return Lanes(Vector((mask.vector() & Mask::Vector(yes.numbers_)) | (~mask.vector() & Mask::Vector(no.numbers_))));
  }
  friend Lanes max(const Lanes& a, const Lanes& b) { return select(a > b, a, b); }
  friend Lanes abs(const Lanes& a) { return max(a, Lanes(-a.numbers_)); }

 private:
  explicit Lanes(Vector numbers) : numbers_(numbers) {}

  Vector numbers_;
};

}  // namespace epsnet::certify::filter

namespace epsnet::certify {

/// The tests of the filter, for several triangles or edges at once. Coordinates are at most 1 in absolute value. `true`
/// is certain, `false` says nothing.
namespace filter {

struct Points {
  Lanes x;
  Lanes y;
};

struct Intervals {
  Lanes lower;
  Lanes upper;
};

/// Whether the triangle is strictly counterclockwise in the hyperbolic plane.
[[nodiscard]] Mask counterclockwise(const Points& z0, const Points& z1, const Points& z2);

/// Whether Im [(z3−z1)(z2−z0)/((z3−z0)(z2−z1))] is negative.
[[nodiscard]] Mask delaunay(const Points& z0, const Points& z1, const Points& z2, const Points& z3);

/// |p − q|², and whether it is accurate to 2⁻⁴⁶ of itself.
struct Squared {
  Lanes value;
  Mask accurate;
};
[[nodiscard]] Squared squared_distance(const Points& p, const Points& q);

/// 1 − |z|², accurate to 2⁻³⁸ of itself; 0 if that is not certain.
[[nodiscard]] Lanes gap(const Points& z);

/// Contains D/(AB) for D accurate to 2⁻⁴⁶, A and B to 2⁻³⁸ of themselves.
[[nodiscard]] Intervals squared_half_sinh(const Lanes& d, const Lanes& a, const Lanes& b);

/// Contains sinh²R for squared distances accurate to 2⁻⁴⁶ and gaps accurate to 2⁻³⁸ of themselves, D_i between corners
/// i and i + 1; [0, ∞] if nothing is certain.
[[nodiscard]] Intervals squared_sinh_of_circumradius(const std::array<Lanes, 3>& d, const std::array<Lanes, 3>& a);

/// A point, and whether labels moved it: then it is known to 2⁻⁴⁴ after one of them, to 2⁻³⁵ after three.
struct Point {
  double x;
  double y;
  bool moved = false;
};

/// A label (a, b) in binary64, up to 2⁻⁵² of |a| + |b|. Of a point z it moves nothing is certain unless |b̄z + ā|² is
/// more than `least_stretch`.
struct Label {
  Point a{};
  Point b{};
  double least_stretch = std::numeric_limits<double>::infinity();
};
[[nodiscard]] Label label_of(const BallIsometry& f);
/// Of the inverse isometry.
[[nodiscard]] Label inverse(const Label& f);
/// The image; nullopt if it is not known as well as is said above.
[[nodiscard]] std::optional<Point> image(const Label& f, const Point& z);

}  // namespace filter

/// What binary64 settles about triangles, with bounds for all errors (docs/proof.md, section 16; but for labels,
/// scaling and underflow, by machine in certify/net/filter/). It never refutes: what it does not settle is asked in
/// balls.
class Filter {
 public:
  /// The document must outlive the filter. Balls for the labels that it should know, by number, and intervals that
  /// contain sinh²ε and sinh²(ε/2). Where this thread does not round to nearest, nothing is settled; threads that ask
  /// it must round as this one does.
  Filter(const NetDocument& document, const CollarMembers& collars, std::span<const std::uint32_t> numbers,
         const LabelTable& labels, Interval sinh_squared, Interval half_sinh_squared);

  struct Answer {
    Questions settled = 0;             ///< Of those asked, the ones whose rule certainly holds.
    Interval circumradius{};           ///< Contains sinh²R, if the question of covering is settled.
    std::array<Interval, 3> length{};  ///< Contains sinh²(d/2) of the edges whose question of length is settled.
  };

  /// How many triangles may be asked about at once.
  static constexpr std::size_t kMost = 64;

  /// About each of some triangles: answers[k] to the questions asked[k] about triangles[k]. O(1) for each of them,
  /// nothing is allocated.
  void answer(std::span<const std::uint32_t> triangles, std::span<const Questions> asked,
              std::span<Answer> answers) const;

 private:
  /// The corners where the triangle lives; nullopt if they are not known well enough.
  [[nodiscard]] std::optional<std::array<filter::Point, 3>> corners(std::uint32_t t) const;
  /// The far corner of the neighbour across an edge of a triangle, likewise.
  [[nodiscard]] std::optional<filter::Point> far_corner(const NetDocument::Triangle& triangle,
                                                        std::uint32_t edge) const;

  const NetDocument& document_;
  const CollarMembers& collars_;
  std::vector<filter::Label> labels_;  ///< By number; that of the identity is not used.
  double sinh_squared_;                ///< At most sinh²ε.
  double half_sinh_squared_;           ///< At least sinh²(ε/2).
  bool is_proved_;                     ///< Whether arithmetic is what the bounds are proved for.
};

}  // namespace epsnet::certify
