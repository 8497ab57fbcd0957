#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "kernel/numbers.h"

/// What the options of many tasks consist of.
namespace epsnet {

/// A positive hyperbolic length, exactly: a decimal such as "0.1" (that is 1/10) or a rational "p/q". For example, ε is
/// a Length.
///
/// The constructors throw std::invalid_argument for anything else (not a number, zero, negative, NaN, infinite, more
/// than 10⁶ digits). Its what() is one line that quotes the text, shortened.
class Length {
 public:
  /// Reads a text by the grammar of docs/format.md ("decimal"). Throws std::invalid_argument.
  explicit Length(std::string text);
  /// Takes the shortest decimal that reads back as `value`: Length(0.1) is 1/10. Throws std::invalid_argument.
  explicit Length(double value);

  /// Returns the number as it was given.
  [[nodiscard]] const std::string& text() const { return text_; }
  /// Returns its exact value.
  [[nodiscard]] const Rational& value() const { return value_; }

 private:
  std::string text_;
  Rational value_;
};

/// Reports the progress of a computation: called occasionally, from the thread that started it, with the name of the
/// current step and the share of it done, 0 to 1. The text is valid during the call only.
/// certify::CheckOptions::progress has this type.
using Progress = std::function<void(std::string_view what, double share)>;

}  // namespace epsnet
