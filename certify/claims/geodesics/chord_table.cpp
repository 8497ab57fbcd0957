#include "certify/claims/geodesics/chord_table.h"

#include <algorithm>
#include <cmath>

#include "certify/net/darts.h"
#include "certify/numbers/parallel.h"
#include "certify/numbers/rounding.h"

namespace epsnet::certify {
namespace {

/// The greatest exponent of a power, and the number of exponents that enclosures may leave; beyond, nothing is decided.
constexpr double kMaxPower = 1e6;
constexpr double kMaxExponents = 16;
/// Operations of balls that a comparison with a power takes.
constexpr std::uint64_t kPowerOperations = 60;

BallIsometry power_of(const BallIsometry& f, std::uint32_t exponent, slong precision) {
  if (exponent == 1) return f;
  BallIsometry result = power_of(f, exponent / 2, precision);
  result = compose(result, result, precision);
  return exponent % 2 == 0 ? result : compose(result, f, precision);
}

}  // namespace

ChordTable::ChordTable(const LiftedPlane& plane, std::vector<Member> members, unsigned threads)
    : plane_(plane),
      lists_(members.size()),
      lengths_(members.size()),
      places_(plane.net().triangles.size()),
      places_by_axis_(plane.net().triangles.size()) {
  for (const Member& member : members) first_darts_.push_back(member.first_dart);
  std::vector<char> found(members.size(), 0);
  for_each_parallel(members.size(), threads, [&](unsigned, std::size_t i) {
    choose_sign(members[i].element);
    lengths_[i] = translation_length(members[i].element, plane.precision());
    auto list = find_chords(plane, members[i].first_dart, members[i].element);
    found[i] = list.has_value();
    if (list) lists_[i] = *std::move(list);
  });
  complete_ = std::find(found.begin(), found.end(), 0) == found.end();
  for (std::uint32_t i = 0; i < lists_.size(); ++i) {
    for (std::uint32_t k = 0; k < lists_[i].chords.size(); ++k) {
      const Chord& chord = lists_[i].chords[k];
      std::vector<Place>& places = places_[chord.triangle];
      places_by_axis_[chord.triangle].insert(chord.key, static_cast<std::uint32_t>(places.size()));
      places.push_back({i, k});
    }
  }
}

std::span<const ChordTable::Place> ChordTable::in_triangle(std::uint32_t triangle, std::uint32_t geodesic) const {
  const std::vector<Place>& places = places_[triangle];
  const auto [first, last] = std::equal_range(places.begin(), places.end(), Place{geodesic, 0},
                                              [](Place x, Place y) { return x.geodesic < y.geodesic; });
  return {first, last};
}

std::vector<ChordTable::Place> ChordTable::on_axis(const Chord& chord) const {
  std::vector<Place> found;
  for (const std::uint32_t i : places_by_axis_[chord.triangle].near(chord.key)) {
    found.push_back(places_[chord.triangle][i]);
  }
  return found;
}

Tri ChordTable::is_power(const Chord& chord, const BallIsometry& root, std::uint32_t exponent) const {
  const std::uint32_t chart = chart_of_triangle(plane_.net(), chord.triangle);
  BallIsometry power = power_of(root, exponent, plane_.precision());
  choose_sign(power);
  const Tri same = plane_.same(chart, chord.element, power);
  if (same == Tri::yes) return same;
  const BallIsometry turned = inverse(power);
  return either(same, plane_.same(chart, chord.element, turned));
}

ChordTable::Match ChordTable::find(const Chord& chord, Interval length, std::uint32_t except) const {
  Match match;
  const std::vector<Place> places = on_axis(chord);
  plane_.spend(1, places.size());
  for (const Place place : places) {
    if (place.geodesic == except) continue;
    // k l ∈ length for l in the member's enclosure: the exponents between two quotients, rounded outward.
    const Interval member = lengths_[place.geodesic];
    const double least = std::max(1.0, std::ceil(below(length.lower / member.upper)));
    const double most = std::floor(above(length.upper / member.lower));
    if (!(most < kMaxPower && most - least < kMaxExponents)) {
      match.found = Tri::unknown;
      continue;
    }
    if (least > most) continue;
    for (auto power = static_cast<std::uint32_t>(least); power <= most; ++power) {
      plane_.spend(kPowerOperations);
      const Tri answer = is_power(chord, this->chord(place).element, power);
      if (answer == Tri::yes) return {Tri::yes, place.geodesic, power};
      match.found = either(match.found, answer);
    }
  }
  return match;
}

ChordTable::Match ChordTable::find_other(std::uint32_t geodesic) const {
  // Where the axis certainly meets a triangle, the chord is one of every geodesic wanted: one such chord will do, that
  // with the fewest others in its triangle. An axis along edges has none, but one of its chords is one of them all.
  const std::vector<Chord>& chords = lists_[geodesic].chords;
  const Chord* best = nullptr;
  for (const Chord& chord : chords) {
    if (!chord.is_certain()) continue;
    if (best == nullptr || places_[chord.triangle].size() < places_[best->triangle].size()) best = &chord;
  }
  Match result;
  for (const Chord& chord : best != nullptr ? std::span(best, 1) : std::span(chords)) {
    const Match match = find(chord, lengths_[geodesic], geodesic);
    if (match.found == Tri::yes) return match;
    result.found = either(result.found, match.found);
  }
  return result;
}

Tri ChordTable::cross(const Chord& x, const Chord& y) const {
  return certainly_less(abs(lorentz_product(x.axis, y.axis, plane_.precision())), Ball::exactly(1));
}

Tri ChordTable::crosses_itself(std::uint32_t geodesic) const {
  Tri result = Tri::no;
  const std::vector<Chord>& chords = lists_[geodesic].chords;
  for (std::uint32_t k = 0; k < chords.size(); ++k) {
    const std::span<const Place> places = in_triangle(chords[k].triangle, geodesic);
    plane_.spend(4, places.size());
    for (const Place place : places) {
      if (place.chord < k) result = either(result, cross(chords[k], chord(place)));
      if (result == Tri::yes) return result;
    }
  }
  return result;
}

Tri ChordTable::crosses_another(std::uint32_t geodesic) const {
  Tri result = Tri::no;
  for (const Chord& own : lists_[geodesic].chords) {
    const std::vector<Place>& places = in_triangle(own.triangle);
    plane_.spend(4, places.size());
    for (const Place place : places) {
      if (place.geodesic != geodesic) result = either(result, cross(own, chord(place)));
      if (result == Tri::yes) return result;
    }
  }
  return result;
}

}  // namespace epsnet::certify
