#include "certify/file/document_reader.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <string_view>
#include <system_error>
#include <tuple>
#include <type_traits>

#include "certify/base/text.h"
#include "certify/claims.h"
#include "certify/file/compact.h"
#include "certify/file/file.h"
#include "certify/file/json.h"

namespace epsnet::certify {
namespace {

constexpr std::size_t kMaxWordLetters = 1'000'000;
constexpr std::size_t kMaxLettersInAll = 10'000'000;

/// "a", "b" or "c".
template <std::size_t kSize>
std::string listed(const std::array<std::string_view, kSize>& names) {
  std::string result;
  for (std::size_t i = 0; i < kSize; ++i) {
    result += (i == 0 ? "" : i + 1 < kSize ? ", " : " or ") + in_quotes(names[i]);
  }
  return result;
}

/// Where we are in the file: member[row].part, kept so that the good case formats nothing.
struct Place {
  const char* prefix = "";
  std::string_view member;
  std::size_t row = 0;
  bool in_row = false;
  std::string_view part = {};

  [[nodiscard]] std::string text() const {
    std::string result = prefix + std::string(member);
    if (in_row) result += "[" + std::to_string(row) + "]";
    if (!part.empty()) result += "." + std::string(part);
    return result;
  }
};

constexpr Place kDocument{.member = "document"};

/// Reads values as their types and fields.h say. What is wrong is said of the place where it is.
class Reader {
 public:
  explicit Reader(ByteStream& text) : json_(text) {}

  /// Reads a text that consists of one object.
  template <class Root>
  void read_all(Root& root) {
    try {
      if (json_.at_end()) fail("the input is empty", "an object");
      read(root);
      place_ = kDocument;
      if (!json_.at_end()) fail("text after the end of the document");
    } catch (const JsonError& error) {
      fail(error.problem(), error.expected());
    }
  }

 private:
  [[noreturn]] void fail(const std::string& problem, const std::string& expected = {}) const {
    throw MalformedError(ErrorParts{.place = place_.text(), .problem = problem, .expected = expected});
  }

  [[noreturn]] void fail_to_find(const std::string& expected) { fail(json_.found() + " found", expected); }

  void open(char bracket, const std::string& expected) {
    if (!json_.take(bracket)) fail_to_find(expected);
  }

  /// A number or literal. Not empty.
  std::string_view token(const char* expected) {
    const std::string_view token = json_.token();
    if (token.empty()) fail_to_find(expected);
    return token;
  }

  std::string_view string(const char* expected) {
    if (json_.next() != '"') fail_to_find(expected);
    return json_.string();
  }

  void read(std::uint32_t& index) {
    if (!json_.take_small_integer(index)) read_token(index);
  }

  void read_token(std::uint32_t& index) {
    constexpr const char* kExpected = "an index: an integer >= 0 without sign, fraction or exponent";
    const std::string_view text = token(kExpected);
    const char* const end = text.data() + text.size();
    const auto [last, error] = std::from_chars(text.data(), end, index);
    const bool digits = last == end && (text.front() != '0' || text.size() == 1);
    if (digits && error == std::errc()) return;
    if (digits && error == std::errc::result_out_of_range) fail("the index " + in_quotes(text) + " is too large");
    fail(in_quotes(text) + " found", kExpected);
  }

  void read(std::uint64_t& integer) { read_integer(integer, "an integer >= 0 without sign, fraction or exponent"); }
  void read(std::int64_t& integer) { read_integer(integer, "an integer without fraction or exponent"); }

  template <class Integer>
  void read_integer(Integer& integer, const char* expected) {
    const std::string_view text = token(expected);
    const char* const end = text.data() + text.size();
    const auto [last, error] = std::from_chars(text.data(), end, integer);
    const bool digits = last == end && (text == "0" || text[text.front() == '-' ? 1 : 0] != '0');
    if (digits && error == std::errc()) return;
    if (digits && error == std::errc::result_out_of_range) fail("the integer " + in_quotes(text) + " is too large");
    fail(in_quotes(text) + " found", expected);
  }

  void read(double& number) {
    constexpr const char* kExpected = "a finite binary64 number";
    const std::string_view text = token(kExpected);
    const auto value = parse_binary64(text);
    if (!value) fail(in_quotes(text) + " found", kExpected);
    number = *value;
  }

  void read(mpq_class& rational) {
    const std::string_view text = string("a rational in a string, such as \"-3/4\"");
    auto value = parse_rational(text);
    if (!value) fail(in_quotes(text) + " is not a rational of at most 10^6 digits, such as \"-3/4\"");
    rational = *std::move(value);
  }

  void read(std::vector<mpz_class>& integers) {
    constexpr const char* kExpected = "an integer in a string, such as \"-3\"";
    open('[', "an array of integers in strings");
    json_.elements([&](std::size_t) {
      const std::string_view text = string(kExpected);
      const auto value = text.find('/') == std::string_view::npos ? parse_rational(text) : std::nullopt;
      if (!value) fail(in_quotes(text) + " is not an integer of at most 10^6 digits, such as \"-3\"");
      integers.push_back(value->get_num());
    });
  }

  void read(std::string& text) { text = string("a string"); }

  void read(bool& truth) {
    constexpr const char* kExpected = "true or false";
    const std::string_view text = token(kExpected);
    truth = text == "true";
    if (!truth && text != "false") fail(in_quotes(text) + " found", kExpected);
  }

  void read(std::vector<std::uint32_t>& word) {
    open('[', "a word, an array of side numbers");
    json_.elements([&](std::size_t position) {
      if (position >= kMaxWordLetters) fail("the word has more than the limit of 10^6 letters");
      if (++letters_in_all_ > kMaxLettersInAll) fail("more than the limit of 10^7 letters in all");
      read(word.emplace_back());
    });
  }

  template <class T>
  void read(std::optional<T>& value) {
    read(value.emplace());
  }

  /// An array of which each element is a row, unless this is part of one.
  template <class T>
  void read(std::vector<T>& list) {
    if constexpr (Array<T>) {
      if (place_.in_row) {
        open('[', std::string("an array of ") + Fields<T>::kExpected);
        json_.elements([&](std::size_t) { read(list.emplace_back()); });
        return;
      }
    }
    read_rows(list, [&](T& row) { read(row); });
  }

  void read(std::vector<double>& numbers) {
    open('[', "an array of numbers");
    json_.elements([&](std::size_t) { read(numbers.emplace_back()); });
  }

  void read(std::vector<std::int64_t>& integers) {
    open('[', "an array of integers");
    json_.elements([&](std::size_t) { read(integers.emplace_back()); });
  }

  void read(const List<std::vector<std::uint32_t>>& list) {
    open('[', "an array of indices");
    json_.elements([&](std::size_t) { read(list.indices.emplace_back()); });
  }

  void read(const List<std::vector<std::vector<std::uint32_t>>>& list) {
    read_rows(list.indices, [&](std::vector<std::uint32_t>& row) { read(List{row}); });
  }

  template <class Row, class ReadRow>
  void read_rows(std::vector<Row>& rows, const ReadRow& read_row) {
    open('[', "an array");
    json_.elements([&](std::size_t position) {
      place_.in_row = true;
      place_.row = position;
      read_row(rows.emplace_back());
      place_.in_row = false;
    });
  }

  template <Array T>
  void read(T& array) {
    open('[', Fields<T>::kExpected);
    std::size_t position = 0;
    std::apply([&](auto&&... element) { (read_element<T>(element, position++), ...); }, Fields<T>::elements(array));
    if (json_.take(']')) return;
    if (json_.next() == ',') fail("too many elements", Fields<T>::kExpected);
    fail_to_find("\",\" or \"]\"");
  }

  template <class T, class Element>
  void read_element(Element& element, std::size_t position) {
    if (position == 0 ? json_.next() == ']' : !json_.take(',')) fail_to_find_element(position, Fields<T>::kExpected);
    read(element);
  }

  [[noreturn]] void fail_to_find_element(std::size_t position, const char* expected) {
    if (json_.next() != ']') fail_to_find("\",\" or \"]\"");
    fail("has " + std::to_string(position) + " elements", expected);
  }

  /// All elements that are left.
  template <class T>
  void read_element(List<std::vector<std::uint32_t>>& rest, std::size_t) {
    while (json_.take(',')) read(rest.indices.emplace_back());
  }

  template <Object T>
  void read(T& object) {
    open('{', "an object");
    if constexpr (requires { Fields<T>::kName; }) place_ = {.member = Fields<T>::kName};
    const Place place = place_;
    std::array<bool, std::tuple_size_v<decltype(Fields<T>::members(object))>> seen{};
    json_.members([&](std::string_view name) {
      std::size_t position = 0;
      const auto read_if_named = [&](auto& member) {
        if (member.name != name) {
          ++position;
          return false;
        }
        if (seen[position]) fail("repeated member " + in_quotes(name));
        seen[position] = true;
        read_member<T>(member, place);
        return true;
      };
      auto members = Fields<T>::members(object);
      const bool known = std::apply([&](auto&... member) { return (read_if_named(member) || ...); }, members);
      if (!known) fail("unknown member " + in_quotes(name));
    });
    std::size_t position = 0;
    const auto check_presence = [&](const auto& member) {
      const bool found = seen[position++];
      if (member.presence == (found ? Presence::forbidden : Presence::required)) {
        fail((found ? "unknown member " : "missing member ") + in_quotes(member.name) + member.condition);
      }
    };
    // Which members there must be may depend on what others say.
    std::apply([&](const auto&... member) { (check_presence(member), ...); }, Fields<T>::members(object));
  }

  /// Reads the value of a member of an object at the place.
  template <class T, class Value>
  void read_member(Member<Value>& member, const Place& place) {
    if constexpr (requires { Fields<T>::kPrefix; }) {
      place_ = {.prefix = Fields<T>::kPrefix, .member = member.name};
    } else {
      place_.part = member.name;
    }
    using Plain = std::remove_reference_t<Value>;
    if constexpr (std::is_same_v<Plain, std::string>) {
      member.value = string(member.expected);
    } else if constexpr (std::is_same_v<Plain, Format>) {
      const std::string_view text = string("a string");
      place_ = place;
      one_of(std::array{member.value.name}, member.name, text);
    } else if constexpr (std::is_same_v<Plain, Version>) {
      std::uint32_t version = 0;
      read(version);
      place_ = place;
      if (version != member.value.number) {
        fail("version " + std::to_string(version) + " is not a version this program reads",
             std::to_string(member.value.number));
      }
    } else if constexpr (Enumeration<Plain>) {
      const std::string_view text = string("a string");
      place_ = place;
      member.value = static_cast<Plain>(one_of(Fields<Plain>::kNames, member.name, text));
    } else {
      if constexpr (requires { member.value.reserve(member.rows); }) member.value.reserve(member.rows);
      read(member.value);
    }
    place_ = place;
  }

  template <std::size_t kSize>
  std::size_t one_of(const std::array<std::string_view, kSize>& names, std::string_view member, std::string_view text) {
    const auto found = std::find(names.begin(), names.end(), text);
    if (found == names.end()) fail(in_quotes(member) + " is " + in_quotes(text), listed(names));
    return static_cast<std::size_t>(found - names.begin());
  }

  void read(SurfaceDocument& surface) {
    SurfaceObject<SurfaceDocument> object{surface, SurfaceKind::tiles};
    read(object);
    // A genus of 0 would read as "not regular" in the document, p = 0 as "no map" and an empty polynomial as "no
    // field", so the ranges are checked here.
    const auto require = [&](const char* member, const std::optional<std::string>& problem) {
      place_ = {.prefix = "surface.", .member = member};
      if (problem) fail(*problem);
    };
    if (object.kind == SurfaceKind::regular) require("genus", regular_genus_problem(surface.regular_genus));
    if (object.kind == SurfaceKind::map) require("p", map_number_problem(surface.map_tile.p));
    if (object.kind == SurfaceKind::field) require("polynomial", polynomial_problem(surface.field.polynomial));
  }

  Json json_;
  Place place_ = kDocument;
  std::size_t letters_in_all_ = 0;
};

template <class Root>
void read_text(ByteStream& text, Root& root) {
  if (text.ahead(3).starts_with("\xef\xbb\xbf")) {
    throw MalformedError(
        ErrorParts{.place = "document", .problem = "begins with a byte order mark", .expected = "an object"});
  }
  Reader(text).read_all(root);
}

NetDocument read_compact_head(std::string_view text) {
  ByteStream head(text);
  NetDocument document;
  try {
    read_text(head, document);
  } catch (const MalformedError& error) {
    throw MalformedError(
        ErrorParts{.place = "head", .problem = error.place() + ": " + error.problem(), .expected = error.expected()});
  }
  return document;
}

template <class Document>
void read_bytes(ByteStream& bytes, Document& document) {
  read_text(bytes, document);
}
void read_bytes(ByteStream& bytes, SurfaceDocument& document) {
  SurfaceFile<SurfaceDocument> file{document};
  read_text(bytes, file);
}
void read_bytes(ByteStream& bytes, NetDocument& document) {
  if (is_compact(bytes.ahead(kCompactMagic.size()))) {
    document = parse_compact(bytes, read_compact_head);
  } else {
    read_text(bytes, document);
  }
}

/// The parts of a problem of the structure: "PLACE: what is wrong, expected …" (structure_problem).
ErrorParts parts_of(const std::string& problem) {
  constexpr std::string_view kColon = ": ";
  constexpr std::string_view kExpected = ", expected ";
  ErrorParts parts{.problem = problem};
  if (const std::size_t colon = problem.find(kColon); colon != std::string::npos) {
    parts.place = problem.substr(0, colon);
    parts.problem = problem.substr(colon + kColon.size());
  }
  if (const std::size_t comma = parts.problem.rfind(kExpected); comma != std::string::npos) {
    parts.expected = parts.problem.substr(comma + kExpected.size());
    parts.problem.resize(comma);
  }
  return parts;
}

}  // namespace

void read_document(ByteStream& bytes, DocumentPointer document, Structure structure) {
  const auto problem = std::visit(
      [&](auto* one) {
        read_bytes(bytes, *one);
        return structure == Structure::checked ? structure_problem(*one) : std::nullopt;
      },
      document);
  if (problem) throw MalformedError(parts_of(*problem));
}

std::optional<std::string> format_of(ByteStream& bytes) {
  try {
    Json json(bytes);
    if (!json.take('{')) return std::nullopt;
    do {
      if (json.member_name() == "format")
        return json.next() == '"' ? std::optional<std::string>(json.string()) : std::nullopt;
      json.skip();
    } while (json.take(','));
  } catch (const JsonError&) {
    return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace epsnet::certify
