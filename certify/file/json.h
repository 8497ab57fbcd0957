#pragma once

#include <cstdint>
#include <cstdio>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "certify/base/error.h"

namespace epsnet::certify {

/// The bytes of a file from front to back, of which a part is in memory at a time.
class ByteStream {
 public:
  /// Is shown all bytes of a file in their order.
  using Witness = std::function<void(std::string_view)>;

  /// Bytes that are all in memory.
  explicit ByteStream(std::string_view bytes) : here_(bytes) {}
  /// The next `size` bytes of an open file.
  ByteStream(std::FILE* file, std::uint64_t size, Witness witness)
      : file_(file), unread_(size), witness_(std::move(witness)) {}
  ByteStream(const ByteStream&) = delete;
  ByteStream& operator=(const ByteStream&) = delete;

  /// What is in memory of the bytes to come: `size` bytes at least, or all that are left. Good until the next call.
  /// Throws MalformedError if the file is shorter than it was said to be, or cannot be read.
  [[nodiscard]] std::string_view ahead(std::size_t size) {
    if (here_.size() < size && unread_ > 0) read(size);
    return here_;
  }
  /// Goes on behind bytes that are in memory.
  void skip(std::size_t size) { here_.remove_prefix(size); }
  /// Goes on to the end, and shows the witness what is left.
  void skip_all() {
    while (left() > 0) skip(ahead(1).size());
  }
  [[nodiscard]] std::uint64_t left() const { return here_.size() + unread_; }

 private:
  void read(std::size_t size);

  std::FILE* file_ = nullptr;
  std::uint64_t unread_ = 0;
  Witness witness_;
  std::vector<char> buffer_;
  std::string_view here_;
};

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
  explicit Json(ByteStream& text) : text_(text) {}

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

  ByteStream& text_;
  const char* begin_ = nullptr;  ///< What is in memory of the text begins here; it is taken up to next_.
  const char* next_ = nullptr;
  const char* end_ = nullptr;
  std::string string_;
};

}  // namespace epsnet::certify
