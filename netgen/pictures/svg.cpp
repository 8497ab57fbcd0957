#include "netgen/pictures/svg.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>

#include "kernel/plane.h"

namespace epsnet {
namespace {

using Point = Complex<double>;

/// Returns the Euclidean curvature, 1/radius, of the geodesic through u and v, for |u|, |v| < 1: positive if 0 lies on
/// its left, negative if on its right, 0 for a diameter.
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

/// Moves a point off the unit circle, to which points far out in thin collars are rounded, so that a translation can
/// take it to 0. The difference cannot be seen.
Point off_circle(const Point& z) {
  constexpr double kFarthest = 1 - 1e-9;
  const double radius = std::sqrt(norm(z));
  return radius > kFarthest ? kFarthest / radius * z : z;
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

/// Writes x/100 with a space in front unless its sign separates it already.
void append_separated(std::string& out, std::int64_t x) {
  if (x >= 0) out += ' ';
  append_hundredths(out, x);
}

}  // namespace

PaperPoint Paper::place(const Point& z) const {
  return {std::llround(100 * (middle_ + radius_ * z.x)), std::llround(100 * (middle_ - radius_ * z.y))};
}

void Path::move(const Point& z) {
  const PaperPoint place = paper_->place(z);
  if (!data_.empty() && place == last_) return;
  append('m', place);
}

void Path::geodesic(const Point& u, const Point& v) {
  const PaperPoint place = paper_->place(v);
  if (place == last_) return;
  const double k = curvature(u, v);
  const double chord = paper_->radius() * std::sqrt(norm(v - u));
  const double radius = paper_->radius() / std::abs(k);  // Infinite for a diameter.
  // The arc is chord²/(8 radius) away from the chord.
  if (chord * chord <= 8 * 0.01 * radius) {
    append('l', place);
    return;
  }
  // With 0 on the left (k > 0) the arc bends to the left on its way, and paper has y downwards: that is sweep 1.
  append_arc(std::llround(100 * radius), k > 0 ? " 0 0 1" : " 0 0 0");
  append('a', place);
}

void Path::line(const Point& z) {
  const PaperPoint place = paper_->place(z);
  if (place == last_) return;
  append('l', place);
}

void Path::circle(const Point& z, double radius) {
  const double t = std::tanh(radius / 2);
  const double scale = 1 / (1 - t * t * norm(z));
  const auto r = std::llround(100 * paper_->radius() * t * (1 - norm(z)) * scale);
  if (r < 10) return;
  PaperPoint left = paper_->place((1 - t * t) * scale * z);
  left.x -= r;
  append('m', left);
  for (const std::int64_t way : {2 * r, -2 * r}) {
    append_arc(r, " 0 1 0");
    append('a', {left.x + (way > 0 ? way : 0), left.y});
  }
  close();
}

void Path::dot(const Point& z) {
  move(z);
  data_ += "h0";
  command_ = 'h';
}

void Path::close() {
  data_ += 'z';
  command_ = 'z';
}

void Path::append(char command, const PaperPoint& place) {
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

void Path::append_arc(std::int64_t r, const char* flags) {
  data_ += 'a';
  append_hundredths(data_, r);
  append_separated(data_, r);
  data_ += flags;
  command_ = 'a';
}

Path& PathsByWidth::at(double share) {
  const double least = std::min(1.0, 0.05 / widest_);
  const auto rank = static_cast<int>(std::lround(-4 * std::log2(std::clamp(share, least, 1.0))));
  return paths_.try_emplace(rank, *paper_).first->second;
}

bool PathsByWidth::add_tapered(const Point& start, const Point& end) {
  const Point u = off_circle(start);
  const Point v = off_circle(end);
  const double chord = std::sqrt(norm(v - u));
  if (chord * paper_->radius() < 0.1) return false;
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
    Path& path = at(1 - norm(middle));
    path.move(from);
    path.geodesic(from, to);
    from = to;
  }
  return true;
}

void PathsByWidth::append_to(std::string& out) const {
  for (const auto& [rank, path] : paths_)
    out += "<path stroke-width=\"" + fixed(widest_ * std::pow(2, -0.25 * rank), 3) + "\" d=\"" + path.data() + "\"/>\n";
}

std::string fixed(double x, int digits) {
  std::array<char, 64> buffer;
  const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), x, std::chars_format::fixed, digits);
  return {buffer.data(), result.ptr};
}

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

std::string Diagram::length(double units) const { return fixed(units * unit_, 2); }

std::string Diagram::line(double x0, double y0, double x1, double y1) const {
  return "M" + length(x0) + ' ' + length(y0) + 'L' + length(x1) + ' ' + length(y1);
}

std::string Diagram::stroke(const std::string& name, const std::string& data, const char* colour, double width,
                            const std::string& attributes) const {
  return "<path class=\"" + name + "\" fill=\"none\" stroke=\"" + colour + "\" stroke-width=\"" + length(width) +
         "\" " + attributes + "d=\"" + data + "\"/>\n";
}

std::string Diagram::text(double x, double y, const std::string& what, const std::string& attributes) const {
  return "<text x=\"" + length(x) + "\" y=\"" + length(y) + "\"" + attributes + ">" + escaped(what) + "</text>\n";
}

std::string Diagram::text_group(const char* name, const char* anchor) const {
  return std::string("<g class=\"") + name + "\" font-family=\"sans-serif\" font-size=\"" + length(kFont) +
         "\" fill=\"#1d2b3a\" text-anchor=\"" + anchor + "\">\n";
}

double Diagram::tick_step(double range) {
  const double power = std::pow(10, std::floor(std::log10(range / 7)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (range / (factor * power) <= 9) return factor * power;
  }
  return 10 * power;
}

std::string Diagram::head(const std::string& title, const std::string& description) const {
  const std::string width = std::to_string(size_);
  const std::string height = std::to_string(std::lround(height_ * unit_));
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + width + "\" height=\"" + height + "\" viewBox=\"0 0 " +
         width + " " + height + "\">\n<title>" + escaped(title) + "</title>\n<desc>" + description +
         "</desc>\n<rect class=\"background\" width=\"" + width + "\" height=\"" + height + "\" fill=\"" +
         palette::kPaper + "\"/>\n";
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
  right_ = std::max(right_, x + 7 * static_cast<double>(text.size()));
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
