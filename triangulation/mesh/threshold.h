#pragma once

#include <array>
#include <optional>

#include "kernel/numbers.h"

namespace epsnet {

/// Encloses the number sinh²x for an exact x > 0, with which circumradii (x = ε) and distances (x = ε/2) are compared.
/// There is an enclosure, lower end first, for each stage of the predicates; it is computed on first use. MPFR rounds
/// the ends correctly, so they are the same on every machine.
class Threshold {
 public:
  /// Encloses sinh²x. Requires: x > 0.
  explicit Threshold(Rational x);

  /// The ends in T: double, Mp256, Mp1024, Mp4096.
  template <class T>
  [[nodiscard]] const std::array<T, 2>& at() const;
  /// The lower end at the binary64 stage.
  [[nodiscard]] double low() const { return ends_[0]; }
  /// The upper end at the binary64 stage.
  [[nodiscard]] double high() const { return ends_[1]; }

 private:
  Rational x_;
  std::array<double, 2> ends_;
  mutable std::optional<std::array<Mp256, 2>> at_256_;
  mutable std::optional<std::array<Mp1024, 2>> at_1024_;
  mutable std::optional<std::array<Mp4096, 2>> at_4096_;
};

}  // namespace epsnet
