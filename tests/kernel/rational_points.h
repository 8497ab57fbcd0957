#pragma once

#include <rapidcheck.h>

#include "kernel/numbers.h"
#include "kernel/plane.h"

/// RapidCheck generators of exact points and isometries; they shrink towards 0 and the identity.
namespace epsnet::test {

inline Complex<Rational> rational_point() {
  // 68² + 68² < 97²: in the open disk.
  const int x = *rc::gen::inRange(-68, 69);
  const int y = *rc::gen::inRange(-68, 69);
  return {Rational(x, 97), Rational(y, 97)};
}

inline Isometry<Rational> rational_rotation() {
  const int x = *rc::gen::inRange(1, 20);
  const int y = *rc::gen::inRange(-20, 20);
  return {{Rational(x), Rational(y)}, {}};
}

inline Isometry<Rational> rational_isometry() {
  return Isometry<Rational>::translation(rational_point()) * rational_rotation();
}

}  // namespace epsnet::test
