#include "netgen/exchange/gaussian_integers.h"

namespace epsnet {
namespace {

constexpr unsigned kMostBits = 20'000;
constexpr unsigned kMostPrimeBits = 4096;
constexpr std::uint32_t kSmallPrimes = 1U << 16;
/// A round takes a composite number for a prime with a probability below 1/4; the result is checked in any case.
constexpr int kPrimalityRounds = 32;
constexpr std::uint32_t kMostBases = 200;

bool is_prime(const Integer& n) { return mpz_probab_prime_p(n.backend().data(), kPrimalityRounds) != 0; }

/// Returns a Gaussian integer of norm p, for a prime p that is 1 modulo 4; nullopt if p turns out not to be prime.
std::optional<Complex<Integer>> prime_root(const Integer& p) {
  // Half of all bases give a square root of −1.
  for (std::uint32_t base = 2; base < kMostBases; ++base) {
    const Integer x = powm(Integer(base), Integer((p - 1) / 4), p);
    if ((x * x + 1) % p != 0) continue;
    const Complex<Integer> root = gaussian_gcd({p, 0}, {x, 1});
    if (norm(root) == p) return root;
  }
  return std::nullopt;
}

class Search {
 public:
  explicit Search(const Integer& n) : rest_(n) {}

  TwoSquares run(const std::vector<Complex<Integer>>& hints) {
    while (rest_ % 2 == 0) divide_by(2, {1, 1});
    for (const Complex<Integer>& hint : hints) use(hint);
    take_square();
    for (std::uint32_t p = 3; p < kSmallPrimes && rest_ != 1; p += 2) {
      // Composite p no longer divide the rest, as their prime factors have been divided out.
      if (mpz_divisible_ui_p(rest_.backend().data(), p) != 0 && !take_small_prime(p)) return {{}, Integer(p)};
    }
    take_square();
    if (rest_ == 1) return {root_, {}};
    if (rest_ % 4 == 3) return {{}, rest_};
    if (msb(rest_) < kMostPrimeBits && is_prime(rest_)) {
      if (const auto root = prime_root(rest_)) return {*root * root_, {}};
    }
    return {};
  }

 private:
  void divide_by(const Integer& divisor, const Complex<Integer>& root) {
    rest_ /= divisor;
    root_ = root_ * root;
  }

  /// Splits off factors that the rest has in common with a hint. A Gaussian divisor g of the rest without a rational
  /// factor is coprime to its conjugate, which also divides the rest; so its norm divides the rest. (A common factor
  /// would divide 2x and 2y, and the rest is odd.)
  void use(const Complex<Integer>& hint) {
    if (hint == Complex<Integer>{0, 0}) return;
    for (;;) {
      Complex<Integer> g = gaussian_gcd({rest_, 0}, hint);
      const Integer rational = gcd(g.x, g.y);
      g = {g.x / rational, g.y / rational};
      const Integer divisor = norm(g);
      if (divisor == 1) return;
      divide_by(divisor, g);
    }
  }

  void take_square() {
    const Integer root = sqrt(rest_);
    if (root * root == rest_) divide_by(rest_, {root, 0});
  }

  /// Divides the rest by p as often as possible; false if p is 3 modulo 4 and divides it an odd number of times.
  bool take_small_prime(std::uint32_t p) {
    const std::optional<Complex<Integer>> root = p % 4 == 1 ? prime_root(p) : std::nullopt;
    while (rest_ % p == 0) {
      if (root) {
        divide_by(p, *root);
      } else if (rest_ % (std::uint64_t{p} * p) == 0) {
        divide_by(std::uint64_t{p} * p, {p, 0});
      } else {
        return false;
      }
    }
    return true;
  }

  Integer rest_;
  Complex<Integer> root_{1, 0};
};

}  // namespace

TwoSquares two_squares(const Integer& n, const std::vector<Complex<Integer>>& hints) {
  if (n <= 0 || msb(n) >= kMostBits) return {};
  TwoSquares result = Search(n).run(hints);
  if (result.root && norm(*result.root) != n) result.root.reset();
  return result;
}

}  // namespace epsnet
