#include <gtest/gtest.h>

#include "kernel/numbers.h"

// The bounds of the predicates, and the same bytes on every machine, need a*b + c to be rounded twice. These functions
// may use the fused multiply-add of x86 where the machine has it, so that only -ffp-contract=off keeps them from it;
// other machines (arm64) have it anyway.
#if defined(__x86_64__)
#define EPSNET_WITH_FMA __attribute__((noinline, target("fma")))
#else
#define EPSNET_WITH_FMA __attribute__((noinline))
#endif

namespace epsnet::contraction_test {
namespace {

bool has_fma() {
#if defined(__x86_64__)
  return __builtin_cpu_supports("fma") != 0;
#else
  return true;
#endif
}

EPSNET_WITH_FMA double multiply_add(double a, double b, double c) { return a * b + c; }
EPSNET_WITH_FMA double norm_less_one(double x, double y) { return norm(Complex<double>{x, y}) - 1; }
EPSNET_WITH_FMA double kernel_cross(double x, double y, double v) {
  return cross(Complex<double>{x, 1}, Complex<double>{v, y});
}

// The same for machines without: as the kernel is compiled for them.
[[gnu::noinline]] double plain_multiply_add(double a, double b, double c) { return a * b + c; }
[[gnu::noinline]] double plain_norm_less_one(double x, double y) { return norm(Complex<double>{x, y}) - 1; }
[[gnu::noinline]] double plain_kernel_cross(double x, double y, double v) {
  return cross(Complex<double>{x, 1}, Complex<double>{v, y});
}

// (1 + h)(1 − h) = 1 − h², which is 1 when rounded and less when it is not. Volatile, so that nothing is computed by
// the compiler.
volatile double above_one = 1 + 0x1p-30;
volatile double below_one = 1 - 0x1p-30;
volatile double one = 1;

TEST(Contraction, OfSumsAndProductsIsOff) {
  EXPECT_EQ((has_fma() ? multiply_add : plain_multiply_add)(above_one, below_one, -one), 0);
}

TEST(Contraction, IsOffInTheKernel) {
  EXPECT_EQ((has_fma() ? kernel_cross : plain_kernel_cross)(above_one, below_one, one), 0);
  // x² = 2⁻² + 2⁻³⁵ + 2⁻⁷⁰ loses its last bit, and y² = 3/4 rounded likewise.
  volatile double x = 0.5 + 0x1p-35;
  volatile double y = 0x1.bb67ae8584caap-1;
  volatile double xx = x * x;
  volatile double yy = y * y;
  volatile double sum = xx + yy;
  EXPECT_EQ((has_fma() ? norm_less_one : plain_norm_less_one)(x, y), sum - 1);
}

}  // namespace
}  // namespace epsnet::contraction_test
