#include "netgen/lifts/info.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <sstream>

#include "certify/base/text.h"
#include "certify/net/numbering.h"
#include "kernel/plane.h"
#include "netgen/base/gmp.h"
#include "netgen/lifts/lifts.h"
#include "netgen/nets/refine.h"
#include "netgen/surfaces/exact_isometries.h"

namespace epsnet {
namespace {

/// Collects facts, each as a line of text with six significant digits ("%g", the stream's default) and as a member of a
/// JSON object.
class Gathered {
 public:
  template <class T>
  void add(const char* name, const char* key, const T& value) {
    line(name, value);
    json[key] = value;
  }
  /// Adds a line only.
  template <class T>
  void line(const char* name, const T& value) {
    text << name << ": " << value << '\n';
  }
  [[nodiscard]] Facts facts() const { return {text.str(), json}; }

  std::ostringstream text;
  Json json = Json::object();
};

/// Returns the number of decimal digits of |n|.
std::size_t digits(const mpz_class& n) {
  const std::string text = n.get_str();
  return text.size() - (text.front() == '-' ? 1 : 0);
}

/// Returns the number of digits of the numerator or denominator in lowest terms, whichever is longer.
std::size_t height(const Rational& q) {
  const mpq_class copy = to_gmp(q);
  return std::max(digits(copy.get_num()), digits(copy.get_den()));
}

double area(std::uint32_t genus) { return 4 * std::numbers::pi * (static_cast<double>(genus) - 1); }

/// The least, the greatest and the mean of values.
class Summary {
 public:
  void add(double x) {
    least_ = std::min(least_, x);
    greatest_ = std::max(greatest_, x);
    sum_ += x;
    ++count_;
  }
  [[nodiscard]] std::uint64_t count() const { return count_; }
  [[nodiscard]] double least() const { return least_; }
  [[nodiscard]] std::string text() const {
    if (count_ == 0) return "none";
    std::ostringstream out;
    out << least_ << " to " << greatest_ << ", mean " << sum_ / static_cast<double>(count_);
    return out.str();
  }
  /// Returns null if there are no values.
  [[nodiscard]] Json json() const {
    if (count_ == 0) return nullptr;
    return Json::object({{"min", least_}, {"max", greatest_}, {"mean", sum_ / static_cast<double>(count_)}});
  }

 private:
  double least_ = std::numeric_limits<double>::infinity();
  double greatest_ = -std::numeric_limits<double>::infinity();
  double sum_ = 0;
  std::uint64_t count_ = 0;
};

struct Measures {
  Summary edges;  ///< Between different vertices.
  Summary loops;  ///< From a vertex to itself.
  Summary circumradii;
  std::uint64_t identities = 0;       ///< Labels of corners 1 and 2 that are the identity.
  std::uint64_t plain_triangles = 0;  ///< Triangles whose labels are the identity.
};

/// Returns by triangle whether it is in a collar. Such triangles are as long as the collar, which is beyond binary64.
std::vector<bool> in_collars(const certify::NetDocument& net) {
  std::vector<bool> result(net.triangles.size());
  if (!net.collars) return result;
  for (const certify::NetDocument::Collar& collar : *net.collars) {
    for (const std::uint32_t t : collar.triangles) result[t] = true;
  }
  return result;
}

/// Edges are measured in triangles outside of collars; those between the two vertices of a collar are not measured.
Measures measure(const NetGeometry& geometry) {
  Measures result;
  const certify::NetDocument& net = geometry.document();
  const std::vector<bool> left_out = in_collars(net);
  for (std::uint32_t t = 0; t < net.triangles.size(); ++t) {
    const certify::NetDocument::Triangle& triangle = net.triangles[t];
    const auto identities = static_cast<std::uint64_t>(std::count(triangle.label.begin(), triangle.label.end(), 0U));
    result.identities += identities;
    result.plain_triangles += identities == 2 ? 1 : 0;
    if (left_out[t]) continue;
    const auto z = geometry.corners(t);
    for (std::uint32_t i = 0; i < 3; ++i) {
      const std::uint32_t j = (i + 1) % 3;
      if (triangle.opposite[i] < 3 * t + i && !left_out[triangle.opposite[i] / 3]) continue;
      (triangle.vertex[i] == triangle.vertex[j] ? result.loops : result.edges).add(distance(z[i], z[j]));
    }
    result.circumradii.add(geometry.circumradius(t));
  }
  return result;
}

std::string percent(std::uint64_t part, std::uint64_t whole) {
  if (whole == 0) return "none";
  std::ostringstream out;
  out.precision(4);
  out << 100 * static_cast<double>(part) / static_cast<double>(whole) << " %";
  return out.str();
}

void add_bounds(Gathered& out, std::size_t vertices, std::uint32_t genus, double epsilon) {
  const double least = least_vertices(genus, epsilon);
  const double most = most_vertices(genus, epsilon);
  const auto count = static_cast<double>(vertices);
  out.text << "lower bound (g-1)/sinh^2(epsilon/2): about " << least << " vertices, here " << count / least
           << " times that\n";
  out.text << "upper bound 16(g-1)/epsilon^2, if the systole is at least epsilon: about " << most << " vertices, here "
           << count / most << " times that\n";
  out.json["vertices_lower_bound"] = least;
  out.json["vertices_upper_bound"] = most;
}

void add_systole(Gathered& out, const Summary& loops, double epsilon) {
  const double shortest = loops.count() > 0 ? loops.least() : std::numeric_limits<double>::infinity();
  const double bound = systole_lower_bound(epsilon, shortest);
  out.text << "systole, if this net is verified (run certify): at least about " << bound;
  if (loops.count() > 0) out.text << ", at most about " << loops.least() << " (the shortest loop)";
  out.text << '\n';
  out.json["systole_if_verified"] =
      Json::object({{"at_least", bound}, {"at_most", loops.count() > 0 ? Json(loops.least()) : Json(nullptr)}});
}

/// A pseudo net makes no claim about the points and loops in its collars.
void add_collars(Gathered& out, const std::vector<certify::NetDocument::Collar>& collars) {
  out.line("pseudo net, collars", collars.size());
  Json& list = out.json["collars"] = Json::array();
  for (const certify::NetDocument::Collar& collar : collars) {
    const certify::Interval length{collar.length[0], collar.length[1]};
    out.text << "collar at vertices " << collar.vertices[0] << ", " << collar.vertices[1] << ": core of length in "
             << to_string(length) << ", " << collar.core.size() << " letters\n";
    list.push_back(
        Json::object({{"vertices", collar.vertices}, {"core_length", interval_json(length)}, {"core", collar.core}}));
  }
}

}  // namespace

namespace {

/// Returns a text of the file on one line, so that it cannot look like further lines of the report.
std::string shortened(const std::string& text) {
  constexpr std::size_t kShown = 200;
  std::string result = text.size() <= kShown ? text : text.substr(0, kShown) + "...";
  for (char& c : result) c = static_cast<unsigned char>(c) < 32 || c == 127 ? '?' : c;
  return result;
}

}  // namespace

Facts surface_info(const Surface& surface, const std::string& kind) {
  Gathered out;
  out.add("file", "file", kind);
  out.add("genus", "genus", surface.genus());
  out.add("area 4 pi (g-1)", "area", area(surface.genus()));
  if (!surface.about().empty()) {
    out.line("about", shortened(surface.about()));
    out.json["about"] = surface.about();
  }
  out.add("tiles", "tiles", surface.tiles().size());
  out.add("sides", "sides", surface.side_count());
  out.add("vertices", "vertices", surface.vertex_class_count());
  if (surface.is_regular_polygon()) {
    out.line("kind", "the regular " + std::to_string(surface.side_count()) + "-gon");
  } else if (const auto& regular = surface.regular_tile()) {
    out.line("kind", "a map of type {" + std::to_string(regular->p) + ", " + std::to_string(regular->q) + "}");
    out.json["type"] = {regular->p, regular->q};
  }
  if (const auto& tiles = surface.field_tiles()) {
    out.line("kind", "over a number field of degree " + std::to_string(tiles->field.degree()));
    out.json["field_degree"] = tiles->field.degree();
  }
  out.json["regular"] = surface.is_regular();
  std::size_t longest = 0;
  std::size_t total = 0;
  double perimeter = 0;
  Summary sides;
  for (const Tile& tile : surface.tiles()) {
    for (std::size_t k = 0; k < tile.size(); ++k) {
      for (const Rational& coordinate : {tile[k].x, tile[k].y}) {
        longest = std::max(longest, height(coordinate));
        total += height(coordinate);
      }
      // Beyond binary64: vertices may be closer to the circle, or to each other, than it can resolve.
      const auto length =
          static_cast<double>(distance(convert<Mp256>(tile[k]), convert<Mp256>(tile[(k + 1) % tile.size()])));
      sides.add(length);
      perimeter += length;
    }
  }
  const std::size_t mean = total / 2 / surface.side_count();
  out.line("height of the coordinates",
           !surface.is_rational() ? "algebraic, not rational"
                                  : "up to " + std::to_string(longest) + " digits, mean " + std::to_string(mean));
  if (surface.is_rational()) out.json["digits"] = Json::object({{"max", longest}, {"mean", mean}});
  out.line("side lengths", sides.text());
  out.json["side_lengths"] = sides.json();
  out.add("perimeter of all tiles", "perimeter", perimeter);
  return out.facts();
}

Facts net_info(const certify::NetDocument& net) {
  const NetGeometry geometry(net);
  const Measures measures = measure(geometry);
  const double epsilon = geometry.epsilon().get_d();
  Gathered out;
  out.line("file", "net (not verified here: run certify)");
  out.json["file"] = net.collars ? "pseudo net" : "net";
  out.line("epsilon", geometry.epsilon_text());
  out.json["epsilon"] = net.epsilon;
  out.add("genus", "genus", geometry.genus());
  out.add("area 4 pi (g-1)", "area", area(geometry.genus()));
  out.add("tiles", "tiles", geometry.sides().first.size());
  out.add("vertices", "vertices", net.vertices.size());
  out.add("edges", "edges", net.triangles.size() * 3 / 2);
  out.add("triangles", "triangles", net.triangles.size());
  if (!net.collars) add_bounds(out, net.vertices.size(), geometry.genus(), epsilon);
  out.add("charts", "charts", net.charts.size());
  out.add("labels", "labels", net.labels.size());
  std::size_t longest_word = 0;
  for (const certify::NetDocument::Label& label : net.labels) longest_word = std::max(longest_word, label.word.size());
  out.add("longest word", "longest_word", longest_word);
  out.line("identity labels", percent(measures.identities, 2 * net.triangles.size()));
  out.line("triangles without other labels", percent(measures.plain_triangles, net.triangles.size()));
  out.json["identity_labels"] = measures.identities;
  out.json["triangles_without_other_labels"] = measures.plain_triangles;
  out.line("edges between different vertices", measures.edges.text());
  out.json["edge_lengths"] = measures.edges.json();
  out.add("loop edges", "loops", measures.loops.count());
  if (measures.loops.count() > 0) out.line("loop lengths", measures.loops.text());
  out.json["loop_lengths"] = measures.loops.json();
  out.line("circumradii", measures.circumradii.text());
  out.json["circumradii"] = measures.circumradii.json();
  if (net.collars) {
    add_collars(out, *net.collars);
  } else {
    add_systole(out, measures.loops, epsilon);
  }
  return out.facts();
}

Facts dirichlet_info(const DirichletPolygon& polygon) {
  Summary distances;
  std::size_t longest_word = 0;
  for (const DirichletPolygon::Side& side : polygon.sides) {
    distances.add(side.distance);
    longest_word = std::max(longest_word, side.word.size());
  }
  double farthest = 0;
  for (const Complex<double>& z : polygon.vertices) {
    farthest = std::max(farthest, 2 * std::atanh(std::min(1.0, std::hypot(z.x, z.y))));
  }
  Gathered out;
  out.line("file", "Dirichlet domain");
  out.json["file"] = "dirichlet";
  out.add("sides", "sides", polygon.sides.size());
  out.add("ties", "ties", polygon.ties);
  out.line("distances of the sides from the base point", distances.text());
  out.json["side_distances"] = distances.json();
  out.add("distance of the farthest vertex", "farthest_vertex", farthest);
  out.add("longest word", "longest_word", longest_word);
  return out.facts();
}

}  // namespace epsnet
