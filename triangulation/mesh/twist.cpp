#include <array>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string>

#include "kernel/isometry.h"
#include "triangulation/mesh/editor.h"
#include "triangulation/mesh/operations.h"

/// Dehn twists: the turns of edges around a short closed curve, undone all at once.
namespace epsnet {
namespace {

/// sinh²(ℓ/2) of a curve of length ¼; longer ones are left to flips.
constexpr double kShort = 0.0157;
/// Fewer turns are left to flips.
constexpr double kManyTurns = 16;
/// Letters that the word of all turns may have.
constexpr double kMostLetters = 100'000;

/// Where the foot of z on the axis lies along it, up to a constant.
template <class T>
T along(const Axis<T>& axis, const Complex<T>& z) {
  return T(log(T(norm(z - axis.from) / norm(z - axis.to)))) / 2;
}

std::string two_digits(double value) {
  std::array<char, 32> text{};
  (void)std::snprintf(text.data(), text.size(), "%.2g", value);
  return text.data();
}

}  // namespace

bool untwist(Triangulation& triangulation, Dart d, Journal* journal) {
  // The quadrilateral a, f, b, c beside d = (a, b), lifted to the chart of d's triangle. If two opposite sides are
  // glued to each other, by τ, the other two are loops: those of p and τp, and of f and τf. The edges across are
  // (p, τᵏf) for two successive k, the sides and the diagonal; other values of k are other triangulations of the same
  // annulus.
  const Dart e = triangulation.opposite(d);
  const bool next_glued = triangulation.opposite(next_dart(d)) == next_dart(e);
  const bool previous_glued = triangulation.opposite(previous_dart(d)) == previous_dart(e);
  if (!next_glued && !previous_glued) return false;
  Atlas& atlas = Editor(triangulation).atlas();
  const TriangleId t = triangle_of(d);
  const TriangleId s = triangle_of(e);
  const std::uint32_t of_p = next_glued ? corner_of(d) : next(corner_of(d));
  const std::uint32_t of_turned_f = next_glued ? next(corner_of(d)) : corner_of(d);
  const Corner p = triangulation.corner(t, of_p);
  const Corner turned_p = triangulation.corner(t, previous(corner_of(d)));
  const LabelId tau = atlas.product(turned_p.label, atlas.inverse(p.label));
  if (tau == kIdentity) return false;
  const Isometry<double> rounded = atlas.isometry(tau);
  constexpr double kRounding = 16 * kUnitRoundoff;
  if (isometry_discriminant(rounded) - kRounding * (norm(rounded.a) + norm(rounded.b)) > kShort) return false;

  const LabelId across = triangulation.transition(d);
  const Corner f = triangulation.moved(across, triangulation.corner(s, previous(corner_of(e))));
  const Isometry<Mp1024> translation = atlas.isometry_in<Mp1024>(tau);
  const auto axis = epsnet::axis(translation);
  if (!axis) return false;
  const auto position = [&](const Corner& c) {
    return along(*axis, atlas.lift<Mp1024>(c.label, triangulation.vertex(c.vertex).z));
  };
  const auto length = static_cast<double>(displacement_length(translation));
  // The edges across are short if the feet of p and τᵏf, k ≤ turns < k + 1, are as near as they can be.
  const double turns = std::floor(static_cast<double>(Mp1024(position(p) - position(f))) / length);
  if (!(std::fabs(turns) >= kManyTurns)) return false;
  const double letters = std::fabs(turns) * static_cast<double>(atlas.labels()[tau].word.size());
  if (!(letters <= kMostLetters)) {
    throw LimitError("edges of the start turn " + two_digits(std::fabs(turns)) +
                     " times around a closed curve of length " + two_digits(length) + ", across " +
                     two_digits(letters) + " sides, expected at most " + two_digits(kMostLetters) +
                     "; the surface must be cut into other tiles");
  }
  const LabelId twist = atlas.power(turns < 0 ? atlas.inverse(tau) : tau, static_cast<std::uint64_t>(std::fabs(turns)));

  std::array<Corner, 3> own;
  std::array<Corner, 3> others;
  for (std::uint32_t i = 0; i < 3; ++i) {
    own[i] = triangulation.corner(t, i);
    others[i] = triangulation.moved(across, triangulation.corner(s, i));
  }
  const auto turn = [&](Corner& c) { c = triangulation.moved(twist, c); };
  turn(own[of_turned_f]);
  turn(others[previous(corner_of(e))]);
  turn(others[next_glued ? corner_of(e) : next(corner_of(e))]);
  // Labels still fit, and V − E + F is the same: what is left to ask is whether triangles are counterclockwise.
  if (triangulation.orientation(own[0], own[1], own[2]) <= 0 ||
      triangulation.orientation(others[0], others[1], others[2]) <= 0)
    return false;
  const Editor editor(triangulation, journal);
  editor.set(t, own[0], own[1], own[2]);
  editor.set(s, others[0], others[1], others[2]);
  return true;
}

}  // namespace epsnet
