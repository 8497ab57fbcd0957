#pragma once

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <concepts>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "certify/document/text.h"
#include "kernel/numbers.h"
#include "netgen/base/gmp.h"

/// What the readers of text formats share: words separated by white space, and the line that each is on.
namespace epsnet {

/// The words of a text, read one after the other. Everything that is not as expected throws `Error`, an exception made
/// from one line of text: "NAME:LINE: what was wrong, what was expected".
template <class Error>
class TokenReader {
 public:
  /// Keeps a reference to the text, which must outlive it. `name` stands for the text in messages.
  TokenReader(std::string_view text, std::string_view name) : rest_(text), name_(name) {}
  template <std::same_as<std::string> Text>
  TokenReader(Text&&, std::string_view) = delete;  // A temporary string would be gone.

  /// The next word; `expected` completes the message if there is none.
  std::string_view next(const std::string& expected) {
    skip_white_space();
    if (rest_.empty()) fail("the text ends here, expected " + expected);
    const std::string_view word = rest_.substr(0, rest_.find_first_of(kWhiteSpace));
    rest_.remove_prefix(word.size());
    return word;
  }

  /// `last` is what the text should have ended with.
  void expect_end(const std::string& last) {
    skip_white_space();
    if (rest_.empty()) return;
    fail(certify::in_quotes(next("")) + " follows " + last + ", expected the end of the text");
  }

  /// An unsigned number of 32 bits.
  std::uint32_t index(const std::string& expected) {
    const std::string_view word = next(expected);
    std::uint32_t value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size()) {
      fail(certify::in_quotes(word) + " found, expected " + expected);
    }
    return value;
  }

  Rational rational(const std::string& expected) {
    const std::string_view word = next(expected);
    const std::optional<mpq_class> value = certify::parse_rational(word);
    if (!value) {
      fail(certify::in_quotes(word) + " found, expected " + expected +
           ": a rational number p/q or p of at most 10^6 digits (decimals are not accepted)");
    }
    return from_gmp(*value);
  }

  /// The line of the last word.
  [[nodiscard]] std::size_t line() const { return line_; }
  [[noreturn]] void fail(const std::string& message) const { fail_at(line_, message); }
  [[noreturn]] void fail_at(std::size_t line, const std::string& message) const {
    throw Error(name_ + ":" + std::to_string(line) + ": " + message);
  }

 private:
  static constexpr std::string_view kWhiteSpace = " \t\n\v\f\r";

  void skip_white_space() {
    const std::size_t length = std::min(rest_.find_first_not_of(kWhiteSpace), rest_.size());
    line_ +=
        static_cast<std::size_t>(std::count(rest_.begin(), rest_.begin() + static_cast<std::ptrdiff_t>(length), '\n'));
    rest_.remove_prefix(length);
  }

  std::string_view rest_;
  std::string name_;
  std::size_t line_ = 1;
};

/// The contents of a file of at most 256 MiB. Throws `Error` where the file cannot be read.
template <class Error>
[[nodiscard]] std::string read_text_file(const std::filesystem::path& path) {
  constexpr std::size_t kMaxFileSize = std::size_t{256} << 20;
  const std::string name = path.string();
  const auto fail = [&](const std::string& what) { throw Error(name + ": " + what); };
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
  return text;
}

}  // namespace epsnet
