#pragma once

#include <string>

#include "kernel/numbers.h"

namespace epsnet {

/// ε as an exact number: a decimal such as "0.1" (that is 1/10) or a rational "p/q", positive; a hyperbolic length.
///
/// Throws std::invalid_argument, which quotes the text, for anything else: not a number, zero, negative, NaN, infinite.
class Length {
 public:
  explicit Length(std::string text);
  /// The shortest decimal that reads back as `value`: Length(0.1) is 1/10.
  explicit Length(double value);

  [[nodiscard]] const std::string& text() const { return text_; }
  [[nodiscard]] const Rational& value() const { return value_; }
  /// Whether ε ≤ ln √2, decided exactly: the limit for pseudo ε-nets (thesis Lemma III.9).
  [[nodiscard]] bool allows_pseudo_nets() const;

 private:
  std::string text_;
  Rational value_;
};

}  // namespace epsnet
