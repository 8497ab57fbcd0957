#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "kernel/numbers.h"

/// The colours of pictures and pages, "#rrggbb". Colours that can be seen together differ clearly (a test measures it).
namespace epsnet::palette {

inline constexpr const char* kPaper = "#ffffff";
inline constexpr const char* kEdges = "#33475b";
inline constexpr const char* kVertices = "#10202f";
inline constexpr const char* kCentre = "#0a6fe0";  ///< The vertex in the centre of a picture.
inline constexpr const char* kDirichlet = "#d0402b";
inline constexpr const char* kCombinatorialDirichlet = "#e08a00";
inline constexpr const char* kCoveringDisks = "#2f9468";
inline constexpr const char* kPackingDisks = "#8a6bb0";
inline constexpr const char* kTiles = "#00909e";
inline constexpr const char* kCollarTriangles = "#e8c000";
inline constexpr const char* kEpsilonCollars = "#85510f";
inline constexpr const char* kGeodesics = "#b5197f";
inline constexpr const char* kShortestGeodesics = "#6e0d12";
inline constexpr const char* kSmallCurveCollars = "#7fae00";
inline constexpr const char* kPaths = "#5a2ee0";

}  // namespace epsnet::palette

/// Geodesics on paper: the disk in pixels, SVG paths.
namespace epsnet {

/// A point of the paper in hundredths of a pixel, the resolution of the file.
struct PaperPoint {
  std::int64_t x;
  std::int64_t y;
  bool operator==(const PaperPoint&) const = default;
  bool operator<(const PaperPoint& other) const { return std::pair(x, y) < std::pair(other.x, other.y); }
};

/// The disk on paper: centre in the middle, y upwards.
class Paper {
 public:
  explicit Paper(std::uint32_t size) : radius_(0.485 * size), middle_(0.5 * size) {}

  [[nodiscard]] double radius() const { return radius_; }  ///< Of the disk, in pixels.
  [[nodiscard]] double middle() const { return middle_; }
  [[nodiscard]] PaperPoint place(const Complex<double>& z) const;
  /// Returns pixels per unit of hyperbolic length at z.
  [[nodiscard]] double scale(const Complex<double>& z) const { return radius_ * std::max(0.0, 1 - norm(z)) / 2; }

 private:
  double radius_;
  double middle_;
};

/// The data of an SVG path, in relative coordinates between rounded places, so that rounding does not accumulate. Keeps
/// a reference to the paper.
class Path {
 public:
  explicit Path(const Paper& paper) : paper_(&paper) {}
  explicit Path(const Paper&&) = delete;

  void move(const Complex<double>& z);
  /// Draws the geodesic from u to v. Requires: the pen is at u.
  void geodesic(const Complex<double>& u, const Complex<double>& v);
  /// Draws the straight line of the paper to z.
  void line(const Complex<double>& z);
  /// Draws the hyperbolic circle of a radius about z, which is a Euclidean circle; draws nothing if it is smaller than
  /// a fifth of a pixel.
  void circle(const Complex<double>& z, double radius);
  void dot(const Complex<double>& z);
  void close();

  [[nodiscard]] const std::string& data() const { return data_; }

 private:
  /// Appends a command and the way to the place. The letter is left out where SVG implies it: for a line after a line
  /// or a move.
  void append(char command, const PaperPoint& place);
  /// Appends the parameters of an arc of a circle of radius r, in hundredths of a pixel, without its end.
  void append_arc(std::int64_t r, const char* flags);

  const Paper* paper_;
  std::string data_;
  char command_ = 'z';
  PaperPoint last_{};  ///< Where the pen is. The first move is from 0.
};

/// Paths in classes of stroke width: powers of ∜2, too fine to see, the widest first. Keeps a reference to the paper.
class PathsByWidth {
 public:
  PathsByWidth(const Paper& paper, double widest) : paper_(&paper), widest_(widest) {}
  PathsByWidth(const Paper&&, double) = delete;

  /// Returns the path for strokes of a share, at most 1, of the greatest width. The least width is a twentieth of a
  /// pixel, as thinner strokes vanish in some renderers, which shows as an edge in the shading of fine nets.
  [[nodiscard]] Path& at(double share);

  /// Adds the geodesic from start to end, in pieces if it is so long that its stroke has to taper. Returns false if it
  /// is too small to see.
  bool add_tapered(const Complex<double>& start, const Complex<double>& end);

  void append_to(std::string& out) const;

 private:
  const Paper* paper_;
  double widest_;
  std::map<int, Path> paths_;
};

/// Returns x with a fixed number of digits after the point.
[[nodiscard]] std::string fixed(double x, int digits);

// Legends of pictures, and the colours beside the palette.

/// Returns a colour from pale yellow, at 0, to blue, at 1, in 24 steps: few colours make a short file.
[[nodiscard]] std::string shade(double share);

/// Returns the colour of a chart; the golden angle keeps the hues of neighbouring numbers apart.
[[nodiscard]] std::string chart_colour(std::uint32_t chart);

/// Returns the text with the escapes that XML needs between tags.
[[nodiscard]] std::string escaped(const std::string& text);

/// Lines and texts of a diagram with axes. Places are in units of a thousandth of its width, to the right and
/// downwards.
class Diagram {
 public:
  /// So many pixels wide, and so many units high.
  Diagram(std::uint32_t size, double height) : size_(size), unit_(size / 1000.0), height_(height) {}

 protected:
  static constexpr double kFont = 15;

  /// The pixels of a unit.
  [[nodiscard]] double unit() const { return unit_; }
  [[nodiscard]] std::string length(double units) const;
  /// The data of a path.
  [[nodiscard]] std::string line(double x0, double y0, double x1, double y1) const;
  [[nodiscard]] std::string stroke(const std::string& name, const std::string& data, const char* colour, double width,
                                   const std::string& attributes = "") const;
  [[nodiscard]] std::string text(double x, double y, const std::string& what, const std::string& attributes = "") const;
  /// The start of a group of texts with an anchor: start, middle or end.
  [[nodiscard]] std::string text_group(const char* name, const char* anchor) const;
  /// A round number, 1, 2 or 5 times a power of ten: about a seventh of the range.
  [[nodiscard]] static double tick_step(double range);
  /// The start of the file.
  [[nodiscard]] std::string head(const std::string& title, const std::string& description) const;

 private:
  std::uint32_t size_;
  double unit_;
  double height_;
};

/// How a legend shows what a name stands for.
enum class Mark { area, line, dot };

/// Rows of marks and names in the upper left corner, which the disk leaves free. Names have a white margin, so that
/// they can be read on any background.
class Legend {
 public:
  /// `unit` is the number of pixels of a unit.
  explicit Legend(double unit) : unit_(unit) {}

  void add(Mark mark, const std::string& colour, const std::string& name);
  /// Adds areas with short names, four in a row, each of a width in units.
  void add_areas(const std::vector<std::pair<std::string, std::string>>& colours_and_names, double width = 38);
  void add_text_row(const std::string& text);

  /// Returns the group of SVG elements.
  [[nodiscard]] std::string group() const;
  /// Its width and height in pixels, estimated from the number of letters: it begins at the corner of the picture.
  [[nodiscard]] double width() const { return unit_ * right_; }
  [[nodiscard]] double height() const { return unit_ * (y_ > 0 ? y_ + 6 : 0); }

 private:
  [[nodiscard]] std::string length(double units) const;
  void next_row() { y_ += 18; }
  void add_text(const std::string& text, double x);
  void add_mark(Mark mark, const std::string& colour, double x);

  double unit_;
  double y_ = 0;
  double right_ = 0;
  std::string marks_;
  std::string texts_;
};

}  // namespace epsnet
