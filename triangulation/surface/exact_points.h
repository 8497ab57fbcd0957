#pragma once

#include "kernel/lorentz.h"
#include "kernel/numbers.h"
#include "kernel/plane.h"

/// Points of the Poincaré disk with rational coordinates, as integers: products of these take no gcd, which would be
/// most of the work.
namespace epsnet {

/// Integers of any size (GMP).
using Integer = boost::multiprecision::number<boost::multiprecision::gmp_int, boost::multiprecision::et_off>;

/// A point n/m of the Poincaré disk: a Gaussian integer over a positive integer.
struct ScaledPoint {
  Complex<Integer> n;
  Integer m;
};

[[nodiscard]] ScaledPoint scaled(const Complex<Rational>& z);

/// m² − |n|²: positive if and only if the point lies in the open unit disk.
[[nodiscard]] Integer disk_gap(const ScaledPoint& z);

/// A number of Q(i) as a quotient n/d of Gaussian integers, not in lowest terms.
struct GaussianFraction {
  Complex<Integer> n;
  Complex<Integer> d;
};

/// p − q times both denominators.
[[nodiscard]] Complex<Integer> scaled_difference(const ScaledPoint& p, const ScaledPoint& q);

/// z as seen from p: its image under the isometry that takes p to 0, (z − p)/(1 − p̄z).
[[nodiscard]] GaussianFraction seen_from(const ScaledPoint& p, const ScaledPoint& z);

/// A point as a positive multiple of (Klein coordinates, 1) = (2z/(1+|z|²), 1), which is one of its vector on the
/// hyperboloid. Hyperbolic lines are the planes through 0 of these vectors.
using KleinVector = LorentzVector<Integer>;

[[nodiscard]] KleinVector klein(const ScaledPoint& z);

/// The sign of the turn p, q, r along hyperbolic lines: 1 left, 0 straight (or coincident points), −1 right.
[[nodiscard]] int orientation(const KleinVector& p, const KleinVector& q, const KleinVector& r);

/// Orders points by their Klein coordinates x, then y.
[[nodiscard]] bool lexicographically_less(const KleinVector& p, const KleinVector& q);

/// The isometry that takes p to p2 and q to q2, with Gaussian integers as coefficients that have no common integer
/// factor. Requires d(p, q) = d(p2, q2) > 0.
[[nodiscard]] Isometry<Rational> integral_crossing(const ScaledPoint& p, const ScaledPoint& q, const ScaledPoint& p2,
                                                   const ScaledPoint& q2);

}  // namespace epsnet
