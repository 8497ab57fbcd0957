#include "certify/exact/comparison_rules.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
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
    const std::size_t degree = degree_of_both(x, y, other_x, other_y);
    if (bits > kMostBitsOfAComparison / degree) throw TooLarge{"the numbers are too large to be compared exactly"};
    for (std::size_t k = 2 * bits + 64;; k *= 2) {
      const std::size_t cost = k * (work_of(x) + work_of(y) + work_of(other_x) + work_of(other_y));
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
  static std::size_t degree_of_both(const RealNumber& x, const RealNumber& y, const RealNumber& other_x,
                                    const RealNumber& other_y) {
    // Integers are in every field.
    const RealNumber& from = x.field.empty() ? other_x : x;
    const RealNumber& to = y.field.empty() ? other_y : y;
    const std::size_t of_x = std::max(x.degree, other_x.degree);
    const std::size_t of_y = std::max(y.degree, other_y.degree);
    return degree_of_cosines(std::lcm(from.n, to.n)) * (from.field == to.field ? std::max(of_x, of_y) : of_x * of_y);
  }

  static std::size_t work_of(const RealNumber& x) { return degree_of_cosines(x.n) * x.degree + 1; }

  /// Of numbers times 2^k, so that the product is times 2^2k.
  static Approximation product(const Approximation& x, const Approximation& y) {
    return {x.value * y.value, abs(x.value) * y.error + abs(y.value) * x.error + x.error * y.error};
  }

  std::size_t bits_left_ = kMostBitsOfAll;
};

/// The lower ends of the lengths of a list, or the upper ones, in order.
std::vector<mpq_class> ends(const GeodesicsDocument& list, std::size_t which) {
  std::vector<mpq_class> result;
  for (const ClosedGeodesic& geodesic : list.geodesics) result.push_back(geodesic.length.at(which));
  std::sort(result.begin(), result.end());
  return result;
}

/// How many of them are not greater.
auto at_most(const std::vector<mpq_class>& ends, const mpq_class& length) {
  return std::upper_bound(ends.begin(), ends.end(), length) - ends.begin();
}

/// Whether the first surface certainly has more closed geodesics up to some length.
bool has_more(const GeodesicsDocument& first, const GeodesicsDocument& other) {
  const std::vector<mpq_class> certain = ends(first, 1);
  const std::vector<mpq_class> possible = ends(other, 0);
  return std::any_of(certain.begin(), certain.end(), [&](const mpq_class& length) {
    return length <= other.up_to && at_most(certain, length) > at_most(possible, length);
  });
}

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
  return has_more(first, other) || has_more(other, first);
}

}  // namespace epsnet::exact
