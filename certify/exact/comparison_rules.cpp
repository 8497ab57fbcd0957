#include "certify/exact/comparison_rules.h"

#include <algorithm>
#include <cstddef>
#include <string>

/// Section 20: two surfaces that are isometric, or not.
namespace epsnet::exact {
namespace {

/// Numbers of two fields are compared with so many bits at most, and with so many in all: some seconds.
constexpr std::size_t kMostBitsOfAComparison = std::size_t{1} << 18;
constexpr std::size_t kMostBitsOfAll = std::size_t{1} << 33;

/// Lemma 45, for numbers that take no more than so many bits in all.
class Comparison {
 public:
  /// Whether xy = x′y′, x and x′ of one field, y and y′ of another. Throws TooLarge.
  bool agree(const RealNumber& x, const RealNumber& y, const RealNumber& other_x, const RealNumber& other_y) {
    const std::size_t bits = std::max(x.bits + y.bits, other_x.bits + other_y.bits) + 1;
    const RealNumber& from = x.degree > 1 ? x : other_x;  // Integers are in every field.
    const RealNumber& to = y.degree > 1 ? y : other_y;
    const std::size_t degree = from.field == to.field ? from.degree : from.degree * to.degree;
    if (bits > kMostBitsOfAComparison / degree) throw TooLarge{"the numbers are too large to be compared exactly"};
    for (std::size_t k = 2 * bits + 64;; k *= 2) {
      const std::size_t cost = k * (x.degree + y.degree + 4);
      if (cost > bits_left_) throw TooLarge{"the numbers take too much work to be compared exactly"};
      bits_left_ -= cost;
      const Approximation p = product(x.approximation(k), y.approximation(k));
      const Approximation q = product(other_x.approximation(k), other_y.approximation(k));
      const mpz_class size = abs(p.value - q.value);
      const mpz_class error = p.error + q.error;
      if (size > error) return false;
      // A number that is not 0 is at least 2^(−bits (degree − 1)).
      if (2 * k > bits * (degree - 1) && size + error < mpz_class(1) << (2 * k - bits * (degree - 1))) return true;
    }
  }

 private:
  /// Of numbers times 2^k, so that the product is times 2^2k.
  static Approximation product(const Approximation& x, const Approximation& y) {
    return {x.value * y.value, abs(x.value) * y.error + abs(y.value) * x.error + x.error * y.error};
  }

  std::size_t bits_left_ = kMostBitsOfAll;
};

/// Of each list: every length is compared with all of the other one.
constexpr std::size_t kMostGeodesics = 30'000;

}  // namespace

void expect_conjugate(const Traces& from, const Traces& to) {
  Comparison comparison;
  int sign = 1;  // Of the images of x, y and xy; then of that of a generator, as soon as it is known.
  for (std::size_t i = 0; i < from.traces.size(); ++i) {
    if (i >= 3 && (i - 3) % 4 == 0) sign = 0;
    const Trace& s = from.traces[i];
    const Trace& t = to.traces.at(i);
    const int product = s.sign * t.sign;
    if (sign * product < 0 || !comparison.agree(s.square, t.determinant, s.determinant, t.square))
      throw Refutation{"it changes traces of " + (i < 3 ? "the pair" : "generator " + number((i - 3) / 4))};
    if (product != 0) sign = product;
  }
}

bool counts_differ(const GeodesicsDocument& first, const GeodesicsDocument& other) {
  if (std::max(first.geodesics.size(), other.geodesics.size()) > kMostGeodesics)
    throw TooLarge{"the lists are too long for this checker"};
  const auto has_more = [](const GeodesicsDocument& s, const GeodesicsDocument& t) {
    return std::any_of(s.geodesics.begin(), s.geodesics.end(), [&](const ClosedGeodesic& geodesic) {
      const mpq_class& length = geodesic.length[1];
      const auto count = [&](const GeodesicsDocument& list, std::size_t end) {
        return std::count_if(list.geodesics.begin(), list.geodesics.end(),
                             [&](const ClosedGeodesic& g) { return g.length.at(end) <= length; });
      };
      return length <= t.up_to && count(s, 1) > count(t, 0);
    });
  };
  return has_more(first, other) || has_more(other, first);
}

}  // namespace epsnet::exact
