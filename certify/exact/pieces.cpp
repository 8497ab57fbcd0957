#include "certify/exact/pieces.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <utility>

namespace epsnet::exact {
namespace {

/// ⟨m, X⟩ for m = (−Im b, Re b, Im a) and the point n/d: with Re a > 0, positive on the left of the axis.
template <class R>
R height(const Isometry<R>& g, const Complex<R>& n, const Complex<R>& d) {
  const Complex<R> z = n * conjugate(d);
  return R(2) * (g.b.re * z.im - g.b.im * z.re) - g.a.im * (norm(n) + norm(d));
}

template <class R>
class Cutter {
 public:
  Cutter(NetRules<R>& net, const Loops<R>& loops, const std::vector<std::size_t>& geodesics)
      : net_(net), loops_(loops), elements_(net.net().vertices.size()), sides_(2 * geodesics.size(), kNone) {
    find_elements(geodesics);
    for (Index dart = 0; dart < net_.darts(); ++dart) {
      count_on(dart);
      first_.push_back(parent_.size());
      const std::size_t segments = dart < net_.opposite(dart) ? crossings_[dart].size() + 1 : 0;
      for (std::size_t k = 0; k < segments; ++k) parent_.push_back(parent_.size());
    }
    for (Index dart = 0; dart < net_.darts(); ++dart) {
      for (std::size_t k = 0; k <= around(dart); ++k) join(segment(dart, k), segment(edge_before(dart), k));
    }
  }

  [[nodiscard]] std::vector<Piece> run() {
    find_sides();
    std::vector<Piece> pieces;
    for (const auto& [root, euler] : euler_characteristics()) {
      std::vector<std::array<Index, 2>> boundaries;
      for (Index k = 0; k < sides_.size(); ++k) {
        if (sides_[k] == root) boundaries.push_back({k / 2, k % 2});
      }
      const long twice_genus = 2 - euler - static_cast<long>(boundaries.size());
      if (twice_genus < 0 || twice_genus % 2 != 0) give_up("a piece has no genus");
      pieces.push_back({static_cast<Index>(twice_genus / 2), std::move(boundaries)});
    }
    return pieces;
  }

 private:
  static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

  struct Element {
    Index geodesic;
    std::size_t loop;
  };
  /// Where a lift of a geodesic counts on an edge, from where a dart starts.
  struct Crossing {
    Index geodesic;
    bool from_left;
    Interval t;
  };
  struct End {
    Interval height;
    bool is_left;
  };

  /// All that edges lead to from the one that is given.
  void find_elements(const std::vector<std::size_t>& geodesics) {
    std::vector<bool> known(loops_.all().size());
    for (Index i = 0; i < geodesics.size(); ++i) {
      std::vector<std::size_t> found{geodesics[i]};
      known[geodesics[i]] = true;
      for (std::size_t k = 0; k < found.size(); ++k) {
        const Index v = loops_.all()[found[k]].vertex;
        elements_[v].push_back({i, found[k]});
        for (const Index dart : loops_.leaving(v)) {
          const auto other = loops_.along(found[k], dart);
          if (!other || known[*other]) continue;
          known[*other] = true;
          found.push_back(*other);
        }
      }
    }
  }

  /// Those at the start of the dart, and those at its end that are not found at both.
  void count_on(Index dart) {
    auto& crossings = crossings_.emplace_back();
    const Index other = net_.opposite(dart);
    if (other < dart) return;
    for (const Index from : {dart, other}) {
      for (const Element& element : elements_[net_.start(from)]) {
        End start = end_of(element, from, false);
        End end = end_of(element, from, true);
        if (start.is_left == end.is_left || (from == other && loops_.along(element.loop, other))) continue;
        if (from == other) std::swap(start, end);
        Crossing crossing{element.geodesic, start.is_left, start.height / (start.height - end.height)};
        const auto is_before = [](const Crossing& x, const Crossing& y) {
          return decided(is_less(x.t, y.t), "which of two geodesics crosses an edge first");
        };
        crossings.insert(std::lower_bound(crossings.begin(), crossings.end(), crossing, is_before), crossing);
      }
    }
  }

  /// Where the start of a dart, or its end, is from the axis of an element at the start.
  [[nodiscard]] End end_of(const Element& element, Index dart, bool at_end) const {
    const auto& loop = loops_.all()[element.loop];
    const Place place = at_end ? loops_.step(dart).place : loops_.self(loop.vertex);
    const Interval h = height(loop.g, place.n, place.d);
    const bool is_turned = decided(is_less(loop.g.a.re, Interval(0)), "the direction of an axis");
    const Interval oriented = is_turned ? -h : h;
    const Answer is_right = is_less(oriented, Interval(0));
    if (is_right != Answer::unknown) return {oriented, is_right == Answer::no};
    const Isometry<R> g = loops_.exact(loop);
    Point<R> z = point<R>(net_.net().vertices[at_end ? loops_.step(dart).end : loop.vertex].z);
    if (at_end) z = net_.image(net_.element(dart), z);
    return {oriented, sgn(height(g, z.n, {z.m, R(0)})) * sgn(g.a.re) >= 0};
  }

  [[nodiscard]] std::size_t count(Index dart) const { return crossings_[std::min(dart, net_.opposite(dart))].size(); }
  /// The other edge at the corner where the dart starts, from there.
  [[nodiscard]] Index edge_before(Index dart) const { return net_.opposite(previous(dart)); }
  /// How many cut off this corner.
  [[nodiscard]] std::size_t around(Index dart) const {
    const std::array counts{count(dart), count(next(dart)), count(previous(dart))};
    const std::size_t twice = counts[0] + counts[1] + counts[2];
    // Implied by Lemma 15.4.
    if (twice % 2 != 0 || 2 * *std::max_element(counts.begin(), counts.end()) > twice) give_up("half an arc");
    return twice / 2 - counts[1];
  }
  /// Segment number k from where the dart starts.
  [[nodiscard]] std::size_t segment(Index dart, std::size_t k) const {
    const Index other = net_.opposite(dart);
    return dart < other ? first_[dart] + k : first_[other] + count(dart) - k;
  }

  [[nodiscard]] std::size_t root(std::size_t i) {
    for (; parent_[i] != i; i = parent_[i]) parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::size_t i, std::size_t j) { parent_[root(i)] = root(j); }

  void find_sides() {
    for (Index dart = 0; dart < net_.darts(); ++dart) {
      for (std::size_t k = 0; k < crossings_[dart].size(); ++k) {
        const Crossing& crossing = crossings_[dart][k];
        for (const bool is_right : {false, true}) {
          const std::size_t here = root(segment(dart, crossing.from_left == is_right ? k + 1 : k));
          std::size_t& side = sides_[2 * std::size_t{crossing.geodesic} + (is_right ? 1 : 0)];
          // Implied by Lemma 15.4.
          if (side != kNone && side != here) give_up("a side of a geodesic is in two pieces");
          side = here;
        }
      }
    }
  }

  /// By component.
  [[nodiscard]] std::map<std::size_t, long> euler_characteristics() {
    std::map<std::size_t, long> euler;
    for (Index v = 0; v < elements_.size(); ++v) ++euler[root(segment(loops_.leaving(v).front(), 0))];
    for (std::size_t i = 0; i < parent_.size(); ++i) --euler[root(i)];
    for (Index dart = 0; dart < net_.darts(); ++dart) {
      const std::size_t cells = around(dart) + (dart % 3 == 0 ? 1 : 0);
      for (std::size_t k = 0; k < cells; ++k) ++euler[root(segment(dart, k))];
    }
    return euler;
  }

  NetRules<R>& net_;
  const Loops<R>& loops_;
  std::vector<std::vector<Element>> elements_;    ///< By vertex.
  std::vector<std::size_t> sides_;                ///< The component at side s of geodesic i, by 2i + s.
  std::vector<std::vector<Crossing>> crossings_;  ///< By dart, of the lesser dart of an edge: in their order.
  std::vector<std::size_t> first_;                ///< Likewise, its first segment.
  std::vector<std::size_t> parent_;               ///< Of a segment, in a set.
};

}  // namespace

template <class R>
std::vector<Piece> pieces(NetRules<R>& net, const Loops<R>& loops, const std::vector<std::size_t>& geodesics) {
  return Cutter<R>(net, loops, geodesics).run();
}

template std::vector<Piece> pieces(NetRules<mpz_class>&, const Loops<mpz_class>&, const std::vector<std::size_t>&);
template std::vector<Piece> pieces(NetRules<Algebraic>&, const Loops<Algebraic>&, const std::vector<std::size_t>&);
template std::vector<Piece> pieces(NetRules<FieldNumber>&, const Loops<FieldNumber>&, const std::vector<std::size_t>&);

}  // namespace epsnet::exact
