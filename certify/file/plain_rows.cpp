#include "certify/file/plain_rows.h"

#include <algorithm>
#include <charconv>
#include <string_view>
#include <system_error>

#include "certify/base/text.h"

namespace epsnet::certify {
namespace {

/// A row, or the beginning of an array of rows, in more bytes than this is not plain.
constexpr std::size_t kLongestRow = 4096;

/// Where more than this is left of a text without its rows, it is not worth taking apart.
constexpr std::size_t kLongestRest = std::size_t{1} << 26;

bool is_white(char c) { return c == ' ' || c == '\n' || c == '\t' || c == '\r'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_of_number(char c) { return is_digit(c) || c == '.' || c == '-' || c == 'e' || c == 'E' || c == '+'; }

/// Tokens from the beginning of a text on. Each function says whether there was what it looked for.
class Tokens {
 public:
  explicit Tokens(std::string_view text) : next_(text.data()), end_(text.data() + text.size()) {}

  [[nodiscard]] const char* place() const { return next_; }

  bool mark(char wanted) {
    while (next_ != end_ && is_white(*next_)) ++next_;
    if (next_ == end_ || *next_ != wanted) return false;
    ++next_;
    return true;
  }

  bool index(std::uint32_t& value) {
    while (next_ != end_ && is_white(*next_)) ++next_;
    const char* const first = next_;
    const auto [last, error] = std::from_chars(first, end_, value);  // Digits alone: without a sign there is none.
    next_ = last;
    return error == std::errc() && (*first != '0' || last == first + 1);
  }

  bool binary64(double& value) {
    while (next_ != end_ && is_white(*next_)) ++next_;
    const char* const first = next_;
    while (next_ != end_ && is_of_number(*next_)) ++next_;
    const auto number = parse_binary64({first, next_});
    if (number) value = *number;
    return number.has_value();
  }

 private:
  const char* next_;
  const char* end_;
};

bool read(Tokens& row, NetDocument::Vertex& vertex) {
  return row.index(vertex.chart) && row.mark(',') && row.binary64(vertex.x) && row.mark(',') && row.binary64(vertex.y);
}

bool read(Tokens& row, NetDocument::Triangle& triangle) {
  const auto indices = [&](auto& numbers) {
    for (std::uint32_t& number : numbers) {
      if (&number != &numbers.front() && !row.mark(',')) return false;
      if (!row.index(number)) return false;
    }
    return true;
  };
  return indices(triangle.vertex) && row.mark(',') && indices(triangle.opposite) && row.mark(',') &&
         indices(triangle.label);
}

/// Reads rows to the end of their array.
template <class Row>
bool read_rows(Pieces& text, std::vector<Row>& rows) {
  for (;;) {
    const std::string_view ahead = text.ahead(kLongestRow);
    Tokens tokens(ahead);
    Row row{};
    if (!tokens.mark('[') || !read(tokens, row) || !tokens.mark(']')) return false;
    rows.push_back(row);
    const bool more = tokens.mark(',');
    if (!more && !tokens.mark(']')) return false;
    text.skip(static_cast<std::size_t>(tokens.place() - ahead.data()));
    if (!more) return true;
  }
}

/// The length of a member's name, of the colon behind it and the bracket that opens its value; 0 if that is not what
/// the text begins with, or if no array follows inside.
std::size_t rows_begin(std::string_view text, std::string_view name) {
  if (!text.starts_with(name)) return 0;
  Tokens tokens(text.substr(name.size()));
  if (!tokens.mark(':') || !tokens.mark('[')) return 0;
  const auto length = static_cast<std::size_t>(tokens.place() - text.data());
  return tokens.mark('[') ? length : 0;
}

void move(Pieces& text, std::size_t size, std::string& to) {
  const std::string_view moved = text.ahead(size).substr(0, size);
  to += moved;
  text.skip(moved.size());
}

/// Moves what is before the first of some characters, and says whether there is one before the rest gets too long.
bool move_until(Pieces& text, std::string_view characters, std::string& to) {
  while (text.left() > 0 && to.size() <= kLongestRest) {
    const std::string_view ahead = text.ahead(1).substr(0, kLongestRow);
    const std::size_t found = ahead.find_first_of(characters);
    move(text, std::min(found, ahead.size()), to);
    if (found != std::string_view::npos) return true;
  }
  return false;
}

/// Moves a string, quotation marks and all.
void move_string(Pieces& text, std::string& to) {
  move(text, 1, to);
  while (move_until(text, "\"\\", to) && text.ahead(1).front() == '\\') move(text, 2, to);
  move(text, 1, to);
}

}  // namespace

std::optional<PlainRows> take_plain_rows(Pieces& text) {
  PlainRows result;
  while (move_until(text, "\"", result.rest)) {
    const std::string_view ahead = text.ahead(kLongestRow);
    const std::size_t vertices = result.vertices.empty() ? rows_begin(ahead, "\"vertices\"") : 0;
    const std::size_t triangles = result.triangles.empty() ? rows_begin(ahead, "\"triangles\"") : 0;
    if (vertices + triangles == 0) {
      move_string(text, result.rest);
      continue;
    }
    move(text, vertices + triangles, result.rest);
    result.rest += ']';
    if (!(vertices != 0 ? read_rows(text, result.vertices) : read_rows(text, result.triangles))) return std::nullopt;
    // A guess, so that the array does not grow step by step: twice as many triangles, and a few.
    if (vertices != 0) result.triangles.reserve(2 * result.vertices.size() + 1000);
  }
  // Where something is left, the rest is too long.
  if (text.left() > 0 || (result.vertices.empty() && result.triangles.empty())) return std::nullopt;
  return result;
}

}  // namespace epsnet::certify
