#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

#include "kernel/numbers.h"
#include "kernel/plane.h"

/// Random points of the disk in binary64 and in multiprecision, near-degenerate on purpose.
namespace epsnet::test {

using Random = std::mt19937_64;

/// An integer in [low, high].
inline int integer(Random& random, int low, int high) {
  return low + static_cast<int>(random() % static_cast<std::uint64_t>(high - low + 1));
}

/// A number in [0, 1) with random bits in the whole mantissa.
template <class T>
T uniform(Random& random) {
  T result(0);
  for (int bits = 0; bits < std::numeric_limits<T>::digits; bits += 32) {
    result = (result + T(static_cast<double>(random() >> 32))) / T(0x1p32);
  }
  return result < 1 ? result : T(0);
}

/// A number in [−1, 1].
template <class T>
T symmetric(Random& random) {
  return random() % 2 == 0 ? uniform<T>(random) : T(-uniform<T>(random));
}

/// 2ⁿ.
template <class T>
T power_of_two(int n) {
  using std::ldexp;
  return ldexp(T(1), n);
}

/// x moved by n units in the last place.
template <class T>
T moved_by_ulps(const T& x, int n) {
  using std::frexp;
  int exponent = 0;
  frexp(x, &exponent);
  return T(x + T(n) * power_of_two<T>(exponent - std::numeric_limits<T>::digits));
}

/// z with each coordinate moved by at most n units in the last place.
template <class T>
Complex<T> nudged(Random& random, const Complex<T>& z, int n) {
  return {moved_by_ulps(z.x, integer(random, -n, n)), moved_by_ulps(z.y, integer(random, -n, n))};
}

/// A point of the unit circle, to rounding.
template <class T>
Complex<T> direction(Random& random) {
  const T t = symmetric<T>(random);
  const T n = T(1) + t * t;
  const T c = (T(1) - t * t) / n;
  const T s = T(2) * t / n;
  switch (random() % 4) {
    case 0:
      return {c, s};
    case 1:
      return {-s, c};
    case 2:
      return {-c, -s};
    default:
      return {s, -c};
  }
}

/// A point with |z| ≤ `radius`, uniformly in |z|.
template <class T>
Complex<T> point(Random& random, double radius) {
  return T(T(radius) * uniform<T>(random)) * direction<T>(random);
}

/// N points in the open disk (up to rounding). They are near-degenerate for some predicate: on a circle, a geodesic, a
/// straight line, coincident, symmetric, on a coarse lattice, tiny, near the unit circle; or just random.
template <class T, std::size_t N>
std::array<Complex<T>, N> adversarial_points(Random& random) {
  std::array<Complex<T>, N> p;
  const int family = integer(random, 0, 8);
  // How large the figure is and where: anywhere, or near the circle and small enough to fit.
  const bool near_circle = random() % 5 == 0;
  const int depth = integer(random, 1, 20);
  const Complex<T> place = near_circle
                               ? T(T(1) - T(2) * power_of_two<T>(-depth)) * direction<T>(random)
                               : (random() % 4 == 0 ? Complex<T>{} : point<T>(random, random() % 2 == 0 ? 0.7 : 0.05));
  const T room = near_circle ? power_of_two<T>(-depth) : T(0.3);
  const T size = random() % 2 == 0 ? room : T(room * power_of_two<T>(-integer(random, 0, 40)));
  switch (family) {
    case 0:  // A circle.
      for (Complex<T>& z : p) {
        z = place + size * direction<T>(random);
      }
      break;
    case 1: {  // A geodesic.
      const Complex<T> e = direction<T>(random);
      for (Complex<T>& z : p) {
        z = Isometry<T>::translation(place)(T(symmetric<T>(random) * (near_circle ? T(0.5) : size)) * e);
      }
      break;
    }
    case 2: {  // A straight line.
      const Complex<T> e = direction<T>(random);
      for (Complex<T>& z : p) {
        z = place + T(symmetric<T>(random) * size) * e;
      }
      break;
    }
    case 3:  // Coincident.
      for (Complex<T>& z : p) {
        z = place + size * direction<T>(random);
      }
      p[random() % N] = p[random() % N];
      break;
    case 4: {  // The corners of a square or of a rectangle: exactly on a circle around 0, in some order.
      const T x = size * uniform<T>(random);
      const T y = random() % 2 == 0 ? x : T(size * uniform<T>(random));
      for (Complex<T>& z : p) {
        z = {random() % 2 == 0 ? x : T(-x), random() % 2 == 0 ? y : T(-y)};
      }
      break;
    }
    case 5:  // A coarse lattice, with many exact ties.
      for (Complex<T>& z : p) {
        z = {T(integer(random, -5, 5) / 8.0), T(integer(random, -5, 5) / 8.0)};
      }
      break;
    case 6: {  // Tiny: down to 1e-300, on a circle or a line.
      const T tiny = power_of_two<T>(-integer(random, 40, 1000));
      const Complex<T> centre = random() % 2 == 0 ? Complex<T>{} : tiny * direction<T>(random);
      const bool line = random() % 2 == 0;
      const Complex<T> e = direction<T>(random);
      for (Complex<T>& z : p) {
        z = centre + (line ? T(tiny * symmetric<T>(random)) * e : tiny * direction<T>(random));
      }
      break;
    }
    case 7:  // Very near to each other.
      for (Complex<T>& z : p) {
        z = nudged(random, place, 3);
      }
      break;
    default:
      for (Complex<T>& z : p) {
        z = point<T>(random, 0.95);
      }
      break;
  }
  const int ulps = integer(random, 0, 3);
  for (Complex<T>& z : p) {
    z = nudged(random, z, ulps);
  }
  return p;
}

}  // namespace epsnet::test
