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

class BandsDrawing : Diagram {
 public:
  BandsDrawing(const BandsPicture& picture, std::uint32_t size) : Diagram(size, 620), picture_(picture) {
    double greatest = 0;
    for (const auto& step : picture.bands) {
      for (const certify::Interval& in : step) greatest = std::max(greatest, in.upper);
    }
    if (greatest > 0 && std::isfinite(greatest)) top_ = 1.06 * greatest;
  }

  [[nodiscard]] std::string svg() const {
    return head("Bands", "Eigenvalues of the Laplacian with phases along a path: intervals that contain them.") +
           grid() + lines() + intervals() + marks() + "</svg>\n";
  }

 private:
  static constexpr double kLeft = 62;
  static constexpr double kRight = 978;
  static constexpr double kTop = 24;
  static constexpr double kBottom = 572;
  static constexpr std::array<const char*, 4> kColours{palette::kPaths, palette::kDirichlet, palette::kCoveringDisks,
                                                       palette::kCombinatorialDirichlet};

  [[nodiscard]] double x(std::size_t step) const {
    const std::size_t last = std::max<std::size_t>(picture_.bands.size(), 2) - 1;
    return kLeft + (kRight - kLeft) * static_cast<double>(step) / static_cast<double>(last);
  }
  [[nodiscard]] double y(double lambda) const { return kBottom - (kBottom - kTop) * std::min(lambda / top_, 1.0); }

  [[nodiscard]] std::string grid() const {
    const double step = tick_step(top_);
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
  double top_ = 1;
};

}  // namespace

std::string draw_svg(const BandsPicture& picture, std::uint32_t size) { return BandsDrawing(picture, size).svg(); }

}  // namespace epsnet
