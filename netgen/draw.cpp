#include "epsnet/netgen/draw.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <deque>
#include <map>
#include <queue>
#include <set>
#include <tuple>
#include <utility>

#include "epsnet/certify/text.h"
#include "epsnet/netgen/dirichlet.h"

namespace epsnet {
namespace {

using Point = Complex<double>;

constexpr std::uint32_t kNone = 0xffffffff;

// ---- Geodesics on paper ----

/// A place on paper in hundredths of a pixel, the resolution of the file.
struct Place {
  std::int64_t x;
  std::int64_t y;
  bool operator==(const Place&) const = default;
  bool operator<(const Place& other) const { return std::pair(x, y) < std::pair(other.x, other.y); }
};

/// The disk on paper: centre in the middle, y upwards.
class Paper {
 public:
  explicit Paper(std::uint32_t size) : radius_(0.485 * size), middle_(0.5 * size) {}

  [[nodiscard]] double radius() const { return radius_; }  ///< Of the disk, in pixels.
  [[nodiscard]] double middle() const { return middle_; }
  [[nodiscard]] Place place(const Point& z) const {
    return {std::llround(100 * (middle_ + radius_ * z.x)), std::llround(100 * (middle_ - radius_ * z.y))};
  }
  /// The length on paper of a small segment of hyperbolic length 1 at z.
  [[nodiscard]] double scale(const Point& z) const { return radius_ * std::max(0.0, 1 - norm(z)) / 2; }

 private:
  double radius_;
  double middle_;
};

/// The Euclidean radius of the geodesic through u and v, for |u|, |v| < 1; the sign says on which side of it 0 lies
/// (positive: left). 0 for a diameter.
double curvature(const Point& u, const Point& v) {
  // The centre c of a circle orthogonal to the unit circle has 2 Re(c̄z) = 1 + |z|² for its points z, and radius² = |c|²
  // − 1.
  const double twice_area = cross(u, v);
  const double a = 1 + norm(u);
  const double b = 1 + norm(v);
  // 2c·cross(u, v) = (a v − b u) turned by −90°; so with w = a v − b u, radius² = (|w|² − 4 cross²)/(4 cross²).
  const double rest = norm(a * v - b * u) - 4 * twice_area * twice_area;
  if (!(rest > 0)) return 0;
  return 2 * twice_area / std::sqrt(rest);
}

/// Writes x/100 without trailing zeros.
void append_hundredths(std::string& out, std::int64_t x) {
  if (x < 0) out += '-';
  const std::int64_t a = std::abs(x);
  const std::int64_t rest = a % 100;
  if (a >= 100 || rest == 0) out += std::to_string(a / 100);
  if (rest == 0) return;
  out += '.';
  out += static_cast<char>('0' + rest / 10);
  if (rest % 10 != 0) out += static_cast<char>('0' + rest % 10);
}

/// A number with a space in front unless a sign separates it already.
void append_separated(std::string& out, std::int64_t x) {
  if (x >= 0) out += ' ';
  append_hundredths(out, x);
}

std::string fixed(double x, int digits) {
  std::array<char, 64> buffer;
  const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), x, std::chars_format::fixed, digits);
  return {buffer.data(), result.ptr};
}

/// The data of an SVG path, in relative coordinates from rounded place to rounded place, so that rounding does not add
/// up.
class Path {
 public:
  explicit Path(const Paper& paper) : paper_(&paper) {}

  void move(const Point& z) {
    const Place place = paper_->place(z);
    if (!data_.empty() && place == last_) return;
    append('m', place);
  }

  /// The geodesic from u to v; the pen is at u.
  void geodesic(const Point& u, const Point& v) {
    const Place place = paper_->place(v);
    if (place == last_) return;
    const double k = curvature(u, v);
    const double chord = paper_->radius() * std::sqrt(norm(v - u));
    const double radius = paper_->radius() / std::abs(k);  // Infinite for a diameter.
    // The arc is chord²/(8 radius) away from the chord.
    if (chord * chord <= 8 * 0.01 * radius) {
      append('l', place);
      return;
    }
    data_ += 'a';
    const auto r = std::llround(100 * radius);
    append_hundredths(data_, r);
    append_separated(data_, r);
    // With 0 on the left (k > 0) the arc bends to the left on its way, and paper has y downwards: that is sweep 1.
    data_ += k > 0 ? " 0 0 1" : " 0 0 0";
    command_ = 'a';
    append('a', place);
  }

  void dot(const Point& z) {
    move(z);
    data_ += "h0";
    command_ = 'h';
  }
  void close() {
    data_ += 'z';
    command_ = 'z';
  }

  [[nodiscard]] const std::string& data() const { return data_; }

 private:
  /// The command and the way to the place; the letter is left out where it goes without saying: a line after a line or
  /// a move.
  void append(char command, const Place& place) {
    if (command == command_ || (command == 'l' && command_ == 'm')) {
      append_separated(data_, place.x - last_.x);
    } else {
      data_ += command;
      append_hundredths(data_, place.x - last_.x);
    }
    append_separated(data_, place.y - last_.y);
    command_ = command;
    last_ = place;
  }

  const Paper* paper_;
  std::string data_;
  char command_ = 'z';
  Place last_{};  ///< Where the pen is. The first move is from 0.
};

/// Paths in classes of stroke width: powers of ∜2, too fine to see, the widest first.
class PathsByWidth {
 public:
  PathsByWidth(const Paper& paper, double widest) : paper_(&paper), widest_(widest) {}

  /// The path for strokes of a share, at most 1, of the greatest width. Strokes of less than a twentieth of a pixel
  /// vanish in some renderers, which shows as an edge in the shading of fine nets; that is the least.
  Path& at(double share) {
    const double least = std::min(1.0, 0.05 / widest_);
    const auto rank = static_cast<int>(std::lround(-4 * std::log2(std::clamp(share, least, 1.0))));
    return paths_.try_emplace(rank, *paper_).first->second;
  }

  void append_to(std::string& out) const {
    for (const auto& [rank, path] : paths_)
      out +=
          "<path stroke-width=\"" + fixed(widest_ * std::pow(2, -0.25 * rank), 3) + "\" d=\"" + path.data() + "\"/>\n";
  }

 private:
  const Paper* paper_;
  double widest_;
  std::map<int, Path> paths_;
};

// ---- The picture ----

class Picture {
 public:
  Picture(const certify::Document& document, const DrawOptions& options)
      : document_(document),
        geometry_(document),
        options_(options),
        paper_(options.size),
        lifts_(lift_triangles(geometry_, options.order, options.centre)),
        on_boundary_(boundary_darts(geometry_, lifts_)) {
    // Edges of a net are about 1.4 ε long. Strokes must leave the triangles of fine nets white.
    const double epsilon = certify::parse_decimal(document.epsilon).value_or(mpq_class(1)).get_d();
    epsilon_text_ = document.epsilon.size() <= 40 ? document.epsilon : certify::shortest(epsilon);
    const double edge = 1.4 * epsilon * paper_.scale({});
    const double unit = options.size / 1000.0;
    edge_width_ = std::clamp(0.03 * edge, 0.08 * unit, 1.2 * unit);
    dot_width_ = std::clamp(0.09 * edge, 0.2 * unit, 6.0 * unit);
    outline_width_ = 1.6 * unit;
  }

  [[nodiscard]] std::string svg() {
    std::string dirichlet;
    if (options_.dirichlet) dirichlet = dirichlet_group();
    const std::string fill = domain_path();
    const std::string edges = edge_group();
    const std::string dots = dot_group();
    return head() + fill + edges + dirichlet + dots + "</svg>\n";
  }

 private:
  [[nodiscard]] const Lifts::LiftedTriangle& lifted(std::uint32_t dart) const {
    return lifts_.lifted[lifts_.place[dart / 3]];
  }
  [[nodiscard]] const Point& start(std::uint32_t dart) const { return lifted(dart).corner[dart % 3]; }
  [[nodiscard]] const Point& end(std::uint32_t dart) const {
    return lifted(dart).corner[(dart + 1 - dart / 3 * 3) % 3];
  }
  [[nodiscard]] std::uint32_t opposite(std::uint32_t dart) const {
    return document_.triangles[dart / 3].opposite[dart % 3];
  }

  /// The boundary dart that follows a boundary dart around the drawing: turn around its end, inside of the drawing.
  [[nodiscard]] std::uint32_t next_on_boundary(std::uint32_t dart) const {
    std::uint32_t next = dart_after(dart);
    for (std::size_t turns = 0; !on_boundary_[next]; ++turns) {
      if (turns > on_boundary_.size()) throw NetGeometryError("the triangles do not fit around a vertex");
      next = dart_after(opposite(next));
    }
    return next;
  }

  /// The drawn domain as an area. Its outline runs with the interior on the left, holes the other way round.
  [[nodiscard]] std::string domain_path() const {
    Path path(paper_);
    std::vector<bool> done(on_boundary_.size(), false);
    for (std::uint32_t first = 0; first < on_boundary_.size(); ++first) {
      if (!on_boundary_[first] || done[first]) continue;
      path.move(start(first));
      for (std::uint32_t dart = first; !done[dart]; dart = next_on_boundary(dart)) {
        done[dart] = true;
        path.geodesic(start(dart), end(dart));
      }
      path.close();
    }
    return "<path class=\"domain\" fill=\"#eef2f7\" d=\"" + path.data() + "\"/>\n";
  }

  /// Adds the geodesic from u to v to the paths, in pieces if it is so long that its stroke has to taper. False if it
  /// is too small to see.
  bool add_tapered(PathsByWidth& paths, const Point& u, const Point& v) const {
    const double chord = std::sqrt(norm(v - u));
    if (chord * paper_.radius() < 0.1) return false;
    // Along a geodesic the scale changes by at most e^length.
    const double length = 2 * std::asinh(chord / std::sqrt(std::max(1e-30, (1 - norm(u)) * (1 - norm(v)))));
    const int pieces = std::clamp(static_cast<int>(std::ceil(length / 0.8)), 1, 64);
    // The geodesic seen from u is a straight line.
    const Isometry<double> to_u = Isometry<double>::translation(u);
    const Point direction = inverse(to_u)(v);
    const double reach = std::sqrt(norm(direction));
    Point from = u;
    for (int i = 1; i <= pieces; ++i) {
      const Point to = i == pieces ? v : to_u(std::tanh(length * i / (2.0 * pieces)) / reach * direction);
      const Point middle = 0.5 * (from + to);
      Path& path = paths.at(1 - norm(middle));
      path.move(from);
      path.geodesic(from, to);
      from = to;
    }
    return true;
  }

  /// An edge of the same kind, on the boundary or not, that leaves the end of a dart and is not done; kNone if none was
  /// found.
  [[nodiscard]] std::uint32_t unfinished_edge_at_end(std::uint32_t dart, const std::vector<bool>& done) const {
    std::uint32_t next = dart_after(dart);
    for (int turns = 0; turns < 32; ++turns) {
      if (on_boundary_[next] == on_boundary_[dart] && !done[next]) return next;
      if (on_boundary_[next]) return kNone;
      next = dart_after(opposite(next));
    }
    return kNone;
  }

  [[nodiscard]] std::string edge_group() {
    PathsByWidth inner(paper_, edge_width_);
    PathsByWidth outline(paper_, std::min(1.8 * edge_width_, outline_width_));
    std::vector<bool> done(on_boundary_.size(), false);
    for (const Lifts::LiftedTriangle& triangle : lifts_.lifted) {
      for (std::uint32_t first = 3 * triangle.triangle; first < 3 * triangle.triangle + 3; ++first) {
        // As long a line as possible without lifting the pen makes a short file.
        for (std::uint32_t dart = first; dart != kNone && !done[dart]; dart = unfinished_edge_at_end(dart, done)) {
          done[dart] = true;
          if (!on_boundary_[dart]) done[opposite(dart)] = true;
          if (!add_tapered(on_boundary_[dart] ? outline : inner, start(dart), end(dart))) ++edges_left_out_;
        }
      }
    }
    std::string out =
        "<g class=\"edges\" fill=\"none\" stroke=\"#33475b\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n";
    inner.append_to(out);
    out +=
        "</g>\n<g class=\"outline\" fill=\"none\" stroke=\"#1d2b3a\" stroke-linecap=\"round\" "
        "stroke-linejoin=\"round\">\n";
    outline.append_to(out);
    return out + "</g>\n";
  }

  [[nodiscard]] std::string dot_group() {
    PathsByWidth dots(paper_, dot_width_);
    PathsByWidth base(paper_, std::max(1.6 * dot_width_, 0.004 * options_.size));
    std::set<Place> drawn;
    for (const Lifts::LiftedTriangle& triangle : lifts_.lifted) {
      for (std::uint32_t i = 0; i < 3; ++i) {
        const Point& z = triangle.corner[i];
        const double share = std::max(0.0, 1 - norm(z));
        if (dot_width_ * share < 0.1 || !drawn.insert(paper_.place(z)).second) continue;
        const bool is_base = document_.triangles[triangle.triangle].vertex[i] == 0;
        (is_base ? base : dots).at(share).dot(z);
      }
    }
    std::string out = "<g class=\"vertices\" fill=\"none\" stroke=\"#10202f\" stroke-linecap=\"round\">\n";
    dots.append_to(out);
    out += "</g>\n<g class=\"base-vertex\" fill=\"none\" stroke=\"#b5442e\" stroke-linecap=\"round\">\n";
    base.append_to(out);
    return out + "</g>\n";
  }

  [[nodiscard]] std::string dirichlet_group() const {
    const DirichletDomain domain = dirichlet_domain(geometry_, 0);
    PathsByWidth paths(paper_, 1.4 * outline_width_);
    for (std::size_t i = 0; i < domain.vertices.size(); ++i)
      add_tapered(paths, domain.vertices[i], domain.vertices[(i + 1) % domain.vertices.size()]);
    std::string out =
        "<g class=\"dirichlet\" fill=\"none\" stroke=\"#c8553d\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n"
        "<title>Dirichlet domain of vertex 0</title>\n";
    paths.append_to(out);
    return out + "</g>\n";
  }

  [[nodiscard]] std::string head() const {
    const std::string size = std::to_string(options_.size);
    const std::string middle = fixed(paper_.middle(), 1);
    const std::string what = "Delaunay triangulation with " + std::to_string(document_.vertices.size()) +
                             " vertices and " + std::to_string(document_.triangles.size()) + " triangles, epsilon " +
                             epsilon_text_;
    std::string desc = "One lift of every triangle in the Poincare disk, connected, by " +
                       std::string(options_.order == DrawOrder::weight ? "least weight |u|^2+|v|^2 of the edge crossed"
                                                                       : "breadth-first search") +
                       ", with vertex 0 in the centre. Edges are geodesics.";
    if (options_.dirichlet) desc += " Red: the Dirichlet domain of vertex 0.";
    if (edges_left_out_ > 0)
      desc += " " + std::to_string(edges_left_out_) + " edges shorter than 0.1 pixel are left out.";
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + size + "\" height=\"" + size + "\" viewBox=\"0 0 " +
           size + " " + size + "\">\n<title>" + what + "</title>\n<desc>" + desc +
           "</desc>\n<circle class=\"disk\" cx=\"" + middle + "\" cy=\"" + middle + "\" r=\"" +
           fixed(paper_.radius(), 2) + "\" fill=\"#fff\" stroke=\"#8a94a0\" stroke-width=\"" +
           fixed(0.8 * options_.size / 1000, 2) + "\"/>\n";
  }

  const certify::Document& document_;
  NetGeometry geometry_;
  DrawOptions options_;
  Paper paper_;
  Lifts lifts_;
  std::string epsilon_text_;
  std::vector<bool> on_boundary_;  ///< By dart.
  double edge_width_ = 0;          ///< In pixels, in the centre.
  double dot_width_ = 0;
  double outline_width_ = 0;
  std::uint64_t edges_left_out_ = 0;
};

}  // namespace

std::string draw_svg(const certify::Document& document, const DrawOptions& options) {
  return Picture(document, options).svg();
}

}  // namespace epsnet
