#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "certify/base/error.h"
#include "certify/file/pieces.h"

namespace epsnet::certify {

/// The text is not JSON. what() says what is wrong, not where.
class JsonError : public LocatedError {
 public:
  using LocatedError::LocatedError;
};

/// A JSON text (RFC 8259) from front to back, each byte once.
///
/// Who reads it says what is to come next, so what is nested deeper than that is not entered. Numbers are handed over
/// as they are written. Strings must be UTF-8, without lone surrogates. All functions pass over white space first, and
/// throw JsonError. O(size); memory for the string, number or name that is being read.
class Json {
 public:
  explicit Json(Pieces& text) : text_(text) {}

  /// Returns the first character of the next token; 0 at the end of the text.
  [[nodiscard]] char next() { return next_ != end_ && *next_ > ' ' ? *next_ : next_of_any_kind(); }

  /// Whether nothing but white space is left.
  [[nodiscard]] bool at_end() { return next() == '\0' && next_ == end_; }

  /// Takes one of the characters []{},: if it is next, and returns whether it was.
  bool take(char mark) {
    if (next() != mark) return false;
    ++next_;
    return true;
  }

  /// Returns all that stands before the next white space, mark or quotation mark: a number or a literal as it is
  /// written, or what is neither. Valid until the next call of any function.
  [[nodiscard]] std::string_view token();

  /// Takes an integer of at most nine digits that a comma or bracket follows. Returns false, and takes nothing, if
  /// there is anything else, or if the end of what is in memory is too near; then token() says what is there.
  bool take_small_integer(std::uint32_t& value) {
    constexpr int kMaxDigits = 9;
    const char first = next();
    if (end_ - next_ <= kMaxDigits) return false;
    const char* const limit = next_ + kMaxDigits;
    const char* last = next_;
    std::uint32_t result = 0;
    for (; last != limit; ++last) {
      const auto digit = static_cast<std::uint32_t>(static_cast<unsigned char>(*last)) - '0';
      if (digit > 9) break;
      result = 10 * result + digit;
    }
    if (last == next_ || (*last != ',' && *last != ']') || (first == '0' && last != next_ + 1)) return false;
    next_ = last;
    value = result;
    return true;
  }

  /// Returns the characters that a string means. Valid until the next string. Requires: next() == '"'.
  [[nodiscard]] std::string_view string();

  /// Calls read_element(position) for each element of an array. Requires: '[' was taken.
  template <class ReadElement>
  void elements(const ReadElement& read_element) {
    if (take(']')) return;
    std::size_t position = 0;
    do {
      read_element(position++);
    } while (take(','));
    if (!take(']')) fail_to_find("\",\" or \"]\"");
  }

  /// Calls read_member(name) for each member of an object, repeated ones as well. The name is valid until the next
  /// string. Requires: '{' was taken.
  template <class ReadMember>
  void members(const ReadMember& read_member) {
    if (take('}')) return;
    do {
      read_member(member_name());
    } while (take(','));
    if (!take('}')) fail_to_find("\",\" or \"}\"");
  }

  /// Takes the name of a member and the colon behind it. The name is valid until the next string.
  [[nodiscard]] std::string_view member_name();

  /// Passes over a value. What is nested in it need not be JSON.
  void skip();

  /// Returns words for what is next, for messages, and may take it.
  [[nodiscard]] std::string found();

 private:
  char next_of_any_kind();
  bool more();
  char character();
  unsigned code_unit();
  void escape();
  [[noreturn]] void fail_to_find(const char* expected);

  Pieces& text_;
  const char* begin_ = nullptr;  ///< What is in memory of the text begins here; it is taken up to next_.
  const char* next_ = nullptr;
  const char* end_ = nullptr;
  std::string string_;
};

}  // namespace epsnet::certify
