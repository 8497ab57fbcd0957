#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "certify/exact/loops.h"

/// Section 18.1 of docs/proof.md: isometries as pairs of loops whose axes cross. In intervals.
namespace epsnet::exact {

inline bool may_be_equal(const Interval& x, const Interval& y) {
  return either(is_less(x, y), is_less(y, x)) != Answer::yes;
}

inline bool may_be_identity(const Motion& g) {
  return may_be_equal(g.a.im, 0) && may_be_equal(g.b.re, 0) && may_be_equal(g.b.im, 0);
}

inline Vector cross_product(const Vector& u, const Vector& v) {
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[1] * v[0] - u[0] * v[1]};
}

/// Two loops at one vertex whose axes cross: the normals of these, for the signs with positive traces, and their
/// product are a basis.
struct Basis {
  Basis(const Motion& x, const Motion& y)
      : u(normal(x)), v(normal(y)), uu(lorentz_product(u, u)), uv(lorentz_product(u, v)), vv(lorentz_product(v, v)) {}

  static Vector normal(const Motion& g) {
    return axis_normal(is_less(g.a.re, 0) == Answer::yes ? Motion{-g.a, -g.b} : g);
  }

  [[nodiscard]] Answer axes_cross() const { return is_less(square(uv), uu * vv); }
  /// Whether an isometry may take the other pair to this one: lengths and angles agree.
  [[nodiscard]] bool may_be_image_of(const Basis& other) const {
    return may_be_equal(uu, other.uu) && may_be_equal(uv, other.uv) && may_be_equal(vv, other.vv);
  }

  /// What a vector is in u, v and w = u × v.
  [[nodiscard]] Vector coordinates(const Vector& p) const {
    const Vector w = cross_product(u, v);
    const Interval pu = lorentz_product(p, u);
    const Interval pv = lorentz_product(p, v);
    const Interval determinant = uu * vv - square(uv);
    return {(pu * vv - pv * uv) / determinant, (pv * uu - pu * uv) / determinant,
            lorentz_product(p, w) / lorentz_product(w, w)};
  }
  /// The vector that has these.
  [[nodiscard]] Vector combination(const Vector& c) const {
    const Vector w = cross_product(u, v);
    const auto entry = [&](std::size_t i) { return c[0] * u.at(i) + c[1] * v.at(i) + c[2] * w.at(i); };
    return {entry(0), entry(1), entry(2)};
  }

  Vector u;
  Vector v;
  Interval uu;
  Interval uv;
  Interval vv;
};

/// Half of the trace of an element, and its normal in a basis.
struct Coordinates {
  Coordinates(const Motion& g, const Basis& basis) : half_trace(g.a.re), normal(basis.coordinates(axis_normal(g))) {}

  /// The element that has the same in another basis.
  [[nodiscard]] Motion in(const Basis& basis) const {
    const Vector n = basis.combination(normal);
    return {{half_trace, n[2]}, {n[1], -n[0]}};
  }

  Interval half_trace;
  Vector normal;
};

/// Two loops at one vertex, by their numbers.
using LoopPair = std::array<std::size_t, 2>;

/// Looks for pairs of loops of one surface. The rules of its net are verified; they and the loops must live as long.
template <class R>
class PairSearch {
 public:
  PairSearch(NetRules<R>& net, Loops<R>& loops) : net_(net), loops_(loops), near_(net.net().vertices.size()) {
    for (std::size_t i = 0; i < loops_.all().size(); ++i) {
      if (loops_.is_near_axis(i)) near_[loops_.all()[i].vertex].push_back(i);
    }
  }

  [[nodiscard]] Basis basis_of(const LoopPair& pair) const {
    return {loops_.all()[pair[0]].g, loops_.all()[pair[1]].g};
  }
  [[nodiscard]] Index vertex_of(const LoopPair& pair) const { return loops_.all()[pair[0]].vertex; }

  /// Two loops whose axes cross.
  LoopPair crossing_pair() {
    const std::size_t all = std::accumulate(near_.begin(), near_.end(), std::size_t{0},
                                            [](auto n, const auto& here) { return n + here.size() * here.size(); });
    for (const std::vector<std::size_t>& here : near_) {
      for (const std::size_t i : here) {
        spend_pairs(here.size(), all);
        for (const std::size_t j : here) {
          if (j < i && basis_of({j, i}).axes_cross() == Answer::yes) return {j, i};
        }
      }
    }
    give_up("no two closed geodesics of the list certainly cross");
  }

  /// Pairs to which an isometry may take one of this surface or of another one, one for each isometry.
  std::vector<LoopPair> possible_images(const Basis& from) {
    std::map<LoopPair, std::size_t> found;
    // Loops that are as long as the first one of the pair.
    std::vector<std::pair<std::size_t, const std::vector<std::size_t>*>> first;
    std::size_t all = 0;
    for (const std::vector<std::size_t>& here : near_) {
      for (const std::size_t i : here) {
        const Vector u = Basis::normal(loops_.all()[i].g);
        if (!may_be_equal(lorentz_product(u, u), from.uu)) continue;
        first.emplace_back(i, &here);
        all += here.size();
      }
    }
    spend_pairs(all, all);
    for (const auto& [i, here] : first) {
      for (const std::size_t j : *here) {
        if (basis_of({i, j}).may_be_image_of(from)) found.emplace(LoopPair{i, j}, found.size());
      }
    }
    std::vector<std::size_t> root(found.size());
    std::iota(root.begin(), root.end(), std::size_t{0});
    const auto find_root = [&](std::size_t n) {
      for (; root[n] != n; n = root[n]) root[n] = root[root[n]];
      return n;
    };
    for (const auto& [image, n] : found) {
      for (const Index dart : loops_.leaving(vertex_of(image))) {
        const auto i = loops_.along(image[0], dart);
        const auto j = i ? loops_.along(image[1], dart) : std::nullopt;
        const auto other = j ? found.find({*i, *j}) : found.end();
        if (other != found.end()) root[find_root(n)] = find_root(other->second);
      }
    }
    std::vector<LoopPair> result;
    for (const auto& [image, n] : found) {
      if (root[n] == n) result.push_back(image);
    }
    return result;
  }

  Motion at_vertex(const std::vector<Index>& word, Index v, const std::vector<std::vector<Index>>& paths) {
    return element_at_vertex(net_, word, v, paths);
  }

  /// Whether an isometry may be an element of the group at vertex v. If it is, it takes the vertex to a lift of it, to
  /// which nearer and nearer neighbours lead (Lemma 15.1).
  bool may_be_element(Index v, const Motion& g) {
    const Loops<R>& loops = loops_;
    Index here = v;
    Motion frame;  // From the chart of the vertex that has been reached.
    for (;;) {
      if (loops.leaving(here).size() > edges_left_)
        give_up("possible isometries that move vertices across more than " + number(kMostEdges) + " edges");
      edges_left_ -= loops.leaving(here).size();
      const Place target = image(compose(inverse(frame), g), loops.self(v));
      const Interval distance = loops.half_distance(here, target, v);
      bool is_nearest = true;
      const Index* nearer = nullptr;
      for (const Index& dart : loops.leaving(here)) {
        const auto& step = loops.step(dart);
        const Answer less = is_less(loops.half_distance(step.end, image(inverse(step.motion), target), v), distance);
        is_nearest = is_nearest && less == Answer::no;
        if (less == Answer::yes) nearer = &dart;
      }
      if (nearer == nullptr) return !is_nearest || (here == v && may_be_identity(compose(inverse(frame), g)));
      frame = compose(frame, loops.step(*nearer).motion);
      here = loops.step(*nearer).end;
    }
  }

 private:
  /// Pairs of loops that are compared, and edges at vertices on the ways of possible isometries: some seconds each.
  static constexpr std::size_t kMostPairs = 3'000'000;
  static constexpr std::size_t kMostEdges = 1'000'000;

  /// Before so many pairs of loops are compared, of which there may be `all`.
  void spend_pairs(std::size_t pairs, std::size_t all) {
    if (pairs > pairs_left_)
      give_up(number(all) + " pairs of closed geodesics, and this checker compares " + number(kMostPairs));
    pairs_left_ -= pairs;
  }

  NetRules<R>& net_;
  Loops<R>& loops_;
  std::vector<std::vector<std::size_t>> near_;  ///< By vertex: the loops whose axes are not certainly farther than ε.
  std::size_t pairs_left_ = kMostPairs;
  std::size_t edges_left_ = kMostEdges;
};

/// How many isometries there are at most from one surface to another, or to itself, if not more than `enough` (Lemma
/// 41.1). The paths lead from tile 0 of the first one, whose loops the search `from` is about, to all its tiles.
template <class R, class Q>
std::size_t possible_isometries(const NetRules<R>& net, PairSearch<R>& from,
                                const std::vector<std::vector<Index>>& paths, PairSearch<Q>& to, std::size_t enough) {
  const LoopPair pair = from.crossing_pair();
  const Basis basis = from.basis_of(pair);
  std::vector<LoopPair> images = to.possible_images(basis);
  for (const std::vector<Index>& word : net.generators(paths)) {
    if (images.size() <= enough) break;
    const Coordinates generator(from.at_vertex(word, from.vertex_of(pair), paths), basis);
    const auto is_none = [&](const LoopPair& image) {
      return !to.may_be_element(to.vertex_of(image), generator.in(to.basis_of(image)));
    };
    images.erase(std::remove_if(images.begin(), images.end(), is_none), images.end());
  }
  return images.size();
}

}  // namespace epsnet::exact
