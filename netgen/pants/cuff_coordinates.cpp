#include "netgen/pants/cuff_coordinates.h"

#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "kernel/lorentz.h"
#include "netgen/base/gmp.h"
#include "netgen/surfaces/exact_isometries.h"
#include "triangulation/surface/error.h"

namespace epsnet {
namespace {

using certify::Ball;
using certify::BallIsometry;
using Vector = LorentzVector<Ball>;

constexpr slong kFirstBits = 256;
constexpr slong kMostBits = 1 << 15;
/// Letters of a path of which the length is perhaps known exactly.
constexpr std::size_t kMostLetters = 1000;

/// The normal of the axis of an element with Re a > 0, not of length 1.
Vector normal(const BallIsometry& f) { return {-certify::imaginary(f.b), certify::real(f.b), certify::imaginary(f.a)}; }

/// Values of paths in balls: the isometry from the lift of the tile at the end to that at the start.
class Values {
 public:
  Values(const Surface& surface, slong precision) : surface_(surface), precision_(precision) {}

  [[nodiscard]] BallIsometry operator()(const Word& word) const {
    return certify::inverse(ball_isometry(surface_, word, precision_));
  }

  [[nodiscard]] BallIsometry times(const BallIsometry& f, const BallIsometry& g) const {
    return certify::compose(f, g, precision_);
  }

 private:
  const Surface& surface_;
  slong precision_;
};

/// The one of ±f with Re a > 0, if that is certain.
std::optional<BallIsometry> positive(const BallIsometry& f) {
  const int sign = certify::certain_sign(certify::real(f.a));
  if (sign == 0) return std::nullopt;
  return sign > 0 ? f : BallIsometry{-f.a, -f.b};
}

/// The elements of the three cuffs.
using Cuffs = std::array<BallIsometry, 3>;

/// One path after the other.
Word joined(Word first, const Word& then) {
  first.insert(first.end(), then.begin(), then.end());
  return first;
}

/// e^{l/2} for an element of length l, if it is rational.
std::optional<Rational> rational_root(const Surface& surface, const Word& path) {
  if (!surface.is_rational() || path.empty() || path.size() > kMostLetters) return std::nullopt;
  const certify::ExactIsometry f = integer_isometry(surface, path);
  // cosh(l/2) = |Re a|/√det, and sinh²(l/2) = (|b|² − (Im a)²)/det.
  const mpz_class square = f.b.re * f.b.re + f.b.im * f.b.im - f.a.im * f.a.im;
  const mpz_class determinant = f.a.re * f.a.re - square;
  if (mpz_perfect_square_p(square.get_mpz_t()) == 0 || mpz_perfect_square_p(determinant.get_mpz_t()) == 0) {
    return std::nullopt;
  }
  mpq_class root(mpz_class(abs(f.a.re) + sqrt(square)), sqrt(determinant));
  root.canonicalize();
  return from_gmp(root);
}

class Coordinates {
 public:
  Coordinates(const Surface& surface, const PantsGraph& graph, const std::vector<PantsPaths>& pants,
              const std::vector<Word>& across)
      : surface_(surface), graph_(graph), across_(across) {
    for (const auto& [cuffs] : pants) {
      paths_.insert(paths_.end(), {cuffs[0], cuffs[1], reversed(surface, joined(cuffs[0], cuffs[1]))});
    }
    for (const PantsGraph::Edge& edge : graph.edges()) {
      result_.push_back({{}, {}, rational_root(surface, path(edge[0]))});
    }
  }

  [[nodiscard]] std::vector<CuffCoordinates> enclose() {
    std::vector<bool> done(across_.size());
    for (slong bits = kFirstBits;; bits *= 2) {
      const certify::Precision precision(bits);
      const Values value(surface_, bits);
      bool all = true;
      for (std::size_t e = 0; e < across_.size(); ++e) {
        if (!done[e]) done[e] = enclose(value, e);
        all = all && done[e];
      }
      if (all) return std::move(result_);
      if (bits >= kMostBits) throw LimitError("the twists are not known with " + std::to_string(bits) + " bits");
    }
  }

 private:
  [[nodiscard]] const Word& path(const PantsGraph::End& end) const {
    return paths_[3 * std::size_t{end.pants} + end.cuff];
  }

  [[nodiscard]] std::optional<Cuffs> cuffs(const Values& value, std::uint32_t pants) const {
    Cuffs result;
    for (std::uint32_t k = 0; k < 3; ++k) {
      auto f = positive(value(path({pants, k})));
      if (!f) return std::nullopt;
      result[k] = *std::move(f);
    }
    return result;
  }

  /// Whether length and twist of an edge are known to almost the last digit.
  bool enclose(const Values& value, std::size_t e) {
    const auto& [first, second] = graph_.edges()[e];
    const auto own = cuffs(value, first.pants);
    const auto others = cuffs(value, second.pants);
    if (!own || !others) return false;
    const BallIsometry there = value(across_[e]);
    const BallIsometry& next = (*others)[(second.cuff + 1) % 3];
    const Vector n = normal((*own)[first.cuff]);
    const Vector left = normal((*own)[(first.cuff + 1) % 3]);
    const Vector right = normal(value.times(value.times(there, next), certify::inverse(there)));
    const Ball sinh_half = certify::sqrt(lorentz_product(n, n));
    const Ball length = certify::twice(certify::asinh(sinh_half));
    // The normals of the two perpendiculars, and sinh of their distance along the axis.
    const Vector u = lorentz_cross(n, left);
    const Vector v = lorentz_cross(n, right);
    const Ball sizes = certify::sqrt(lorentz_product(u, u) * lorentz_product(v, v));
    Ball twist = certify::asinh(lorentz_product(lorentz_cross(n, v), u) / (sinh_half * sizes));
    const Ball turns = twist / length;
    if (!certify::is_finite(turns)) return false;
    const double whole = std::nearbyint(arf_get_d(arb_midref(turns.get()), ARF_RND_NEAR));
    if (!(std::abs(whole) < 0x1p53)) return false;
    twist = twist - Ball::exactly(whole) * length;
    const Ball least = certify::scaled(length, -70);
    for (const Ball& x : {length, twist}) {
      if (certify::certainly_less(radius(x), least) != certify::Tri::yes) return false;
    }
    result_[e].length = certify::outer_interval(length);
    result_[e].twist = certify::outer_interval(twist);
    return true;
  }

  static Ball radius(const Ball& x) {
    Ball result;
    arb_get_rad_arb(result.get(), x.get());
    return result;
  }

  const Surface& surface_;
  const PantsGraph& graph_;
  const std::vector<Word>& across_;
  std::vector<Word> paths_;  ///< By cuff of all pairs of pants.
  std::vector<CuffCoordinates> result_;
};

}  // namespace

std::vector<CuffCoordinates> cuff_coordinates(const Surface& surface, const PantsGraph& graph,
                                              const std::vector<PantsPaths>& pants, const std::vector<Word>& across) {
  return Coordinates(surface, graph, pants, across).enclose();
}

}  // namespace epsnet
