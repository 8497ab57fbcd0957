#include "certify/file/json.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>

#include "certify/base/text.h"
#include "certify/file/file.h"

namespace epsnet::certify {

void ByteStream::read(std::size_t size) {
  constexpr std::size_t kBlock = std::size_t{1} << 18;  // Fits into caches.
  if (!here_.empty()) std::memmove(buffer_.data(), here_.data(), here_.size());
  const std::size_t kept = here_.size();
  const std::size_t wanted = std::max(size, kBlock) - kept;
  const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(wanted, unread_));
  buffer_.resize(std::max(buffer_.size(), kept + count));
  if (std::fread(buffer_.data() + kept, 1, count, file_) != count) throw MalformedError("the file ends early");
  unread_ -= count;
  if (witness_) witness_({buffer_.data() + kept, count});
  here_ = {buffer_.data(), kept + count};
}

namespace {

constexpr std::string_view kWhiteSpace = " \t\n\r";

/// Characters that are no part of a number or a literal.
constexpr std::string_view kDelimiters = " \t\n\r[]{},:\"";

constexpr auto kDelimits = [] {
  std::array<bool, 256> table{};
  for (const char c : kDelimiters) table[static_cast<unsigned char>(c)] = true;
  return table;
}();

bool delimits(char c) { return kDelimits[static_cast<unsigned char>(c)]; }

void append_utf8(std::string& text, std::uint32_t code) {
  const auto add = [&](std::uint32_t byte) { text += static_cast<char>(static_cast<unsigned char>(byte)); };
  if (code < 0x80) return add(code);
  if (code < 0x800) {
    add(0xc0U | code >> 6U);
  } else {
    if (code < 0x10000) {
      add(0xe0U | code >> 12U);
    } else {
      add(0xf0U | code >> 18U);
      add(0x80U | (code >> 12U & 0x3fU));
    }
    add(0x80U | (code >> 6U & 0x3fU));
  }
  add(0x80U | (code & 0x3fU));
}

}  // namespace

/// As next(), also where there is white space, or the end of what is in memory.
char Json::next_of_any_kind() {
  while (next_ != end_ || more()) {
    if (kWhiteSpace.find(*next_) == std::string_view::npos) return *next_;
    ++next_;
  }
  return '\0';
}

/// Gets more bytes behind those that are not taken yet, twice as many or so. Returns whether there were any.
bool Json::more() {
  const auto kept = static_cast<std::size_t>(end_ - next_);
  text_.skip(static_cast<std::size_t>(next_ - begin_));
  const std::string_view ahead = text_.ahead(2 * kept + 1);
  begin_ = next_ = ahead.data();
  end_ = begin_ + ahead.size();
  return ahead.size() > kept;
}

std::string_view Json::token() {
  static_cast<void>(next());
  const char* last = next_;
  for (;;) {
    while (last != end_ && !delimits(*last)) ++last;
    const auto length = last - next_;
    if (last != end_ || !more()) {
      const std::string_view token(next_, static_cast<std::size_t>(length));
      next_ += length;
      return token;
    }
    last = next_ + length;
  }
}

/// The next character of a string.
char Json::character() {
  if (next_ == end_ && !more()) throw JsonError("a string does not end");
  return *next_++;
}

/// Four hexadecimal digits.
unsigned Json::code_unit() {
  unsigned code = 0;
  for (int i = 0; i < 4; ++i) {
    constexpr std::string_view kDigits = "0123456789abcdef0123456789ABCDEF";
    const std::size_t digit = kDigits.find(character());
    if (digit == std::string_view::npos) throw JsonError("a string has \"\\u\" without four hexadecimal digits");
    code = 16 * code + static_cast<unsigned>(digit % 16);
  }
  return code;
}

/// What stands behind a backslash.
void Json::escape() {
  constexpr std::string_view kEscapes = "\"\\/bfnrt";
  constexpr std::string_view kMeanings = "\"\\/\b\f\n\r\t";
  const char kind = character();
  if (kind != 'u') {
    const std::size_t which = kEscapes.find(kind);
    if (which == std::string_view::npos) throw JsonError("a string has an escape that JSON does not have");
    string_ += kMeanings[which];
    return;
  }
  const auto is_low = [](unsigned code) { return code >= 0xdc00 && code < 0xe000; };
  std::uint32_t code = code_unit();
  if (code >= 0xd800 && code < 0xe000) {
    const bool pair = !is_low(code) && character() == '\\' && character() == 'u';
    const unsigned low = pair ? code_unit() : 0;
    if (!is_low(low)) throw JsonError("a string has a lone surrogate");
    code = 0x10000 + ((code - 0xd800) << 10U) + (low - 0xdc00);
  }
  append_utf8(string_, code);
}

std::string_view Json::string() {
  string_.clear();
  ++next_;
  for (;;) {
    const char* const first = next_;
    const auto is_special = [](char c) { return c == '"' || c == '\\' || static_cast<unsigned char>(c) < 0x20; };
    next_ = std::find_if(first, end_, is_special);
    string_.append(first, next_);
    if (next_ == end_ && more()) continue;
    const char special = character();
    if (special == '"') break;
    if (special != '\\') throw JsonError("a string has a character that must be escaped");
    escape();
  }
  // What escapes stand for is whole characters, so it does not hide what is wrong around them.
  if (!is_utf8(string_)) throw JsonError("a string is not valid UTF-8");
  return string_;
}

/// What is next is not what should be.
void Json::fail_to_find(const char* expected) {
  throw JsonError(ErrorParts{.problem = found() + " found", .expected = expected});
}

std::string_view Json::member_name() {
  if (next() != '"') fail_to_find("the name of a member");
  const std::string_view name = string();
  if (!take(':')) fail_to_find("\":\" behind the name of a member");
  return name;
}

void Json::skip() {
  std::size_t depth = 0;
  do {
    const char first = next();
    if (first == '"') {
      static_cast<void>(string());
    } else if (!delimits(first)) {
      if (token().empty()) throw JsonError("the text ends early");
    } else if (first == '[' || first == '{') {
      ++depth;
      ++next_;
    } else {
      if (depth == 0) fail_to_find("a value");
      if (first == ']' || first == '}') --depth;
      ++next_;
    }
  } while (depth > 0);
}

std::string Json::found() {
  if (at_end()) return "the end of the text";
  const char first = next();
  if (first == '"') return "the string " + in_quotes(string());
  if (first == '[') return "an array";
  if (first == '{') return "an object";
  return in_quotes(delimits(first) ? std::string_view(&first, 1) : token());
}

}  // namespace epsnet::certify
