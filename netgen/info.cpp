#include "epsnet/netgen/info.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <sstream>

#include "epsnet/certify/text.h"
#include "epsnet/kernel/plane.h"
#include "epsnet/netgen/gmp.h"
#include "epsnet/netgen/net_geometry.h"

namespace epsnet {
namespace {

/// Six significant digits, "%g", which is the stream's default.
template <class T>
void line(std::ostringstream& out, const char* name, const T& value) {
  out << name << ": " << value << '\n';
}

/// The number of decimal digits of |n|.
std::size_t digits(const mpz_class& n) {
  const std::string text = n.get_str();
  return text.size() - (text.front() == '-' ? 1 : 0);
}

/// The height of a rational number in digits: those of the longer of numerator and denominator, in lowest terms.
std::size_t height(const Rational& q) {
  const mpq_class copy = to_gmp(q);
  return std::max(digits(copy.get_num()), digits(copy.get_den()));
}

double area(std::uint32_t genus) { return 4 * std::numbers::pi * (static_cast<double>(genus) - 1); }

/// Least, greatest and mean of values.
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
  std::uint64_t identities = 0;       ///< Of the labels of all corners 1 and 2.
  std::uint64_t plain_triangles = 0;  ///< With no other label than the identity.
};

/// By triangle: whether it is one of a collar. These are as long as the collar, beyond binary64.
std::vector<bool> in_collars(const certify::Document& net) {
  std::vector<bool> result(net.triangles.size());
  if (!net.collars) return result;
  for (const certify::Collar& collar : *net.collars) {
    for (const std::uint32_t t : collar.triangles) result[t] = true;
  }
  return result;
}

/// Edges are measured in a triangle outside of collars, those between the two vertices of a collar not at all.
Measures measure(const NetGeometry& geometry) {
  Measures result;
  const certify::Document& net = geometry.document();
  const std::vector<bool> left_out = in_collars(net);
  for (std::uint32_t t = 0; t < net.triangles.size(); ++t) {
    const certify::Triangle& triangle = net.triangles[t];
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

void add_bounds(std::ostringstream& out, std::size_t vertices, std::uint32_t genus, double epsilon) {
  const double least = least_vertices(genus, epsilon);
  const double most = most_vertices(genus, epsilon);
  const auto count = static_cast<double>(vertices);
  out << "lower bound (g-1)/sinh^2(epsilon/2): " << least << " vertices, here " << count / least << " times that\n";
  out << "upper bound 16(g-1)/epsilon^2, if the systole is at least epsilon: " << most << " vertices, here "
      << count / most << " times that\n";
}

void add_systole(std::ostringstream& out, const Summary& loops, double epsilon) {
  const double shortest = loops.count() > 0 ? loops.least() : std::numeric_limits<double>::infinity();
  out << "systole, if this net is verified (run certify): at least " << systole_lower_bound(epsilon, shortest);
  if (loops.count() > 0) out << ", at most " << loops.least() << " (the shortest loop)";
  out << '\n';
}

/// A pseudo net says nothing of the points and loops in its collars.
void add_collars(std::ostringstream& out, const std::vector<certify::Collar>& collars) {
  line(out, "pseudo net, collars", collars.size());
  for (const certify::Collar& collar : collars) {
    out << "collar at vertices " << collar.vertices[0] << ", " << collar.vertices[1] << ": core of length "
        << collar.length[0] << ", " << collar.core.size() << " letters\n";
  }
}

}  // namespace

double least_vertices(std::uint32_t genus, double epsilon) {
  const double s = std::sinh(epsilon / 2);
  return (static_cast<double>(genus) - 1) / (s * s);
}

double most_vertices(std::uint32_t genus, double epsilon) {
  return 16 * (static_cast<double>(genus) - 1) / (epsilon * epsilon);
}

double systole_lower_bound(double epsilon, double shortest_loop) {
  // Ratios, as sinh and cosh of a large ε overflow: sinh(ε/2)/cosh ε < 1.
  const double at_thin_loops = std::numbers::sqrt2 * std::sinh(epsilon / 2);
  const double at_loops =
      std::isinf(shortest_loop) ? at_thin_loops : std::min(at_thin_loops, std::sinh(shortest_loop / 2));
  const double bound = 2 * std::asinh(at_loops / std::cosh(epsilon));
  return std::isfinite(bound) ? bound : 0;
}

namespace {

std::string shortened(const std::string& text) {
  constexpr std::size_t kShown = 200;
  return text.size() <= kShown ? text : text.substr(0, kShown) + "...";
}

}  // namespace

std::string surface_info(const Surface& surface) {
  std::ostringstream out;
  line(out, "file", "surface");
  line(out, "genus", surface.genus());
  line(out, "area 4 pi (g-1)", area(surface.genus()));
  if (!surface.about().empty()) line(out, "about", shortened(surface.about()));
  line(out, "tiles", surface.tiles().size());
  line(out, "sides", surface.side_count());
  line(out, "vertices", surface.vertex_class_count());
  if (surface.is_regular()) line(out, "kind", "the regular " + std::to_string(surface.side_count()) + "-gon");
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
      // Beyond binary64: vertices may be closer to the circle, or to each other, than it can tell.
      const auto length =
          static_cast<double>(distance(convert<Mp256>(tile[k]), convert<Mp256>(tile[(k + 1) % tile.size()])));
      sides.add(length);
      perimeter += length;
    }
  }
  line(out, "height of the coordinates",
       surface.is_regular()
           ? "algebraic, not rational"
           : "up to " + std::to_string(longest) + " digits, mean " + std::to_string(total / 2 / surface.side_count()));
  line(out, "side lengths", sides.text());
  line(out, "perimeter of all tiles", perimeter);
  return out.str();
}

std::string net_info(const certify::Document& net) {
  const NetGeometry geometry(net);
  const Measures measures = measure(geometry);
  const double epsilon = geometry.epsilon().get_d();
  const SideTable& sides = geometry.sides();
  std::ostringstream out;
  line(out, "file", "net (not verified here: run certify)");
  line(out, "epsilon", geometry.epsilon_text());
  line(out, "genus", sides.genus);
  line(out, "area 4 pi (g-1)", area(sides.genus));
  line(out, "tiles", sides.first_side.size() - 1);
  line(out, "vertices", net.vertices.size());
  line(out, "edges", net.triangles.size() * 3 / 2);
  line(out, "triangles", net.triangles.size());
  if (!net.collars) add_bounds(out, net.vertices.size(), sides.genus, epsilon);
  line(out, "charts", net.charts.size());
  line(out, "labels", net.labels.size());
  std::size_t longest_word = 0;
  for (const certify::Label& label : net.labels) longest_word = std::max(longest_word, label.word.size());
  line(out, "longest word", longest_word);
  line(out, "identity labels", percent(measures.identities, 2 * net.triangles.size()));
  line(out, "triangles without other labels", percent(measures.plain_triangles, net.triangles.size()));
  line(out, "edges between different vertices", measures.edges.text());
  line(out, "loop edges", measures.loops.count());
  if (measures.loops.count() > 0) line(out, "loop lengths", measures.loops.text());
  line(out, "circumradii", measures.circumradii.text());
  if (net.collars) {
    add_collars(out, *net.collars);
  } else {
    add_systole(out, measures.loops, epsilon);
  }
  return out.str();
}

}  // namespace epsnet
