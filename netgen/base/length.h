#pragma once

#include <string>

#include "kernel/numbers.h"

namespace epsnet {

/// A positive hyperbolic length, exactly: a decimal such as "0.1" (that is 1/10) or a rational "p/q". ε is one.
///
/// What is anything else (not a number, zero, negative, NaN, infinite, more than 10⁶ digits) throws
/// std::invalid_argument, whose what() is one line that quotes the text, shortened.
class Length {
 public:
  /// The number that the text is, by the grammar of docs/format.md ("decimal").
  explicit Length(std::string text);
  /// The shortest decimal that reads back as `value`: Length(0.1) is 1/10.
  explicit Length(double value);

  /// The number as it was given.
  [[nodiscard]] const std::string& text() const { return text_; }
  /// Its exact value.
  [[nodiscard]] const Rational& value() const { return value_; }

 private:
  std::string text_;
  Rational value_;
};

}  // namespace epsnet
