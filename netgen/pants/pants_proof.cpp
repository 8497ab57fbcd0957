#include "netgen/pants/pants_proof.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <variant>

#include "certify/net/crossings.h"
#include "certify/numbers/isometry.h"
#include "kernel/lorentz.h"
#include "netgen/base/gmp.h"
#include "netgen/nets/certified_net.h"
#include "netgen/pants/exact_crossings.h"
#include "triangulation/surface/error.h"

namespace epsnet {
namespace {

using certify::Ball;
using certify::BallIsometry;
using Vector = LorentzVector<Ball>;

constexpr slong kFirstBits = 256;
constexpr slong kMostBits = 1 << 15;

Ball real_part(const BallIsometry& f) { return certify::real(f.a); }

/// The normal of the axis of an element with Re a > 0, not of length 1.
Vector normal(const BallIsometry& f) { return {-certify::imaginary(f.b), certify::real(f.b), certify::imaginary(f.a)}; }

/// Values of paths in balls: the isometry from the lift of the tile at the end to that at the start.
class Values {
 public:
  Values(const certify::Crossings& crossings, slong precision) : crossings_(crossings), precision_(precision) {}

  [[nodiscard]] BallIsometry operator()(const Word& word) const {
    BallIsometry value = certify::identity_isometry();
    for (const SideId s : word) {
      value = times(value, certify::inverse(ball_crossing(crossings_, s.number(), precision_)));
    }
    return value;
  }

  [[nodiscard]] BallIsometry times(const BallIsometry& f, const BallIsometry& g) const {
    return certify::compose(f, g, precision_);
  }

 private:
  const certify::Crossings& crossings_;
  slong precision_;
};

/// The one of ±f with Re a > 0, if that is certain.
std::optional<BallIsometry> positive(const BallIsometry& f) {
  const int sign = certify::certain_sign(real_part(f));
  if (sign == 0) return std::nullopt;
  return sign > 0 ? f : BallIsometry{-f.a, -f.b};
}

/// The elements of the three cuffs.
using Cuffs = std::array<BallIsometry, 3>;

/// Yes, if the elements are those of a pair of pants on their left.
certify::Tri is_pants(const Cuffs& cuffs, const BallIsometry& product) {
  const Ball one = Ball::exactly(1);
  certify::Tri result = certify::certainly_less(real_part(product), -one);
  for (const BallIsometry& f : {cuffs[0], cuffs[1]}) {
    result = certify::both(result, certify::certainly_less(one, real_part(f)));
  }
  const Vector n = normal(cuffs[0]);
  const Vector m = normal(cuffs[1]);
  // The point of the second axis that is nearest to the first one is on its left.
  const Ball nearest = n.t * lorentz_product(m, m) - m.t * lorentz_product(n, m);
  return certify::both(result, certify::certainly_negative(nearest));
}

/// Whether the element of a path is 1, exactly.
bool is_one(const certify::Crossings& crossings, const Word& path, const std::string& name) {
  const std::vector<std::uint32_t> word = letters_of(path);
  return std::visit(
      [&](const auto& kind) {
        using Kind = std::decay_t<decltype(kind)>;
        if (kind.product_bits(0, word) > Kind::kMaxExactBits / 8) {
          throw LimitError(name + ": its numbers are too large to be compared exactly");
        }
        const auto f = kind.exact(word);
        return sign(twice_imaginary(f.a)) == 0 && sign(norm(f.b)) == 0;
      },
      crossings);
}

/// One path after the other, without any short cut that a proof would rest on.
Word joined(Word first, const Word& then) {
  first.insert(first.end(), then.begin(), then.end());
  return first;
}

TileId end_of(const Surface& surface, const Word& path) { return surface.tile_of_side(surface.partner(path.back())); }

std::string edge_name(std::size_t e) { return "cuff " + std::to_string(e); }

/// e^{l/2} for an element of length l, if it is rational.
std::optional<Rational> rational_root(const Surface& surface, const certify::Crossings& crossings, const Word& path) {
  const std::vector<std::uint32_t> word = letters_of(path);
  if (surface.is_regular()) return std::nullopt;
  const auto& kind = std::get<certify::RationalCrossings>(crossings);
  if (kind.product_bits(0, word) > certify::RationalCrossings::kMaxExactBits / 8) return std::nullopt;
  const certify::ExactIsometry f = kind.exact(word);
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

class Proof {
 public:
  Proof(const Surface& surface, const PantsGraph& graph, const std::vector<PantsPaths>& pants,
        const std::vector<Word>& across)
      : graph_(graph), across_(across), crossings_(crossings_of(surface)) {
    if (pants.size() != 2 * std::size_t{surface.genus()} - 2 || graph.genus() != surface.genus()) {
      throw NetError(std::to_string(pants.size()) + " pairs of pants on a surface of genus " +
                     std::to_string(surface.genus()));
    }
    for (std::size_t p = 0; p < pants.size(); ++p) {
      const auto& [first, second] = pants[p].cuffs;
      const TileId tile = first.empty() ? TileId(0) : end_of(surface, first);
      if (first.empty() || !is_path(surface, tile, tile, first) || !is_path(surface, tile, tile, second)) {
        throw NetError("piece " + std::to_string(p) + " has no paths that are closed");
      }
      paths_.insert(paths_.end(), {first, second, reversed(surface, joined(first, second))});
    }
    for (std::size_t e = 0; e < across.size(); ++e) {
      const auto& [first, second] = graph.edges()[e];
      if (!is_path(surface, end_of(surface, path(first)), end_of(surface, path(second)), across[e])) {
        throw NetError(edge_name(e) + " has no path across it");
      }
      const Word other = joined(joined(across[e], path(second)), reversed(surface, across[e]));
      if (!is_one(crossings_, joined(path(first), other), edge_name(e))) {
        throw NetError(edge_name(e) + " is not the same closed geodesic from both sides");
      }
      result_.push_back({{}, {}, rational_root(surface, crossings_, path(first))});
    }
  }

  [[nodiscard]] std::vector<ProvedCuff> prove() {
    std::vector<bool> done(across_.size());
    std::vector<bool> pants_done(paths_.size() / 3);
    for (slong bits = kFirstBits;; bits *= 2) {
      const certify::Precision precision(bits);
      const Values value(crossings_, bits);
      bool all = true;
      for (std::uint32_t p = 0; p < pants_done.size(); ++p) {
        if (pants_done[p]) continue;
        const auto elements = cuffs(value, p);
        const certify::Tri answer =
            elements ? is_pants(*elements, value.times((*elements)[0], (*elements)[1])) : certify::Tri::unknown;
        if (answer == certify::Tri::no) throw NetError("piece " + std::to_string(p) + " is no pair of pants");
        pants_done[p] = answer == certify::Tri::yes;
        all = all && pants_done[p];
      }
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

  const PantsGraph& graph_;
  const std::vector<Word>& across_;
  certify::Crossings crossings_;
  std::vector<Word> paths_;  ///< By cuff of all pairs of pants.
  std::vector<ProvedCuff> result_;
};

}  // namespace

std::vector<ProvedCuff> prove_pants(const Surface& surface, const PantsGraph& graph,
                                    const std::vector<PantsPaths>& pants, const std::vector<Word>& across) {
  return Proof(surface, graph, pants, across).prove();
}

}  // namespace epsnet
