#include "epsnet/netgen/domain_format.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <limits>
#include <memory>
#include <system_error>
#include <utility>
#include <vector>

#include "epsnet/certify/text.h"
#include "epsnet/netgen/ear_clipping.h"
#include "epsnet/triangulation/glued_polygons.h"

namespace epsnet {
namespace {

using certify::in_quotes;

constexpr std::size_t kMaxFileSize = std::size_t{256} << 20;
constexpr std::size_t kManySides = 256;
constexpr std::string_view kWhiteSpace = " \t\n\v\f\r";

/// The words of the text and the lines that they are on.
class Words {
 public:
  Words(std::string_view text, std::string_view name) : rest_(text), name_(name) {}

  /// The next word; `expected` completes the message if there is none.
  std::string_view next(const std::string& expected) {
    skip_white_space();
    if (rest_.empty()) fail("the text ends here, expected " + expected);
    const std::string_view word = rest_.substr(0, rest_.find_first_of(kWhiteSpace));
    rest_.remove_prefix(word.size());
    return word;
  }

  void expect_end() {
    skip_white_space();
    if (rest_.empty()) return;
    fail(in_quotes(next("")) + " follows the last vertex, expected the end of the text");
  }

  /// An unsigned number of 32 bits.
  std::uint32_t index(const std::string& expected) {
    const std::string_view word = next(expected);
    std::uint32_t value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size()) {
      fail(in_quotes(word) + " found, expected " + expected);
    }
    return value;
  }

  Rational rational(const std::string& expected) {
    const std::string_view word = next(expected);
    const std::optional<mpq_class> value = certify::parse_rational(word);
    if (!value) {
      fail(in_quotes(word) + " found, expected " + expected +
           ": a rational number p/q or p of at most 10^6 digits (decimals are not accepted)");
    }
    return Rational(value->get_mpq_t());
  }

  [[nodiscard]] std::size_t line() const { return line_; }
  [[noreturn]] void fail(const std::string& message) const { fail_at(line_, message); }
  [[noreturn]] void fail_at(std::size_t line, const std::string& message) const {
    throw DomainError(std::string(name_) + ":" + std::to_string(line) + ": " + message);
  }

 private:
  void skip_white_space() {
    const std::size_t length = std::min(rest_.find_first_not_of(kWhiteSpace), rest_.size());
    line_ +=
        static_cast<std::size_t>(std::count(rest_.begin(), rest_.begin() + static_cast<std::ptrdiff_t>(length), '\n'));
    rest_.remove_prefix(length);
  }

  std::string_view rest_;
  std::string_view name_;
  std::size_t line_ = 1;
};

struct Domain {
  Tile polygon;
  std::vector<Gluing> gluing;
};

std::vector<Gluing> read_pairing(Words& words, std::uint32_t size) {
  std::vector<std::uint32_t> partner;
  std::vector<std::size_t> line;
  const std::string range =
      ", from 0 to " + std::to_string(size - 1) + " (the text claims " + std::to_string(size) + " sides)";
  // Grows with the text, not with what it claims.
  for (std::uint32_t k = 0; k < size; ++k) {
    const std::string expected = "the index of the side paired with side " + std::to_string(k) + range;
    partner.push_back(words.index(expected));
    line.push_back(words.line());
    if (partner[k] >= size) words.fail(std::to_string(partner[k]) + " found, expected " + expected);
    if (partner[k] == k) words.fail("side " + std::to_string(k) + " is paired with itself");
  }
  std::vector<Gluing> gluing;
  for (std::uint32_t k = 0; k < size; ++k) {
    if (partner[partner[k]] != k) {
      words.fail_at(line[k], "side " + std::to_string(k) + " is paired with side " + std::to_string(partner[k]) +
                                 ", but side " + std::to_string(partner[k]) + " with side " +
                                 std::to_string(partner[partner[k]]));
    }
    if (k < partner[k]) gluing.push_back({0, k, 0, partner[k]});
  }
  return gluing;
}

Domain parse(std::string_view text, std::string_view name) {
  Words words(text, name);
  const std::uint32_t size = words.index("the number of sides, an even number from 8 to 2^32 - 2");
  if (size < 8 || size % 2 != 0) {
    words.fail(std::to_string(size) + " sides found, expected an even number, at least 8 (genus 2)");
  }
  Domain domain;
  domain.gluing = read_pairing(words, size);
  for (std::uint32_t k = 0; k < size; ++k) {
    const std::string vertex = "vertex " + std::to_string(k);
    const Complex<Rational> z{words.rational("the x coordinate of " + vertex),
                              words.rational("the y coordinate of " + vertex)};
    if (disk_gap(scaled(z)) <= 0) {
      words.fail(vertex + " lies outside of the open unit disk, expected |z| < 1, found |z|^2 = " +
                 certify::shortest(static_cast<double>(Mp256(norm(z)))));
    }
    domain.polygon.push_back(z);
  }
  words.expect_end();
  return domain;
}

Surface make_surface(Domain domain) {
  std::vector<Tile> tiles{std::move(domain.polygon)};
  std::vector<Gluing> gluing;
  {
    GluedPolygons polygon(tiles, domain.gluing);
    polygon.check_vertices();
    const std::optional<std::string> problem = polygon.convexity_problem();
    if (!problem) return {std::move(tiles), std::move(domain.gluing)};
    if (tiles[0].size() > kMaxNonConvexSides) {
      throw SurfaceError(*problem + "; polygons that are not convex may have at most " +
                         std::to_string(kMaxNonConvexSides) + " sides");
    }
    // "Intersects itself" says more than "lengths differ". For large polygons, the quick tests keep the quadratic one
    // from junk.
    if (tiles[0].size() > kManySides) {
      polygon.check_lengths();
      polygon.check_angles();
    }
    if (const auto pair = crossing_sides(polygon.klein_points())) {
      throw SurfaceError("the polygon intersects itself: side " + std::to_string(pair->first) + " meets side " +
                         std::to_string(pair->second));
    }
    if (polygon.clockwise(0)) throw SurfaceError(*problem);
    polygon.check_lengths();
    polygon.check_angles();
    PolygonTriangulation triangulation = clip_ears(polygon.klein_points());
    const Tile vertices = std::move(tiles[0]);
    tiles.clear();
    for (const auto& [a, b, c] : triangulation.triangles) tiles.push_back({vertices[a], vertices[b], vertices[c]});
    gluing = std::move(triangulation.diagonals);
    for (const Gluing& pair : domain.gluing) {
      const auto [tile, side] = triangulation.place_of_side[pair.side];
      const auto [other_tile, other_side] = triangulation.place_of_side[pair.other_side];
      gluing.push_back({tile, side, other_tile, other_side});
    }
  }
  return {std::move(tiles), std::move(gluing)};
}

}  // namespace

Surface read_domain(std::string_view text, std::string_view name) {
  Domain domain = parse(text, name);
  try {
    return make_surface(std::move(domain));
  } catch (const SurfaceError& error) {
    throw DomainError(std::string(name) + ": " + error.what());
  }
}

Surface load_domain(const std::filesystem::path& path) {
  const std::string name = path.string();
  const auto fail = [&](const std::string& what) { throw DomainError(name + ": " + what); };
  const auto reason = [] { return std::system_category().message(errno); };
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(name.c_str(), "rb"), &std::fclose);
  if (!file) fail("cannot be opened: " + reason());
  std::string text;
  std::vector<char> block(std::size_t{1} << 16);
  while (const std::size_t count = std::fread(block.data(), 1, block.size(), file.get())) {
    if (count > kMaxFileSize - text.size()) fail("is larger than 256 MiB");
    text.append(block.data(), count);
  }
  if (std::ferror(file.get()) != 0) fail("cannot be read: " + reason());
  return read_domain(text, name);
}

std::string write_domain(const Surface& surface) {
  if (surface.tiles().size() != 1) {
    throw std::invalid_argument("the domain format holds one polygon, the surface has " +
                                std::to_string(surface.tiles().size()) + " tiles");
  }
  std::string text = std::to_string(surface.side_count()) + "\n";
  for (std::uint32_t s = 0; s < surface.side_count(); ++s) text += std::to_string(surface.partner(s)) + "\n";
  const auto fraction = [](const Rational& value) { return numerator(value).str() + "/" + denominator(value).str(); };
  for (const auto& [x, y] : surface.tiles()[0]) text += fraction(x) + " " + fraction(y) + "\n";
  return text;
}

}  // namespace epsnet
