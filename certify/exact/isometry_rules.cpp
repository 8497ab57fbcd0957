#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <numeric>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "certify/exact/claim_rules.h"
#include "certify/exact/geodesic_rules.h"

/// Section 18: isometries, and by section 18.1 that there are no others.
namespace epsnet::exact {
namespace {

using Word = IsometriesDocument::Word;

/// Letters that are read for the orbit of the cocycle, pairs of loops that are compared, and edges at vertices on the
/// ways of possible isometries: some seconds each.
constexpr std::size_t kMostLetters = 100'000'000;
constexpr std::size_t kMostPairs = 3'000'000;
constexpr std::size_t kMostEdges = 1'000'000;

bool may_be_equal(const Interval& x, const Interval& y) { return either(is_less(x, y), is_less(y, x)) != Answer::yes; }

bool may_be_identity(const Motion& g) {
  return may_be_equal(g.a.im, 0) && may_be_equal(g.b.re, 0) && may_be_equal(g.b.im, 0);
}

Vector cross_product(const Vector& u, const Vector& v) {
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

  Vector u;
  Vector v;
  Interval uu;
  Interval uv;
  Interval vv;
};

/// Half of the trace of an element, and its normal in a basis.
struct Coordinates {
  Coordinates(const Motion& g, const Basis& basis) : half_trace(g.a.re) {
    const Vector n = axis_normal(g);
    const Vector w = cross_product(basis.u, basis.v);
    const Interval nu = lorentz_product(n, basis.u);
    const Interval nv = lorentz_product(n, basis.v);
    const Interval determinant = basis.uu * basis.vv - square(basis.uv);
    normal = {(nu * basis.vv - nv * basis.uv) / determinant, (nv * basis.uu - nu * basis.uv) / determinant,
              lorentz_product(n, w) / lorentz_product(w, w)};
  }

  /// The element that has the same in another basis.
  [[nodiscard]] Motion in(const Basis& basis) const {
    const Vector w = cross_product(basis.u, basis.v);
    const auto entry = [&](std::size_t i) {
      return normal[0] * basis.u.at(i) + normal[1] * basis.v.at(i) + normal[2] * w.at(i);
    };
    return {{half_trace, entry(2)}, {entry(1), -entry(0)}};
  }

  Interval half_trace;
  Vector normal;
};

template <class R>
class IsometryRules {
 public:
  IsometryRules(const IsometriesDocument& document, NetRules<R>& net, long most_lifts)
      : document_(document), net_(net), spectrum_(document.spectrum, net, most_lifts) {
    check_structure();
  }

  [[nodiscard]] std::vector<Rule> rules() {
    std::vector<Rule> rules = spectrum_.rules();
    rules.push_back({"isometries", [this] { check_isometries(); }});
    rules.push_back({"least", [this] { check_least(); }, true});
    rules.push_back({"most", [this] { check_most(); }});
    return rules;
  }

 private:
  using Values = std::vector<std::uint32_t>;  ///< By pair of sides; modulo 2³².

  void check_structure() const {
    if (document_.order == 0) throw Malformed("the order is 0");
    if (document_.paths.size() != net_.net().tile_count()) throw Malformed("paths: not one for each tile");
    for (Index t = 0; t < document_.paths.size(); ++t) net_.expect_path(document_.paths[t], 0, t);
    const auto expect_loops = [&](const std::vector<Word>& words, std::size_t size, const char* what) {
      if (words.size() != size) throw Malformed(std::string(what) + ": another number of words");
      for (const Word& word : words) net_.expect_path(word, 0, 0);
    };
    expect_loops(document_.pair, 2, "pair");
    for (const auto& row : document_.isometries) expect_loops(row.images, 2 + net_.sides() / 2, "images");
    if (document_.cocycle.size() != net_.sides() / 2) throw Malformed("cocycle: another number of values");
    const Values c = by_side(document_.cocycle);
    for (Index first = 0; first < net_.sides(); ++first) {
      std::uint32_t sum = 0;
      Index s = first;
      do {
        sum += c[s];
        s = net_.side_after(net_.partner(s));
      } while (s != first);
      if (sum != 0) throw Malformed("cocycle: the sum around a vertex is not 0");
    }
  }

  /// c(s), with c(s′) = −c(s) for the partner s′ of s.
  [[nodiscard]] Values by_side(const Values& values) const {
    Values result(net_.sides());
    std::size_t next = 0;
    for (Index s = 0; s < result.size(); ++s)
      result[s] = s < net_.partner(s) ? values[next++] : 0 - result[net_.partner(s)];
    return result;
  }

  /// The words g_s, s less than its partner.
  [[nodiscard]] std::vector<Word> generators() const {
    std::vector<Word> result;
    for (Index s = 0; s < net_.sides(); ++s) {
      if (net_.partner(s) < s) continue;
      Word word = document_.paths[net_.tile_of(s)];
      word.push_back(s);
      const Word& back = document_.paths[net_.tile_of(net_.partner(s))];
      std::for_each(back.rbegin(), back.rend(), [&](Index t) { word.push_back(net_.partner(t)); });
      result.push_back(std::move(word));
    }
    return result;
  }

  // Rule `isometries`.

  /// The value of a word, with a trace that is not negative.
  Isometry<R> element(const Word& word) {
    Isometry<R> g = net_.value(word);
    return sgn(g.a.re) < 0 ? Isometry<R>{-g.a, -g.b} : g;
  }

  /// Lemma 39: 0 if the axes do not cross, else the sign of Im p, p = 2i Im(b b̄′) of xy − yx.
  static int crossing_sign(const Isometry<R>& x, const Isometry<R>& y) {
    const R p = (x.b * conjugate(y.b)).im;
    const Complex<R> q = x.a.im * y.b - y.a.im * x.b;
    return sgn(R(p * p - norm(q))) > 0 ? sgn(p) : 0;
  }

  /// Whether the traces are equal up to their signs, and the product of these.
  static std::pair<bool, int> compare_traces(const Isometry<R>& f, const Isometry<R>& g) {
    const R difference = f.a.re * f.a.re * (norm(g.a) - norm(g.b)) - g.a.re * g.a.re * (norm(f.a) - norm(f.b));
    return {sgn(difference) == 0, sgn(f.a.re) * sgn(g.a.re)};
  }

  /// 1, x, y, xy.
  std::array<Isometry<R>, 4> basis(const Isometry<R>& x, const Isometry<R>& y) {
    return {Isometry<R>(), x, y, net_.product(x, y)};
  }

  void check_isometries() {
    const auto from = basis(element(document_.pair[0]), element(document_.pair[1]));
    const int sign = crossing_sign(from[1], from[2]);
    if (sign == 0) throw Refutation{"the axes of the pair do not cross"};
    std::vector<Isometry<R>> elements;
    for (const Word& word : generators()) elements.push_back(element(word));
    for (std::size_t i = 0; i < document_.isometries.size(); ++i) {
      const auto& [preserves_orientation, images] = document_.isometries[i];
      const std::string name = "isometry " + number(i);
      const auto to = basis(element(images[0]), element(images[1]));
      for (std::size_t k = 1; k < 4; ++k) {
        if (compare_traces(from.at(k), to.at(k)) != std::pair(true, 1)) throw Refutation{name + " changes traces"};
      }
      for (std::size_t n = 0; n < elements.size(); ++n) {
        if (!has_traces_of(elements[n], from, element(images[n + 2]), to))
          throw Refutation{name + " changes traces of generator " + number(n)};
      }
      if ((crossing_sign(to[1], to[2]) == sign) != preserves_orientation)
        throw Refutation{name + (preserves_orientation ? " reverses the orientation" : " preserves the orientation")};
    }
  }

  /// Lemma 38, for one sign of the image.
  bool has_traces_of(const Isometry<R>& g, const std::array<Isometry<R>, 4>& from, const Isometry<R>& image,
                     const std::array<Isometry<R>, 4>& to) {
    int sign = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      const auto [equal, product] = compare_traces(net_.product(from.at(k), g), net_.product(to.at(k), image));
      if (!equal || sign * product < 0) return false;
      if (product != 0) sign = product;
    }
    return true;
  }

  // Rule `least`.

  void check_least() const {
    std::size_t letters = 1;
    for (const auto& row : document_.isometries) {
      for (const Word& word : row.images) letters += word.size() + 1;
    }
    const auto sum = [](const Values& c, const Word& word) {
      return std::accumulate(word.begin(), word.end(), std::uint32_t{0}, [&](auto n, Index s) { return n + c[s]; });
    };
    Values first;
    const Values given = by_side(document_.cocycle);
    for (const Word& word : generators()) first.push_back(sum(given, word));
    std::set<Values> orbit{first};
    std::vector<Values> reached{first};
    for (std::size_t i = 0; i < reached.size() && orbit.size() <= document_.order; ++i) {
      if (i * letters > kMostLetters) give_up("the group is too large for this checker");
      const Values c = by_side(reached[i]);
      for (const auto& row : document_.isometries) {
        Values moved;
        std::for_each(row.images.begin() + 2, row.images.end(), [&](const Word& w) { moved.push_back(sum(c, w)); });
        if (orbit.insert(moved).second) reached.push_back(std::move(moved));
      }
    }
    if (orbit.size() > document_.order) throw Refutation{"they generate more than " + number(document_.order)};
    if (orbit.size() < document_.order) give_up("they generate at least " + number(orbit.size()));
  }

  // Rule `most`.

  using Pair = std::array<std::size_t, 2>;  ///< Of loops at one vertex.

  [[nodiscard]] Basis basis_of(const Pair& pair) {
    return {spectrum_.loops().all()[pair[0]].g, spectrum_.loops().all()[pair[1]].g};
  }

  /// By vertex: the loops whose axes are not certainly farther than ε.
  [[nodiscard]] std::vector<std::vector<std::size_t>> near_loops() {
    std::vector<std::vector<std::size_t>> result(net_.net().vertices.size());
    for (std::size_t i = 0; i < spectrum_.loops().all().size(); ++i) {
      if (spectrum_.loops().is_near_axis(i)) result[spectrum_.loops().all()[i].vertex].push_back(i);
    }
    return result;
  }

  /// Before so many pairs of loops are compared, of which there may be `all`.
  void spend_pairs(std::size_t pairs, std::size_t all) {
    if (pairs > pairs_left_)
      give_up(number(all) + " pairs of closed geodesics, and this checker compares " + number(kMostPairs));
    pairs_left_ -= pairs;
  }

  /// Two loops whose axes cross.
  Pair crossing_pair(const std::vector<std::vector<std::size_t>>& loops) {
    const std::size_t all = std::accumulate(loops.begin(), loops.end(), std::size_t{0},
                                            [](auto n, const auto& here) { return n + here.size() * here.size(); });
    for (const std::vector<std::size_t>& here : loops) {
      for (const std::size_t i : here) {
        spend_pairs(here.size(), all);
        for (const std::size_t j : here) {
          if (j < i && basis_of({j, i}).axes_cross() == Answer::yes) return {j, i};
        }
      }
    }
    give_up("no two closed geodesics of the list certainly cross");
  }

  /// Pairs to which an isometry may take the given one, one for each isometry.
  std::vector<Pair> possible_images(const Pair& pair, const std::vector<std::vector<std::size_t>>& loops) {
    const Basis from = basis_of(pair);
    std::map<Pair, std::size_t> found;
    // Loops that are as long as the first one of the pair.
    std::vector<std::pair<std::size_t, const std::vector<std::size_t>*>> first;
    std::size_t all = 0;
    for (const std::vector<std::size_t>& here : loops) {
      for (const std::size_t i : here) {
        const Vector u = Basis::normal(spectrum_.loops().all()[i].g);
        if (!may_be_equal(lorentz_product(u, u), from.uu)) continue;
        first.emplace_back(i, &here);
        all += here.size();
      }
    }
    spend_pairs(all, all);
    for (const auto& [i, here] : first) {
      for (const std::size_t j : *here) {
        if (basis_of({i, j}).may_be_image_of(from)) found.emplace(Pair{i, j}, found.size());
      }
    }
    std::vector<std::size_t> root(found.size());
    std::iota(root.begin(), root.end(), std::size_t{0});
    const auto find_root = [&](std::size_t n) {
      for (; root[n] != n; n = root[n]) root[n] = root[root[n]];
      return n;
    };
    for (const auto& [image, n] : found) {
      for (const Index dart : spectrum_.loops().leaving(spectrum_.loops().all()[image[0]].vertex)) {
        const auto i = spectrum_.loops().along(image[0], dart);
        const auto j = i ? spectrum_.loops().along(image[1], dart) : std::nullopt;
        const auto other = j ? found.find({*i, *j}) : found.end();
        if (other != found.end()) root[find_root(n)] = find_root(other->second);
      }
    }
    std::vector<Pair> result;
    for (const auto& [image, n] : found) {
      if (root[n] == n) result.push_back(image);
    }
    return result;
  }

  /// An element of the group at tile 0, in the chart of a vertex.
  Motion at_vertex(const Word& word, Index v) {
    const Index chart = net_.net().vertices[v].chart;
    const Isometry<R> to_tile = net_.value(document_.paths[net_.net().charts[chart].first]);
    const Isometry<R> to_chart = net_.product(inverse(net_.frame(chart)), to_tile);
    return enclose(net_.product(to_chart, net_.product(net_.value(word), inverse(to_chart))));
  }

  /// Whether an isometry may be an element of the group at vertex v. If it is, it takes the vertex to a lift of it, to
  /// which nearer and nearer neighbours lead (Lemma 15.1).
  bool may_be_element(Index v, const Motion& g) {
    const Loops<R>& loops = spectrum_.loops();
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

  void check_most() {
    const std::vector<std::vector<std::size_t>> loops = near_loops();
    const Pair pair = crossing_pair(loops);
    const Basis from = basis_of(pair);
    std::vector<Pair> images = possible_images(pair, loops);
    for (const Word& word : generators()) {
      if (images.size() <= document_.order) break;
      const Coordinates generator(at_vertex(word, spectrum_.loops().all()[pair[0]].vertex), from);
      const auto is_none = [&](const Pair& image) {
        return !may_be_element(spectrum_.loops().all()[image[0]].vertex, generator.in(basis_of(image)));
      };
      images.erase(std::remove_if(images.begin(), images.end(), is_none), images.end());
    }
    const std::string found = "there are at most " + number(images.size());
    if (images.size() > document_.order) give_up(found);
    if (images.size() < document_.order) throw Refutation{found};
  }

  const IsometriesDocument& document_;
  NetRules<R>& net_;
  GeodesicRules<R> spectrum_;
  std::size_t pairs_left_ = kMostPairs;
  std::size_t edges_left_ = kMostEdges;
};

}  // namespace

template <class R>
std::vector<Rule> isometry_rules(const IsometriesDocument& document, NetRules<R>& net, long most_lifts) {
  const auto rules = std::make_shared<IsometryRules<R>>(document, net, most_lifts);
  return kept(rules, rules->rules());
}

template std::vector<Rule> isometry_rules(const IsometriesDocument& document, NetRules<mpz_class>& net, long);
template std::vector<Rule> isometry_rules(const IsometriesDocument& document, NetRules<Algebraic>& net, long);
template std::vector<Rule> isometry_rules(const IsometriesDocument& document, NetRules<FieldNumber>& net, long);

}  // namespace epsnet::exact
