#include "certify/file/document_reader.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <limits>
#include <memory>
#include <string_view>
#include <sys/stat.h>
#include <system_error>
#include <tuple>
#include <type_traits>
#include <unistd.h>
#include <utility>
#include <variant>

#include "certify/base/interval.h"
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

namespace {

constexpr std::uint64_t kMaxFileBytes = std::uint64_t{4} << 30;
// Indices of rows are stored in 32 bits: a row takes two bytes or more, and a comma.
static_assert(kMaxFileBytes / 3 < std::numeric_limits<std::uint32_t>::max());

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

/// The bytes of a file, from the beginning as often as they are asked for.
class Source {
 public:
  explicit Source(std::string_view bytes) : size_(bytes.size()), bytes_(bytes) {}
  Source(std::FILE* file, std::uint64_t size) : size_(size), file_(file) {}

  [[nodiscard]] std::uint64_t size() const { return size_; }
  [[nodiscard]] ByteStream open_bytes(const Witness& witness = {}) const {
    if (file_ == nullptr) return ByteStream(bytes_);
    std::rewind(file_);
    return {file_, size_, witness};
  }

 private:
  std::uint64_t size_;
  std::FILE* file_ = nullptr;
  std::string_view bytes_;
};

constexpr const char* kTooLarge = "the file is larger than the limit of 4 GiB";

void read_source(const Source& source, const Witness& witness, Structure structure, DocumentPointer document) {
  ByteStream bytes = source.open_bytes(witness);
  try {
    read_document(bytes, document, structure);
  } catch (const MalformedError&) {
    bytes.skip_all();
    throw;
  }
}

/// An empty document of the kind that the format names, or else of the first.
template <class... Documents>
void choose(std::variant<Documents...>& document, const std::optional<std::string>& format) {
  (void)((format == Fields<Documents>::kKind.format && (document.template emplace<Documents>(), true)) || ...);
}

void read_source(const Source& source, const Witness& witness, Structure structure, ClaimDocument* document) {
  ByteStream beginning = source.open_bytes();
  choose(*document, format_of(beginning));
  read_source(source, witness, structure, std::visit([](auto& one) -> DocumentPointer { return &one; }, *document));
}

void read_contents(const Source& source, std::string_view name, const Witness& witness, Structure structure,
                   ContentsPointer contents) {
  const RoundingToNearest rounding;
  try {
    if (source.size() > kMaxFileBytes) throw MalformedError(ErrorParts{.place = "document", .problem = kTooLarge});
    std::visit([&](auto* one) { read_source(source, witness, structure, one); }, contents);
  } catch (const MalformedError& error) {
    ErrorParts parts = error.parts();
    parts.file = name;
    throw MalformedError(parts);
  }
}

/// Opens a file that should be read in chunks, and says how large it is.
std::pair<File, std::uint64_t> open_large_file(const std::filesystem::path& path) {
  File file(nullptr, &std::fclose);
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return {std::move(file), 0};
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (!error && size > kMaxBytesAtOnce && size <= kMaxFileBytes) file.reset(std::fopen(path.c_str(), "rb"));
  return {std::move(file), size};
}

}  // namespace

std::string display_name(const std::filesystem::path& path) {
  return path == "-" ? "standard input" : path_in_quotes(path.string());
}

std::string load(const std::filesystem::path& path) {
  const std::string name = display_name(path);
  const auto fail_to_read = [&](const std::string& why, const std::string& expected = {}) {
    throw FileError(ErrorParts{.file = name, .problem = why, .expected = expected});
  };
  std::FILE* file = stdin;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> opened(nullptr, &std::fclose);
  if (path != "-") {
    opened.reset(std::fopen(path.c_str(), "rb"));
    if (!opened)
      fail_to_read(errno == ENOENT ? "no such file" : "cannot be opened: " + std::string(std::strerror(errno)));
    file = opened.get();
  }
  struct stat status {};
  if (fstat(fileno(file), &status) != 0) fail_to_read("cannot be read: " + std::string(std::strerror(errno)));
  if (S_ISDIR(status.st_mode)) fail_to_read("is a directory", "a file");
  // Of the devices only a terminal ends: /dev/zero never would.
  if ((S_ISCHR(status.st_mode) && isatty(fileno(file)) == 0) || S_ISBLK(status.st_mode)) {
    fail_to_read("is a device", "a file");
  }
  std::string bytes;
  constexpr std::size_t kChunk = 1 << 20;
  if (S_ISREG(status.st_mode) && static_cast<std::uint64_t>(status.st_size) <= kMaxFileBytes) {
    // The last chunk, which is not filled, has to fit in as well.
    bytes.reserve(static_cast<std::size_t>(status.st_size) + kChunk);
  }
  for (std::size_t read = kChunk; read == kChunk;) {
    const std::size_t old_size = bytes.size();
    bytes.resize(old_size + kChunk);
    read = std::fread(bytes.data() + old_size, 1, kChunk, file);
    bytes.resize(old_size + read);
    if (bytes.size() > kMaxFileBytes) {
      throw MalformedError(ErrorParts{.file = name, .place = "document", .problem = kTooLarge});
    }
  }
  if (std::ferror(file) != 0) fail_to_read("cannot be read: " + std::string(std::strerror(errno)));
  return bytes;
}

void read_file_into(ContentsPointer contents, const std::filesystem::path& path, const Witness& witness,
                    Structure structure) {
  const std::string name = display_name(path);
  if (const auto [file, size] = open_large_file(path); file) {
    return read_contents(Source(file.get(), size), name, witness, structure, contents);
  }
  const std::string bytes = load(path);
  if (witness) witness(bytes);
  read_contents(Source(bytes), name, {}, structure, contents);
}

void parse_file_into(ContentsPointer contents, std::string_view bytes, std::string_view name) {
  read_contents(Source(bytes), name, {}, Structure::checked, contents);
}

}  // namespace epsnet::certify
