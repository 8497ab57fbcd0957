#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

/// Legends of pictures, and the colours beside the palette.
namespace epsnet {

/// Returns a colour from pale yellow, at 0, to blue, at 1, in 24 steps: few colours make a short file.
[[nodiscard]] std::string shade(double share);

/// Returns the colour of a chart; the golden angle keeps the hues of neighbouring numbers apart.
[[nodiscard]] std::string chart_colour(std::uint32_t chart);

/// Returns the text with the escapes that XML needs between tags.
[[nodiscard]] std::string escaped(const std::string& text);

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

 private:
  [[nodiscard]] std::string length(double units) const;
  void next_row() { y_ += 18; }
  void add_text(const std::string& text, double x);
  void add_mark(Mark mark, const std::string& colour, double x);

  double unit_;
  double y_ = 0;
  std::string marks_;
  std::string texts_;
};

}  // namespace epsnet
