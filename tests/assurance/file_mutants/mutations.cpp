#include "tests/assurance/file_mutants/mutations.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <limits>
#include <sstream>
#include <tuple>

#include "certify/net/numbering.h"
#include "netgen/base/options.h"

namespace epsnet::attack {
namespace {

using certify::BoundDocument;
using certify::CurvesDocument;
using certify::DistanceDocument;
using certify::EigenvaluesDocument;
using certify::GeodesicsDocument;
using certify::IsometriesDocument;
using certify::NetDocument;
using certify::PantsDocument;

/// Changes an index to another one below n; sometimes to one that is just too large, or as large as possible.
void change_index(std::uint32_t& index, std::size_t n, Random& random) {
  switch (random.below(12)) {
    case 0:
      index = static_cast<std::uint32_t>(n);
      break;
    case 1:
      index = ~0U;
      break;
    default:
      index = random.below(n);
  }
}

/// Returns a small or a large step, relative to numbers below 1.
mpq_class some_step(Random& random) {
  mpz_class power;
  mpz_ui_pow_ui(power.get_mpz_t(), 10, 1 + random.below(40));
  return mpq_class(random.below(2) == 0 ? 1 : -1, power);
}

double& coordinate(NetDocument& net, Random& random) {
  certify::NetDocument::Vertex& v = random.of(net.vertices);
  return random.below(2) == 0 ? v.x : v.y;
}
mpq_class& coordinate(certify::RationalPoint& z, Random& random) { return random.below(2) == 0 ? z.x : z.y; }

std::uint32_t& letter(NetDocument& net, Random& random) {
  std::vector<std::uint32_t*> letters;
  for (certify::NetDocument::Label& l : net.labels) {
    for (std::uint32_t& s : l.word) letters.push_back(&s);
  }
  return *random.of(letters);
}

template <class T>
void drop_last(std::vector<T>& rows) {
  if (rows.empty()) throw NothingToChange{};
  rows.pop_back();
}

/// Changes the end of an interval: to a neighbouring number, or by a little or a lot.
void change_length(double& x, Random& r) {
  switch (r.below(5)) {
    case 0:
      x = std::nextafter(x, r.sign() * 1e9);
      break;
    case 1:
      x *= 1 + std::ldexp(r.sign(), -1 - static_cast<int>(r.below(50)));
      break;
    case 2:
      x += std::ldexp(r.sign(), -1 - static_cast<int>(r.below(60)));
      break;
    case 3:
      x = 0;
      break;
    default:
      x *= 1 + r.share();
  }
}

std::size_t side_count(const NetDocument& net) {
  std::size_t n = std::size_t{4} * net.surface.regular_genus;
  for (const certify::SurfaceDocument::Tile& tile : net.surface.tiles) n += tile.size();
  for (const auto& polygon : net.surface.field.polygons) n += polygon.size();
  return n;
}

/// Returns for every side the one that it is glued to.
std::vector<std::uint32_t> partners(const certify::SurfaceDocument& surface) {
  if (surface.regular_genus != 0) {
    std::vector<std::uint32_t> result;
    for (std::uint32_t k = 0; k < 4 * surface.regular_genus; ++k) {
      result.push_back((k + 2 * surface.regular_genus) % (4 * surface.regular_genus));
    }
    return result;
  }
  std::vector<std::uint32_t> first;
  std::uint32_t sides = 0;
  for (const certify::SurfaceDocument::Tile& tile : surface.tiles) {
    first.push_back(sides);
    sides += static_cast<std::uint32_t>(tile.size());
  }
  for (const auto& polygon : surface.field.polygons) {
    first.push_back(sides);
    sides += static_cast<std::uint32_t>(polygon.size());
  }
  std::vector<std::uint32_t> result(sides);
  for (const certify::SurfaceDocument::Gluing& g : surface.gluing) {
    const std::uint32_t s = first.at(g.tile) + g.side;
    const std::uint32_t t = first.at(g.other_tile) + g.other_side;
    result.at(s) = t;
    result.at(t) = s;
  }
  return result;
}
/// Changes a word to that of the inverse.
void invert(std::vector<std::uint32_t>& word, const certify::SurfaceDocument& surface) {
  const std::vector<std::uint32_t> partner = partners(surface);
  std::reverse(word.begin(), word.end());
  for (std::uint32_t& s : word) s = partner.at(s);
}

void change_word(std::vector<std::uint32_t>& word, const NetDocument& net, Random& r) {
  const std::uint32_t at = r.below(word.size() + 1);
  const std::uint32_t side = r.below(side_count(net));
  switch (r.below(5)) {
    case 0:
      word.insert(word.begin() + at, side);
      break;
    case 1:
      if (at < word.size()) word.erase(word.begin() + at);
      break;
    case 2:
      if (at < word.size()) word[at] = side;
      break;
    case 3: {
      // Around: a conjugate, or with tiles no path.
      if (word.empty()) break;
      std::rotate(word.begin(), word.begin() + 1, word.end());
      break;
    }
    default:
      word.insert(word.begin() + at, {side, partners(net.surface).at(side)});
  }
}

/// Changes a count by one, or to anything small.
void change_count(std::uint32_t& count, Random& r) {
  switch (r.below(3)) {
    case 0:
      ++count;
      break;
    case 1:
      --count;
      break;
    default:
      count = r.below(6);
  }
}

// Of pants files.

using Word = PantsDocument::Word;

void append(Word& word, const Word& then) { word.insert(word.end(), then.begin(), then.end()); }

Word inverted(Word word, const PantsDocument& file) {
  invert(word, file.net.surface);
  return word;
}

/// The path of a cuff.
Word path_of(const PantsDocument& file, const PantsDocument::End& end) {
  const auto& [first, second] = file.pants.at(end[0]);
  if (end[1] < 2) return end[1] == 0 ? first : second;
  Word both = first;
  append(both, second);
  return inverted(std::move(both), file);
}

Word& any_path(PantsDocument& file, Random& r) { return r.of(file.pants).at(r.below(2)); }
PantsDocument::End& any_end(PantsDocument& file, Random& r) { return r.of(file.cuffs).ends.at(r.below(2)); }

/// At each end that is cuff k of p, the path across goes along a word first; or comes along its inverse last.
void go_first(PantsDocument& file, std::uint32_t p, std::uint32_t k, const Word& word) {
  for (PantsDocument::Cuff& cuff : file.cuffs) {
    const PantsDocument::End end{p, k};
    if (cuff.ends[0] == end) cuff.across.insert(cuff.across.begin(), word.begin(), word.end());
    if (cuff.ends[1] == end) append(cuff.across, inverted(word, file));
  }
}

void add_to_twist(PantsDocument::Cuff& cuff, double lengths) {
  cuff.twist.lower += lengths * (lengths > 0 ? cuff.length.lower : cuff.length.upper);
  cuff.twist.upper += lengths * (lengths > 0 ? cuff.length.upper : cuff.length.lower);
  cuff.twist.lower = std::nextafter(cuff.twist.lower, -1e9);
  cuff.twist.upper = std::nextafter(cuff.twist.upper, 1e9);
}

/// Those of the file, or those of functions.
std::vector<std::string>& phases(EigenvaluesDocument& file) {
  if (file.phases.empty()) file.phases.resize(certify::SurfaceSides(file.net.surface).partner.size(), "0");
  return file.phases;
}

/// That of the file, or one of all heights 0 and one direction, with phases.
EigenvaluesDocument::Box& box(EigenvaluesDocument& file) {
  const std::size_t sides = phases(file).size();
  if (!file.box) file.box = {"1/100", {}};
  if (file.box->directions.empty())
    file.box->directions = {{std::vector<std::int64_t>(sides, 0), std::vector<double>(file.net.vertices.size(), 0)}};
  return *file.box;
}
EigenvaluesDocument::Direction& direction(EigenvaluesDocument& file, Random& r) { return r.of(box(file).directions); }

/// Any number below which eigenvalues are counted.
double& below(EigenvaluesDocument& file, Random& r) {
  if (r.below(file.at_most.size() + file.at_least.size()) < file.at_most.size()) return r.of(file.at_most).below;
  return r.of(file.at_least).below;
}
double& end(certify::Interval& in, Random& r) { return r.below(2) == 0 ? in.lower : in.upper; }
/// By so little, or so much, that a count may change: 10⁻⁹ to a tenth of the number.
void change_threshold(double& x, Random& r) { x *= 1 + r.sign() * std::pow(10.0, -1 - static_cast<int>(r.below(9))); }

/// Makes the clusters that follow from the lengths. Only clusters that already existed keep their claim to be equal.
void make_clusters(GeodesicsDocument& file) {
  if (file.claim == GeodesicsDocument::Claim::systole) return;
  const std::vector<GeodesicsDocument::Cluster> before = std::move(file.clusters);
  file.clusters.clear();
  double end = 0;
  for (std::uint32_t i = 0; i < file.geodesics.size(); ++i) {
    const certify::Interval length = file.geodesics[i].length;
    if (file.clusters.empty() || length.lower > end) file.clusters.push_back({i, 0, false});
    ++file.clusters.back().count;
    end = std::max(end, length.upper);
  }
  for (GeodesicsDocument::Cluster& c : file.clusters) {
    for (const GeodesicsDocument::Cluster& old : before) {
      if (old.first == c.first && old.count == c.count) c.equal = old.equal;
    }
  }
}

/// Sorts the geodesics by lo; pieces keep their geodesics.
void sort_geodesics(GeodesicsDocument& file) {
  std::vector<std::uint32_t> order(file.geodesics.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) {
    return file.geodesics[i].length.lower < file.geodesics[j].length.lower;
  });
  std::vector<GeodesicsDocument::ClosedGeodesic> sorted;
  std::vector<std::uint32_t> place(order.size());
  for (const std::uint32_t i : order) {
    place[i] = static_cast<std::uint32_t>(sorted.size());
    sorted.push_back(file.geodesics[i]);
  }
  file.geodesics = std::move(sorted);
  for (GeodesicsDocument::Piece& piece : file.pieces) {
    for (auto& [geodesic, side] : piece.boundaries) geodesic = place.at(geodesic);
  }
  make_clusters(file);
}

/// Removes a geodesic and joins the pieces on its two sides, so that the rest of the file is right.
void leave_out(GeodesicsDocument& file, std::uint32_t gone) {
  file.geodesics.erase(file.geodesics.begin() + gone);
  std::vector<std::size_t> at;
  for (std::size_t p = 0; p < file.pieces.size(); ++p) {
    auto& boundaries = file.pieces[p].boundaries;
    for (std::size_t i = boundaries.size(); i-- > 0;) {
      if (boundaries[i].first == gone) {
        at.push_back(p);
        boundaries.erase(boundaries.begin() + static_cast<std::ptrdiff_t>(i));
      } else if (boundaries[i].first > gone) {
        --boundaries[i].first;
      }
    }
  }
  if (at.size() == 2 && at[0] == at[1]) ++file.pieces[at[0]].genus;
  if (at.size() == 2 && at[0] != at[1]) {
    GeodesicsDocument::Piece& one = file.pieces[at[0]];
    const GeodesicsDocument::Piece& other = file.pieces[at[1]];
    one.genus += other.genus;
    one.boundaries.insert(one.boundaries.end(), other.boundaries.begin(), other.boundaries.end());
    file.pieces.erase(file.pieces.begin() + static_cast<std::ptrdiff_t>(at[1]));
  }
  make_clusters(file);
}

NetDocument::Collar& collar(NetDocument& net, Random& r) {
  if (!net.collars) throw NothingToChange{};
  return r.of(*net.collars);
}

}  // namespace

const std::vector<Mutation>& mutations() {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  static const std::vector<Mutation> all{
      {"vertex moved by an ulp",
       [](NetDocument& net, Random& r) {
         double& x = coordinate(net, r);
         x = std::nextafter(x, r.sign());
       }},
      {"vertex moved by 1e-6", [](NetDocument& net, Random& r) { coordinate(net, r) += 1e-6 * r.sign(); }},
      {"vertex moved by up to 0.3",
       [](NetDocument& net, Random& r) { coordinate(net, r) += 0.3 * r.share() * r.sign(); }},
      {"vertex anywhere",
       [](NetDocument& net, Random& r) {
         const std::vector<double> numbers{
             0.0,       -0.0, 1.0,    -1.0, 0.999999, 2.0,          -1e300,
             kInfinity, 1e-9, 5e-324, 0.5,  -0.5,     std::nan(""), std::nextafter(1.0, 0.0)};
         coordinate(net, r) = numbers[r.below(numbers.size())];
       }},
      {"vertex mirrored",
       [](NetDocument& net, Random& r) {
         double& x = coordinate(net, r);
         x = -x;
       }},
      {"vertices exchanged", [](NetDocument& net, Random& r) { std::swap(r.of(net.vertices), r.of(net.vertices)); }},
      {"vertex in another chart",
       [](NetDocument& net, Random& r) { change_index(r.of(net.vertices).chart, net.charts.size() + 1, r); }},
      {"vertex dropped", [](NetDocument& net, Random&) { drop_last(net.vertices); }},
      {"vertex added", [](NetDocument& net, Random& r) { net.vertices.push_back(r.of(net.vertices)); }},
      {"chart moved", [](NetDocument& net, Random& r) { coordinate(r.of(net.charts).centre, r) += some_step(r); }},
      {"chart mirrored",
       [](NetDocument& net, Random& r) {
         mpq_class& x = coordinate(r.of(net.charts).centre, r);
         x = -x;
       }},
      {"chart of another tile",
       [](NetDocument& net, Random& r) { change_index(r.of(net.charts).tile, net.surface.tiles.size() + 1, r); }},
      {"chart dropped", [](NetDocument& net, Random&) { drop_last(net.charts); }},
      {"epsilon a little different",
       [](NetDocument& net, Random& r) {
         mpq_class value(Length(net.epsilon).value().backend().data());
         value *= 1 + some_step(r);
         net.epsilon = value.get_str();
       }},
      {"epsilon up to twice or half",
       [](NetDocument& net, Random& r) {
         const double factor = std::exp2(r.share() * r.sign());
         std::ostringstream text;
         text << factor * static_cast<double>(Length(net.epsilon).value());
         net.epsilon = text.str();
       }},
      {"epsilon something else",
       [](NetDocument& net, Random& r) {
         const std::vector<const char*> texts{"0",   "-1",   "",        "nan", "inf", "1/0",    "0x1", "1e9999",
                                              "100", "1e-9", "1e-9999", "0.0", "1 ",  "-0.5e1", "1/",  "1e99999"};
         net.epsilon = texts[r.below(texts.size())];
       }},
      {"letter changed", [](NetDocument& net, Random& r) { change_index(letter(net, r), side_count(net) + 1, r); }},
      {"letter dropped",
       [](NetDocument& net, Random& r) {
         auto& word = r.of(net.labels).word;
         if (!word.empty()) word.erase(word.begin() + r.below(word.size()));
       }},
      {"letter added",
       [](NetDocument& net, Random& r) {
         auto& word = r.of(net.labels).word;
         word.insert(word.begin() + r.below(word.size() + 1), r.below(side_count(net)));
       }},
      {"word reversed",
       [](NetDocument& net, Random& r) {
         auto& word = r.of(net.labels).word;
         std::reverse(word.begin(), word.end());
       }},
      {"words exchanged", [](NetDocument& net, Random& r) { std::swap(r.of(net.labels).word, r.of(net.labels).word); }},
      {"a side crossed there and back",
       [](NetDocument& net, Random& r) {
         // The same element of the group, so the same net.
         auto& word = r.of(net.labels).word;
         const certify::SurfaceDocument::Gluing& g = r.of(net.surface.gluing);
         if (net.surface.tiles.size() == 1)
           word.insert(word.begin() + r.below(word.size() + 1), {g.side, g.other_side});
       }},
      {"label to another chart",
       [](NetDocument& net, Random& r) {
         certify::NetDocument::Label& l = r.of(net.labels);
         change_index(r.below(2) == 0 ? l.from : l.to, net.charts.size() + 1, r);
       }},
      {"labels exchanged", [](NetDocument& net, Random& r) { std::swap(r.of(net.labels), r.of(net.labels)); }},
      {"label dropped",
       [](NetDocument& net, Random& r) { net.labels.erase(net.labels.begin() + r.below(net.labels.size())); }},
      {"corner of another vertex",
       [](NetDocument& net, Random& r) {
         change_index(r.of(net.triangles).vertex[r.below(3)], net.vertices.size(), r);
       }},
      {"another opposite",
       [](NetDocument& net, Random& r) {
         change_index(r.of(net.triangles).opposite[r.below(3)], 3 * net.triangles.size(), r);
       }},
      {"two edges glued otherwise",
       [](NetDocument& net, Random& r) {
         // a–b and c–d become a–d and c–b: still an involution.
         const auto across = [&](std::uint32_t d) -> std::uint32_t& { return net.triangles.at(d / 3).opposite[d % 3]; };
         const std::uint32_t a = r.below(3 * net.triangles.size());
         const std::uint32_t c = r.below(3 * net.triangles.size());
         const std::uint32_t b = across(a);
         const std::uint32_t d = across(c);
         if (a == d) return;
         across(a) = d;
         across(d) = a;
         across(c) = b;
         across(b) = c;
       }},
      {"corner with another label",
       [](NetDocument& net, Random& r) {
         change_index(r.of(net.triangles).label[r.below(2)], net.labels.size() + 1, r);
       }},
      {"corner with another label that fits",
       [](NetDocument& net, Random& r) {
         certify::NetDocument::Triangle& t = r.of(net.triangles);
         std::uint32_t& l = t.label[r.below(2)];
         const certify::NetDocument::Label wanted =
             l == 0 ? certify::NetDocument::Label{net.vertices.at(t.vertex[0]).chart,
                                                  net.vertices.at(t.vertex[0]).chart,
                                                  {}}
                    : net.labels.at(l - 1);
         for (int i = 0; i < 50; ++i) {
           const std::uint32_t other = r.below(net.labels.size());
           if (other + 1 != l && net.labels[other].from == wanted.from && net.labels[other].to == wanted.to) {
             l = other + 1;
             return;
           }
         }
       }},
      {"corners' labels exchanged",
       [](NetDocument& net, Random& r) {
         certify::NetDocument::Triangle& t = r.of(net.triangles);
         std::swap(t.label[0], t.label[1]);
       }},
      {"triangle turned over",
       [](NetDocument& net, Random& r) {
         certify::NetDocument::Triangle& t = r.of(net.triangles);
         std::swap(t.vertex[1], t.vertex[2]);
         std::swap(t.label[0], t.label[1]);
       }},
      {"triangles exchanged", [](NetDocument& net, Random& r) { std::swap(r.of(net.triangles), r.of(net.triangles)); }},
      {"triangle dropped",
       [](NetDocument& net, Random& r) { net.triangles.erase(net.triangles.begin() + r.below(net.triangles.size())); }},
      {"triangle doubled", [](NetDocument& net, Random& r) { net.triangles.push_back(r.of(net.triangles)); }},
      {"polygon's vertex moved",
       [](NetDocument& net, Random& r) { coordinate(r.of(r.of(net.surface.tiles)), r) += some_step(r); }},
      {"polygon's vertices exchanged",
       [](NetDocument& net, Random& r) {
         certify::SurfaceDocument::Tile& tile = r.of(net.surface.tiles);
         std::swap(r.of(tile), r.of(tile));
       }},
      {"polygon reversed",
       [](NetDocument& net, Random& r) {
         certify::SurfaceDocument::Tile& tile = r.of(net.surface.tiles);
         std::reverse(tile.begin(), tile.end());
       }},
      {"polygon's vertex dropped", [](NetDocument& net, Random& r) { drop_last(r.of(net.surface.tiles)); }},
      {"gluing changed",
       [](NetDocument& net, Random& r) {
         certify::SurfaceDocument::Gluing& g = r.of(net.surface.gluing);
         change_index(r.below(2) == 0 ? g.side : g.other_side, side_count(net), r);
       }},
      {"gluings crossed",
       [](NetDocument& net, Random& r) {
         std::swap(r.of(net.surface.gluing).other_side, r.of(net.surface.gluing).other_side);
       }},
      {"gluing turned round",
       [](NetDocument& net, Random& r) {
         // The same pairs: still the same net.
         certify::SurfaceDocument::Gluing& g = r.of(net.surface.gluing);
         g = {g.other_tile, g.other_side, g.tile, g.side};
       }},
      {"gluing dropped", [](NetDocument& net, Random&) { drop_last(net.surface.gluing); }},
      {"tile added",
       [](NetDocument& net, Random&) {
         const certify::SurfaceDocument::Tile first = net.surface.tiles.at(0);
         net.surface.tiles.push_back(first);
       }},
  };
  return all;
}

namespace {

/// Adds or takes away 1, or turns the sign.
void change_integer(std::vector<mpz_class>& integers, Random& r) {
  mpz_class& x = r.of(integers);
  switch (r.below(3)) {
    case 0:
      ++x;
      break;
    case 1:
      --x;
      break;
    default:
      x = -x;
  }
}

/// The same vector or isometry, if all numbers are multiplied by an integer.
template <std::size_t kSize>
void multiply(std::array<std::vector<mpz_class>, kSize>& numbers, int factor) {
  for (std::vector<mpz_class>& number : numbers) {
    for (mpz_class& x : number) x *= factor;
  }
}

}  // namespace

const std::vector<Mutation>& field_mutations() {
  static const std::vector<Mutation> all{
      {"vertex over a field moved",
       [](NetDocument& net, Random& r) { change_integer(r.of(r.of(net.surface.field.polygons)).at(r.below(3)), r); }},
      {"vertex over a field multiplied",
       [](NetDocument& net, Random& r) {
         multiply(r.of(r.of(net.surface.field.polygons)), static_cast<int>(r.below(5)) - 1);
       }},
      {"vertices over a field exchanged",
       [](NetDocument& net, Random& r) {
         auto& polygon = r.of(net.surface.field.polygons);
         std::swap(r.of(polygon), r.of(polygon));
       }},
      {"vertex over a field dropped", [](NetDocument& net, Random& r) { drop_last(r.of(net.surface.field.polygons)); }},
      {"polygon added",
       [](NetDocument& net, Random& r) {
         const auto polygon = r.of(net.surface.field.polygons);
         net.surface.field.polygons.push_back(polygon);
       }},
      {"crossing changed",
       [](NetDocument& net, Random& r) { change_integer(r.of(net.surface.field.crossings).at(r.below(4)), r); }},
      {"crossing multiplied",
       [](NetDocument& net, Random& r) {
         multiply(r.of(net.surface.field.crossings), static_cast<int>(r.below(5)) - 2);
       }},
      {"crossings exchanged",
       [](NetDocument& net, Random& r) {
         std::swap(r.of(net.surface.field.crossings), r.of(net.surface.field.crossings));
       }},
      {"crossing dropped", [](NetDocument& net, Random&) { drop_last(net.surface.field.crossings); }},
      {"polynomial changed", [](NetDocument& net, Random& r) { change_integer(net.surface.field.polynomial, r); }},
      {"end of the root's interval moved",
       [](NetDocument& net, Random& r) {
         net.surface.field.root.at(r.below(2)) += mpq_class(r.below(2) == 0 ? 1 : -1, 2);
       }},
      {"number of a field longer",
       [](NetDocument& net, Random& r) { r.of(net.surface.field.crossings).at(r.below(4)).emplace_back(r.below(2)); }},
  };
  return all;
}

const std::vector<Mutation>& regular_mutations() {
  static const std::vector<Mutation> all{
      {"another genus", [](NetDocument& net, Random& r) { net.surface.regular_genus = r.below(6); }},
      {"letters of a word turned",
       [](NetDocument& net, Random& r) {
         const auto sides = static_cast<std::uint32_t>(side_count(net));
         const std::uint32_t turn = r.below(sides);
         for (std::uint32_t& s : r.of(net.labels).word) s = (s + turn) % sides;
       }},
      {"all letters and nothing else turned",
       [](NetDocument& net, Random& r) {
         const auto sides = static_cast<std::uint32_t>(side_count(net));
         const std::uint32_t turn = r.below(sides);
         for (NetDocument::Label& l : net.labels) {
           for (std::uint32_t& s : l.word) s = (s + turn) % sides;
         }
       }},
      {"vertex at the centre",
       [](NetDocument& net, Random& r) {
         NetDocument::Vertex& v = r.of(net.vertices);
         v.x = v.y = 0;
       }},
      {"all turned by a half",
       [](NetDocument& net, Random&) {
         // A symmetry of the surface: the same net.
         const auto half = static_cast<std::uint32_t>(side_count(net) / 2);
         for (NetDocument::Chart& c : net.charts) c.centre = {-c.centre.x, -c.centre.y};
         for (NetDocument::Vertex& v : net.vertices) v = {-v.x, -v.y, v.chart};
         for (NetDocument::Label& l : net.labels) {
           for (std::uint32_t& s : l.word) s = (s + half) % (2 * half);
         }
       }},
      {"a word gone round the corner",
       [](NetDocument& net, Random& r) {
         // All crossings around the one vertex: the identity.
         const auto sides = static_cast<std::uint32_t>(side_count(net));
         std::vector<std::uint32_t> round;
         std::uint32_t s = r.below(sides);
         do {
           round.push_back(s);
           s = (s + sides / 2 + 1) % sides;
         } while (s != round.front());
         auto& word = r.of(net.labels).word;
         if (r.below(2) == 0) round.pop_back();
         word.insert(word.begin() + r.below(word.size() + 1), round.begin(), round.end());
       }},
  };
  return all;
}

const std::vector<Mutation>& collar_mutations() {
  static const std::vector<Mutation> all{
      {"collar dropped",
       [](NetDocument& net, Random& r) {
         static_cast<void>(collar(net, r));
         net.collars->erase(net.collars->begin() + r.below(net.collars->size()));
       }},
      {"collars gone", [](NetDocument& net, Random&) { net.collars.reset(); }},
      {"collar twice",
       [](NetDocument& net, Random& r) { net.collars->push_back(NetDocument::Collar(collar(net, r))); }},
      {"collar of another vertex",
       [](NetDocument& net, Random& r) { change_index(collar(net, r).vertices[r.below(2)], net.vertices.size(), r); }},
      {"collar of another triangle",
       [](NetDocument& net, Random& r) {
         change_index(collar(net, r).triangles[r.below(2)], net.triangles.size(), r);
       }},
      {"collar seen from the other side",
       [](NetDocument& net, Random& r) {
         NetDocument::Collar& c = collar(net, r);
         std::swap(c.vertices[0], c.vertices[1]);
         std::swap(c.triangles[0], c.triangles[1]);
       }},
      {"collar's triangles exchanged",
       [](NetDocument& net, Random& r) {
         NetDocument::Collar& c = collar(net, r);
         std::swap(c.triangles[0], c.triangles[1]);
       }},
      {"parts of collars exchanged",
       [](NetDocument& net, Random& r) {
         NetDocument::Collar& c = collar(net, r);
         NetDocument::Collar& d = collar(net, r);
         switch (r.below(4)) {
           case 0:
             std::swap(c.core, d.core);
             break;
           case 1:
             std::swap(c.length, d.length);
             break;
           case 2:
             std::swap(c.vertices, d.vertices);
             break;
           default:
             std::swap(c.triangles[r.below(2)], d.triangles[r.below(2)]);
         }
       }},
      {"core changed", [](NetDocument& net, Random& r) { change_word(collar(net, r).core, net, r); }},
      {"core inverted", [](NetDocument& net, Random& r) { invert(collar(net, r).core, net.surface); }},
      {"core twice",
       [](NetDocument& net, Random& r) {
         auto& core = collar(net, r).core;
         const std::vector<std::uint32_t> once = core;
         core.insert(core.end(), once.begin(), once.end());
       }},
      {"length of a core", [](NetDocument& net, Random& r) { change_length(collar(net, r).length[r.below(2)], r); }},
      {"vertex of a collar moved",
       [](NetDocument& net, Random& r) {
         NetDocument::Vertex& v = net.vertices.at(collar(net, r).vertices[r.below(2)]);
         (r.below(2) == 0 ? v.x : v.y) += std::ldexp(r.sign(), -3 - static_cast<int>(r.below(50)));
       }},
      {"epsilon near a bound",
       [](NetDocument& net, Random& r) {
         // ln √2, the length of a core, or what is a little different.
         double x = r.below(2) == 0 ? std::log(2) / 2 : collar(net, r).length[r.below(2)];
         if (r.below(2) == 0) x *= 1 + std::ldexp(r.sign(), -static_cast<int>(r.below(54)));
         std::ostringstream text;
         text.precision(17);
         text << std::fixed << x;
         net.epsilon = text.str();
       }},
  };
  return all;
}

const std::vector<MutationOf<GeodesicsDocument>>& geodesics_mutations() {
  static const std::vector<MutationOf<GeodesicsDocument>> all{
      {"geodesic left out, and all else fits",
       [](GeodesicsDocument& file, Random& r) { leave_out(file, r.below(file.geodesics.size())); }},
      {"geodesic dropped",
       [](GeodesicsDocument& file, Random& r) {
         file.geodesics.erase(file.geodesics.begin() + r.below(file.geodesics.size()));
       }},
      {"geodesic twice, once backwards perhaps",
       [](GeodesicsDocument& file, Random& r) {
         GeodesicsDocument::ClosedGeodesic twin = r.of(file.geodesics);
         if (r.below(2) == 0) invert(twin.word, file.net.surface);
         file.geodesics.push_back(std::move(twin));
         sort_geodesics(file);
       }},
      {"power of a geodesic",
       [](GeodesicsDocument& file, Random& r) {
         GeodesicsDocument::ClosedGeodesic power = r.of(file.geodesics);
         const std::vector<std::uint32_t> once = power.word;
         power.word.insert(power.word.end(), once.begin(), once.end());
         power.length = {2 * power.length.lower, 2 * power.length.upper};
         if (r.below(2) == 0) power.simple = false;
         if (r.below(2) == 0) {
           r.of(file.geodesics) = power;
         } else {
           file.geodesics.push_back(power);
         }
         if (file.has_up_to()) file.up_to = std::to_string(power.length.upper + 0.1);
         sort_geodesics(file);
       }},
      {"direction",
       [](GeodesicsDocument& file, Random& r) {
         // The sides are exchanged, for those who look at them.
         const std::uint32_t i = r.below(file.geodesics.size());
         invert(file.geodesics[i].word, file.net.surface);
         if (r.below(2) == 0) return;
         for (GeodesicsDocument::Piece& piece : file.pieces) {
           for (auto& [geodesic, side] : piece.boundaries) {
             if (geodesic == i) side ^= 1U;
           }
         }
       }},
      {"word changed", [](GeodesicsDocument& file, Random& r) { change_word(r.of(file.geodesics).word, file.net, r); }},
      {"word of another",
       [](GeodesicsDocument& file, Random& r) { r.of(file.geodesics).word = r.of(file.geodesics).word; }},
      {"word of a label",
       [](GeodesicsDocument& file, Random& r) {
         const NetDocument::Label& label = r.of(file.net.labels);
         r.of(file.geodesics).word = label.word;
       }},
      {"geodesics exchanged",
       [](GeodesicsDocument& file, Random& r) { std::swap(r.of(file.geodesics), r.of(file.geodesics)); }},
      {"geodesics exchanged, and the pieces with them",
       [](GeodesicsDocument& file, Random& r) {
         const std::uint32_t i = r.below(file.geodesics.size());
         const std::uint32_t j = r.below(file.geodesics.size());
         std::swap(file.geodesics[i], file.geodesics[j]);
         for (GeodesicsDocument::Piece& piece : file.pieces) {
           for (auto& [geodesic, side] : piece.boundaries) geodesic = geodesic == i ? j : geodesic == j ? i : geodesic;
         }
         if (r.below(2) == 0) sort_geodesics(file);
       }},
      {"simple or not",
       [](GeodesicsDocument& file, Random& r) {
         bool& simple = r.of(file.geodesics).simple;
         simple = !simple;
       }},
      {"length",
       [](GeodesicsDocument& file, Random& r) {
         certify::Interval& length = r.of(file.geodesics).length;
         change_length(r.below(2) == 0 ? length.lower : length.upper, r);
         if (r.below(2) == 0) sort_geodesics(file);
       }},
      {"enclosures wider",
       [](GeodesicsDocument& file, Random& r) {
         // True still, and the clusters larger.
         const double by = std::ldexp(1, -static_cast<int>(r.below(50)));
         for (auto& g : file.geodesics) g.length = {g.length.lower / (1 + by), g.length.upper * (1 + by)};
         make_clusters(file);
       }},
      {"all enclosures moved",
       [](GeodesicsDocument& file, Random& r) {
         const double by = std::ldexp(r.sign(), -static_cast<int>(r.below(52)));
         for (auto& g : file.geodesics) g.length = {g.length.lower * (1 + by), g.length.upper * (1 + by)};
         make_clusters(file);
       }},
      {"vertex of another tile perhaps",
       [](GeodesicsDocument& file, Random& r) {
         change_index(r.of(file.geodesics).vertex, file.net.vertices.size(), r);
       }},
      {"equal or not",
       [](GeodesicsDocument& file, Random& r) {
         bool& equal = r.of(file.clusters).equal;
         equal = !equal;
       }},
      {"cluster",
       [](GeodesicsDocument& file, Random& r) {
         GeodesicsDocument::Cluster& c = r.of(file.clusters);
         change_index(r.below(2) == 0 ? c.first : c.count, file.geodesics.size() + 1, r);
       }},
      {"genus of a piece", [](GeodesicsDocument& file, Random& r) { r.of(file.pieces).genus = r.below(4); }},
      {"boundary of a piece",
       [](GeodesicsDocument& file, Random& r) {
         auto& [geodesic, side] = r.of(r.of(file.pieces).boundaries);
         if (r.below(2) == 0) {
           change_index(geodesic, file.geodesics.size(), r);
         } else {
           side ^= 1U;
         }
       }},
      {"boundaries exchanged",
       [](GeodesicsDocument& file, Random& r) {
         std::swap(r.of(r.of(file.pieces).boundaries), r.of(r.of(file.pieces).boundaries));
       }},
      {"pieces in another order",
       [](GeodesicsDocument& file, Random& r) {
         std::swap(r.of(file.pieces), r.of(file.pieces));
         auto& boundaries = r.of(file.pieces).boundaries;
         std::reverse(boundaries.begin(), boundaries.end());
       }},
      {"piece dropped", [](GeodesicsDocument& file, Random&) { drop_last(file.pieces); }},
      {"piece added",
       [](GeodesicsDocument& file, Random&) {
         file.pieces.push_back({1, {}});
       }},
      {"another bound",
       [](GeodesicsDocument& file, Random& r) {
         if (file.up_to.empty()) throw NothingToChange{};
         const certify::Interval length = r.of(file.geodesics).length;
         std::ostringstream text;
         text.precision(17);
         text << std::fixed << (r.below(2) == 0 ? length.upper * (1 + 0.1 * r.share() * r.sign()) : length.lower);
         file.up_to = text.str();
       }},
      {"a systole instead",
       [](GeodesicsDocument& file, Random& r) {
         file.geodesics = {GeodesicsDocument::ClosedGeodesic(r.of(file.geodesics))};
         file.claim = GeodesicsDocument::Claim::systole;
         file.up_to.clear();
         file.clusters.clear();
         file.pieces.clear();
         file.basis.clear();
         file.weights.clear();
       }},
      {"a spectrum instead",
       [](GeodesicsDocument& file, Random& r) {
         file.claim = GeodesicsDocument::Claim::spectrum;
         std::ostringstream text;
         text.precision(17);
         text << std::fixed << file.geodesics.at(file.geodesics.size() - 1).length.upper + 1e-3 * r.share();
         file.up_to = text.str();
         file.pieces.clear();
         file.basis.clear();
         file.weights.clear();
         make_clusters(file);
       }},
      {"another basis",
       [](GeodesicsDocument& file, Random& r) {
         // Still in order, as a rule: one of the basis and one that is not in it are exchanged.
         std::uint32_t& element = r.of(file.basis);
         element = r.below(file.geodesics.size());
         std::sort(file.basis.begin(), file.basis.end());
       }},
      {"element of the basis",
       [](GeodesicsDocument& file, Random& r) { change_index(r.of(file.basis), file.geodesics.size(), r); }},
      {"a weight", [](GeodesicsDocument& file, Random& r) { r.of(file.weights) = 1 + r.below(1U << r.below(12)); }},
      {"all weights",
       [](GeodesicsDocument& file, Random& r) {
         for (std::uint32_t& weight : file.weights) weight = 1 + r.below(3);
         if (file.weights.empty()) throw NothingToChange{};
       }},
      {"one more or less in the basis",
       [](GeodesicsDocument& file, Random& r) {
         if (file.basis.empty()) throw NothingToChange{};
         if (r.below(2) == 0) {
           file.basis.pop_back();
           file.weights.push_back(1);
         } else {
           file.basis.push_back(file.basis.back() + 1);
           file.weights.pop_back();
         }
       }},
  };
  return all;
}

const std::vector<MutationOf<DistanceDocument>>& distance_mutations() {
  static const std::vector<MutationOf<DistanceDocument>> all{
      {"end of the distance",
       [](DistanceDocument& file, Random& r) {
         change_length(r.below(2) == 0 ? file.distance.lower : file.distance.upper, r);
       }},
      {"path left out",
       [](DistanceDocument& file, Random& r) { file.paths.erase(file.paths.begin() + r.below(file.paths.size())); }},
      {"path twice", [](DistanceDocument& file, Random& r) { file.paths.push_back(r.of(file.paths)); }},
      {"path changed", [](DistanceDocument& file, Random& r) { change_word(r.of(file.paths), file.net, r); }},
      {"paths exchanged", [](DistanceDocument& file, Random& r) { std::swap(r.of(file.paths), r.of(file.paths)); }},
      {"equal or not", [](DistanceDocument& file, Random&) { file.equal = !file.equal; }},
      {"point moved",
       [](DistanceDocument& file, Random& r) {
         mpq_class& x = r.below(2) == 0 ? file.point.z.x : file.point.z.y;
         x += mpq_class(r.below(2) == 0 ? 1 : -1, mpz_class(1) << (4 + r.below(60)));
         x.canonicalize();
       }},
      {"tile of the point",
       [](DistanceDocument& file, Random& r) { file.point.tile = r.below(file.net.surface.tiles.size() + 1); }},
  };
  return all;
}

certify::BoundSymmetry& symmetry(BoundDocument& file) {
  if (!file.symmetry) throw NothingToChange{};
  return *file.symmetry;
}

const std::vector<MutationOf<BoundDocument>>& bound_mutations() {
  static const std::vector<MutationOf<BoundDocument>> all{
      {"end of the value",
       [](BoundDocument& file, Random& r) { change_length(r.below(2) == 0 ? file.value.lower : file.value.upper, r); }},
      {"another claim",
       [](BoundDocument& file, Random& r) { file.claim = static_cast<BoundDocument::Claim>(r.below(3)); }},
      {"number of a cell", [](BoundDocument& file, Random& r) { r.of(r.of(file.cells)) = r.below(40); }},
      {"number of a cell, of another one",
       [](BoundDocument& file, Random& r) { r.of(r.of(file.cells)) = r.of(r.of(file.cells)); }},
      {"cell left out",
       [](BoundDocument& file, Random& r) {
         std::vector<std::uint32_t>& row = r.of(file.cells);
         row.erase(row.begin() + r.below(row.size()));
       }},
      {"two cells made one",
       [](BoundDocument& file, Random& r) {
         std::vector<std::uint32_t>& row = r.of(file.cells);
         const std::size_t i = r.below(row.size());
         if (row.size() < i + 3 || row[i] > 2 || row[i + 1] < 3 || row[i + 2] < 3) throw NothingToChange{};
         row.erase(row.begin() + static_cast<std::ptrdiff_t>(i), row.begin() + static_cast<std::ptrdiff_t>(i + 2));
       }},
      {"rows of cells exchanged",
       [](BoundDocument& file, Random& r) { std::swap(r.of(file.cells), r.of(file.cells)); }},
      {"step of the base",
       [](BoundDocument& file, Random& r) {
         std::uint32_t& step = r.of(file.base);
         // As many triangles as before.
         step = 2 * r.below(3 * (file.net.triangles.size() + 2)) + step % 2;
       }},
      {"steps of the base exchanged",
       [](BoundDocument& file, Random& r) { std::swap(r.of(file.base), r.of(file.base)); }},
      {"flip of the base left out",
       [](BoundDocument& file, Random& r) {
         const std::size_t i = r.below(file.base.size());
         if (file.base.empty() || file.base[i] % 2 != 0) throw NothingToChange{};
         file.base.erase(file.base.begin() + static_cast<std::ptrdiff_t>(i));
       }},
      {"flip of another dart",
       [](BoundDocument& file, Random& r) {
         r.of(r.of(file.triangulations).flips) = r.below(3 * file.net.triangles.size() + 1);
       }},
      {"flip left out",
       [](BoundDocument& file, Random& r) {
         std::vector<std::uint32_t>& flips = r.of(file.triangulations).flips;
         flips.erase(flips.begin() + r.below(flips.size()));
       }},
      {"triangulation made from another one",
       [](BoundDocument& file, Random& r) {
         r.of(file.triangulations).parent = r.below(file.triangulations.size() + 1);
       }},
      {"triangulations exchanged",
       [](BoundDocument& file, Random& r) { std::swap(r.of(file.triangulations), r.of(file.triangulations)); }},
      {"centre of a domain",
       [](BoundDocument& file, Random& r) { change_length(symmetry(file).centre.at(r.below(2)), r); }},
      {"symmetry left out", [](BoundDocument& file, Random&) { symmetry(file), file.symmetry.reset(); }},
      {"sides of a domain exchanged",
       [](BoundDocument& file, Random& r) {
         auto& rows = symmetry(file).isometries;
         const std::size_t i = r.below(rows.size());
         const std::size_t k = r.below(rows.size());
         std::swap(rows.at(i), rows.at(k));
         if (r.below(2) == 0) std::swap(file.cells.at(i), file.cells.at(k));
       }},
      {"side of a domain left out",
       [](BoundDocument& file, Random& r) {
         auto& rows = symmetry(file).isometries;
         const std::size_t i = r.below(rows.size());
         rows.erase(rows.begin() + static_cast<std::ptrdiff_t>(i));
         file.cells.erase(file.cells.begin() + static_cast<std::ptrdiff_t>(i));
       }},
      {"side of a domain in place of another",
       [](BoundDocument& file, Random& r) { r.of(symmetry(file).isometries) = r.of(symmetry(file).isometries); }},
      {"orientation of a side of a domain",
       [](BoundDocument& file, Random& r) {
         bool& preserves = r.of(symmetry(file).isometries).preserves_orientation;
         preserves = !preserves;
       }},
      {"image of a side of a domain",
       [](BoundDocument& file, Random& r) { change_word(r.of(r.of(symmetry(file).isometries).images), file.net, r); }},
      {"pair of a symmetry",
       [](BoundDocument& file, Random& r) { change_word(r.of(symmetry(file).pair), file.net, r); }},
  };
  return all;
}

const std::vector<MutationOf<EigenvaluesDocument>>& eigenvalues_mutations() {
  static const std::vector<MutationOf<EigenvaluesDocument>> all{
      {"number of a count, by little", [](EigenvaluesDocument& file, Random& r) { change_length(below(file, r), r); }},
      {"number of a count", [](EigenvaluesDocument& file, Random& r) { change_threshold(below(file, r), r); }},
      {"phase of a side", [](EigenvaluesDocument& file, Random& r) { r.of(phases(file)) = "1/7"; }},
      {"phases of two sides that are glued",
       [](EigenvaluesDocument& file, Random& r) {
         const certify::SurfaceSides sides(file.net.surface);
         std::vector<std::string>& turns = phases(file);
         const std::uint32_t side = r.below(turns.size());
         turns.at(side) = r.below(2) == 0 ? "1/2" : "0.2";
         turns.at(sides.partner.at(side)) = "-" + turns[side];
       }},
      {"phases left out, or those of functions",
       [](EigenvaluesDocument& file, Random&) {
         if (file.phases.empty()) {
           phases(file);
         } else {
           file.phases.clear();
         }
       }},
      {"radius of a box",
       [](EigenvaluesDocument& file, Random& r) {
         constexpr const char* kRadii[] = {"0.0100000001", "0.011", "1/3", "1/101"};
         box(file).radius = kRadii[r.below(4)];
       }},
      {"height in a box",
       [](EigenvaluesDocument& file, Random& r) {
         std::vector<double>& heights = direction(file, r).heights;
         heights.at(r.below(heights.size())) += r.sign() * std::pow(10.0, -static_cast<int>(r.below(7)));
       }},
      {"step in a box",
       [](EigenvaluesDocument& file, Random& r) { r.of(direction(file, r).steps) += r.below(2) == 0 ? 1 : -1; }},
      {"steps of two sides that are glued",
       [](EigenvaluesDocument& file, Random& r) {
         const certify::SurfaceSides sides(file.net.surface);
         std::vector<std::int64_t>& steps = direction(file, r).steps;
         const std::uint32_t side = r.below(steps.size());
         steps.at(side) += 1;
         steps.at(sides.partner.at(side)) -= 1;
       }},
      {"direction left out, still true, or the box",
       [](EigenvaluesDocument& file, Random& r) {
         if (r.below(2) == 0) {
           box(file).directions.erase(box(file).directions.begin() + r.below(box(file).directions.size()));
         } else {
           file.box.reset();
         }
       }},
      {"direction twice, another one not at all",
       [](EigenvaluesDocument& file, Random& r) {
         EigenvaluesDocument::Direction& one = direction(file, r);
         one = direction(file, r);
       }},
      {"sigma", [](EigenvaluesDocument& file, Random& r) { change_threshold(r.of(file.at_most).sigma, r); }},
      {"sigma and the number of its count",
       [](EigenvaluesDocument& file, Random& r) {
         EigenvaluesDocument::AtMost& row = r.of(file.at_most);
         const double before = row.sigma;
         change_threshold(row.sigma, r);
         row.below *= row.sigma / before;
       }},
      {"sigma for the number of its count",
       [](EigenvaluesDocument& file, Random& r) {
         EigenvaluesDocument::AtMost& row = r.of(file.at_most);
         row.below = row.sigma;
       }},
      {"at most another number",
       [](EigenvaluesDocument& file, Random& r) { change_count(r.of(file.at_most).count, r); }},
      {"at least another number",
       [](EigenvaluesDocument& file, Random& r) { change_count(r.of(file.at_least).count, r); }},
      {"count left out",
       [](EigenvaluesDocument& file, Random& r) {
         if (r.below(2) == 0) {
           file.at_most.erase(file.at_most.begin() + r.below(file.at_most.size()));
         } else {
           file.at_least.erase(file.at_least.begin() + r.below(file.at_least.size()));
         }
       }},
      {"counts in another order, still true",
       [](EigenvaluesDocument& file, Random& r) { std::swap(r.of(file.at_most), r.of(file.at_most)); }},
      {"interval", [](EigenvaluesDocument& file, Random& r) { change_length(end(r.of(file.eigenvalues).in, r), r); }},
      {"interval and a count",
       [](EigenvaluesDocument& file, Random& r) {
         double& x = end(r.of(file.eigenvalues).in, r);
         const double before = x;
         change_threshold(x, r);
         for (auto& row : file.at_most) row.below = row.below == before ? x : row.below;
         for (auto& row : file.at_least) row.below = row.below == before ? x : row.below;
       }},
      {"number of eigenvalues",
       [](EigenvaluesDocument& file, Random& r) { change_count(r.of(file.eigenvalues).count, r); }},
      {"number of eigenvalues, and of counts",
       [](EigenvaluesDocument& file, Random& r) {
         const std::uint32_t by = r.below(2) == 0 ? 1U : ~0U;
         for (auto& row : file.at_most) row.count += row.count == 0 ? 0 : by;
         for (auto& row : file.at_least) row.count += by;
         file.eigenvalues.at(0).count += by;
       }},
      {"interval left out",
       [](EigenvaluesDocument& file, Random& r) {
         file.eigenvalues.erase(file.eigenvalues.begin() + r.below(file.eigenvalues.size()));
       }},
      {"next", [](EigenvaluesDocument& file, Random& r) { change_length(file.next, r); }},
      {"next and its count",
       [](EigenvaluesDocument& file, Random& r) {
         change_threshold(file.next, r);
         file.at_most.at(file.at_most.size() - 1).below = file.next;
       }},
      {"halvings", [](EigenvaluesDocument& file, Random& r) { change_index(file.halvings, 14, r); }},
      {"places in an order exchanged, still true",
       [](EigenvaluesDocument& file, Random& r) {
         EigenvaluesDocument::Order& order = r.below(2) == 0 ? file.side_order : file.vertex_order;
         std::swap(r.of(order), r.of(order));
       }},
      {"place in an order",
       [](EigenvaluesDocument& file, Random& r) {
         EigenvaluesDocument::Order& order = r.below(2) == 0 ? file.side_order : file.vertex_order;
         change_index(r.of(order), order.size() + 1, r);
       }},
      {"place in an order left out",
       [](EigenvaluesDocument& file, Random& r) { drop_last(r.below(2) == 0 ? file.side_order : file.vertex_order); }},
      {"coefficient",
       [](EigenvaluesDocument& file, Random& r) { change_length(r.of(r.of(r.of(file.eigenfunctions).functions)), r); }},
      {"coefficient left out",
       [](EigenvaluesDocument& file, Random& r) { drop_last(r.of(r.of(file.eigenfunctions).functions)); }},
      {"function twice",
       [](EigenvaluesDocument& file, Random& r) {
         auto& functions = r.of(file.eigenfunctions).functions;
         functions.push_back(r.of(functions));
       }},
      {"function left out",
       [](EigenvaluesDocument& file, Random& r) { drop_last(r.of(file.eigenfunctions).functions); }},
      {"functions scaled, still true",
       [](EigenvaluesDocument& file, Random& r) {
         const double by = std::ldexp(r.sign(), static_cast<int>(r.below(200)) - 100);
         for (auto& function : r.of(file.eigenfunctions).functions) {
           for (double& c : function) c *= by;
         }
       }},
      {"lambda", [](EigenvaluesDocument& file, Random& r) { change_threshold(r.of(file.eigenfunctions).lambda, r); }},
      {"radius of functions",
       [](EigenvaluesDocument& file, Random& r) { change_threshold(r.of(file.eigenfunctions).radius, r); }},
      {"interval of functions",
       [](EigenvaluesDocument& file, Random& r) { change_threshold(end(r.of(file.eigenfunctions).in, r), r); }},
      {"row of functions twice",
       [](EigenvaluesDocument& file, Random& r) { file.eigenfunctions.push_back(r.of(file.eigenfunctions)); }},
  };
  return all;
}

const std::vector<MutationOf<IsometriesDocument>>& isometries_mutations() {
  static const std::vector<MutationOf<IsometriesDocument>> all{
      {"order", [](IsometriesDocument& file, Random& r) { change_count(file.order, r); }},
      {"orientation",
       [](IsometriesDocument& file, Random& r) {
         bool& preserves = r.of(file.isometries).preserves_orientation;
         preserves = !preserves;
       }},
      {"image changed",
       [](IsometriesDocument& file, Random& r) { change_word(r.of(r.of(file.isometries).images), file.net, r); }},
      {"image inverted",
       [](IsometriesDocument& file, Random& r) { invert(r.of(r.of(file.isometries).images), file.net.surface); }},
      {"images exchanged",
       [](IsometriesDocument& file, Random& r) {
         auto& images = r.of(file.isometries).images;
         std::swap(r.of(images), r.of(images));
       }},
      {"images of another isometry",
       [](IsometriesDocument& file, Random& r) { r.of(file.isometries).images = r.of(file.isometries).images; }},
      {"the identity",
       [](IsometriesDocument& file, Random& r) {
         // True if the generators are single letters, as they are of one tile.
         IsometriesDocument::Isometry& isometry = r.of(file.isometries);
         isometry.images = file.pair;
         const std::vector<std::uint32_t> partner = partners(file.net.surface);
         for (std::uint32_t s = 0; s < partner.size(); ++s) {
           if (s < partner[s]) isometry.images.push_back({s});
         }
       }},
      {"isometry left out",
       [](IsometriesDocument& file, Random& r) {
         file.isometries.erase(file.isometries.begin() + r.below(file.isometries.size()));
         if (r.below(2) == 0) file.order = 1;
       }},
      {"isometry twice", [](IsometriesDocument& file, Random& r) { file.isometries.push_back(r.of(file.isometries)); }},
      {"path changed", [](IsometriesDocument& file, Random& r) { change_word(r.of(file.paths), file.net, r); }},
      {"pair changed", [](IsometriesDocument& file, Random& r) { change_word(r.of(file.pair), file.net, r); }},
      {"pair exchanged",
       [](IsometriesDocument& file, Random& r) {
         std::swap(file.pair.at(0), file.pair.at(1));
         if (r.below(2) == 0) return;
         for (auto& isometry : file.isometries) std::swap(isometry.images.at(0), isometry.images.at(1));
       }},
      {"cocycle",
       [](IsometriesDocument& file, Random& r) { change_index(r.of(file.cocycle), std::size_t{1} << 31, r); }},
      {"another cocycle of one tile, or of 0",
       [](IsometriesDocument& file, Random& r) {
         const bool zero = r.below(2) == 0;
         for (std::uint32_t& c : file.cocycle) c = zero ? 0 : r.below(1000);
       }},
  };
  return all;
}

const std::vector<MutationOf<CurvesDocument>>& curves_mutations() {
  // For words that are changed: whatever the length is then.
  static constexpr certify::Interval kAnyLength{1e-3, 1e3};
  static const std::vector<MutationOf<CurvesDocument>> all{
      {"word changed",
       [](CurvesDocument& file, Random& r) {
         CurvesDocument::Curve& curve = r.of(file.curves);
         change_word(curve.word, file.net, r);
         curve.length = kAnyLength;
       }},
      {"word with a detour, still true",
       [](CurvesDocument& file, Random& r) {
         Word& word = r.of(file.curves).word;
         const std::uint32_t at = r.below(word.size());
         const std::uint32_t side = word[at];
         const Word detour{side, partners(file.net.surface).at(side)};
         word.insert(word.begin() + at, detour.begin(), detour.end());
       }},
      {"word backwards", [](CurvesDocument& file, Random& r) { invert(r.of(file.curves).word, file.net.surface); }},
      {"word of another curve",
       [](CurvesDocument& file, Random& r) {
         CurvesDocument::Curve& curve = r.of(file.curves);
         const CurvesDocument::Curve& other = r.of(file.curves);
         std::tie(curve.vertex, curve.word, curve.length) = std::tuple(other.vertex, other.word, other.length);
       }},
      {"word several times",
       [](CurvesDocument& file, Random& r) {
         CurvesDocument::Curve& curve = r.of(file.curves);
         append(curve.word, Word(curve.word));
         curve.length = kAnyLength;
         if (r.below(2) == 0) curve.power *= 2;
       }},
      {"curves exchanged", [](CurvesDocument& file, Random& r) { std::swap(r.of(file.curves), r.of(file.curves)); }},
      {"length",
       [](CurvesDocument& file, Random& r) {
         certify::Interval& length = r.of(file.curves).length;
         (r.below(2) == 0 ? length.lower : length.upper) *=
             1 + r.sign() * std::ldexp(1, -static_cast<int>(r.below(52)));
       }},
      {"power", [](CurvesDocument& file, Random& r) { change_count(r.of(file.curves).power, r); }},
      {"self-intersections",
       [](CurvesDocument& file, Random& r) {
         std::uint64_t& number = r.of(file.curves).self_intersections;
         number += r.below(2) == 0 && number > 0 ? ~std::uint64_t{0} : 1;
       }},
      {"class", [](CurvesDocument& file, Random& r) { r.of(r.of(file.curves).homology) += r.below(2) == 0 ? 1 : -1; }},
      {"class of the inverse",
       [](CurvesDocument& file, Random& r) {
         for (std::int64_t& coefficient : r.of(file.curves).homology) coefficient = -coefficient;
       }},
      {"intersections",
       [](CurvesDocument& file, Random& r) {
         std::uint64_t& number = r.of(file.pairs).intersections;
         number += r.below(2) == 0 && number > 1 ? ~std::uint64_t{1} : 2;
       }},
      {"algebraic number",
       [](CurvesDocument& file, Random& r) {
         std::int64_t& number = r.of(file.pairs).algebraic;
         number = r.below(2) == 0 ? -number : number + 2;
       }},
      {"pairs exchanged",
       [](CurvesDocument& file, Random& r) {
         CurvesDocument::Pair& one = r.of(file.pairs);
         CurvesDocument::Pair& other = r.of(file.pairs);
         std::swap(one.intersections, other.intersections);
         std::swap(one.algebraic, other.algebraic);
       }},
      {"pair left out", [](CurvesDocument& file, Random&) { drop_last(file.pairs); }},
      {"basis", [](CurvesDocument& file, Random& r) { change_index(r.of(file.basis), file.curves.size(), r); }},
      {"basis in another order",
       [](CurvesDocument& file, Random& r) { std::swap(r.of(file.basis), r.of(file.basis)); }},
      {"another set",
       [](CurvesDocument& file, Random& r) {
         Word set;
         const std::size_t one_of = 1 + r.below(6);
         for (std::uint32_t i = 0; i < file.curves.size(); ++i) {
           if (r.below(one_of) == 0) set.push_back(i);
         }
         file.filling.push_back(set);
       }},
      {"curve of a set",
       [](CurvesDocument& file, Random& r) { change_index(r.of(r.of(file.filling)), file.curves.size(), r); }},
      {"set without a curve",
       [](CurvesDocument& file, Random& r) {
         Word& set = r.of(file.filling);
         set.erase(set.begin() + r.below(set.size()));
       }},
  };
  return all;
}

const std::vector<MutationOf<PantsDocument>>& pants_mutations() {
  static const std::vector<MutationOf<PantsDocument>> all{
      {"path changed", [](PantsDocument& file, Random& r) { change_word(any_path(file, r), file.net, r); }},
      {"path backwards", [](PantsDocument& file, Random& r) { invert(any_path(file, r), file.net.surface); }},
      {"path squared",
       [](PantsDocument& file, Random& r) {
         Word& path = any_path(file, r);
         append(path, Word(path));
       }},
      {"path along the other one",
       [](PantsDocument& file, Random& r) {
         auto& paths = r.of(file.pants);
         append(paths.at(0), paths.at(1));
       }},
      {"paths exchanged",
       [](PantsDocument& file, Random& r) {
         auto& paths = r.of(file.pants);
         std::swap(paths.at(0), paths.at(1));
       }},
      {"pants mirrored, true if all are",
       [](PantsDocument& file, Random& r) {
         const bool both = r.below(2) == 0;
         const std::uint32_t one = r.below(file.pants.size());
         for (std::uint32_t p = 0; p < file.pants.size(); ++p) {
           if (!both && p != one) continue;
           go_first(file, p, 2, inverted(file.pants[p][0], file));
           std::swap(file.pants[p][0], file.pants[p][1]);
           for (auto& cuff : file.cuffs) {
             for (auto& end : cuff.ends) {
               if (end[0] == p && end[1] < 2) end[1] = 1 - end[1];
             }
           }
         }
       }},
      {"pants on the right",
       [](PantsDocument& file, Random&) {
         for (std::uint32_t p = 0; p < file.pants.size(); ++p) {
           go_first(file, p, 2, file.pants[p][1]);
           for (Word& path : file.pants[p]) invert(path, file.net.surface);
         }
       }},
      {"pants numbered otherwise, still true",
       [](PantsDocument& file, Random& r) {
         const std::uint32_t p = r.below(file.pants.size());
         file.pants[p] = {path_of(file, {p, 1}), path_of(file, {p, 2})};
         for (auto& cuff : file.cuffs) {
           for (auto& end : cuff.ends) {
             if (end[0] == p) end[1] = (end[1] + 2) % 3;
           }
         }
       }},
      {"pants from elsewhere, still true",
       [](PantsDocument& file, Random& r) {
         const std::uint32_t p = r.below(file.pants.size());
         const Word around = path_of(file, {p, r.below(3)});
         for (Word& path : file.pants[p]) {
           Word conjugate = around;
           append(conjugate, path);
           append(conjugate, inverted(around, file));
           path = std::move(conjugate);
         }
         for (std::uint32_t k = 0; k < 3; ++k) go_first(file, p, k, around);
       }},
      {"pants of another number", [](PantsDocument& file, Random& r) { r.of(file.pants) = r.of(file.pants); }},
      {"everything twice, or a double cover",
       [](PantsDocument& file, Random& r) {
         const std::size_t count = file.cuffs.size();
         const auto pants = static_cast<std::uint32_t>(file.pants.size());
         for (std::uint32_t p = 0; p < pants; ++p) file.pants.push_back(PantsDocument::Paths(file.pants[p]));
         for (std::size_t i = 0; i < count; ++i) {
           PantsDocument::Cuff cuff = file.cuffs[i];
           for (auto& end : cuff.ends) end[0] += pants;
           file.cuffs.push_back(std::move(cuff));
         }
         if (r.below(2) == 0) return;
         const std::size_t exchanged = r.below(count);
         std::swap(file.cuffs[exchanged].ends[1], file.cuffs[count + exchanged].ends[1]);
       }},
      {"no pants",
       [](PantsDocument& file, Random&) {
         file.pants.clear();
         file.cuffs.clear();
       }},
      {"cuff left out",
       [](PantsDocument& file, Random& r) { file.cuffs.erase(file.cuffs.begin() + r.below(file.cuffs.size())); }},
      {"end changed",
       [](PantsDocument& file, Random& r) {
         if (r.below(2) == 0) {
           change_index(any_end(file, r)[0], file.pants.size(), r);
         } else {
           change_index(any_end(file, r)[1], 3, r);
         }
       }},
      {"ends exchanged", [](PantsDocument& file, Random& r) { std::swap(any_end(file, r), any_end(file, r)); }},
      {"cuff from the other side, still true if backwards",
       [](PantsDocument& file, Random& r) {
         PantsDocument::Cuff& cuff = r.of(file.cuffs);
         std::swap(cuff.ends[0], cuff.ends[1]);
         if (r.below(3) != 0) invert(cuff.across, file.net.surface);
       }},
      {"across changed", [](PantsDocument& file, Random& r) { change_word(r.of(file.cuffs).across, file.net, r); }},
      {"across around a cuff, true if it is this one",
       [](PantsDocument& file, Random& r) {
         PantsDocument::Cuff& cuff = r.of(file.cuffs);
         const std::uint32_t k = r.below(2) == 0 ? cuff.ends[0][1] : r.below(3);
         Word across = path_of(file, {cuff.ends[0][0], k});
         append(across, cuff.across);
         cuff.across = std::move(across);
       }},
      {"length", [](PantsDocument& file, Random& r) { change_length(end(r.of(file.cuffs).length, r), r); }},
      {"length of the next numbers, or twice",
       [](PantsDocument& file, Random& r) {
         certify::Interval& length = r.of(file.cuffs).length;
         const double by = r.sign() * 1e9;
         const bool twice = r.below(3) == 0;
         for (double* x : {&length.lower, &length.upper}) *x = twice ? 2 * *x : std::nextafter(*x, by);
       }},
      {"lengths exchanged",
       [](PantsDocument& file, Random& r) { std::swap(r.of(file.cuffs).length, r.of(file.cuffs).length); }},
      {"twist", [](PantsDocument& file, Random& r) { change_length(end(r.of(file.cuffs).twist, r), r); }},
      {"twist of the next numbers",
       [](PantsDocument& file, Random& r) {
         certify::Interval& twist = r.of(file.cuffs).twist;
         const double by = r.sign() * 1e9;
         for (double* x : {&twist.lower, &twist.upper}) *x = std::nextafter(*x, by);
       }},
      {"twist to the other side",
       [](PantsDocument& file, Random& r) {
         certify::Interval& twist = r.of(file.cuffs).twist;
         twist = {-twist.upper, -twist.lower};
       }},
      {"twist and lengths, still true; or a half of one",
       [](PantsDocument& file, Random& r) {
         const double lengths = r.sign() * r.below(1U << r.below(20));
         add_to_twist(r.of(file.cuffs), r.below(3) == 0 ? lengths + 0.5 : lengths);
       }},
      {"exact length",
       [](PantsDocument& file, Random& r) {
         mpq_class& root = r.of(file.cuffs).exp_half_length;
         switch (r.below(4)) {
           case 0:
             root = 0;
             break;
           case 1:
             root *= mpq_class(root);
             break;
           case 2:
             if (root == 0) root = mpq_class(7, 4);
             root += some_step(r);
             break;
           default:
             root = r.of(file.cuffs).exp_half_length;
         }
       }},
  };
  return all;
}

void change_text(std::string& text, Random& r) {
  if (text.empty()) throw NothingToChange{};
  const std::uint32_t at = r.below(text.size());
  /// The number, or the number in quotes, that begins at or after the place.
  const auto number = [&] {
    std::size_t begin = at;
    while (begin < text.size() && std::isdigit(static_cast<unsigned char>(text[begin])) == 0) ++begin;
    std::size_t end = begin;
    while (end < text.size() && std::string_view("0123456789.eE+-/").find(text[end]) != std::string_view::npos) ++end;
    if (begin == end) throw NothingToChange{};
    if (begin > 0 && text[begin - 1] == '-') --begin;
    return std::pair(begin, end - begin);
  };
  switch (r.below(10)) {
    case 0:
      text.erase(at, 1);
      break;
    case 1: {
      constexpr std::string_view kBytes("0123456789-+.eE,:[]{}\"\\/ \t\ntfn\0\xff\xc3u\0", 35);
      text[at] = kBytes[r.below(kBytes.size())];
      break;
    }
    case 2: {
      constexpr std::string_view kBytes("0123456789-+.eE,:[]{}\"\\/ \t\ntfn\0\xff\xc3u\0", 35);
      text.insert(at, 1, kBytes[r.below(kBytes.size())]);
      break;
    }
    case 3:
      if (at + 1 < text.size()) std::swap(text[at], text[at + 1]);
      break;
    case 4: {  // A digit is another one.
      std::size_t i = at;
      while (i < text.size() && std::isdigit(static_cast<unsigned char>(text[i])) == 0) ++i;
      if (i < text.size()) text[i] = static_cast<char>('0' + r.below(10));
      break;
    }
    case 5: {  // A number is that of another place.
      const auto [begin, size] = number();
      const std::string copy = text.substr(begin, size);
      const auto [other, other_size] = [&] {
        std::size_t i = r.below(text.size());
        while (i < text.size() && std::isdigit(static_cast<unsigned char>(text[i])) == 0) ++i;
        std::size_t end = i;
        while (end < text.size() && std::string_view("0123456789.eE+-/").find(text[end]) != std::string_view::npos)
          ++end;
        return std::pair(i, end - i);
      }();
      text.replace(other, other_size, copy);
      break;
    }
    case 6: {  // A number is written otherwise.
      const auto [begin, size] = number();
      const std::string old = text.substr(begin, size);
      const std::vector<std::string> forms{
          old + "e0",
          old + ".0",
          old + "0",
          "0" + old,
          "-" + old,
          old + "00000000000000000000",
          old + "/1",
          old + "E-0000",
          old + "e00001",
          "1" + old,
          old + "e-400",
          old + "e400",
          "4294967296",
          "18446744073709551616",
          "4294967295",
          old.find('.') == std::string::npos ? old + ".00000000000000000000" : old + "00000000000000000000"};
      text.replace(begin, size, forms[r.below(forms.size())]);
      break;
    }
    case 7: {  // A stretch is gone, or there twice.
      const std::size_t size = 1 + r.below(40);
      if (r.below(2) == 0) {
        text.erase(at, size);
      } else {
        text.insert(at, text.substr(at, size));
      }
      break;
    }
    case 8: {  // A row: from a comma to the next one in the same array.
      const std::size_t begin = text.find("],", at);
      if (begin == std::string::npos) throw NothingToChange{};
      const std::size_t end = text.find("],", begin + 2);
      if (end == std::string::npos) throw NothingToChange{};
      if (r.below(2) == 0) {
        text.erase(begin, end - begin);
      } else {
        text.insert(begin, text.substr(begin, end - begin));
      }
      break;
    }
    default: {  // A character as an escape, spaces: mostly the same document.
      const std::size_t quote = text.find('"', at);
      if (quote == std::string::npos || quote + 1 >= text.size()) throw NothingToChange{};
      const unsigned char c = static_cast<unsigned char>(text[quote + 1]);
      if (std::isalnum(c) == 0) {
        text.insert(quote, r.below(2) == 0 ? " \n\t" : "\f");
      } else {
        constexpr std::string_view kHex = "0123456789abcdef";
        text.replace(quote + 1, 1, {'\\', 'u', '0', '0', kHex[c / 16U], kHex[c % 16U]});
      }
    }
  }
}

}  // namespace epsnet::attack
