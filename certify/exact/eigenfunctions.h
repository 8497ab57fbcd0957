#pragma once

#include <cstddef>
#include <vector>

#include "certify/exact/document.h"
#include "certify/exact/interval.h"
#include "certify/exact/loops.h"

/// Functions around the vertices that nearly fit together (docs/proof.md, section 17).
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

/// By vertex: all other lifts of vertices nearer than ε + R, and perhaps some that are hardly farther. A motion leads
/// from the disk with the lift's vertex in its centre to the one with the vertex in its centre.
struct NearLift {
  Index vertex;
  Motion motion;
};
using NearLifts = std::vector<std::vector<NearLift>>;

/// How much work eigenvalue_error is: values of functions that it takes, and some products of two functions.
[[nodiscard]] std::size_t values_needed(const EigenvaluesDocument::Eigenfunctions& row, const NearLifts& near);

/// δ such that as many eigenvalues as functions, perhaps with 0, lie in [λ − δ, λ + δ] (Lemmas 37.1 to 37.6). Throws
/// TooLarge if none is proved. The rules of the net are verified; `minus_euler` = 2g − 2.
[[nodiscard]] Interval eigenvalue_error(const EigenvaluesDocument::Eigenfunctions& row, const mpq_class& epsilon,
                                        const NearLifts& near, long minus_euler);

}  // namespace epsnet::exact
