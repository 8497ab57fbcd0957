#include "netgen/pictures/draw.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <map>
#include <set>
#include <utility>

#include "netgen/pictures/dirichlet.h"
#include "netgen/pictures/palette.h"

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

  /// The hyperbolic circle of a radius about z, a Euclidean one. Nothing if it is smaller than a fifth of a pixel.
  void circle(const Point& z, double radius) {
    const double t = std::tanh(radius / 2);
    const double scale = 1 / (1 - t * t * norm(z));
    const auto r = std::llround(100 * paper_->radius() * t * (1 - norm(z)) * scale);
    if (r < 10) return;
    Place left = paper_->place((1 - t * t) * scale * z);
    left.x -= r;
    append('m', left);
    for (const std::int64_t way : {2 * r, -2 * r}) {
      data_ += 'a';
      append_hundredths(data_, r);
      append_separated(data_, r);
      data_ += " 0 1 0";
      command_ = 'a';
      append('a', {left.x + (way > 0 ? way : 0), left.y});
    }
    close();
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

/// From pale yellow, at 0, to blue, at 1, in 24 steps: few colours make a short file.
std::string shade(double share) {
  constexpr int kSteps = 24;
  constexpr std::array<std::array<double, 3>, 4> kStops{
      {{255, 252, 224}, {199, 227, 201}, {111, 178, 205}, {44, 99, 164}}};
  const double s = 3 * (std::floor(std::clamp(share, 0.0, 0.999) * kSteps) + 0.5) / kSteps;
  const auto stop = static_cast<std::size_t>(s);
  std::string out = "#";
  for (std::size_t i = 0; i < 3; ++i) {
    const double from = kStops[stop][i];
    const auto value = static_cast<unsigned>(std::lround(from + (s - std::floor(s)) * (kStops[stop + 1][i] - from)));
    out += "0123456789abcdef"[value / 16];
    out += "0123456789abcdef"[value % 16];
  }
  return out;
}

/// The golden angle keeps the hues of neighbouring numbers apart.
std::string chart_colour(std::uint32_t chart) {
  return "hsl(" + fixed(std::fmod(chart * 137.508, 360), 0) + ",45%,85%)";
}

/// Text between the tags of XML.
std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '<') {
      out += "&lt;";
    } else if (c == '&') {
      out += "&amp;";
    } else if (static_cast<unsigned char>(c) >= 32) {
      out += c;
    }
  }
  return out;
}

/// How a legend shows what a name stands for.
enum class Mark { area, line, dot };

/// Rows of marks and names in the upper left corner, which the disk leaves free; names have a margin of white, so that
/// they can be read on anything.
class Legend {
 public:
  explicit Legend(double unit) : unit_(unit) {}

  void add(Mark mark, const std::string& colour, const std::string& name) {
    next_row();
    add_mark(mark, colour, 10);
    add_text(name, 27);
  }

  /// Several areas with short names to a row.
  void add_areas(const std::vector<std::pair<std::string, std::string>>& colours_and_names) {
    constexpr std::size_t kPerRow = 4;
    for (std::size_t i = 0; i < colours_and_names.size(); ++i) {
      const double x = 10 + 38.0 * static_cast<double>(i % kPerRow);
      if (i % kPerRow == 0) next_row();
      add_mark(Mark::area, colours_and_names[i].first, x);
      add_text(colours_and_names[i].second, x + 14);
    }
  }

  void add_text_row(const std::string& text) {
    next_row();
    add_text(text, 10);
  }

  [[nodiscard]] std::string group() const {
    return "<g class=\"legend\">\n" + marks_ + "<g font-family=\"sans-serif\" font-size=\"" + length(12) +
           "\" fill=\"#1d2b3a\" stroke=\"" + palette::kPaper + "\" stroke-width=\"" + length(3) +
           "\" stroke-linejoin=\"round\" paint-order=\"stroke\">\n" + texts_ + "</g>\n</g>\n";
  }

 private:
  [[nodiscard]] std::string length(double units) const { return fixed(units * unit_, 1); }

  void next_row() { y_ += 18; }

  void add_text(const std::string& text, double x) {
    texts_ += "<text x=\"" + length(x) + "\" y=\"" + length(y_) + "\">" + escaped(text) + "</text>\n";
  }

  void add_mark(Mark mark, const std::string& colour, double x) {
    if (mark == Mark::area) {
      marks_ += "<rect x=\"" + length(x) + "\" y=\"" + length(y_ - 9) + "\" width=\"" + length(11) + "\" height=\"" +
                length(11) + "\" fill=\"" + colour + "\"/>\n";
    } else if (mark == Mark::line) {
      marks_ += "<path stroke=\"" + colour + "\" stroke-width=\"" + length(2.5) + "\" d=\"M" + length(x) + ' ' +
                length(y_ - 4) + 'h' + length(11) + "\"/>\n";
    } else {
      marks_ += "<circle cx=\"" + length(x + 5.5) + "\" cy=\"" + length(y_ - 4) + "\" r=\"" + length(4) + "\" fill=\"" +
                colour + "\"/>\n";
    }
  }

  double unit_;
  double y_ = 0;
  std::string marks_;
  std::string texts_;
};

/// What a legend calls a layer: of closed geodesics also their number and lengths.
std::string legend_name(const Layer& layer) {
  if (layer.parts.empty()) return layer.name;
  double shortest = layer.parts[0].length;
  double longest = shortest;
  for (const Layer::Part& part : layer.parts) {
    shortest = std::min(shortest, part.length);
    longest = std::max(longest, part.length);
  }
  // Four digits tell lengths apart that are not of one cluster, and hide that equal ones are rounded.
  const std::string from = fixed(shortest, 4);
  const std::string to = fixed(longest, 4);
  return layer.name + ": " + std::to_string(layer.parts.size()) +
         (from == to ? " of length " + from : " of lengths " + from + " to " + to);
}

class Picture {
 public:
  Picture(const certify::NetDocument& document, const DrawOptions& options)
      : document_(document),
        geometry_(document),
        options_(options),
        paper_(options.size),
        lifts_(lift_triangles(geometry_, options.order, options.centre)),
        epsilon_(geometry_.epsilon().get_d()),
        on_boundary_(boundary_darts(geometry_, lifts_)) {
    // Edges of a net are about 1.4 ε long. Strokes must leave the triangles of fine nets white.
    const double edge = 1.4 * epsilon_ * paper_.scale({});
    const double unit = options.size / 1000.0;
    edge_width_ = std::clamp(0.03 * edge, 0.08 * unit, 1.2 * unit);
    dot_width_ = std::clamp(0.09 * edge, 0.2 * unit, 6.0 * unit);
    outline_width_ = 1.6 * unit;
  }

  [[nodiscard]] std::string svg() {
    std::string body = domain_path();
    if (options_.colouring != Colouring::none) body += colour_group();
    if (options_.covering_disks)
      body += disk_group("covering", "disks of radius epsilon", palette::kCoveringDisks, epsilon_);
    if (options_.packing_disks)
      body += disk_group("packing", "disks of radius epsilon/2", palette::kPackingDisks, epsilon_ / 2);
    for (const Layer& layer : options_.layers) body += area_group(layer);
    if (options_.triangles) body += edge_group();
    if (options_.combinatorial_dirichlet) body += combinatorial_dirichlet_path();
    for (const Layer& layer : options_.layers) body += curve_group(layer);
    if (options_.dirichlet) body += dirichlet_group();
    if (options_.vertices) body += dot_group();
    if (options_.legend) body += legend_group();
    return head() + body + "</svg>\n";
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
    return "<path class=\"domain\" fill=\"#eef2f7\" d=\"" + outline() + "\"/>\n";
  }

  [[nodiscard]] std::string outline() const {
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
    return path.data();
  }

  /// The outline of the same triangles lifted breadth first.
  [[nodiscard]] std::string combinatorial_dirichlet_path() const {
    DrawOptions options = options_;
    options.order = DrawOrder::breadth_first;
    const std::string data =
        options_.order == DrawOrder::breadth_first ? outline() : Picture(document_, options).outline();
    return std::string("<path class=\"combinatorial-dirichlet\" fill=\"none\" stroke=\"") +
           palette::kCombinatorialDirichlet + "\" stroke-width=\"" + fixed(outline_width_, 3) + "\" d=\"" + data +
           "\"/>\n";
  }

  void add_triangle(Path& path, const Lifts::LiftedTriangle& triangle) const {
    const auto& [a, b, c] = triangle.corner;
    path.move(a);
    path.geodesic(a, b);
    path.geodesic(b, c);
    path.geodesic(c, a);
    path.close();
  }

  [[nodiscard]] bool is_visible(const Lifts::LiftedTriangle& triangle) const {
    const auto& [a, b, c] = triangle.corner;
    return std::max({norm(a - b), norm(b - c), norm(c - a)}) * paper_.radius() * paper_.radius() > 0.01;
  }

  [[nodiscard]] std::uint32_t chart_of(std::uint32_t triangle) const {
    return document_.vertices[document_.triangles[triangle].vertex[0]].chart;
  }

  [[nodiscard]] std::string colour_of(std::uint32_t triangle) const {
    if (options_.colouring == Colouring::chart) return chart_colour(chart_of(triangle));
    return shade(2 * geometry_.circumradius(triangle) / epsilon_ - 1);
  }

  /// Triangles of a colour are one path, with a hairline around it that covers the seams smoothing leaves.
  [[nodiscard]] std::string colour_group() const {
    std::map<std::string, Path> paths;
    for (const Lifts::LiftedTriangle& triangle : lifts_.lifted)
      if (is_visible(triangle))
        add_triangle(paths.try_emplace(colour_of(triangle.triangle), paper_).first->second, triangle);
    std::string out = "<g class=\"colours\" stroke-width=\"0.3\" stroke-linejoin=\"round\">\n";
    for (const auto& [colour, path] : paths)
      out += "<path fill=\"" + colour + "\" stroke=\"" + colour + "\" d=\"" + path.data() + "\"/>\n";
    return out + "</g>\n";
  }

  /// The disks around all drawn lifts of vertices, as one area.
  [[nodiscard]] std::string disk_group(const char* name, const char* title, const char* colour, double radius) const {
    std::set<Place> drawn;
    Path path(paper_);
    for (const Lifts::LiftedTriangle& triangle : lifts_.lifted)
      for (const Point& z : triangle.corner)
        if (drawn.insert(paper_.place(z)).second) path.circle(z, radius);
    return std::string("<path class=\"") + name + "\" fill=\"" + colour + "\" fill-opacity=\"0.15\" stroke=\"" +
           colour + "\" stroke-width=\"" + fixed(0.6 * edge_width_, 3) + "\" d=\"" + path.data() + "\"><title>" +
           title + "</title></path>\n";
  }

  [[nodiscard]] std::string area_group(const Layer& layer) const {
    if (layer.triangles.empty()) return "";
    Path path(paper_);
    for (const std::uint32_t triangle : layer.triangles) add_triangle(path, lifts_.lifted[lifts_.place[triangle]]);
    return "<path class=\"layer\" fill=\"" + layer.colour + "\" fill-opacity=\"0.6\" d=\"" + path.data() +
           "\"><title>" + escaped(layer.name) + "</title></path>\n";
  }

  [[nodiscard]] std::string curve_group(const Layer& layer) const {
    if (layer.arcs.empty() && layer.darts.empty()) return "";
    PathsByWidth paths(paper_, 1.4 * outline_width_);
    for (const Arc& arc : layer.arcs) {
      const Isometry<double>& placement = lifts_.placements[lifts_.lifted[lifts_.place[arc.triangle]].placement];
      add_tapered(paths, placement(arc.from), placement(arc.to));
    }
    for (const std::uint32_t dart : layer.darts) add_tapered(paths, start(dart), end(dart));
    std::string out = "<g class=\"layer\" fill=\"none\" stroke=\"" + layer.colour +
                      "\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n<title>" + escaped(layer.name) +
                      "</title>\n";
    paths.append_to(out);
    return out + "</g>\n";
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
    std::string out = std::string("<g class=\"edges\" fill=\"none\" stroke=\"") + palette::kEdges +
                      "\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n";
    inner.append_to(out);
    out +=
        "</g>\n<g class=\"outline\" fill=\"none\" stroke=\"#1d2b3a\" stroke-linecap=\"round\" "
        "stroke-linejoin=\"round\">\n";
    outline.append_to(out);
    return out + "</g>\n";
  }

  /// Dots of less than half a pixel are a grey veil, which ends where they are left out.
  [[nodiscard]] bool shows_all_vertices() const { return dot_width_ >= 0.5; }

  [[nodiscard]] std::string dot_group() {
    PathsByWidth dots(paper_, dot_width_);
    // The centre has a rim of white, so that it can be seen on dark triangles.
    const double base_width = std::max(1.6 * dot_width_, 0.006 * options_.size);
    PathsByWidth base(paper_, base_width);
    PathsByWidth rim(paper_, 1.5 * base_width);
    std::set<Place> drawn;
    for (const Lifts::LiftedTriangle& triangle : lifts_.lifted) {
      for (std::uint32_t i = 0; i < 3; ++i) {
        const Point& z = triangle.corner[i];
        const double share = std::max(0.0, 1 - norm(z));
        const bool is_base = document_.triangles[triangle.triangle].vertex[i] == options_.centre;
        if (!is_base && !shows_all_vertices()) continue;
        if (dot_width_ * share < 0.1 || !drawn.insert(paper_.place(z)).second) continue;
        (is_base ? base : dots).at(share).dot(z);
        if (is_base) rim.at(share).dot(z);
      }
    }
    std::string out;
    const auto append = [&](const char* name, const char* colour, const PathsByWidth& paths) {
      out +=
          std::string("<g class=\"") + name + "\" fill=\"none\" stroke=\"" + colour + "\" stroke-linecap=\"round\">\n";
      paths.append_to(out);
      out += "</g>\n";
    };
    append("vertices", palette::kVertices, dots);
    append("rim", palette::kPaper, rim);
    append("base-vertex", palette::kCentre, base);
    return out;
  }

  [[nodiscard]] std::string dirichlet_group() const {
    const DirichletDomain domain = dirichlet_domain(geometry_, options_.centre);
    PathsByWidth paths(paper_, 1.4 * outline_width_);
    for (std::size_t i = 0; i < domain.vertices.size(); ++i)
      add_tapered(paths, domain.vertices[i], domain.vertices[(i + 1) % domain.vertices.size()]);
    std::string out = std::string("<g class=\"dirichlet\" fill=\"none\" stroke=\"") + palette::kDirichlet +
                      "\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n"
                      "<title>Dirichlet domain of vertex " +
                      std::to_string(options_.centre) + "</title>\n";
    paths.append_to(out);
    return out + "</g>\n";
  }

  [[nodiscard]] std::string legend_group() const {
    Legend legend(std::max(options_.size, 700U) / 1000.0);
    if (options_.triangles) legend.add(Mark::line, palette::kEdges, "triangles");
    if (options_.vertices && shows_all_vertices()) legend.add(Mark::dot, palette::kVertices, "vertices");
    if (options_.vertices) legend.add(Mark::dot, palette::kCentre, "vertex " + std::to_string(options_.centre));
    if (options_.dirichlet) legend.add(Mark::line, palette::kDirichlet, "Dirichlet domain");
    if (options_.combinatorial_dirichlet)
      legend.add(Mark::line, palette::kCombinatorialDirichlet, "combinatorial Dirichlet domain");
    if (options_.covering_disks)
      legend.add(Mark::area, palette::kCoveringDisks, "disks of radius " + geometry_.epsilon_text());
    if (options_.packing_disks)
      legend.add(Mark::area, palette::kPackingDisks, "disks of radius " + geometry_.epsilon_text() + "/2");
    for (const Layer& layer : options_.layers)
      legend.add(layer.triangles.empty() ? Mark::line : Mark::area, layer.colour, legend_name(layer));
    if (options_.colouring == Colouring::circumradius) {
      for (const double share : {0.0, 0.33, 0.67, 1.0})
        legend.add(Mark::area, shade(share),
                   "circumradius " + fixed((1 + share) / 2, 2) + " epsilon" + (share == 0 ? " or less" : ""));
    }
    if (options_.colouring == Colouring::chart) add_charts(legend);
    return legend.group();
  }

  /// The colours of the charts that triangles have, as far as there is room.
  void add_charts(Legend& legend) const {
    constexpr std::size_t kMost = 16;
    std::set<std::uint32_t> charts;
    for (std::uint32_t t = 0; t < document_.triangles.size(); ++t) charts.insert(chart_of(t));
    std::vector<std::pair<std::string, std::string>> named;
    for (const std::uint32_t chart : charts)
      if (named.size() < kMost) named.emplace_back(chart_colour(chart), std::to_string(chart));
    legend.add_text_row("triangles by chart:");
    legend.add_areas(named);
    if (charts.size() > kMost) legend.add_text_row("and " + std::to_string(charts.size() - kMost) + " more charts");
  }

  [[nodiscard]] std::string head() const {
    const std::string size = std::to_string(options_.size);
    const std::string middle = fixed(paper_.middle(), 1);
    const std::string what = "Delaunay triangulation with " + std::to_string(document_.vertices.size()) +
                             " vertices and " + std::to_string(document_.triangles.size()) + " triangles, epsilon " +
                             geometry_.epsilon_text();
    std::string desc = "One lift of every triangle in the Poincare disk, connected, by " +
                       std::string(options_.order == DrawOrder::weight ? "least weight |u|^2+|v|^2 of the edge crossed"
                                                                       : "breadth-first search") +
                       ", with vertex " + std::to_string(options_.centre) + " in the centre. Edges are geodesics.";
    if (options_.dirichlet) desc += " Red: the Dirichlet domain of vertex " + std::to_string(options_.centre) + ".";
    if (edges_left_out_ > 0)
      desc += " " + std::to_string(edges_left_out_) + " edges shorter than 0.1 pixel are left out.";
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + size + "\" height=\"" + size + "\" viewBox=\"0 0 " +
           size + " " + size + "\">\n<title>" + what + "</title>\n<desc>" + desc +
           "</desc>\n<rect class=\"background\" width=\"" + size + "\" height=\"" + size + "\" fill=\"" +
           palette::kPaper + "\"/>\n<circle class=\"disk\" cx=\"" + middle + "\" cy=\"" + middle + "\" r=\"" +
           fixed(paper_.radius(), 2) + "\" fill=\"#fff\" stroke=\"#8a94a0\" stroke-width=\"" +
           fixed(0.8 * options_.size / 1000, 2) + "\"/>\n";
  }

  const certify::NetDocument& document_;
  NetGeometry geometry_;
  DrawOptions options_;
  Paper paper_;
  Lifts lifts_;
  double epsilon_;
  std::vector<bool> on_boundary_;  ///< By dart.
  double edge_width_ = 0;          ///< In pixels, in the centre.
  double dot_width_ = 0;
  double outline_width_ = 0;
  std::uint64_t edges_left_out_ = 0;
};

}  // namespace

std::string draw_svg(const certify::NetDocument& document, const DrawOptions& options) {
  return Picture(document, options).svg();
}

}  // namespace epsnet
