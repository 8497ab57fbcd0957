#include "netgen/exchange/triangulation_stream.h"

#include <algorithm>
#include <charconv>
#include <ostream>

#include "certify/base/text.h"
#include "netgen/exchange/token_reader.h"

namespace epsnet {
namespace {

constexpr std::uint32_t kUnset = ~std::uint32_t{0};

class Reader {
 public:
  Reader(std::string_view text, std::string_view name) : text_size_(text.size()), words_(text, name) {}

  TriangulationStream read() {
    read_dart_count();
    const bool all_anchored = read_anchor();
    read_triangles(all_anchored);
    read_edges();
    words_.expect_end("the last edge");
    return std::move(stream_);
  }

 private:
  void read_dart_count() {
    darts_ = words_.index("the number of darts, a positive multiple of 6 below 2^32");
    if (darts_ == 0 || darts_ % 6 != 0) {
      words_.fail(std::to_string(darts_) +
                  " darts found, expected a positive multiple of 6 (triangles have three, edges two)");
    }
    // The sizes of tables below are proportional to this number, so it may not exceed the length of the text.
    if (darts_ > text_size_) {
      words_.fail("the text claims " + std::to_string(darts_) + " darts, but has only " + std::to_string(text_size_) +
                  " bytes");
    }
    range_ = ", from 0 to " + std::to_string(darts_ - 1) + " (the text claims " + std::to_string(darts_) + " darts)";
  }

  /// Reads the anchor, if there is one here. Returns true if a dart comes instead: then each triangle has its own
  /// anchor.
  bool read_anchor() {
    const std::string expected =
        "\"yes\" or \"no\": whether there is an anchor, or the first dart of triangle 0" + range_;
    const std::string_view word = TokenReader(words_).next(expected);
    if (word.find_first_not_of("0123456789") == std::string_view::npos) return true;
    static_cast<void>(words_.next(expected));
    if (word == "no") return false;
    if (word != "yes") words_.fail(certify::in_quotes(word) + " found, expected " + expected);
    read_lift("the anchor");
    return false;
  }

  /// Reads a dart and the points of its triangle.
  void read_lift(const std::string& name) {
    TriangulationStream::Anchor& anchor = stream_.anchors.emplace_back();
    anchor.dart = dart("the dart of " + name);
    if (!stream_.triangles.empty()) {
      const TriangulationStream::Triangle& triangle = stream_.triangles.back();
      if (std::find(triangle.begin(), triangle.end(), anchor.dart) == triangle.end()) {
        words_.fail("dart " + std::to_string(anchor.dart) + " found, expected the dart of " + name +
                    ", one of this triangle");
      }
    }
    for (std::size_t i = 0; i < 3; ++i) {
      anchor.points[i] = complex("point " + std::to_string(i) + " of " + name, "x coordinate", "y coordinate");
    }
  }

  void read_triangles(bool all_anchored) {
    std::vector<std::uint32_t> triangle_of(darts_, kUnset);
    for (std::uint32_t t = 0; t < darts_ / 3; ++t) {
      const std::string place = " of triangle " + std::to_string(t);
      const auto next_dart = [&](const char* which) {
        const std::uint32_t d = dart(which + place);
        claim(triangle_of, d, t, "triangle");
        return d;
      };
      const std::uint32_t first = next_dart("the first dart");
      const std::uint32_t last = next_dart("the dart before the first one");
      const std::uint32_t second = next_dart("the dart after the first one");
      stream_.triangles.push_back({first, second, last});
      if (all_anchored) read_lift("the anchor" + place);
    }
  }

  void read_edges() {
    std::vector<std::uint32_t> edge_of(darts_, kUnset);
    for (std::uint32_t e = 0; e < darts_ / 2; ++e) {
      const std::string place = " of edge " + std::to_string(e);
      const std::uint32_t first = dart("the first dart" + place);
      claim(edge_of, first, e, "edge");
      const std::uint32_t second = dart("the second dart" + place);
      claim(edge_of, second, e, "edge");
      stream_.edges.push_back({first, second, complex("the cross-ratio" + place, "real part", "imaginary part")});
    }
  }

  std::uint32_t dart(const std::string& what) {
    const std::string expected = what + range_;
    const std::uint32_t d = words_.index(expected);
    if (d >= darts_) words_.fail(std::to_string(d) + " found, expected " + expected);
    return d;
  }

  /// Records the triangle or edge to which a dart belongs. Fails if it belongs to two, or twice to one.
  void claim(std::vector<std::uint32_t>& owner, std::uint32_t d, std::uint32_t by, const std::string& kind) {
    if (owner[d] == by) {
      words_.fail("dart " + std::to_string(d) + " occurs twice in " + kind + " " + std::to_string(by));
    }
    if (owner[d] != kUnset) {
      words_.fail("dart " + std::to_string(d) + " belongs to " + kind + " " + std::to_string(owner[d]) + " and to " +
                  kind + " " + std::to_string(by));
    }
    owner[d] = by;
  }

  Complex<Rational> complex(const std::string& what, const char* x, const char* y) {
    Rational first = words_.rational("the " + (x + (" of " + what)));
    return {std::move(first), words_.rational("the " + (y + (" of " + what)))};
  }

  std::size_t text_size_;
  TokenReader words_;
  std::uint32_t darts_ = 0;
  std::string range_;
  TriangulationStream stream_;
};

}  // namespace

bool is_triangulation_stream(std::string_view text) {
  constexpr std::string_view kWhiteSpace = " \t\n\v\f\r";
  const auto next = [&] {
    text.remove_prefix(std::min(text.find_first_not_of(kWhiteSpace), text.size()));
    const std::string_view word = text.substr(0, text.find_first_of(kWhiteSpace));
    text.remove_prefix(word.size());
    return word;
  };
  const std::string_view count = next();
  const std::string_view second = next();
  if (second == "yes" || second == "no") return true;
  std::uint32_t darts = 0;
  if (std::from_chars(count.data(), count.data() + count.size(), darts).ec != std::errc() || darts % 6 != 0)
    return false;
  for (std::size_t i = 2; i < 5; ++i) static_cast<void>(next());
  bool has_fraction = false;
  for (std::size_t i = 5; i < 11; ++i) has_fraction |= next().find('/') != std::string_view::npos;
  return has_fraction;
}

TriangulationStream read_triangulation_stream(std::string_view text, std::string_view name) {
  return Reader(text, name).read();
}

void write_triangulation_stream(const TriangulationStream& stream, std::ostream& out) {
  const bool all_anchored = stream.anchors.size() > 1;
  out << 3 * stream.triangles.size() << '\n';
  if (!all_anchored) out << (stream.anchors.empty() ? "no" : "yes") << '\n';
  if (stream.anchors.size() == 1) {
    out << stream.anchors[0].dart << '\n';
    for (const auto& [x, y] : stream.anchors[0].points) out << x.str() << ' ' << y.str() << '\n';
  }
  for (std::size_t t = 0; t < stream.triangles.size(); ++t) {
    const auto& [first, second, last] = stream.triangles[t];
    out << first << '\n' << last << '\n' << second << '\n';
    if (!all_anchored) continue;
    out << stream.anchors[t].dart << '\n';
    for (const auto& [x, y] : stream.anchors[t].points) out << x.str() << '\n' << y.str() << '\n';
  }
  for (const auto& [dart, opposite, ratio] : stream.edges) {
    out << dart << '\n' << opposite << '\n' << ratio.x.str() << '\n' << ratio.y.str() << '\n';
  }
}

}  // namespace epsnet
