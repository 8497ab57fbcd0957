#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>

#include "certify/base/text.h"
#include "netgen/pictures/pictures.h"
#include "netgen/pictures/svg.h"

namespace epsnet {
namespace {

class BandsDrawing {
 public:
  BandsDrawing(const BandsPicture& picture, std::uint32_t size) : picture_(picture), size_(size), unit_(size / 1000.0) {
    double greatest = 0;
    for (const auto& step : picture.bands) {
      for (const certify::Interval& in : step) greatest = std::max(greatest, in.upper);
    }
    if (greatest > 0 && std::isfinite(greatest)) top_ = 1.06 * greatest;
  }

  [[nodiscard]] std::string svg() const { return head() + grid() + lines() + intervals() + marks() + "</svg>\n"; }

 private:
  static constexpr double kFont = 15;
  static constexpr double kLeft = 62;
  static constexpr double kRight = 978;
  static constexpr double kTop = 24;
  static constexpr double kBottom = 572;
  static constexpr double kHeight = 620;
  static constexpr std::array<const char*, 4> kColours{palette::kPaths, palette::kDirichlet, palette::kCoveringDisks,
                                                       palette::kCombinatorialDirichlet};

  [[nodiscard]] std::string length(double units) const { return fixed(units * unit_, 2); }
  [[nodiscard]] double x(std::size_t step) const {
    const std::size_t last = std::max<std::size_t>(picture_.bands.size(), 2) - 1;
    return kLeft + (kRight - kLeft) * static_cast<double>(step) / static_cast<double>(last);
  }
  [[nodiscard]] double y(double lambda) const { return kBottom - (kBottom - kTop) * std::min(lambda / top_, 1.0); }
  [[nodiscard]] std::string line(double x0, double y0, double x1, double y1) const {
    return "M" + length(x0) + ' ' + length(y0) + 'L' + length(x1) + ' ' + length(y1);
  }
  [[nodiscard]] std::string stroke(const std::string& name, const std::string& data, const char* colour,
                                   double width) const {
    return "<path class=\"" + name + "\" fill=\"none\" stroke=\"" + colour + "\" stroke-width=\"" + length(width) +
           "\" d=\"" + data + "\"/>\n";
  }
  [[nodiscard]] std::string text(double at_x, double at_y, const std::string& what,
                                 const std::string& attributes = "") const {
    return "<text x=\"" + length(at_x) + "\" y=\"" + length(at_y) + "\"" + attributes + ">" + escaped(what) +
           "</text>\n";
  }
  [[nodiscard]] std::string text_group(const char* name, const char* anchor) const {
    return std::string("<g class=\"") + name + "\" font-family=\"sans-serif\" font-size=\"" + length(kFont) +
           "\" fill=\"#1d2b3a\" text-anchor=\"" + anchor + "\">\n";
  }

  [[nodiscard]] std::string head() const {
    const std::string width = std::to_string(size_);
    const std::string height = std::to_string(std::lround(kHeight * unit_));
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + width + "\" height=\"" + height +
           "\" viewBox=\"0 0 " + width + " " + height +
           "\">\n<title>Bands</title>\n<desc>Eigenvalues of the Laplacian with phases along a path: intervals that "
           "contain them.</desc>\n<rect class=\"background\" width=\"" +
           width + "\" height=\"" + height + "\" fill=\"" + palette::kPaper + "\"/>\n";
  }

  [[nodiscard]] std::string grid() const {
    const double power = std::pow(10, std::floor(std::log10(top_ / 5)));
    const double step = top_ / power > 25 ? 5 * power : top_ / power > 10 ? 2 * power : power;
    std::string across;
    std::string beside = text_group("eigenvalues", "end");
    for (double tick = 0; tick <= top_; tick += step) {
      across += line(kLeft, y(tick), kRight, y(tick));
      beside += text(kLeft - 8, y(tick) + 0.35 * kFont, certify::shortest(std::stod(fixed(tick, 6))));
    }
    return stroke("grid", across, "#d5dbe2", 1) + beside + text(kLeft - 8, kTop - 6, "\u03bb") + "</g>\n";
  }

  [[nodiscard]] static const char* colour(std::size_t band) { return kColours[band % kColours.size()]; }
  [[nodiscard]] std::size_t count() const {
    std::size_t result = picture_.bands.empty() ? 0 : picture_.bands.front().size();
    for (const auto& step : picture_.bands) result = std::min(result, step.size());
    return result;
  }

  [[nodiscard]] std::string lines() const {
    std::string out;
    for (std::size_t band = 0; band < count(); ++band) {
      std::string data;
      for (std::size_t step = 0; step < picture_.bands.size(); ++step) {
        const auto [lower, upper] = picture_.bands[step][band];
        data += (data.empty() ? 'M' : 'L') + length(x(step)) + ' ' + length(y(lower / 2 + upper / 2));
      }
      out += stroke("band", data, colour(band), 1);
    }
    return out;
  }

  [[nodiscard]] std::string intervals() const {
    std::string out;
    for (std::size_t band = 0; band < count(); ++band) {
      std::string data;
      for (std::size_t step = 0; step < picture_.bands.size(); ++step) {
        const auto [lower, upper] = picture_.bands[step][band];
        const double missing = std::max(0.0, 1.5 - (y(lower) - y(upper))) / 2;
        data += line(x(step), y(lower) + missing, x(step), y(upper) - missing);
      }
      out += stroke("intervals", data, colour(band), 4);
    }
    return out;
  }

  [[nodiscard]] std::string marks() const {
    std::string lines;
    std::string names = text_group("marks", "middle");
    for (const BandsPicture::Mark& mark : picture_.marks) {
      if (mark.step >= picture_.bands.size()) continue;
      lines += line(x(mark.step), kTop, x(mark.step), kBottom);
      // The last name ends there: it may be long.
      const bool last = mark.step > 0 && mark.step + 1 == picture_.bands.size();
      names += text(x(mark.step), kBottom + 24, mark.name, last ? " text-anchor=\"end\"" : "");
    }
    return stroke("axes", lines + line(kLeft, kBottom, kRight, kBottom) + line(kLeft, kTop, kLeft, kBottom),
                  palette::kEdges, 1) +
           names + "</g>\n";
  }

  const BandsPicture& picture_;
  std::uint32_t size_;
  double unit_;
  double top_ = 1;
};

}  // namespace

std::string draw_svg(const BandsPicture& picture, std::uint32_t size) { return BandsDrawing(picture, size).svg(); }

}  // namespace epsnet
