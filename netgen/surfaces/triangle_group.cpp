#include "netgen/surfaces/triangle_group.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "certify/base/text.h"
#include "netgen/base/gmp.h"
#include "netgen/surfaces/number_field.h"

namespace epsnet {
namespace {

using certify::PowerOfZeta;
using Number = TriangleGroup::Number;
using ExactElement = TriangleGroup::ExactElement;

constexpr std::int64_t kMostOrder = 100'000;

std::int64_t order_of(RegularTile tile) {
  return std::lcm(std::lcm(std::int64_t{2} * tile.p, std::int64_t{2} * tile.q), std::int64_t{4});
}

Number pi() { return boost::math::constants::pi<Number>(); }

/// The turn around 0 by an angle.
Isometry<Number> turned(const Number& angle) {
  const Number half = angle / 2;
  return {{cos(half), sin(half)}, {Number(0), Number(0)}};
}

std::unique_ptr<const certify::RegularRing> ring_of(RegularTile tile, const certify::Budget& budget) {
  if (tile.p < 3 || tile.q < 3 || 2 * (std::uint64_t{tile.p} + tile.q) >= std::uint64_t{tile.p} * tile.q) {
    throw SurfaceError("tiles " + std::to_string(tile.p) + " " + std::to_string(tile.q) +
                       ": expected p and q of at least 3, with 1/p + 1/q < 1/2");
  }
  const std::int64_t order = order_of(tile);
  if (order > kMostOrder) {
    throw SurfaceError("tiles: lcm(2p, 2q, 4) is " + std::to_string(order) + ", expected at most " +
                       std::to_string(kMostOrder));
  }
  // s² = (2 sin(π/q))² (2 cos(2π/p) + 2 cos(2π/q)).
  const std::int64_t p = order / tile.p;
  const std::int64_t q = order / tile.q;
  std::vector<PowerOfZeta> square;
  for (const PowerOfZeta& x : {PowerOfZeta{2, 0}, PowerOfZeta{-1, q}, PowerOfZeta{-1, -q}}) {
    for (const std::int64_t power : {p, -p, q, -q}) square.push_back({x.coefficient, x.power + power});
  }
  return std::make_unique<certify::RegularRing>(static_cast<std::uint32_t>(order), square, budget);
}

bool is_zero(const certify::RegularNumber& x) {
  return certify::sign(certify::twice_real(x)) == 0 && certify::sign(certify::twice_imaginary(x)) == 0;
}

/// Glues tiles as walks and vertices say. A side is a number: its tile times p and its place there.
class CosetTiles {
 public:
  using Side = std::uint32_t;

  explicit CosetTiles(RegularTile tile) : p_(tile.p), q_(tile.q) { add_tile(); }

  /// Whether it ends within the limit.
  bool enumerate(const std::vector<TileWalk>& walks) {
    for (const TileWalk& walk : walks) {
      if (!close(walk, 0)) return false;
    }
    TileWalk around_vertex{std::vector<std::uint32_t>(q_, 1), 1};
    around_vertex.turns.front() = 0;
    std::vector<bool> closed;  // The vertex where a side starts.
    for (std::uint32_t t = 0; t < parents_.size(); ++t) {
      for (std::uint32_t k = 0; k < p_ && parents_[t].tile == t; ++k) {
        closed.resize(partners_.size());
        if (closed[t * p_ + k]) continue;
        if (!close(around_vertex, t * p_ + k)) return false;
        closed.resize(partners_.size());
        for (Side side = canonical(t * p_ + k); !closed[side]; side = turned(canonical(partners_[side]), 1))
          closed[side] = true;
      }
    }
    return true;
  }

  /// With the tiles that are left numbered anew.
  SubgroupTiles result(const std::vector<TileWalk>& walks) {
    std::vector<std::uint32_t> numbers(parents_.size());
    std::uint32_t count = 0;
    for (std::uint32_t t = 0; t < parents_.size(); ++t) {
      if (parents_[t].tile == t) numbers[t] = count++;
    }
    const auto numbered = [&](Side side) { return numbers[side / p_] * p_ + side % p_; };
    SubgroupTiles result;
    for (std::uint32_t t = 0; t < parents_.size(); ++t) {
      for (std::uint32_t k = 0; k < p_ && parents_[t].tile == t; ++k) {
        const Side side = numbered(t * p_ + k);
        const Side other = numbered(canonical(partners_[t * p_ + k]));
        if (side == other) throw SurfaceError("the group has torsion: half a turn about the midpoint of a side");
        if (side < other) result.gluing.push_back({side / p_, side % p_, other / p_, other % p_});
      }
    }
    expect_whole_vertices();
    for (const TileWalk& walk : walks) {
      Side side = 0;
      result.paths.emplace_back();
      for (const std::uint32_t turn : walk.turns) {
        side = turned(side, turn);
        result.paths.back().push_back(numbered(side));
        side = canonical(partners_[side]);
      }
    }
    return result;
  }

 private:
  static constexpr Side kNone = std::numeric_limits<Side>::max();
  static constexpr std::size_t kMostSides = std::size_t{1} << 20;

  void add_tile() {
    parents_.push_back({static_cast<std::uint32_t>(parents_.size()), 0});
    partners_.resize(partners_.size() + p_, kNone);
  }

  [[nodiscard]] Side turned(Side side, std::uint32_t by) const {
    return side - side % p_ + static_cast<Side>((std::uint64_t{side} % p_ + by) % p_);
  }

  /// The side of a tile that is left.
  [[nodiscard]] Side canonical(Side side) const {
    while (parents_[side / p_].tile != side / p_) {
      const Parent& parent = parents_[side / p_];
      side = turned(parent.tile * p_ + side % p_, parent.turn);
    }
    return side;
  }

  void expect_whole_vertices() {
    std::vector<bool> seen(partners_.size());
    for (Side first = 0; first < partners_.size(); ++first) {
      if (canonical(first) != first || seen[first]) continue;
      std::uint32_t corners = 0;
      for (Side side = first; !seen[side]; side = turned(canonical(partners_[side]), 1), ++corners) seen[side] = true;
      if (corners != q_) throw SurfaceError("the group has torsion: a turn about a vertex of the tiles");
    }
  }

  /// A walk from a side that is left ends where it starts: its two ends are followed as far as tiles are known, and
  /// what is between them is one crossing, or takes new tiles. False beyond the limit.
  bool close(const TileWalk& walk, Side base) {
    Side ahead = base;                                // After `done` crossings.
    Side behind = turned(base, p_ - walk.last_turn);  // Before all but `left` of them are taken back.
    std::size_t done = 0;
    std::size_t left = walk.turns.size();
    while (true) {
      for (; done < left; ++done) {
        const Side partner = partners_[turned(ahead, walk.turns[done])];
        if (partner == kNone) break;
        ahead = canonical(partner);
      }
      for (; done < left && partners_[behind] != kNone; --left)
        behind = turned(canonical(partners_[behind]), p_ - walk.turns[left - 1]);
      if (done == left) {
        identify(ahead, behind);
        return true;
      }
      const Side side = turned(ahead, walk.turns[done]);
      if (done + 1 == left) {
        glue(side, behind);
        return true;
      }
      if (partners_.size() + p_ > kMostSides) return false;
      add_tile();
      glue(side, static_cast<Side>(partners_.size()) - p_);
    }
  }

  void glue(Side side, Side other) {
    partners_[side] = other;
    partners_[other] = side;
  }

  /// Two sides are one, and so are their tiles, and what is across.
  void identify(Side first, Side second) {
    std::vector<std::pair<Side, Side>> open{{first, second}};
    while (!open.empty()) {
      Side kept = canonical(open.back().first);
      Side other = canonical(open.back().second);
      open.pop_back();
      if (kept == other) continue;
      if (kept / p_ == other / p_) throw SurfaceError("the group has torsion: a turn about the centre of a tile");
      if (kept > other) std::swap(kept, other);
      const std::uint32_t tile = other / p_;
      parents_[tile] = {kept / p_, (kept % p_ + p_ - other % p_) % p_};
      for (Side side = tile * p_; side < (tile + 1) * p_; ++side) {
        const Side partner = partners_[side];
        if (partner == kNone) continue;
        Side& known = partners_[canonical(side)];
        if (known == kNone) {
          known = partner;
        } else {
          open.emplace_back(known, partner);
        }
      }
    }
  }

  /// A tile that is the same as another one, turned.
  struct Parent {
    std::uint32_t tile;  ///< Its own number, if it is not.
    std::uint32_t turn;  ///< Side k is side k + turn there.
  };

  std::uint32_t p_;
  std::uint32_t q_;
  std::vector<Parent> parents_;
  std::vector<Side> partners_;  ///< By side; not canonical.
};

}  // namespace

TileWalk walk_of(const Surface& surface, const Word& word) {
  const std::uint32_t p = surface.regular_tile()->p;
  TileWalk result;
  std::uint32_t ahead = 0;
  for (const SideId s : word) {
    result.turns.push_back((surface.place_in_tile(s) + p - ahead) % p);
    ahead = surface.place_in_tile(surface.partner(s));
  }
  result.last_turn = (p - ahead) % p;
  return result;
}

TriangleGroup::TriangleGroup(RegularTile tile, const certify::Budget& budget)
    : tile_(tile), ring_(ring_of(tile, budget)) {
  const Number square = 2 * cos(Number(2 * pi() / tile.p)) + 2 * cos(Number(2 * pi() / tile.q));
  s_ = 2 * sin(Number(pi() / tile.q)) * sqrt(square);
}

std::optional<TileWalk> TriangleGroup::walk(const Isometry<Number>& element) const {
  constexpr std::size_t kMostSteps = 10'000;
  constexpr double kTiny = 1e-30;
  const std::uint32_t p = tile_.p;
  const Isometry<Number> back = inverse(element);
  // Half a turn about the midpoint of side 0.
  const Isometry<Number> half_turn =
      normalized(Isometry<Number>{{Number(0), Number(2 * sin(Number(2 * pi() / tile_.q)))}, {Number(0), Number(-s_)}});
  TileWalk result;
  Number farthest(1e200);
  Isometry<Number> from_start{{Number(1), Number(0)}, {Number(0), Number(0)}};
  // The number of the side in a direction, and how far the direction is from it, in sides.
  const auto side_ahead = [&](const Complex<Number>& direction) {
    const Number sides = atan2(direction.y, direction.x) * p / (2 * pi());
    const Number nearest = round(sides);
    const auto k = static_cast<std::int64_t>(nearest);
    return std::pair(static_cast<std::uint32_t>((k + p) % p), Number(abs(Number(sides - nearest))));
  };
  for (std::size_t step = 0; step <= kMostSteps; ++step) {
    const Isometry<Number> rest = from_start * back;  // Takes 0 to the goal, as seen from here.
    // Each crossing leads nearer to the centre of another tile. The first one bounds what is rounded off.
    const Number far = norm(rest.a);
    if (!(far < farthest)) return std::nullopt;
    farthest = far;
    if (sqrt(Number(norm(rest.b) / norm(rest.a))) < kTiny) {
      // A turn by the angle 2 arg a: the element turns back by it at last.
      const auto [sides, distance] =
          side_ahead({Number(rest.a.x * rest.a.x - rest.a.y * rest.a.y), Number(2 * rest.a.x * rest.a.y)});
      if (distance > kTiny) return std::nullopt;
      result.last_turn = sides;
      return result;
    }
    // The goal is b/ā.
    const std::uint32_t side = side_ahead({Number(rest.b.x * rest.a.x - rest.b.y * rest.a.y),
                                           Number(rest.b.x * rest.a.y + rest.b.y * rest.a.x)})
                                   .first;
    result.turns.push_back(side);
    from_start = normalized(half_turn * turned(Number(-2 * pi() * side / p)) * from_start);
  }
  return std::nullopt;
}

ExactElement TriangleGroup::element(const TileWalk& walk) const {
  const std::int64_t order = ring_->order();
  // e^{−iπk/p}, which turns by k sides clockwise.
  const auto turn = [&](std::uint32_t k) {
    return ExactElement{
        certify::regular_number(
            *ring_, std::array{PowerOfZeta{1, -std::int64_t{k} * (order / (std::int64_t{2} * tile_.p))}}, {}),
        certify::regular_number(*ring_, {}, {})};
  };
  // 2i sin(2π/q) and −is.
  const std::int64_t q = order / tile_.q;
  const ExactElement half_turn{certify::regular_number(*ring_, std::array{PowerOfZeta{1, q}, PowerOfZeta{-1, -q}}, {}),
                               certify::regular_number(*ring_, {}, std::array{PowerOfZeta{-1, order / 4}})};
  ExactElement last = turn(walk.last_turn);
  if (walk.turns.empty()) return last;
  return certify::compose(last, certify::compose_range(0, walk.turns.size(), [&](std::size_t i) {
                            return certify::compose(half_turn, turn(walk.turns[i]));
                          }));
}

bool TriangleGroup::same(const ExactElement& f, const ExactElement& g) {
  return certify::sign(certify::twice_imaginary(f.a * certify::conjugate(g.a))) == 0 && is_zero(f.a * g.b - f.b * g.a);
}

std::optional<SubgroupTiles> subgroup_tiles(RegularTile tile, const std::vector<TileWalk>& walks) {
  CosetTiles tiles(tile);
  if (!tiles.enumerate(walks)) return std::nullopt;
  return tiles.result(walks);
}

namespace {

using certify::PowerOfZeta;
using certify::RegularNumber;
using Number = TriangleGroup::Number;

static_assert(sizeof(long) == sizeof(std::int64_t));
/// GMP has no constructor for `long long`, which std::int64_t is in WebAssembly.
mpz_class gmp_integer(std::int64_t n) { return mpz_class(static_cast<long>(n)); }

mpz_class coefficient(const certify::Polynomial& x, slong power) {
  certify::Integer result;
  fmpz_poly_get_coeff_fmpz(result.get(), x.get(), power);
  return result.value();
}

class RingNumberParser : public ArithmeticParser<RingNumber> {
 public:
  RingNumberParser(std::string_view text, const TriangleGroup& group)
      : ArithmeticParser(text), group_(group), order_(group.ring().order()) {}

 private:
  [[noreturn]] void not_there(const std::string& number) const {
    throw SurfaceError(number + " is not a number of these tiles: of cosines they have those of multiples of 2*pi/" +
                       std::to_string(order_) +
                       ", of roots those of rational numbers that are sums of such cosines, and s");
  }

  RingNumber constant(const mpq_class& x) override {
    return {certify::regular_number(group_.ring(), certify::Gaussian{x.get_num(), 0}), x.get_den(), rounded<Number>(x)};
  }
  RingNumber negative(RingNumber x) override {
    return {mpz_class(-1) * x.numerator, std::move(x.denominator), -x.rounded};
  }
  RingNumber sum(RingNumber x, const RingNumber& y) override {
    return {y.denominator * x.numerator + x.denominator * y.numerator, x.denominator * y.denominator,
            x.rounded + y.rounded};
  }
  RingNumber product(const RingNumber& x, const RingNumber& y) override {
    return {x.numerator * y.numerator, x.denominator * y.denominator, x.rounded * y.rounded};
  }
  RingNumber quotient(const RingNumber& x, const RingNumber& y) override {
    const auto divisor = rational_numerator(y);
    if (!divisor || *divisor == 0) fail("a rational number other than 0 before this");
    return {mpz_class(sgn(*divisor) * y.denominator) * x.numerator, x.denominator * abs(*divisor),
            x.rounded / y.rounded};
  }
  std::string expected_number() const override { return "a number, sqrt(x), cos(a*pi/b), sin(a*pi/b) or s"; }

  std::optional<RingNumber> named_number() override {
    const std::size_t first = place();
    if (take("cos(")) return cosine(angle(), first);
    if (take("sin(")) return cosine(mpq_class(1, 2) - angle(), first);
    if (take("sqrt(")) {
      const RingNumber square = sum_of_products();
      expect(")");
      return root(square, text_from(first));
    }
    if (take("s")) return RingNumber{s_number(), 1, group_.s()};
    return std::nullopt;
  }

  /// Of a number that is written as a rational one.
  static std::optional<mpz_class> rational_numerator(const RingNumber& x) {
    const auto& [ring, u, v] = x.numerator;
    if (fmpz_poly_degree(u.get()) > 0 || !fmpz_poly_is_zero(v.get())) return std::nullopt;
    return coefficient(u, 0);
  }

  /// The cosine of a multiple of π, which begins at a character.
  RingNumber cosine(const mpq_class& times_pi, std::size_t first) {
    // ζ to this power is e^{iangle}.
    mpq_class exponent = times_pi * gmp_integer(order_) / 2;
    exponent.canonicalize();
    if (exponent.get_den() != 1) not_there(text_from(first));
    const mpz_class reduced = exponent.get_num() % gmp_integer(order_);
    const auto power = static_cast<std::int64_t>(reduced.get_si());
    return {certify::regular_number(group_.ring(), std::array{PowerOfZeta{1, power}, PowerOfZeta{1, -power}}, {}), 2,
            cos(Number(2 * boost::math::constants::pi<Number>() * power / order_))};
  }

  /// The root of a rational number, or of s² times the square of one.
  RingNumber root(const RingNumber& x, const std::string& name) {
    constexpr long kGreatest = 1'000'000;
    if (const auto numerator = rational_numerator(x)) {
      const mpz_class product = *numerator * x.denominator;
      if (product < 0 || product > kGreatest) {
        fail("a rational number n/m before this, n times m from 0 to " + std::to_string(kGreatest));
      }
      RingNumber result = root_of_integer(product.get_si(), name);
      result.denominator = x.denominator;
      result.rounded /= rounded<Number>(mpq_class(x.denominator));
      return result;
    }
    // Where the rounded numbers say so, exact ones decide.
    const Number factor = sqrt(Number(abs(x.rounded))) / group_.s();
    constexpr long kMostDenominator = 1000;
    for (long d = 1; d <= kMostDenominator && factor < kGreatest; ++d) {
      const auto n = static_cast<long>(round(Number(factor * d)));
      if (abs(Number(factor * d - n)) > 1e-100) continue;
      const RegularNumber s = s_number();
      const RegularNumber difference =
          mpz_class(mpz_class(d) * d) * x.numerator - mpz_class(mpz_class(n) * n * x.denominator) * (s * s);
      if (certify::sign(difference) != 0) break;
      return {mpz_class(n) * s, d, Number(group_.s() * n / d)};
    }
    not_there(name);
  }

  [[nodiscard]] RegularNumber s_number() const {
    return certify::regular_number(group_.ring(), {}, std::array{PowerOfZeta{1, 0}});
  }

  /// √n, by Gauss's sums: Σ (a/p) e^{2πia/p} is √p, or i√p for p = 3 modulo 4.
  RingNumber root_of_integer(std::int64_t n, const std::string& name) {
    RegularNumber result = certify::regular_number(group_.ring(), certify::Gaussian{n == 0 ? 0 : 1, 0});
    std::int64_t rest = std::max<std::int64_t>(n, 1);
    for (std::int64_t prime = 2; prime <= rest; ++prime) {
      for (; rest % (prime * prime) == 0; rest /= prime * prime) result = gmp_integer(prime) * result;
      if (rest % prime != 0) continue;
      rest /= prime;
      if (order_ % (prime == 2 ? 8 : prime) != 0) not_there(name);
      std::vector<PowerOfZeta> terms;
      if (prime == 2) {
        terms = {{1, order_ / 8}, {1, -order_ / 8}};
      } else {
        const std::int64_t quarter = prime % 4 == 3 ? order_ / 4 : 0;
        for (std::int64_t a = 1; a < prime; ++a) {
          terms.push_back({mpz_legendre(gmp_integer(a).get_mpz_t(), gmp_integer(prime).get_mpz_t()),
                           a * (order_ / prime) - quarter});
        }
      }
      result = result * certify::regular_number(group_.ring(), terms, {});
    }
    return {std::move(result), 1, sqrt(Number(n))};
  }

  const TriangleGroup& group_;
  std::int64_t order_;
};

/// The coefficients of cos(2πk/n) in a real number's real part, k from 0 to n/4.
std::vector<mpz_class> cosines(const certify::Polynomial& x, std::uint32_t order) {
  std::vector<mpz_class> result(order / 4);  // That of n/4 is 0.
  for (slong k = 0; k < fmpz_poly_length(x.get()); ++k) {
    const auto i = static_cast<std::uint32_t>(k);
    if (i < order / 4) result[i] += coefficient(x, k);
    if (i > order / 4) result[order / 2 - i] -= coefficient(x, k);
  }
  return result;
}

/// "cos(3*pi/8)", for 2πk/n.
std::string cosine_text(std::uint32_t k, std::uint32_t order) {
  const std::uint32_t common = std::gcd(2 * k, order);
  const std::uint32_t times = 2 * k / common;
  return "cos(" + (times == 1 ? std::string() : std::to_string(times) + "*") + "pi/" + std::to_string(order / common) +
         ")";
}

std::string sum_text(const std::vector<mpz_class>& coefficients, const mpz_class& divisor, std::uint32_t order) {
  std::string result;
  for (std::uint32_t k = 0; k < coefficients.size(); ++k) {
    const mpz_class coefficient = coefficients[k] / divisor;
    if (coefficient == 0) continue;
    if (coefficient > 0 && !result.empty()) result += '+';
    const bool one = k > 0 && abs(coefficient) == 1;
    if (one) result += coefficient < 0 ? "-" : "";
    if (!one) result += coefficient.get_str() + (k > 0 ? "*" : "");
    if (k > 0) result += cosine_text(k, order);
  }
  return result;
}

}  // namespace

RingNumber parse_ring_number(std::string_view text, const TriangleGroup& group) {
  return RingNumberParser(text, group).read();
}

std::vector<std::string> field_texts(const std::vector<RegularNumber>& numbers) {
  std::vector<std::array<std::vector<mpz_class>, 2>> coefficients;
  mpz_class divisor;
  for (const RegularNumber& x : numbers) {
    const std::uint32_t order = x.ring->order();
    coefficients.push_back({cosines(x.u, order), cosines(x.v, order)});
    for (const auto& some : coefficients.back()) {
      for (const mpz_class& coefficient : some) divisor = gcd(divisor, coefficient);
    }
  }
  if (divisor == 0) divisor = 1;
  std::vector<std::string> result;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const std::uint32_t order = numbers[i].ring->order();
    const std::string own = sum_text(coefficients[i][0], divisor, order);
    const std::string of_s = sum_text(coefficients[i][1], divisor, order);
    std::string text = own;
    if (!of_s.empty()) text += (own.empty() ? "" : "+") + (of_s == "1" ? "s" : "s*(" + of_s + ")");
    result.push_back(text.empty() ? "0" : text);
  }
  return result;
}

namespace {

/// Twice a sum of cosines of multiples of 2π/n, as a polynomial in x = 2cos(2π/n): that of k of these angles is the
/// Dickson polynomial D_k(x), with D_0 = 2, D_1 = x and D_{k+1} = xD_k − D_{k−1}.
std::vector<mpz_class> twice_in_cosine(const std::vector<mpz_class>& cosines) {
  std::vector<mpz_class> result(cosines.size() + 1);
  std::vector<mpz_class> dickson{2};
  std::vector<mpz_class> next{0, 1};
  for (const mpz_class& c : cosines) {
    for (std::size_t i = 0; i < dickson.size(); ++i) result[i] += c * dickson[i];
    std::vector<mpz_class> after(next.size() + 1);
    for (std::size_t i = 0; i < next.size(); ++i) after[i + 1] = next[i];
    for (std::size_t i = 0; i < dickson.size(); ++i) after[i] -= dickson[i];
    dickson = std::exchange(next, std::move(after));
  }
  return result;
}

}  // namespace

RingGenerators generator_texts(const certify::RegularRing& ring) {
  const std::string cosine = "(2*cos(2*pi/" + std::to_string(ring.order()) + "))";
  const std::string square = polynomial_text(twice_in_cosine(cosines(ring.square_of_s(), ring.order())), cosine);
  return {cosine, "sqrt((" + square + ")/2)"};
}

std::vector<std::string> number_texts(const std::vector<RegularNumber>& numbers, const RingGenerators& generators) {
  std::vector<std::string> result;
  for (const RegularNumber& x : numbers) {
    const auto part = [&](const certify::Polynomial& some) {
      return polynomial_text(twice_in_cosine(cosines(some, x.ring->order())), generators.cosine);
    };
    const std::string of_s = part(x.v);
    result.push_back(part(x.u) + (of_s == "0" ? "" : "+" + generators.s + "*(" + of_s + ")"));
  }
  return result;
}

// The surface that matrices over the ring of a triangle group generate: they are known as walks over its tiling by
// rounded numbers, which exact ones confirm, and walks say which tiles are the same.

namespace {

using Kind = MatricesError::Kind;
using Number = TriangleGroup::Number;
using ExactElement = TriangleGroup::ExactElement;

/// Some 20 seconds.
constexpr std::uint64_t kMostWork = 20'000'000'000;

/// A generator, exactly up to scale, and rounded.
struct Generator {
  ExactElement exact;
  Isometry<Number> rounded;
};

std::string named(std::size_t k) { return "generator " + std::to_string(k + 1); }

Generator generator_of(const std::array<std::string, 4>& texts, MatrixModel model, const TriangleGroup& group,
                       const std::string& name) {
  std::vector<RingNumber> numbers;
  mpz_class denominator = 1;
  for (const std::string& text : texts) {
    try {
      numbers.push_back(parse_ring_number(text, group));
    } catch (const SurfaceError& error) {
      throw MatricesError(Kind::text, name + ": " + error.what());
    }
    denominator = lcm(denominator, numbers.back().denominator);
  }
  std::vector<certify::RegularNumber> e;
  e.reserve(numbers.size());
  for (const RingNumber& number : numbers) e.push_back(mpz_class(denominator / number.denominator) * number.numerator);
  const std::array<Number, 4> r{numbers[0].rounded, numbers[1].rounded, numbers[2].rounded, numbers[3].rounded};
  const certify::Gaussian i{0, 1};
  ExactElement exact = model == MatrixModel::su11
                           ? ExactElement{e[0] + i * e[1], e[2] + i * e[3]}
                           : ExactElement{e[0] + e[3] + i * (e[1] - e[2]), e[0] - e[3] - i * (e[1] + e[2])};
  if (certify::sign(certify::norm(exact.a) - certify::norm(exact.b)) <= 0) {
    throw MatricesError(
        Kind::text,
        name + ": the determinant is not positive, so it is no isometry of the plane that preserves the orientation");
  }
  return {std::move(exact), normalized(isometry_of_entries(r, model))};
}

void check_relation(const std::vector<std::int32_t>& relation, const std::vector<Generator>& generators) {
  if (relation.empty()) return;
  const ExactElement product = certify::compose_range(0, relation.size(), [&](std::size_t i) {
    const std::int32_t k = relation[relation.size() - 1 - i];
    const ExactElement& f = generators[static_cast<std::size_t>(std::abs(k)) - 1].exact;
    return k > 0 ? f : certify::inverse(f);
  });
  const certify::RegularRing& ring = *product.a.ring;
  const ExactElement one{certify::regular_number(ring, certify::Gaussian{1, 0}),
                         certify::regular_number(ring, certify::Gaussian{0, 0})};
  if (!TriangleGroup::same(product, one)) {
    throw MatricesError(Kind::relation, "the relation does not hold: the product is not a multiple of 1");
  }
}

MatrixSurface made(const MatrixGenerators& matrices) {
  const RegularTile tile = *matrices.tile;
  const TriangleGroup group = [&] {
    try {
      return TriangleGroup(tile, certify::Budget(kMostWork));
    } catch (const SurfaceError& error) {
      throw MatricesError(Kind::text, error.what());
    }
  }();
  const std::string tiling = "the tiles " + std::to_string(tile.p) + " " + std::to_string(tile.q);
  std::vector<Generator> generators;
  for (std::size_t k = 0; k < matrices.numbers.size(); ++k)
    generators.push_back(generator_of(matrices.numbers[k], matrices.model, group, named(k)));
  check_relation(matrices.relation, generators);
  std::vector<TileWalk> walks;
  for (std::size_t k = 0; k < generators.size(); ++k) {
    const auto walk = group.walk(generators[k].rounded);
    if (!walk || !TriangleGroup::same(group.element(*walk), generators[k].exact)) {
      throw MatricesError(Kind::undecided,
                          "could not decide: " + named(k) + " does not take " + tiling +
                              " to themselves, of which one has its centre at " +
                              (matrices.model == MatrixModel::su11 ? "0" : "i") +
                              " and the midpoint of a side to the right of it, or moves them too far; without tiles, "
                              "decimals mean a surface that is near");
    }
    walks.push_back(*walk);
  }
  const auto tiles = subgroup_tiles(tile, walks);
  if (!tiles) {
    throw MatricesError(Kind::undecided, "could not decide: the surface has more than 2^20 sides of " + tiling +
                                             ", or the group is not cocompact");
  }
  MatrixSurface result{Surface::map(tile, tiles->gluing), {}};
  for (const std::vector<std::uint32_t>& path : tiles->paths) result.words.push_back(word_of_letters(path));
  result.surface.set_about("map of type {" + std::to_string(tile.p) + ", " + std::to_string(tile.q) + "} of " +
                           std::to_string(matrices.numbers.size()) + " matrices");
  return result;
}

}  // namespace

MatrixSurface surface_of_field_matrices(const MatrixGenerators& matrices) {
  try {
    return made(matrices);
  } catch (const MatricesError&) {
    throw;
  } catch (const certify::BudgetSpent&) {
    throw MatricesError(Kind::undecided, "could not decide: the numbers are too long");
  } catch (const SurfaceError& error) {
    throw MatricesError(Kind::torsion, error.what());
  }
}

}  // namespace epsnet
