#pragma once

#include <vector>

#include "certify/exact/interval.h"

namespace epsnet::exact {

/// Lemma 37.1: F_0, …, F_M at s <= ½, by the series of F_M and F_(M + 1), and then (b).
class RadialFactors {
 public:
  /// Throws TooLarge if λ is so large that the terms of a series may not decrease where it ends.
  RadialFactors(const Interval& lambda, long order);

  /// Throws TooLarge unless s <= ½ for certain.
  [[nodiscard]] std::vector<Interval> operator()(const Interval& s) const;

 private:
  /// For x <= 1. Terms alternate, and decrease from (i + 1)(m + 1) >= λ on: the rest is less than the first of them.
  class Series {
   public:
    Series(const Interval& lambda, long m);
    [[nodiscard]] Interval at(const Interval& x) const;

   private:
    std::vector<Interval> coefficients_;
    Interval rest_;
  };

  Series last_;
  Series next_;
  std::vector<Interval> weights_;  ///< By m − 1: 1 + λ/(m(m + 1)).
};

}  // namespace epsnet::exact
