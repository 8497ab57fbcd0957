#include <algorithm>
#include <cctype>
#include <charconv>
#include <utility>

#include "certify/base/text.h"
#include "netgen/curves/curves.h"
#include "netgen/curves/radial_graph.h"
#include "netgen/pants/pants.h"
#include "netgen/surfaces/group.h"

namespace epsnet {
namespace {

/// Of 64 bits, as that of GMP: in the WebAssembly module std::int64_t is another type, which gmpxx does not multiply.
long to_long(std::int64_t x) {
  static_assert(sizeof(long) == sizeof(std::int64_t));
  return x;
}

/// Words are reduced in time that is quadratic in that, at worst.
constexpr std::size_t kMostLetters = 10'000;

using Matrix = std::vector<std::vector<mpz_class>>;

Matrix identity_matrix(std::size_t size) {
  Matrix result(size, std::vector<mpz_class>(size));
  for (std::size_t i = 0; i < size; ++i) result[i][i] = 1;
  return result;
}

Matrix product(const Matrix& a, const Matrix& b) {
  Matrix result(a.size(), std::vector<mpz_class>(a.size()));
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t k = 0; k < a.size(); ++k) {
      if (a[i][k] == 0) continue;
      for (std::size_t j = 0; j < a.size(); ++j) result[i][j] += a[i][k] * b[k][j];
    }
  }
  return result;
}

/// The algebraic intersection number with a basis curve, in coefficients of a symplectic basis.
std::int64_t product_with_basis(const std::vector<std::int64_t>& x, std::size_t j) {
  return j % 2 == 0 ? -x[j + 1] : x[j - 1];
}

bool is_space(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }
bool is_upper(char c) { return std::isupper(static_cast<unsigned char>(c)) != 0; }
char lower(char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); }

/// Reads a product of Dehn twists.
class Parser {
 public:
  Parser(std::string_view text, const std::vector<NamedCurve>& names) : text_(text), names_(names) {}

  [[nodiscard]] MappingClass read() {
    MappingClass result;
    for (skip(); at_ < text_.size(); skip()) {
      DehnTwist twist = text_[at_] == '(' ? word() : named();
      if (at_ < text_.size() && text_[at_] == '^') twist.power = power(twist.power);
      result.push_back(std::move(twist));
    }
    return result;
  }

 private:
  void skip() {
    while (at_ < text_.size() && (is_space(text_[at_]) || text_[at_] == '*')) ++at_;
  }

  [[noreturn]] void refuse(std::size_t at, const std::string& expected) const {
    throw MappingClassError("at character " + std::to_string(at + 1) + " of " + certify::in_quotes(text_) +
                            ": expected " + expected);
  }

  template <class T>
  [[nodiscard]] std::optional<T> number() {
    T value = 0;
    const auto [end, error] = std::from_chars(text_.data() + at_, text_.data() + text_.size(), value);
    if (error != std::errc()) return std::nullopt;
    at_ = static_cast<std::size_t>(end - text_.data());
    return value;
  }

  DehnTwist word() {
    const std::size_t start = at_++;
    DehnTwist result;
    for (;;) {
      while (at_ < text_.size() && (is_space(text_[at_]) || text_[at_] == ',')) ++at_;
      if (at_ == text_.size()) refuse(start, "a word that ends with )");
      if (text_[at_] == ')') break;
      const auto side = number<std::uint32_t>();
      if (!side) refuse(at_, "the number of a side, or )");
      result.curve.emplace_back(*side);
    }
    ++at_;
    return result;
  }

  DehnTwist named() {
    const std::size_t start = at_;
    const auto is_of_name = [&](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; };
    while (at_ < text_.size() && is_of_name(text_[at_])) ++at_;
    std::string name(text_.substr(start, at_ - start));
    const bool inverted = !name.empty() && is_upper(name.front());
    if (inverted) name.front() = lower(name.front());
    const auto found =
        std::find_if(names_.begin(), names_.end(), [&](const NamedCurve& one) { return one.name == name; });
    if (found == names_.end()) {
      refuse(start, "a name from a1 to " + names_.back().name +
                        ", in upper case for the inverse, or a word of sides in parentheses");
    }
    return {found->curve, inverted ? -1 : 1};
  }

  std::int32_t power(std::int32_t sign) {
    const std::size_t start = at_++;
    const auto value = number<std::int32_t>();
    if (!value || *value < -kMostTwists || *value > kMostTwists) {
      refuse(start, "an exponent from -" + std::to_string(kMostTwists) + " to " + std::to_string(kMostTwists));
    }
    return sign * *value;
  }

  std::string_view text_;
  const std::vector<NamedCurve>& names_;
  std::size_t at_ = 0;
};

/// The curve of a factor of f. Throws CurveError.
ClosedCurve curve_of(const CurveTopology& topology, const MappingClass& f, const DehnTwist& twist) {
  const auto number = static_cast<std::size_t>(&twist - f.data());
  try {
    ClosedCurve curve = topology.curve(twist.curve);
    if (curve.is_null_homotopic()) throw CurveError(number, "null-homotopic");
    if (curve.power != 1) throw CurveError(number, "power " + std::to_string(curve.power) + " of another closed curve");
    if (!curve.is_simple()) throw CurveError(number, "not simple");
    return curve;
  } catch (const SurfaceError& error) {
    throw CurveError(number, error.problem());
  }
}

}  // namespace

MappingClass inverse(const MappingClass& f) {
  MappingClass result(f.rbegin(), f.rend());
  for (DehnTwist& twist : result) twist.power = -twist.power;
  return result;
}

MappingClass product(MappingClass f, const MappingClass& g) {
  f.insert(f.end(), g.begin(), g.end());
  return f;
}

MappingClassGroup::MappingClassGroup(const Surface& surface) : surface_(surface), topology_(surface) {
  const std::vector<Word>& basis = topology_.homology_basis();
  const std::uint32_t genus = surface.genus();
  const auto a = [&](std::size_t i) { return basis[2 * i]; };
  const auto b = [&](std::size_t i) { return basis[2 * i + 1]; };
  // A part of the relation [a₁, b₁][a₂, b₂]… = 1, as a_i and b_i are.
  const auto c = [&](std::size_t i) {
    Word word = concatenated(surface_, b(i), reversed(surface_, a(i)));
    word = concatenated(surface_, std::move(word), reversed(surface_, b(i)));
    return concatenated(surface_, std::move(word), a(i + 1));
  };
  const auto add = [&](char letter, std::size_t count, const auto& curve) {
    for (std::size_t i = 0; i < count; ++i) {
      generators_.push_back({letter + std::to_string(i + 1), topology_.word(topology_.curve(curve(i)))});
    }
  };
  add('a', genus, a);
  add('b', genus, b);
  add('c', genus - 1, c);
  chain_.push_back(graph().walk_of(a(0)));
  for (std::size_t i = 0; i < genus; ++i) {
    if (i > 0) chain_.push_back(graph().walk_of(c(i - 1)));
    chain_.push_back(graph().walk_of(b(i)));
  }
}

MappingClass MappingClassGroup::parse(std::string_view text) const { return Parser(text, generators_).read(); }

std::vector<MappingClassGroup::Images> MappingClassGroup::images_of(const MappingClass& f) const {
  std::vector<Images> result;
  for (std::size_t i = 0; i < f.size(); ++i) {
    const auto same = std::find_if(f.begin(), f.begin() + static_cast<std::ptrdiff_t>(i), [&](const DehnTwist& other) {
      return other.power == f[i].power && other.curve == f[i].curve;
    });
    const auto before = static_cast<std::size_t>(same - f.begin());
    try {
      result.push_back(before < i ? result[before] : dehn_twist_words(surface_, f[i].curve, f[i].power));
    } catch (const CurveError& error) {
      throw CurveError(i, error.problem());
    }
  }
  return result;
}

MappingClassGroup::Walk MappingClassGroup::image(const std::vector<Images>& f, Walk curve) const {
  for (auto twist = f.rbegin(); twist != f.rend(); ++twist) {
    Word image;
    for (const SideId s : graph().path(graph().sides_of(curve))) {
      image = concatenated(surface_, std::move(image), (*twist)[s]);
      if (image.size() > kMostLetters) {
        throw LimitError("the image of a curve has more than " + std::to_string(kMostLetters) + " letters");
      }
    }
    curve = graph().walk_of(image);
  }
  return curve;
}

ClosedCurve MappingClassGroup::image(const MappingClass& f, const ClosedCurve& curve) const {
  if (curve.is_null_homotopic()) return curve;
  // Its power, its self-intersections, and what is on its left stay as they are.
  ClosedCurve result = curve;
  result.root = image(images_of(f), curve.root);
  const Matrix matrix = homology(f);
  for (std::size_t i = 0; i < matrix.size(); ++i) {
    mpz_class sum;
    for (std::size_t j = 0; j < matrix.size(); ++j) sum += matrix[i][j] * to_long(curve.homology[j]);
    result.homology[i] = sum.get_si();
  }
  return result;
}

Matrix MappingClassGroup::homology(const MappingClass& f) const {
  const std::size_t size = topology_.homology_basis().size();
  Matrix result = identity_matrix(size);
  // T(x) = x + power · ⟨x, c⟩ c, from the last one on; rows of the product so far are multiplied with T.
  for (const DehnTwist& twist : f) {
    const ClosedCurve curve = curve_of(topology_, f, twist);
    const std::vector<std::int64_t>& c = curve.homology;
    for (std::vector<mpz_class>& row : result) {
      mpz_class along;
      for (std::size_t i = 0; i < size; ++i) along += row[i] * to_long(c[i]);
      along *= twist.power;
      for (std::size_t j = 0; j < size; ++j) row[j] -= along * to_long(product_with_basis(c, j));
    }
  }
  return result;
}

bool MappingClassGroup::is_identity(const MappingClass& f) const {
  if (homology(f) != identity_matrix(topology_.homology_basis().size())) return false;
  const std::vector<Images> images = images_of(f);
  return std::all_of(chain_.begin(), chain_.end(), [&](const Walk& curve) { return image(images, curve) == curve; });
}

std::optional<std::uint32_t> MappingClassGroup::order(const MappingClass& f) const {
  const Matrix matrix = homology(f);
  const Matrix one = identity_matrix(matrix.size());
  const std::uint32_t most = 4 * surface_.genus() + 2;
  std::uint32_t order = 1;
  for (Matrix power = matrix; power != one; power = product(power, matrix)) {
    if (++order > most) return std::nullopt;
  }
  // fⁿ fixes a curve if and only if a power of f makes of it what a power of its inverse does.
  const std::vector<Images> forward = images_of(f);
  const std::vector<Images> backward = images_of(inverse(f));
  for (const Walk& curve : chain_) {
    Walk ahead = curve;
    Walk behind = curve;
    for (std::uint32_t i = 0; i < order; ++i) {
      if (i % 2 == 0) {
        ahead = image(forward, std::move(ahead));
      } else {
        behind = image(backward, std::move(behind));
      }
    }
    if (ahead != behind) return std::nullopt;
  }
  return order;
}

bool MappingClassGroup::is_isometry(const MappingClass& f, const SurfaceIsometry& isometry) const {
  if (!isometry.preserves_orientation) return false;
  // By side of the surface: the image of the path across it; none for sides inside of the polygon. The generator of
  // side k is the path across its partner.
  Images image_of_side(surface_.side_count());
  const PolygonSides polygon = polygon_sides(surface_);
  std::size_t generator = 0;
  for (std::uint32_t k = 0; k < polygon.side.size(); ++k) {
    if (k > polygon.partner[k]) continue;
    const Word& word = isometry.images[generator++];
    image_of_side[polygon.side[polygon.partner[k]]] = word;
    image_of_side[polygon.side[k]] = reversed(surface_, word);
  }
  const std::vector<Images> own = images_of(f);
  return std::all_of(chain_.begin(), chain_.end(),
                     [&](const Walk& curve) { return image(own, curve) == image({image_of_side}, curve); });
}

namespace {

/// A word of a surface for the surface of triangles into which the diagonals from corner 0 cut its tiles, from and to
/// the first triangle of a tile.
Word through_triangles(const Surface& surface, const Word& word) {
  std::vector<std::uint32_t> first_triangle{0};
  for (const TileId tile : surface.tile_ids()) {
    first_triangle.push_back(first_triangle.back() + static_cast<std::uint32_t>(surface.tile(tile).size()) - 2);
  }
  Word result;
  for (const SideId s : word) {
    const auto triangle_of = [&](SideId side) {
      const auto last = static_cast<std::uint32_t>(surface.tile(surface.tile_of_side(side)).size()) - 3;
      const std::uint32_t place = surface.place_in_tile(side);
      return place == 0 ? 0 : std::min(place - 1, last);
    };
    const std::uint32_t first = first_triangle[surface.tile_of_side(s).number()];
    const std::uint32_t out = triangle_of(s);
    for (std::uint32_t k = 0; k < out; ++k) result.emplace_back(3 * (first + k) + 2);
    const std::uint32_t place = surface.place_in_tile(s);
    const bool is_last = place + 1 == surface.tile(surface.tile_of_side(s)).size();
    result.emplace_back(3 * (first + out) + (place == 0 ? 0U : is_last ? 2U : 1U));
    const SideId other = surface.partner(s);
    const std::uint32_t beyond = first_triangle[surface.tile_of_side(other).number()];
    for (std::uint32_t k = triangle_of(other); k > 0; --k) result.emplace_back(3 * (beyond + k));
  }
  return result;
}

}  // namespace

Surface with_marking(const Surface& surface, const MappingClass& f) {
  Surface result = surface;
  for (std::size_t i = 0; i < f.size(); ++i) {
    // A word of the result stands for its image under the twists before, and so does this twist.
    try {
      result = dehn_twisted(result, i == 0 ? f[i].curve : through_triangles(surface, f[i].curve), f[i].power);
    } catch (const CurveError& error) {
      throw CurveError(i, error.problem());
    }
  }
  return result;
}

}  // namespace epsnet
