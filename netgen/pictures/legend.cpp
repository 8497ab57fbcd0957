#include "netgen/pictures/legend.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "netgen/pictures/palette.h"
#include "netgen/pictures/svg_path.h"

namespace epsnet {

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

std::string chart_colour(std::uint32_t chart) {
  return "hsl(" + fixed(std::fmod(chart * 137.508, 360), 0) + ",45%,85%)";
}

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

void Legend::add(Mark mark, const std::string& colour, const std::string& name) {
  next_row();
  add_mark(mark, colour, 10);
  add_text(name, 27);
}

void Legend::add_areas(const std::vector<std::pair<std::string, std::string>>& colours_and_names, double width) {
  constexpr std::size_t kPerRow = 4;
  for (std::size_t i = 0; i < colours_and_names.size(); ++i) {
    const double x = 10 + width * static_cast<double>(i % kPerRow);
    if (i % kPerRow == 0) next_row();
    add_mark(Mark::area, colours_and_names[i].first, x);
    add_text(colours_and_names[i].second, x + 14);
  }
}

void Legend::add_text_row(const std::string& text) {
  next_row();
  add_text(text, 10);
}

std::string Legend::group() const {
  return "<g class=\"legend\">\n" + marks_ + "<g font-family=\"sans-serif\" font-size=\"" + length(12) +
         "\" fill=\"#1d2b3a\" stroke=\"" + palette::kPaper + "\" stroke-width=\"" + length(3) +
         "\" stroke-linejoin=\"round\" paint-order=\"stroke\">\n" + texts_ + "</g>\n</g>\n";
}

std::string Legend::length(double units) const { return fixed(units * unit_, 1); }

void Legend::add_text(const std::string& text, double x) {
  texts_ += "<text x=\"" + length(x) + "\" y=\"" + length(y_) + "\">" + escaped(text) + "</text>\n";
}

void Legend::add_mark(Mark mark, const std::string& colour, double x) {
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

}  // namespace epsnet
