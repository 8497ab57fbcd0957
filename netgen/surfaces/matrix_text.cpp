#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <sstream>
#include <string_view>
#include <utility>

#include "certify/base/text.h"
#include "certify/file/json.h"
#include "netgen/base/gmp.h"
#include "netgen/base/json_text.h"
#include "netgen/surfaces/exact_isometries.h"
#include "netgen/surfaces/group.h"
#include "netgen/surfaces/number_field.h"
#include "netgen/surfaces/relations.h"
#include "netgen/surfaces/triangle_group.h"
#include "triangulation/surface/exact_polygons.h"

/// Matrices as text: JSON or a matrix in each line.
namespace epsnet {
namespace {

constexpr std::size_t kMostGenerators = 1000;
constexpr std::size_t kMostBitsOfEntry = 100'000;

[[noreturn]] void fail(const std::string& message) { throw MatricesError(MatricesError::Kind::text, message); }

/// The significant digits of a decimal; nothing for integers and fractions.
std::optional<unsigned> digits_of_decimal(std::string_view text) {
  if (text.find_first_of(".eE") == std::string_view::npos) return std::nullopt;
  unsigned digits = 0;
  for (const char c : text.substr(0, text.find_first_of("eE"))) {
    if (std::isdigit(static_cast<unsigned char>(c)) != 0 && (digits > 0 || c != '0')) ++digits;
  }
  return digits;
}

class MatrixReader {
 public:
  MatrixGenerators read(const std::string& text) {
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    if (first == std::string::npos) fail("the text is empty, expected matrices");
    if (text[first] == '{') {
      read_json(text);
    } else {
      read_lines(text);
    }
    if (entries_.empty()) fail("no generators found, expected at least one");
    if (!algebra_.empty()) split_quaternions();
    if (result_.tile || !all_rational()) {
      result_.numbers = entries_;
    } else {
      for (std::size_t k = 0; k < entries_.size(); ++k) result_.generators.push_back(isometry(k));
    }
    const auto most = static_cast<std::int32_t>(entries_.size());
    for (const std::int32_t letter : result_.relation) {
      if (letter == 0 || letter > most || -letter > most) {
        fail("relation: " + letter_name(letter) + " found, expected generators 1 to " + std::to_string(most) +
             ", negative for inverses, or letters from a on");
      }
    }
    return std::move(result_);
  }

 private:
  static std::string letter_name(std::int32_t letter) { return std::to_string(letter); }

  void set_model(std::string_view name) {
    if (name == "sl2r") {
      result_.model = MatrixModel::sl2r;
    } else if (name == "su11") {
      result_.model = MatrixModel::su11;
    } else {
      fail("model: " + certify::in_quotes(name) + R"( found, expected "sl2r" or "su11")");
    }
  }

  /// Whether no entry needs a field: roots and cosines have letters, products and parentheses.
  [[nodiscard]] bool all_rational() const {
    return std::all_of(entries_.begin(), entries_.end(), [](const auto& matrix) {
      return std::all_of(matrix.begin(), matrix.end(),
                         [](const std::string& entry) { return entry.find_first_of("(*^") == std::string::npos; });
    });
  }

  Rational number(std::string_view text, const std::string& place) {
    const auto value = text.size() <= kMostBitsOfEntry ? parse_decimal(text) : std::nullopt;
    if (!value) {
      fail(place + ": " + certify::in_quotes(text) +
           " found, expected an integer, a fraction, a decimal, or a number with sqrt(x), cos(a*pi/b) or root(f,r)");
    }
    if (*value != 0 && msb(Integer(abs(numerator(*value)))) + msb(Integer(denominator(*value))) > kMostBitsOfEntry) {
      fail(place + ": more than " + std::to_string(kMostBitsOfEntry) + " bits");
    }
    if (const auto digits = digits_of_decimal(text)) result_.digits = std::max(result_.digits.value_or(0), *digits);
    return *value;
  }

  std::string name_of_next() const { return "generator " + std::to_string(entries_.size() + 1); }

  /// Requires: four numbers.
  void add(const std::vector<std::string>& entries, const std::string& place) {
    if (entries_.size() == kMostGenerators) fail("more than " + std::to_string(kMostGenerators) + " generators");
    entries_.push_back({entries[0], entries[1], entries[2], entries[3]});
    places_.push_back(place);
  }

  void set_tile(std::string_view p, std::string_view q) {
    const auto number_of = [](std::string_view text) {
      std::uint32_t value = 0;
      const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
      if (error != std::errc() || end != text.data() + text.size()) {
        fail("tiles: " + certify::in_quotes(text) +
             " found, expected the number p of sides, or q of tiles at a vertex");
      }
      return value;
    };
    result_.tile = RegularTile{number_of(p), number_of(q)};
  }

  Isometry<Rational> isometry(std::size_t k) {
    std::array<Rational, 4> e;
    for (std::size_t i = 0; i < e.size(); ++i) e.at(i) = number(entries_[k].at(i), places_[k]);
    Isometry<Rational> f = isometry_of_entries(e, result_.model);
    if (f.determinant() <= 0) {
      fail("generator " + std::to_string(k + 1) +
           ": the determinant is not positive, so it is no isometry of the plane" + " that preserves the orientation");
    }
    return f;
  }

  void read_letters(std::string_view word) {
    for (const char c : word) {
      if (c == ' ' || c == '*' || c == '.') continue;
      if (std::isalpha(static_cast<unsigned char>(c)) == 0) {
        fail("relation: " + certify::in_quotes(word) +
             " found, expected letters, a for generator 1, A for its inverse, or numbers");
      }
      const int letter = std::tolower(static_cast<unsigned char>(c)) - 'a' + 1;
      result_.relation.push_back(std::islower(static_cast<unsigned char>(c)) != 0 ? letter : -letter);
    }
  }

  void read_letter_number(std::string_view text) {
    std::int32_t letter = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), letter);
    if (error != std::errc() || end != text.data() + text.size()) {
      fail("relation: " + certify::in_quotes(text) + " found, expected the number of a generator");
    }
    result_.relation.push_back(letter);
  }

  void read_lines(const std::string& text) {
    std::istringstream lines(text);
    std::string line;
    for (std::size_t number_of_line = 1; std::getline(lines, line); ++number_of_line) {
      line.erase(std::min(line.find('#'), line.size()));
      const std::vector<std::string> words = words_of(line);
      if (words.empty()) continue;
      const std::string place = "line " + std::to_string(number_of_line);
      if (words[0] == "model" && words.size() == 2) {
        set_model(words[1]);
      } else if (words[0] == "algebra" && words.size() == 3) {
        algebra_ = {words[1], words[2]};
      } else if (words[0] == "relation") {
        const bool is_number = words.size() > 1 && std::isalpha(static_cast<unsigned char>(words[1][0])) == 0;
        for (std::size_t i = 1; i < words.size(); ++i)
          is_number ? read_letter_number(words[i]) : read_letters(words[i]);
      } else if (words[0] == "tiles" && words.size() == 3) {
        set_tile(words[1], words[2]);
      } else if (words.size() == 4) {
        add(words, place);
      } else {
        fail(place + ": " + std::to_string(words.size()) + " words found, expected the four numbers of a matrix, " +
             "\"model sl2r\", \"model su11\", \"algebra a b\", \"tiles p q\" or \"relation\" and its letters");
      }
    }
  }

  /// Separated by spaces, commas and semicolons outside of parentheses.
  static std::vector<std::string> words_of(const std::string& line) {
    std::vector<std::string> words;
    int depth = 0;
    bool in_word = false;
    for (const char c : line) {
      const bool is_space = std::isspace(static_cast<unsigned char>(c)) != 0;
      if (depth <= 0 && (is_space || c == ',' || c == ';')) {
        in_word = false;
        continue;
      }
      if (!in_word) words.emplace_back();
      in_word = true;
      if (c == '(') ++depth;
      if (c == ')') --depth;
      if (!is_space) words.back() += c;
    }
    return words;
  }

  void read_json(const std::string& text) {
    certify::ByteStream bytes(text);
    certify::Json json(bytes);
    try {
      (void)json.take('{');
      json.members([&](std::string_view name) {
        if (name == "model") {
          expect_string(json, "model");
          set_model(json.string());
        } else if (name == "algebra") {
          algebra_.clear();
          expect_array(json, "algebra");
          json.elements([&](std::size_t) { algebra_.push_back(number_text(json)); });
          if (algebra_.size() != 2)
            fail("algebra: " + std::to_string(algebra_.size()) + " numbers found, expected [a, b]");
        } else if (name == "tiles") {
          expect_array(json, "tiles");
          std::vector<std::string> pq;
          json.elements([&](std::size_t) { pq.emplace_back(json.token()); });
          if (pq.size() != 2) fail("tiles: " + std::to_string(pq.size()) + " numbers found, expected [p, q]");
          set_tile(pq[0], pq[1]);
        } else if (name == "generators") {
          entries_.clear();
          places_.clear();
          expect_array(json, "generators");
          json.elements([&](std::size_t) { read_matrix(json); });
        } else if (name == "relation") {
          result_.relation.clear();
          if (json.next() == '"') {
            read_letters(json.string());
          } else {
            expect_array(json, "relation");
            json.elements([&](std::size_t) { read_letter_number(json.token()); });
          }
        } else {
          json.skip();
        }
      });
      if (!json.at_end()) fail(json.found() + " found after the object");
    } catch (const certify::JsonError& error) {
      fail(error.what());
    }
  }

  /// Numbers may be strings, as fractions have to be.
  static std::string number_text(certify::Json& json) {
    return std::string(json.next() == '"' ? json.string() : json.token());
  }

  /// Quaternions x + yi + zj + wij, i² = a > 0 and j² = b, become the matrices x + y√a, z + w√a; b(z − w√a), x − y√a.
  /// If a < 0, i and j change their parts.
  void split_quaternions() {
    if (result_.tile || result_.model != MatrixModel::sl2r)
      fail("algebra: expected neither tiles nor model su11 beside it");
    bool exchanged = false;
    if (!has_root(algebra_[0])) {
      exchanged = true;
      std::swap(algebra_[0], algebra_[1]);
      if (!has_root(algebra_[0])) {
        fail("algebra: " + certify::in_quotes(algebra_[1]) + " and " + certify::in_quotes(algebra_[0]) +
             " found, expected a positive number: the algebra is that of a group of the hyperbolic plane");
      }
    }
    const std::string root = "sqrt(" + algebra_[0] + ")";
    for (auto& [x, y, z, w] : entries_) {
      if (exchanged) {
        std::swap(y, z);
        w = "-(" + w + ")";
      }
      const auto combined = [&](const std::string& one, const char* sign, const std::string& other) {
        return "(" + one + ")" + sign + "(" + other + ")*" + root;
      };
      std::array<std::string, 4> matrix{combined(x, "+", y), combined(z, "+", w),
                                        "(" + algebra_[1] + ")*(" + combined(z, "-", w) + ")", combined(x, "-", y)};
      x = std::move(matrix[0]);
      y = std::move(matrix[1]);
      z = std::move(matrix[2]);
      w = std::move(matrix[3]);
    }
  }

  /// Whether a number is positive.
  static bool has_root(const std::string& number) {
    NumberFieldReader reader;
    try {
      reader.add(number);
    } catch (const SurfaceError& error) {
      fail(std::string("algebra: ") + error.what());
    }
    try {
      reader.add("sqrt(" + number + ")");
      return true;
    } catch (const SurfaceError&) {
      return false;
    }
  }

  static void expect_string(certify::Json& json, const std::string& place) {
    if (json.next() != '"') fail(place + ": " + json.found() + " found, expected a string");
  }
  static void expect_array(certify::Json& json, const std::string& place) {
    if (!json.take('[')) fail(place + ": " + json.found() + " found, expected an array");
  }

  void read_matrix(certify::Json& json) {
    const std::string place = name_of_next();
    expect_array(json, place);
    std::vector<std::string> entries;
    std::size_t rows = 0;
    json.elements([&](std::size_t) {
      ++rows;
      expect_array(json, place);
      std::size_t columns = 0;
      json.elements([&](std::size_t) {
        ++columns;
        entries.push_back(number_text(json));
      });
      if (columns != 2) fail(place + ": " + std::to_string(columns) + " numbers in a row, expected 2");
    });
    if (rows != 2) {
      fail(place + ": " + std::to_string(rows) +
           " rows found, expected two: [[a, b], [c, d]], or [[Re a, Im a], [Re b, " + "Im b]] for su11");
    }
    add(entries, place);
  }

  MatrixGenerators result_;
  std::vector<std::array<std::string, 4>> entries_;
  std::vector<std::string> places_;   ///< Of entries.
  std::vector<std::string> algebra_;  ///< a and b, if entries are quaternions.
};

/// The four numbers of a matrix, as its text has them.
template <class T>
std::vector<T> entries(const Isometry<T>& f, MatrixModel model) {
  if (model == MatrixModel::su11) return {f.a.x, f.a.y, f.b.x, f.b.y};
  return {f.a.x + f.b.x, f.a.y - f.b.y, T(-f.a.y - f.b.y), f.a.x - f.b.x};
}

template <class T, class Text>
Json matrix_json(const Isometry<T>& f, MatrixModel model, const Text& text) {
  const std::vector<T> e = entries(f, model);
  return Json::array({Json::array({text(e[0]), text(e[1])}), Json::array({text(e[2]), text(e[3])})});
}

Json rounded_json(const Isometry<Mp1024>& f, MatrixModel model) {
  constexpr int kDigits = 50;
  return matrix_json(f, model, [](const Mp1024& x) { return x.str(kDigits, std::ios_base::fmtflags{}); });
}

/// The numbers of a matrix, exactly, up to a positive factor; texts(numbers) writes real ones.
template <class Number, class Texts>
Json irrational_matrix_json(const certify::Isometry<Number>& f, MatrixModel model, const Texts& texts) {
  const auto x = [](const Number& z) { return twice_real(z); };
  const auto y = [](const Number& z) { return twice_imaginary(z); };
  const std::vector<std::string> e =
      model == MatrixModel::su11
          ? texts({x(f.a), y(f.a), x(f.b), y(f.b)})
          : texts({x(f.a) + x(f.b), y(f.a) - y(f.b), mpz_class(-1) * (y(f.a) + y(f.b)), x(f.a) - x(f.b)});
  return Json::array({Json::array({e[0], e[1]}), Json::array({e[2], e[3]})});
}

/// The side pairings k < partner that one relation leaves, in their order.
std::vector<std::uint32_t> kept_generators(const PolygonSides& sides, const OneRelator& group) {
  std::vector<std::uint32_t> result;
  for (const std::uint32_t k : group.relation) {
    if (k < sides.partner[k]) result.push_back(k);
  }
  std::sort(result.begin(), result.end());
  return result;
}

/// k + 1 is kept generator k, −(k + 1) its inverse.
using Product = std::vector<std::int32_t>;

/// By side of the polygon: its isometry as a product of the kept generators, the first one on the left.
std::vector<Product> pairings(const PolygonSides& sides, const OneRelator& group) {
  std::vector<Product> result(sides.side.size());
  std::int32_t count = 0;
  for (const std::uint32_t k : kept_generators(sides, group)) {
    ++count;
    result[k] = {count};
    result[sides.partner[k]] = {-count};
  }
  for (auto one = group.expressed.rbegin(); one != group.expressed.rend(); ++one) {
    Product& product = result[one->side];
    for (const std::uint32_t k : one->word) {
      for (const std::int32_t letter : result[k]) {
        if (!product.empty() && product.back() == -letter) {
          product.pop_back();
        } else {
          product.push_back(letter);
        }
      }
    }
    Product& inverse = result[sides.partner[one->side]];
    for (auto letter = product.rbegin(); letter != product.rend(); ++letter) inverse.push_back(-*letter);
  }
  return result;
}

}  // namespace

MatrixGenerators parse_matrices(const std::string& text) { return MatrixReader().read(text); }

std::string write_matrices(const Surface& surface, MatrixModel model) {
  const PolygonSides sides = polygon_sides(surface);
  const OneRelator group(sides);
  const FundamentalPolygon polygon = fundamental_polygon(surface);
  Json exact = Json::array();
  Json rounded = Json::array();
  Json relation = Json::array();
  Json words = Json::array();
  Json products = Json::array();
  const std::string root = surface.field_tiles() ? root_text(*surface.field_tiles()) : "";
  std::optional<TriangleGroup> tiling;
  if (surface.is_regular()) tiling.emplace(*surface.regular_tile());
  const std::vector<Product> pairing = pairings(sides, group);
  for (const std::uint32_t k : kept_generators(sides, group)) {
    const Word& word = polygon.sides[k].word;
    words.push_back(word);
    Isometry<Mp1024> f;
    if (surface.is_regular()) {
      f = {{Mp1024(1), Mp1024(0)}, {Mp1024(0), Mp1024(0)}};
      for (const SideId s : word) f = surface.crossing_as<Mp1024>(s) * f;
      f = normalized(f);
      exact.push_back(irrational_matrix_json(tiling->element(walk_of(surface, word)), model, field_texts));
    } else if (surface.field_tiles()) {
      const certify::Isometry<certify::FieldNumber> isometry = field_isometry(surface, word);
      f = rounded_isometry<Mp1024>(isometry);
      exact.push_back(irrational_matrix_json(isometry, model, [&](const std::vector<certify::FieldNumber>& numbers) {
        return number_texts(numbers, root);
      }));
    } else {
      const Isometry<Rational> isometry = exact_isometry(surface, word);
      f = normalized(convert<Mp1024>(isometry));
      exact.push_back(matrix_json(isometry, model, [](const Rational& x) { return x.str(); }));
    }
    rounded.push_back(rounded_json(f, model));
  }
  for (const std::uint32_t k : group.relation) relation.push_back(pairing[k].front());
  for (std::uint32_t k = 0; k < pairing.size(); ++k) {
    if (k < sides.partner[k]) products.push_back(pairing[k]);
  }
  // One member in each line, one matrix in each line.
  std::ostringstream out;
  const auto list = [&](const char* name, const Json& items) {
    out << "  \"" << name << "\": [";
    for (std::size_t i = 0; i < items.size(); ++i) out << (i == 0 ? "\n    " : ",\n    ") << json_text(items[i]);
    out << "\n  ]";
  };
  out << "{\n  \"format\": \"epsnet-matrices\",\n  \"version\": 1,\n";
  out << "  \"about\": " << json_text(Json(surface.about())) << ",\n";
  out << "  \"model\": \"" << (model == MatrixModel::sl2r ? "sl2r" : "su11") << "\",\n";
  out << "  \"genus\": " << surface.genus() << ",\n";
  if (tiling) out << "  \"tiles\": [" << tiling->tile().p << ", " << tiling->tile().q << "],\n";
  list("generators", exact);
  out << ",\n  \"relation\": " << json_text(relation) << ",\n";
  list("rounded", rounded);
  out << ",\n";
  list("words", words);
  out << ",\n";
  list("pairings", products);
  out << "\n}\n";
  return out.str();
}

}  // namespace epsnet
