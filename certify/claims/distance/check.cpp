#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "certify/base/interval.h"
#include "certify/base/text.h"
#include "certify/claims/distance/fields.h"
#include "certify/claims/net/claim.h"
#include "certify/lifted/lifted_plane.h"
#include "certify/net/numbering.h"
#include "certify/net/structure.h"
#include "certify/numbers/ball.h"
#include "certify/verdict/verification.h"

namespace epsnet::certify {
namespace {

Problem point_problem(const DistanceDocument& document) {
  const auto& [tile, z] = document.point;
  const std::size_t tiles = number_of_tiles(document.net.surface);
  if (tile >= tiles) {
    return "point: tile " + std::to_string(tile) + " does not exist, expected less than " + std::to_string(tiles);
  }
  if (z.x * z.x + z.y * z.y < 1) return std::nullopt;
  return "point: outside of the open unit disk";
}

Problem paths_problem(const DistanceDocument& document) {
  if (document.paths.empty()) return "paths: no element, expected at least one";
  const SurfaceSides sides(document.net.surface);
  const std::uint32_t start = document.net.charts[document.net.vertices[0].chart].tile;
  return first_row_problem("paths", document.paths, [&](const std::vector<std::uint32_t>& path) {
    return word_problem(sides, path, start, document.point.tile, "the point");
  });
}

}  // namespace

Problem structure_problem(const DistanceDocument& document) {
  if (auto problem = one_vertex_problem(document.net)) return problem;
  if (auto problem = point_problem(document)) return problem;
  if (!is_length(document.distance)) return "distance: " + to_string(document.distance) + " is not 0 <= lo <= hi";
  return paths_problem(document);
}

std::uint64_t least_bytes(const DistanceDocument& document) {
  std::uint64_t bytes = least_bytes(document.net) + 64 + least_bytes(document.point.z);
  for (const std::vector<std::uint32_t>& path : document.paths) bytes += 3 + least_bytes(path);
  return bytes;
}

namespace {

/// Operations of balls that it takes to compare two elements, and to ask for the distance of a neighbour.
constexpr std::uint64_t kSameOperations = 120;
constexpr std::uint64_t kNeighbourOperations = 8;

std::string path_name(std::size_t i) { return "path " + std::to_string(i); }

/// The net with a chart for the point, whose coordinates are those of its tile, and the words of the paths as further
/// labels, from the vertex's chart to that one; no triangle uses them.
NetDocument extended(const DistanceDocument& document) {
  NetDocument net = document.net;
  const auto chart = static_cast<std::uint32_t>(net.charts.size());
  net.charts.push_back({document.point.tile, {0, 0}});
  for (const std::vector<std::uint32_t>& path : document.paths) {
    net.labels.push_back({net.vertices[0].chart, chart, path});
  }
  return net;
}

ExactPoint exact_point_within(const RationalPoint& z, const Budget& budget) {
  budget.spend(exact_point_work(z));
  return exact_point(z);
}

/// The unit vector of a point.
BallVector unit_vector(const ExactPoint& z) {
  const HyperboloidVector<mpz_class> v = hyperboloid_vector(z);
  const Ball scale = Ball::rounded(gap(z));
  return {Ball::rounded(v.x) / scale, Ball::rounded(v.y) / scale, Ball::rounded(v.t) / scale};
}

/// cosh of the distance of two points.
Ball cosh_distance(const BallVector& u, const BallVector& v, slong precision) {
  return -lorentz_product(u, v, precision);
}

/// From cosh d, rounded outward; from 0 up if balls do not tell cosh d > 1.
Interval distance_interval(const Ball& cosh) {
  const Ball distance = acosh(cosh);
  if (is_finite(distance)) return outer_interval(distance);
  // acosh grows, so that the upper end alone will do.
  Ball upper;
  arb_get_ubound_arf(arb_midref(upper.get()), cosh.get(), Precision::bits());
  return {0, outer_interval(acosh(upper)).upper};
}

/// A number that lifts of q have, of which no two on one surface agree but by accident. Any number would do that is
/// the same for equal lifts: those whose keys may be equal are compared.
Interval key(const BallVector& x) { return outer_interval(617 * x[0] + 391 * x[1]); }

/// sinh² of half of a length, up to a factor that all lengths share.
template <class CrossingsOfAKind>
struct ExactLength {
  using Real = decltype(norm(std::declval<typename CrossingsOfAKind::Number>()));
  Real numerator;
  Real denominator;
};

constexpr const char* kPaths = "paths";
constexpr const char* kEqual = "equal";
constexpr const char* kNearest = "nearest";

class DistanceCheck {
 public:
  DistanceCheck(const DistanceDocument& document, const Verification& run, Crossings crossings)
      : document_(document),
        options_(run.options()),
        threads_(run.threads()),
        net_(extended(document)),
        parts_(label_parts(std::move(crossings), net_.charts, run.budget())),
        evaluator_(net_, parts_),
        point_(exact_point_within(document.point.z, run.budget())),
        rules_(own_rules(document)) {}

  void ask(Verification& run) {
    try {
      with_rising_precision(options_.max_precision, [&](slong precision) {
        precision_ = precision;
        pass();
        return verdict(kPaths) == Verdict::refuted || (!open(kPaths) && !open(kNearest));
      });
      if (verdict(kPaths) == Verdict::refuted) {
        rules_.keep_first();
      } else {
        check_equal();
      }
    } catch (const BudgetSpent& spent) {
      rules_.give_up(spent.what());
    }
    rules_.conclude(run);
    run.used(static_cast<std::uint64_t>(precision_));
  }

 private:
  [[nodiscard]] Verdict verdict(const char* rule) const { return rules_.verdict(rule); }
  [[nodiscard]] bool open(const char* rule) const { return rules_.open(rule); }
  void report(const char* rule, Verdict verdict, std::string text) { rules_.report({rule, verdict, std::move(text)}); }
  [[nodiscard]] std::string bits() const { return std::to_string(precision_) + " bits"; }

  /// The label number of a path's word, W, which takes p to a lift in the disk of q's tile.
  [[nodiscard]] std::uint32_t number(std::size_t path) const {
    return static_cast<std::uint32_t>(document_.net.labels.size() + 1 + path);
  }

  /// One path at one precision, in the chart of the vertex.
  struct Path {
    BallIsometry element;  ///< W.
    BallVector end;        ///< W⁻¹q, a lift of q.
    Ball cosh;             ///< Of the length.
  };

  /// What a pass knows.
  struct Paths {
    BallVector target;  ///< q in the coordinates of its tile.
    std::vector<Path> all;
    IntervalIndex by_end;
  };

  /// All open rules at one precision.
  void pass() {
    if (options_.progress) options_.progress(open(kPaths) ? kPaths : kNearest, 0);
    const LiftedPlane plane(net_, evaluator_, parts_, precision_, options_.max_precision, threads_);
    const NetDocument::Vertex& vertex = net_.vertices[0];
    const BallVector start = certify::unit_vector(identity_isometry(), vertex.x, vertex.y, precision_);
    budget().spend(4 * product_work(certify::bits(point_)));
    Paths paths{unit_vector(point_), {}, {}};
    for (std::size_t i = 0; i < document_.paths.size(); ++i) {
      plane.spend(60);
      plane.keep(11);
      const BallIsometry& element = plane.label(number(i));
      BallVector end = end_of(element, paths);
      Ball cosh = cosh_distance(start, end, precision_);
      paths.all.push_back({element, std::move(end), std::move(cosh)});
    }
    if (open(kPaths)) check_lengths(paths.all);
    if (verdict(kPaths) == Verdict::refuted) return;
    const bool different = index_paths(plane, paths);
    if (verdict(kPaths) == Verdict::refuted) return;
    if (open(kPaths) && different && lengths_decided_) {
      const bool one = paths.all.size() == 1;
      report(kPaths, Verdict::verified,
             std::to_string(paths.all.size()) + (one ? " path has a length in " : " paths have lengths in ") +
                 to_string(document_.distance) + (one ? "" : ", and no two are the same"));
    }
    if (open(kNearest)) check_nearest(plane, start, paths);
  }

  [[nodiscard]] const Budget& budget() const { return evaluator_.budget(); }

  /// The end of the path with an element.
  [[nodiscard]] BallVector end_of(const BallIsometry& element, const Paths& paths) const {
    return apply(lorentz_matrix(inverse(element), precision_), paths.target, precision_);
  }

  // Rule paths.

  void check_lengths(const std::vector<Path>& paths) {
    lengths_decided_ = true;
    for (std::size_t i = 0; i < paths.size(); ++i) {
      const Tri enclosed = is_enclosed(paths[i].cosh, i);
      if (enclosed == Tri::yes) continue;
      const bool wrong = enclosed == Tri::no;
      if (!wrong && !lengths_decided_) continue;  // The first one is named.
      lengths_decided_ = false;
      report(kPaths, wrong ? Verdict::refuted : Verdict::undecided,
             path_name(i) + " has a length in " + to_string(distance_interval(paths[i].cosh)) +
                 (wrong ? ", not in " : ", not decided whether in ") + to_string(document_.distance) +
                 (wrong ? "" : ", with " + bits()));
      if (wrong) return;
    }
  }

  /// lo ≤ d ≤ hi; equality is impossible but for 0, as cosh d is algebraic.
  [[nodiscard]] Tri is_enclosed(const Ball& cosh, std::size_t i) const {
    const auto [lower, upper] = document_.distance;
    const Tri above_lower = lower > 0 ? certainly_less(certify::cosh(Ball::exactly(lower)), cosh) : Tri::yes;
    const Tri below_upper = upper > 0 ? certainly_less(cosh, certify::cosh(Ball::exactly(upper))) : is_zero(cosh, i);
    return both(above_lower, below_upper);
  }

  /// Of a path. Nothing if its numbers are not of a size to calculate with.
  template <class CrossingsOfAKind>
  [[nodiscard]] std::optional<ExactLength<CrossingsOfAKind>> exact_length(const CrossingsOfAKind& crossings,
                                                                          std::size_t i) const {
    if (evaluator_.exact_bits(number(i)) > CrossingsOfAKind::kMaxExactBits) return std::nullopt;
    const NetDocument::Vertex& vertex = net_.vertices[0];
    const ExactPoint from = exact_point(vertex.x, vertex.y);
    budget().spend(CrossingsOfAKind::exact_work(2 * evaluator_.exact_bits(number(i)) +
                                                8 * (certify::bits(from) + certify::bits(point_))));
    // h(n/d, q) = |n − q d|²/((|d|² − |n|²)(1 − |q|²)).
    const auto moved_from = moved(evaluator_.evaluate_exactly(crossings, number(i)), from);
    return ExactLength<CrossingsOfAKind>{norm(point_.m * moved_from.n - point_.n * moved_from.d),
                                         norm(moved_from.d) - norm(moved_from.n)};
  }

  [[nodiscard]] Tri is_zero(const Ball& cosh, std::size_t i) const {
    if (certainly_less(Ball::exactly(1), cosh) == Tri::yes) return Tri::no;
    const auto sign = std::visit(
        [&](const auto& crossings) -> std::optional<int> {
          const auto length = exact_length(crossings, i);
          if (!length) return std::nullopt;
          return certify::sign(length->numerator);
        },
        evaluator_.crossings());
    if (!sign) return Tri::unknown;
    return *sign == 0 ? Tri::yes : Tri::no;
  }

  /// Puts the paths into the index by their ends. Whether no two are certainly, or possibly, the same.
  bool index_paths(const LiftedPlane& plane, Paths& paths) {
    bool different = true;
    for (std::uint32_t i = 0; i < paths.all.size(); ++i) {
      const Interval x = key(paths.all[i].end);
      if (open(kPaths)) {
        for (const std::uint32_t other : paths.by_end.near(x)) {
          const Tri same = is_same(plane, paths.all[other].element, paths.all[i].element);
          if (same == Tri::no) continue;
          if (same == Tri::yes) {
            report(kPaths, Verdict::refuted, path_name(i) + " is " + path_name(other) + " again");
            return false;
          }
          if (different && lengths_decided_) {
            rules_.doubt(kPaths,
                         path_name(i) + ": not decided whether it is " + path_name(other) + " again, with " + bits());
          }
          different = false;
        }
      }
      paths.by_end.insert(x, i);
    }
    return different;
  }

  /// Whether two elements with the same ends are equal. Their quotient is in the group, so that its sign can be chosen.
  [[nodiscard]] Tri is_same(const LiftedPlane& plane, const BallIsometry& f, const BallIsometry& g) const {
    plane.spend(kSameOperations);
    BallIsometry quotient = compose(inverse(f), g, precision_);
    choose_sign(quotient);
    return plane.same(net_.vertices[0].chart, quotient, identity_isometry());
  }

  // Rule equal.

  void check_equal() {
    if (!document_.equal || document_.paths.size() == 1) {
      report(kEqual, Verdict::verified, document_.equal ? "there is one path" : "nothing is claimed");
      return;
    }
    std::visit(
        [&](const auto& crossings) {
          const auto first = exact_length(crossings, 0);
          for (std::size_t i = 1; i < document_.paths.size(); ++i) {
            const auto other = exact_length(crossings, i);
            if (!first || !other) {
              report(kEqual, Verdict::undecided,
                     path_name(0) + " and " + path_name(i) + ": the words are too long to compare the lengths exactly");
              return;
            }
            if (sign(first->numerator * other->denominator - other->numerator * first->denominator) == 0) continue;
            report(kEqual, Verdict::refuted, path_name(0) + " and " + path_name(i) + " have different lengths");
            return;
          }
          report(kEqual, Verdict::verified, "the lengths are equal, exactly");
        },
        evaluator_.crossings());
  }

  // Rule nearest.

  /// One of the neighbours of a lift of the vertex, which are the ends of its darts.
  struct Neighbour {
    BallIsometry element;  ///< γ, which takes the vertex there.
    BallVector place;
  };

  [[nodiscard]] std::vector<Neighbour> neighbours(const LiftedPlane& plane, const BallVector& start) const {
    std::vector<Neighbour> result;
    for (std::uint32_t dart = 0; dart < 3 * net_.triangles.size(); ++dart) {
      plane.spend(60);
      plane.keep(11);
      BallIsometry element = compose(inverse(plane.label(corner_label(net_, dart))),
                                     plane.label(corner_label(net_, next_dart(dart))), precision_);
      BallVector place = apply(lorentz_matrix(element, precision_), start, precision_);
      result.push_back({std::move(element), std::move(place)});
    }
    return result;
  }

  void check_nearest(const LiftedPlane& plane, const BallVector& start, const Paths& paths) {
    const std::vector<Neighbour> around = neighbours(plane, start);
    const Ball most = cosh(Ball::exactly(document_.distance.upper));
    std::optional<std::string> undecided;
    for (std::size_t i = 0; i < paths.all.size(); ++i) {
      const Path& path = paths.all[i];
      plane.spend(kNeighbourOperations, around.size());
      for (std::size_t dart = 0; dart < around.size(); ++dart) {
        const Ball cosh = cosh_distance(around[dart].place, path.end, precision_);
        const Tri farther = certainly_less(most, cosh);
        if (farther == Tri::yes) continue;
        // The path from γp to W⁻¹q is the path with Wγ from p.
        const Tri listed = is_listed(plane, compose(path.element, around[dart].element, precision_), paths);
        if (listed == Tri::yes) continue;
        if (both(!listed, !farther) == Tri::yes) {
          report(kNearest, Verdict::refuted,
                 "a path of length in " + to_string(distance_interval(cosh)) +
                     " is missing: the loop at the vertex along dart " + std::to_string(dart) + ", then " +
                     path_name(i));
          return;
        }
        if (!undecided) {
          undecided = "not decided whether the loop at the vertex along dart " + std::to_string(dart) + ", then " +
                      path_name(i) + ", is missing, with " + bits();
        }
      }
    }
    if (undecided) {
      rules_.doubt(kNearest, *undecided);
    } else {
      report(kNearest, Verdict::verified,
             "no path of length at most " + decimal_below(document_.distance.upper) + " is missing");
    }
  }

  /// Whether the element is that of a path.
  [[nodiscard]] Tri is_listed(const LiftedPlane& plane, const BallIsometry& element, const Paths& paths) const {
    plane.spend(kSameOperations);
    Tri result = Tri::no;
    for (const std::uint32_t i : paths.by_end.near(key(end_of(element, paths)))) {
      result = either(result, is_same(plane, paths.all[i].element, element));
      if (result == Tri::yes) break;
    }
    return result;
  }

  const DistanceDocument& document_;
  const CheckOptions& options_;
  unsigned threads_;
  NetDocument net_;
  LabelParts parts_;
  LabelEvaluator evaluator_;
  ExactPoint point_;  ///< q.
  OpenRules rules_;
  bool lengths_decided_ = false;
  slong precision_ = 64;
};

std::string point_name(std::uint32_t tile, const RationalPoint& z) {
  return "(" + in_quotes(z.x.get_str()) + ", " + in_quotes(z.y.get_str()) + ") of tile " + std::to_string(tile);
}

/// p: a point of a tile if it is the centre of its chart.
std::string vertex_name(const NetDocument& net) {
  const NetDocument::Vertex& vertex = net.vertices[0];
  const auto& [tile, centre] = net.charts[vertex.chart];
  return vertex.x == 0 && vertex.y == 0 ? point_name(tile, centre) : "the net's vertex";
}

/// What the document says, in words.
std::string text_of(const DistanceDocument& document) {
  const std::string count = std::to_string(document.paths.size());
  return "the distance of " + vertex_name(document.net) + " from " + point_name(document.point.tile, document.point.z) +
         " lies in " + to_string(document.distance) + ", and " +
         (document.paths.size() == 1 ? "the path listed is the only shortest one"
          : document.equal
              ? "the " + count + " paths listed are all the shortest ones"
              : "the " + count + " paths listed are all of length at most " + decimal_below(document.distance.upper));
}

}  // namespace

RuleNames own_rules(const DistanceDocument& /*document*/) { return {kPaths, kEqual, kNearest}; }

Claim claim_of(const DistanceDocument& document) {
  const auto ask = [&](Verification& run, Crossings crossings) {
    DistanceCheck(document, run, std::move(crossings)).ask(run);
  };
  return {document.net, text_of(document), own_rules(document), ask};
}

}  // namespace epsnet::certify
