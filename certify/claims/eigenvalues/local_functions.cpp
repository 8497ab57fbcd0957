#include "certify/claims/eigenvalues/local_functions.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <complex>
#include <iterator>
#include <limits>
#include <map>
#include <utility>

#include "certify/base/text.h"
#include "certify/net/numbering.h"
#include "certify/numbers/ball.h"
#include "certify/numbers/parallel.h"

namespace epsnet::certify {

namespace {

__extension__ using Wide = __int128;

constexpr int kBits = 61;       ///< Of radial factors, after the point;
constexpr int kValueBits = 62;  ///< of values and z.
/// For all that bounds of errors leave out: products of two of them, and their own rounding.
constexpr double kLeftOut = 1 + 0x1p-15;
constexpr double kGreatestError = 0x1p20;

/// x·2^bits, less than 1 away; nothing if x is not known so well, or too large.
std::optional<std::int64_t> in_units(const Ball& x, slong bits) {
  if (!is_finite(x) || arf_cmpabs_2exp_si(arb_midref(x.get()), 64 - bits) >= 0) return std::nullopt;
  if (mag_cmp_2exp_si(arb_radref(x.get()), -bits - 2) > 0) return std::nullopt;
  const Ball units = scaled(x, bits);
  Integer result;
  arf_get_fmpz(result.get(), arb_midref(units.get()), ARF_RND_NEAR);
  return fmpz_fits_si(result.get()) != 0 ? std::optional<std::int64_t>(fmpz_get_si(result.get())) : std::nullopt;
}

/// x·2^−bits, at most ½ away.
std::int64_t shifted(Wide x, int bits) { return static_cast<std::int64_t>((x + (Wide{1} << (bits - 1))) >> bits); }

/// ₂F₁(½ − ir, ½ + ir; m + 1; −x), λ = ¼ + r², for x ≤ X ≤ 1, as a polynomial of x/X, which is at most
/// `greatest_ratio`. The terms alternate and, from (i + 1)(m + 1) ≥ λ on, decrease, so what is left is less than the
/// first term that is left out.
std::optional<std::vector<std::int64_t>> series(const Ball& lambda, std::uint32_t m, const Ball& most,
                                                const Ball& greatest_ratio) {
  constexpr std::uint64_t kMostTerms = 500;
  std::vector<std::int64_t> result;
  Ball term = Ball::exactly(1);
  Ball power = Ball::exactly(1);  // Of the greatest ratio.
  double sum = 0;
  for (std::uint64_t i = 0; i < kMostTerms; ++i) {
    const bool decreasing = certainly_less(lambda, Ball::exactly(i * (std::uint64_t{m} + 1))) == Tri::yes;
    if (decreasing && certainly_less(abs(term) * power, scaled(Ball::exactly(1), -kBits)) == Tri::yes) return result;
    const auto coefficient = in_units(term, kBits);
    if (!coefficient) return std::nullopt;
    sum += std::abs(std::ldexp(static_cast<double>(*coefficient), -kBits));
    if (!(sum < 2.9)) return std::nullopt;
    result.push_back(*coefficient);
    power = power * greatest_ratio;
    term = -(term * most) * (lambda + i * (i + 1)) / ((i + 1) * (std::uint64_t{m} + 1 + i));
  }
  return std::nullopt;
}

/// In units: ½ for the rounding of each step, 1 for its coefficient, 3 for x/X, with which sums of at most 3 are
/// multiplied; and 1 for what is left.
double error_of_series(std::size_t terms, double greatest_ratio) {
  double error = 0;
  for (std::size_t i = 0; i < terms; ++i) error = error * greatest_ratio + 4.5;
  return error + 1;
}

/// X for points with this s₀.
Ball greatest_argument(const Ball& greatest) { return min(Ball::exactly(1), twice(greatest / (1 - greatest))); }

std::int64_t value(const std::vector<std::int64_t>& polynomial, std::int64_t x) {
  std::int64_t sum = 0;
  for (std::size_t i = polynomial.size(); i-- > 0;) sum = shifted(Wide{sum} * x, kBits) + polynomial[i];
  return sum;
}

}  // namespace

std::optional<LocalPoint> LocalPoint::of(const ComplexBall& z, const Ball& greatest) {
  const Ball s = norm(z);
  if (certainly_less(greatest, s) != Tri::no) return std::nullopt;
  const Ball scale = rsqrt(greatest);
  const auto x = in_units(real(z) * scale, kValueBits);
  const auto y = in_units(imaginary(z) * scale, kValueBits);
  const auto units = in_units(s, kBits);
  const auto ratio = in_units(s / (1 - s) / greatest_argument(greatest), kBits);
  if (!x || !y || !units || !ratio) return std::nullopt;
  return LocalPoint{*x, *y, *units, *ratio};
}

std::optional<RadialFactors> RadialFactors::make(const Ball& lambda, std::uint32_t order, const Ball& greatest) {
  const auto less = [](const Ball& x, const Ball& y) { return certainly_less(x, y) == Tri::yes; };
  if (certainly_less(half(Ball::exactly(1)), greatest) != Tri::no) return std::nullopt;
  if (!less(lambda * greatest, Ball::exactly(7))) return std::nullopt;
  const Ball most = greatest_argument(greatest);
  const Ball greatest_ratio = greatest / (1 - greatest) / most;
  auto last = series(lambda, order, most, greatest_ratio);
  auto next = series(lambda, order + 1, most, greatest_ratio);
  if (!last || !next) return std::nullopt;
  RadialFactors result;
  result.last_ = *std::move(last);
  result.next_ = *std::move(next);
  const double lambda_above = outer_interval(lambda).upper;
  // Positive: series are so short only for λ < 2⁹(M + 2).
  result.weight_bits_ = kBits;
  while (std::ldexp(lambda_above, result.weight_bits_) >= 0x1p62) --result.weight_bits_;
  for (std::uint64_t m = 1; m <= order; ++m) {
    const auto weight = in_units(lambda / (m * (m + 1)), result.weight_bits_);
    if (!weight) return std::nullopt;
    result.weights_.push_back(*weight);
  }
  // Of F_m, F_{m + 1}, and F_m − F_{m + 1}.
  const double ratio = outer_interval(greatest_ratio).upper;
  double own = error_of_series(result.last_.size(), ratio);
  double after = error_of_series(result.next_.size(), ratio);
  double difference = own + after;
  const double s = outer_interval(greatest).upper;
  std::vector<double> errors{own};
  for (double m = order; m > 0; --m) {
    const double weight = lambda_above / (m * (m + 1));
    const double of_product = weight + s * std::ldexp(1, kBits - result.weight_bits_) + 0.5;
    difference = (s * difference + 2 + s * weight * after + of_product + 0.5) * kLeftOut;
    after = own;
    own = (own + difference) * kLeftOut;
    errors.push_back(own);
    if (!(own <= kGreatestError)) return std::nullopt;
  }
  result.errors_.assign(errors.rbegin(), errors.rend());
  return result;
}

void RadialFactors::set(const LocalPoint& point, std::vector<std::int64_t>& factors) const {
  const std::size_t order = weights_.size();
  factors.resize(order + 1);
  std::int64_t after = value(next_, point.ratio);
  std::int64_t own = value(last_, point.ratio);
  std::int64_t difference = own - after;
  factors[order] = own;
  for (std::size_t m = order; m > 0; --m) {
    const std::int64_t product = shifted(Wide{point.s} * weights_[m - 1], weight_bits_);
    difference = shifted(Wide{point.s} * difference - Wide{product} * after, kBits);
    after = own;
    own += difference;
    factors[m - 1] = own;
  }
}

std::optional<LocalValues> LocalValues::make(const EigenvaluesDocument::Eigenfunctions& row, std::size_t vertices,
                                             const Ball& greatest) {
  const std::size_t each = row.functions.front().size() / vertices;
  const std::size_t order = each / 2;
  auto factors = RadialFactors::make(Ball::exactly(row.lambda), static_cast<std::uint32_t>(order), greatest);
  if (!factors) return std::nullopt;
  LocalValues result(*std::move(factors));
  std::vector<Ball> powers{Ball::exactly(1)};
  std::vector<double> powers_above{1};
  for (std::size_t m = 1; m <= order; ++m) {
    powers.push_back(powers.back() * sqrt(greatest));
    powers_above.push_back(outer_interval(powers.back()).upper);
  }
  const std::size_t count = row.functions.size();
  result.coefficients_.resize(vertices * count * (order + 1));
  for (std::size_t j = 0; j < count; ++j) {
    const EigenvaluesDocument::Coefficients& given = row.functions[j];
    const auto alpha = [&](std::size_t vertex, std::size_t m) {
      return given[vertex * each + (m == 0 ? 0 : 2 * m - 1)];
    };
    const auto beta = [&](std::size_t vertex, std::size_t m) { return m == 0 ? 0 : given[vertex * each + 2 * m]; };
    // So that the sum of the sizes of a vertex's coefficients is less than 1.
    double most = 0;
    for (std::size_t vertex = 0; vertex < vertices; ++vertex) {
      double sum = 0;
      for (std::size_t m = 0; m <= order; ++m)
        sum += (std::abs(alpha(vertex, m)) + std::abs(beta(vertex, m))) * powers_above[m];
      most = std::max(most, sum * kLeftOut);
    }
    if (!(most < 0x1p500)) return std::nullopt;
    const int exponent = std::ilogb(std::max(most, 0x1p-500)) + 1;
    Scale scale{std::ldexp(1, exponent - kValueBits), {}};
    for (std::size_t vertex = 0; vertex < vertices; ++vertex) {
      double error = 3 * (static_cast<double>(order) + 1);
      for (std::size_t m = 0; m <= order; ++m) {
        const auto in = [&](double x) { return in_units(Ball::exactly(x) * powers[m], kValueBits - exponent); };
        const auto real = in(alpha(vertex, m));
        const auto imaginary = in(-beta(vertex, m));
        if (!real || !imaginary) return std::nullopt;
        result.coefficients_[(vertex * count + j) * (order + 1) + m] = {*real, *imaginary};
        const double size =
            std::ldexp(std::abs(static_cast<double>(*real)) + std::abs(static_cast<double>(*imaginary)), -kValueBits);
        error += size * (1.5 * static_cast<double>(m) + 2 * result.factors_.errors()[m]);
      }
      scale.errors.push_back(error * kLeftOut);
    }
    result.scales_.push_back(std::move(scale));
  }
  return result;
}

void LocalValues::set(std::size_t vertex, const LocalPoint& point, const std::vector<std::int64_t>& factors,
                      std::vector<std::int64_t>& values) const {
  const std::size_t each = factors.size();
  values.resize(count());
  for (std::size_t j = 0; j < values.size(); ++j) {
    const Coefficient* own = coefficients_.data() + (vertex * values.size() + j) * each;
    std::int64_t real = 0;
    std::int64_t imaginary = 0;
    for (std::size_t m = each; m-- > 0;) {
      // A factor has one bit less after the point.
      const Wide factor = Wide{factors[m]} << (kValueBits - kBits);
      const Wide next = Wide{real} * point.x - Wide{imaginary} * point.y + factor * own[m].real;
      imaginary = shifted(Wide{real} * point.y + Wide{imaginary} * point.x + factor * own[m].imaginary, kValueBits);
      real = shifted(next, kValueBits);
    }
    values[j] = real;
  }
}

namespace {

BallIsometry product(const BallIsometry& f, const BallIsometry& g) { return compose(f, g, Precision::bits()); }

/// sinh²(d/2), d the distance of 0 and f(0).
Ball displacement(const BallIsometry& f) {
  Ball result;
  half_displacement_squared(result.get(), f, Precision::bits());
  return result;
}

/// From the disk of the vertex's chart to the one with the vertex in its centre.
BallIsometry to_centre(const NetDocument::Vertex& vertex) {
  const Ball x = Ball::exactly(vertex.x);
  const Ball y = Ball::exactly(vertex.y);
  const Ball scale = rsqrt(Ball::exactly(1) - sqr(x) - sqr(y));
  return {{scale, Ball()}, {-(scale * x), -(scale * y)}};
}

/// By vertex: the ends of its edges, as they are seen from it.
std::vector<std::vector<NearVertex>> neighbours(const NetDocument& net, const std::vector<BallIsometry>& labels) {
  std::vector<BallIsometry> frames;
  for (const NetDocument::Vertex& vertex : net.vertices) frames.push_back(to_centre(vertex));
  // From the disk around the start of a dart to the chart of its triangle.
  const auto placed = [&](std::uint32_t dart) {
    const std::uint32_t label = corner_label(net, dart);
    const BallIsometry from = inverse(looked_up(frames, start(net, dart), "there is no vertex"));
    return label == 0 ? from : product(looked_up(labels, label - 1, "there is no label"), from);
  };
  std::vector<std::vector<NearVertex>> result(net.vertices.size());
  for (std::uint32_t dart = 0; dart < 3 * net.triangles.size(); ++dart) {
    const std::uint32_t next = next_dart(dart);
    result[start(net, dart)].push_back({start(net, next), product(inverse(placed(dart)), placed(next)), {}});
  }
  return result;
}

/// The lifts around one vertex.
class Neighbourhood {
 public:
  Neighbourhood(const std::vector<std::vector<NearVertex>>& edges, const Ball& shortest, const Ball& near,
                const Budget& budget)
      : edges_(edges), shortest_(shortest), near_(near), budget_(budget) {}

  [[nodiscard]] std::optional<std::vector<NearVertex>> around(std::uint32_t centre) const {
    const std::uint64_t work = 40 * ball_work(static_cast<std::uint64_t>(Precision::bits()));
    std::vector<NearVertex> found{{centre, identity_isometry(), {}}};
    std::multimap<std::uint32_t, std::size_t> of_vertex{{centre, 0}};  // Their numbers.
    for (std::size_t i = 0; i < found.size(); ++i) {
      for (const NearVertex& edge : edges_[found[i].vertex]) {
        const auto [first, last] = of_vertex.equal_range(edge.vertex);
        budget_.spend(work, static_cast<std::uint64_t>(std::distance(first, last)) + 1);
        BallIsometry isometry = product(found[i].isometry, edge.isometry);
        const Ball sinh_squared = displacement(isometry);
        if (certainly_less(near_, sinh_squared) == Tri::yes) continue;
        bool known = false;
        for (auto other = first; other != last && !known; ++other) {
          // Two lifts are the same, or at least as far from each other as the shortest edge is long.
          const Ball apart = displacement(product(inverse(found[other->second].isometry), isometry));
          known = certainly_less(apart, shortest_) == Tri::yes;
          if (!known && certainly_positive(apart) != Tri::yes) return std::nullopt;
        }
        if (known) continue;
        budget_.spend(memory_work(500));
        of_vertex.emplace(edge.vertex, found.size());
        found.push_back({edge.vertex, std::move(isometry), sinh_squared});
      }
    }
    found.erase(found.begin());
    return found;
  }

 private:
  const std::vector<std::vector<NearVertex>>& edges_;
  const Ball& shortest_;
  const Ball& near_;
  const Budget& budget_;
};

}  // namespace

std::optional<std::vector<std::vector<NearVertex>>> near_vertices(const NetDocument& net,
                                                                  const std::vector<BallIsometry>& labels,
                                                                  const Ball& distance, const Budget& budget,
                                                                  unsigned threads) {
  budget.spend(400 * ball_work(static_cast<std::uint64_t>(Precision::bits())), net.triangles.size());
  const auto edges = neighbours(net, labels);
  const Ball near = sqr(sinh(half(distance)));
  Ball shortest = near;
  for (const auto& ends : edges) {
    for (const NearVertex& end : ends) shortest = min(shortest, displacement(end.isometry));
  }
  const Neighbourhood neighbourhood(edges, shortest, near, budget);
  std::vector<std::optional<std::vector<NearVertex>>> found(net.vertices.size());
  for_each_parallel(found.size(), threads, [&](unsigned, std::size_t vertex) {
    found[vertex] = neighbourhood.around(static_cast<std::uint32_t>(vertex));
  });
  std::vector<std::vector<NearVertex>> result;
  for (auto& lifts : found) {
    if (!lifts) return std::nullopt;
    result.push_back(*std::move(lifts));
  }
  return result;
}

namespace {

using Point = std::complex<double>;

/// The sums over all lifts in a cell: all points within ρ of its centre.
class PartitionCell {
 public:
  PartitionCell(double reach, double radius)
      : reach_(reach),
        cosh_(std::cosh(reach)),
        sinh_(std::sinh(reach)),
        scale_(2 * std::pow(std::sinh(radius / 2), 2)) {}

  /// A lift, seen from the centre: C = cosh d, and the vector ∇C.
  void add(Point z) {
    const double gap = 1 - std::norm(z);
    const double beyond_one = 2 * std::norm(z) / gap;  // C − 1
    const Point vector = 2.0 * z / gap;
    const double sinh = std::sqrt(std::norm(vector));
    const double greatest_sinh = sinh * cosh_ + (1 + beyond_one) * sinh_;  // Of d + ρ.
    const double greatest_cosh = (1 + beyond_one) * cosh_ + sinh * sinh_;
    const double change = reach_ * greatest_sinh;
    const double turn = reach_ * greatest_cosh;  // Of the gradient.
    const double most = 1 - (beyond_one - change) / scale_;
    if (most <= 0) return;
    const double least = std::max(0.0, 1 - (beyond_one + change) / scale_);
    const double here = std::max(0.0, 1 - beyond_one / scale_);
    const double steepest = (sinh + turn) / scale_;
    const double flattest = std::max(0.0, sinh - turn) / scale_;
    squares_ += least * least;
    slopes_ += 2 * most * steepest;
    gradient_ += here * vector;
    turns_ += (most - least) * (sinh + turn) + here * turn;
    // Δh² = 2|∇h|² − 4hC/β, or 0 where h is 0.
    double low = 2 * flattest * flattest - 4 * most * greatest_cosh / scale_;
    double high = 2 * steepest * steepest - 4 * least * std::max(1.0, 1 + beyond_one - change) / scale_;
    if (least == 0) {
      low = std::min(low, 0.0);
      high = std::max(high, 0.0);
    }
    laplacians_ += std::max(std::abs(low), std::abs(high));
    lowest_ += low;
    highest_ += high;
  }

  [[nodiscard]] PartitionBounds bounds() const {
    if (squares_ <= 0) return {kInfinity, kInfinity};
    const double gradient = 2 * (std::abs(gradient_) + turns_) / scale_;
    const double laplacian = std::max(std::abs(lowest_), std::abs(highest_));
    return {(laplacians_ + laplacian) / squares_ +
                (2 * slopes_ * gradient + 2 * gradient * gradient) / (squares_ * squares_),
            (slopes_ + gradient) / squares_};
  }

 private:
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();

  double reach_;  ///< ρ
  double cosh_;
  double sinh_;
  double scale_;        ///< β = cosh R − 1
  double squares_ = 0;  ///< Of h, at least.
  double slopes_ = 0;   ///< 2h|∇h|, at most.
  Point gradient_;      ///< Σ h∇C, at the centre,
  double turns_ = 0;    ///< and how far it may be from there.
  double laplacians_ = 0;
  double lowest_ = 0;
  double highest_ = 0;
};

}  // namespace

PartitionBounds partition_bounds(const std::vector<Point>& lifts, double epsilon, double radius) {
  constexpr double kSide = 0.05;  // Of the squares, relative to the disk.
  const double disk = std::tanh(epsilon / 2);
  const double side = kSide * disk;
  const double half_diagonal = side * 0.70710679;
  // In the disk with its cells, lengths are at most 2/(1 − |z|²) times as long. The rest is for rounding.
  const double reach = 2 * half_diagonal / (1 - std::pow(disk + side, 2)) * (1 + 1e-6) + 1e-9;
  PartitionBounds result;
  const int most = static_cast<int>(std::ceil(1 / kSide)) + 1;
  for (int i = -most; i <= most; ++i) {
    for (int j = -most; j <= most; ++j) {
      const Point centre(i * side, j * side);
      if (std::abs(centre) > disk + half_diagonal) continue;
      PartitionCell cell(reach, radius);
      for (const Point& lift : lifts) cell.add((lift - centre) / (1.0 - std::conj(centre) * lift));
      const PartitionBounds here = cell.bounds();
      result.laplacians = std::max(result.laplacians, here.laplacians);
      result.gradients = std::max(result.gradients, here.gradients);
    }
  }
  constexpr double kRounding = 1 + 1e-6;
  return {result.laplacians * kRounding, result.gradients * kRounding};
}

namespace {

ComplexBall quotient(const ComplexBall& x, const ComplexBall& y) {
  ComplexBall result;
  acb_div(result.get(), x.get(), y.get(), Precision::bits());
  return result;
}

/// J: so many that what is beyond them is as small as the rounding of the coefficients, and at most so many. Any number
/// is right, so it may be rounded.
std::uint32_t number_of_waves(const Ball& s, double lambda, std::uint32_t most) {
  constexpr double kSmall = -43;  // The logarithm of 2⁻⁶².
  const double t = std::sqrt(outer_interval(s).upper);
  for (std::uint32_t waves = 2; waves < most; ++waves) {
    const double sinh_wider = (waves + 1) / std::sqrt(lambda);
    const double cosh_wider = std::sqrt(1 + sinh_wider * sinh_wider);
    const double q = t * (1 + cosh_wider) / sinh_wider;
    if (q < 1 && lambda * (cosh_wider - 1) / (waves + 1) + waves * std::log(q) - std::log(1 - q) < kSmall) return waves;
  }
  return most;
}

/// By vertex, the bounds around it. Lifts are placed with errors of less than 10⁻¹²; nothing if the balls are wider.
std::optional<std::vector<PartitionBounds>> partition_around(const std::vector<std::vector<NearVertex>>& near,
                                                             const Ball& epsilon, double radius, unsigned threads) {
  std::vector<PartitionBounds> result(near.size());
  std::atomic<bool> known = true;
  for_each_parallel(near.size(), threads, [&](unsigned, std::size_t vertex) {
    std::vector<std::complex<double>> lifts{0};
    const auto middle = [&](arb_srcptr x) {
      if (arb_is_finite(x) == 0 || mag_cmp_2exp_si(arb_radref(x), -42) > 0) known = false;
      return arf_get_d(arb_midref(x), ARF_RND_NEAR);
    };
    for (const NearVertex& lift : near[vertex]) {
      const ComplexBall place = quotient(lift.isometry.b, conjugate(lift.isometry.a));
      lifts.emplace_back(middle(place.re()), middle(place.im()));
    }
    if (known) result[vertex] = partition_bounds(lifts, above(outer_interval(epsilon).upper), radius);
  });
  return known ? std::optional(std::move(result)) : std::nullopt;
}

/// The points of a circle around the midpoint of two vertices.
class MeetingCircle {
 public:
  /// With this tanh of half the radius.
  MeetingCircle(const BallIsometry& isometry, const ComplexBall& middle, const Ball& t, const Ball& greatest)
      : back_(inverse(isometry)), middle_(middle), turned_(conjugate(middle)), t_(t), greatest_(greatest) {}

  [[nodiscard]] bool set(const ComplexBall& direction, Overlaps::Point& point) const {
    const ComplexBall unit(Ball::exactly(1), Ball());
    const ComplexBall around = t_ * direction;
    const ComplexBall z = quotient(around + middle_, unit + turned_ * around);
    const ComplexBall w = quotient(back_.a * z + back_.b, conjugate(back_.b) * z + conjugate(back_.a));
    const auto own = LocalPoint::of(z, greatest_);
    const auto other = LocalPoint::of(w, greatest_);
    if (!own || !other) return false;
    point = {*own, *other};
    return true;
  }

 private:
  BallIsometry back_;
  ComplexBall middle_;
  ComplexBall turned_;
  Ball t_;
  const Ball& greatest_;
};

}  // namespace

std::optional<Overlaps> Overlaps::make(const NetDocument& net, const std::vector<BallIsometry>& labels, double radius,
                                       std::uint32_t order, double lambda, const Budget& budget, unsigned threads) {
  const Ball epsilon = Ball::rounded(decimal(net.epsilon));
  const Ball big_radius = Ball::exactly(radius);
  const auto near = near_vertices(net, labels, epsilon + big_radius, budget, threads);
  if (!near) return std::nullopt;
  const Ball cosh_epsilon = cosh(epsilon);
  const Ball reach = cosh_epsilon + cosh(big_radius);
  Overlaps result;
  // A point of a circle is at most S and half of the distance d from a vertex, and that is greatest for S = d/2. One of
  // balls that contain it is not greater than the upper end.
  const Ball greatest = (reach - 2) / reach;
  arb_get_ubound_arf(arb_midref(result.greatest_.get()), greatest.get(), Precision::bits());
  if (!is_finite(result.greatest_)) return std::nullopt;
  result.sinh_disk_ = sinh(epsilon);
  result.disk_area_ = outer_interval(twice(pi()) * (cosh_epsilon - 1)).upper;

  const std::uint64_t work = ball_work(static_cast<std::uint64_t>(Precision::bits()));
  std::vector<const BallIsometry*> isometries;
  std::vector<std::vector<ComplexBall>> roots(order + std::size_t{1});  // By J.
  result.roots_.resize(roots.size());
  for (std::uint32_t vertex = 0; vertex < near->size(); ++vertex) {
    for (const NearVertex& other : (*near)[vertex]) {
      result.sinh_disk_ = min(result.sinh_disk_, sqrt(other.sinh_squared));
      if (vertex > other.vertex) continue;
      budget.spend(20 * work + memory_work(200) + 60 * std::uint64_t{order});
      const Ball cosh_radius = half(reach) * rsqrt(norm(other.isometry.a));
      const Ball s = (cosh_radius - 1) / (cosh_radius + 1);
      const auto edge = LocalPoint::of(ComplexBall(sqrt(s), Ball()), result.greatest_);
      if (!edge) return std::nullopt;
      const std::uint32_t waves = number_of_waves(s, lambda, order);
      budget.spend(150 * work + memory_work(sizeof(Point)), std::uint64_t{2} * waves);
      if (roots[waves].empty()) {
        for (std::uint32_t k = 0; k < 2 * waves; ++k) {
          const ComplexBall& root = roots[waves].emplace_back(root_of_unity(k, 2 * waves));
          for (const arb_srcptr part : {root.re(), root.im()})
            result.roots_[waves].push_back(arf_get_d(arb_midref(part), ARF_RND_NEAR));
        }
      }
      result.pairs_.push_back({vertex, other.vertex, waves, result.points_.size(), *edge, s});
      result.points_.resize(result.points_.size() + std::size_t{2} * waves);
      isometries.push_back(&other.isometry);
    }
  }
  std::atomic<bool> known = true;
  for_each_parallel(result.pairs_.size(), threads, [&](unsigned, std::size_t i) {
    const Pair& pair = result.pairs_[i];
    const auto& [a, b] = *isometries[i];
    const Ball length = sqrt_of_nonnegative(norm(a));
    // The midpoint of 0 and b/ā.
    const MeetingCircle circle(*isometries[i], (1 / (length * (length + 1))) * (a * b), sqrt(pair.s), result.greatest_);
    const std::vector<ComplexBall>& directions = roots[pair.waves];
    for (std::size_t k = 0; k < directions.size() && known; ++k) {
      if (!circle.set(directions[k], result.points_[pair.first + k])) known = false;
    }
  });
  if (!known) return std::nullopt;
  constexpr std::uint64_t kCells = 1500;
  for (const auto& lifts : *near) budget.spend(40 * kCells, lifts.size() + 1);
  auto partition = partition_around(*near, epsilon, radius, threads);
  if (!partition) return std::nullopt;
  result.partition_ = *std::move(partition);
  return result;
}

}  // namespace epsnet::certify
