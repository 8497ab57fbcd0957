#include <epsnet/certify/darts.h>
#include <epsnet/certify/orbit_search.h>

#include <array>
#include <vector>

namespace epsnet::certify {
namespace {

/// Bits that a point must be known to; with fewer, nothing would be pruned.
constexpr slong kLeastAccuracy = 16;
/// The weights of q in its triangle, in thousandths, the vertex first: near the vertex, but on no line of the surface's
/// symmetries, so that balls can nearly always tell on which side of an edge it lies.
constexpr std::array<ulong, 3> kWeights{967, 22, 11};
constexpr std::uint32_t kNoEdge = 3;

class OrbitSearch {
 public:
  OrbitSearch(const LiftedPlane& plane, std::uint32_t dart, std::uint64_t limit,
              const std::function<Search(const BallIsometry&, const LabelProduct&)>& report)
      : plane_(plane), net_(plane.net()), root_(dart), vertex_(start(net_, dart)), limit_(limit), report_(report) {
    place_root(dart);
  }

  /// The greatest value of a triangle's α at q if one of its corners is within D of the vertex:
  /// α(q) = cosh d(q, C)/cosh R ≤ cosh(D' + R)/cosh R = cosh D' + sinh D' tanh R with D' = D + d(q, ṽ).
  void set_bound(const Ball& cosh_distance, const Ball& sinh_distance, const Ball& tanh_radius) {
    const slong precision = plane_.precision();
    Ball sinh_shift, product;
    arb_sqr(sinh_shift.get(), cosh_shift_.get(), precision);
    arb_sub_ui(sinh_shift.get(), sinh_shift.get(), 1, precision);
    arb_sqrtpos(sinh_shift.get(), sinh_shift.get(), precision);
    Ball sinh_sum;
    arb_mul(sinh_sum.get(), sinh_distance.get(), cosh_shift_.get(), precision);
    arb_addmul(sinh_sum.get(), cosh_distance.get(), sinh_shift.get(), precision);
    arb_mul(bound_.get(), cosh_distance.get(), cosh_shift_.get(), precision);
    arb_addmul(bound_.get(), sinh_distance.get(), sinh_shift.get(), precision);
    arb_addmul(bound_.get(), sinh_sum.get(), tanh_radius.get(), precision);
  }

  OrbitOutcome run() {
    if (!is_finite(bound_.get()) || !accurate(frames_.back()) || !visit(path_.back())) return outcome_;
    while (!path_.empty()) {
      Step& step = path_.back();
      if (step.next_edge == 3) {
        leave();
        continue;
      }
      const std::uint32_t edge = step.next_edge++;
      if (edge != step.entry && !try_child(3 * step.triangle + edge)) return outcome_;
    }
    outcome_.complete = true;
    return outcome_;
  }

 private:
  /// The chart of a visited triangle, seen from that of the vertex: shared by all visited next to each other in one
  /// chart.
  struct Frame {
    BallIsometry from_base;
    BallVector q;
  };

  /// A lifted triangle on the way from the root: the edge by which it was entered and the next edge to leave it by.
  struct Step {
    std::uint32_t triangle;
    std::uint32_t entry;
    std::uint32_t next_edge;
    bool own_frame;
  };

  void place_root(std::uint32_t dart) {
    const slong precision = plane_.precision();
    Frame frame;
    frame.from_base = plane_.label(corner_label(net_, dart));
    std::uint32_t corner = dart;
    for (const ulong weight : kWeights) {
      for (std::size_t i = 0; i < 3; ++i) {
        arb_addmul_ui(frame.q[i], plane_.corner(corner)[i], weight, precision);
      }
      corner = next_dart(corner);
    }
    Ball scale;
    lorentz_product(scale.get(), frame.q, frame.q, precision);
    arb_neg(scale.get(), scale.get());
    arb_rsqrt(scale.get(), scale.get(), precision);
    for (std::size_t i = 0; i < 3; ++i) arb_mul(frame.q[i], frame.q[i], scale.get(), precision);
    lorentz_product(cosh_shift_.get(), frame.q, plane_.corner(dart), precision);
    arb_neg(cosh_shift_.get(), cosh_shift_.get());
    frames_.push_back(std::move(frame));
    path_.push_back({dart / 3, kNoEdge, 0, true});
  }

  void leave() {
    if (path_.back().own_frame) frames_.pop_back();
    path_.pop_back();
  }

  [[nodiscard]] static bool accurate(const Frame& frame) {
    return is_finite(frame.q[2]) && arb_rel_accuracy_bits(frame.q[2]) >= kLeastAccuracy;
  }

  /// Visits the neighbour across a dart of the last triangle if it may be that one's child and is near enough. False if
  /// the search must end.
  bool try_child(std::uint32_t dart) {
    // The child has this edge between itself and q: q is strictly on our side of it. Left out only if certainly not.
    dot(value_.get(), plane_.line(dart), frames_.back().q, plane_.precision());
    if (certainly_positive(value_.get()) == Tri::no) return true;
    const std::uint32_t other = opposite(net_, dart);
    const bool own_frame = enter_frame(dart);
    if (own_frame && !accurate(frames_.back())) return false;
    if (!is_child(other)) {
      if (own_frame) frames_.pop_back();
      return true;
    }
    path_.push_back({other / 3, other % 3, 0, own_frame});
    return visit(path_.back());
  }

  /// Makes the chart across the dart the current one; false if it is the same.
  bool enter_frame(std::uint32_t dart) {
    const auto* transition = plane_.transition(dart);
    if (transition == nullptr) return false;
    const slong precision = plane_.precision();
    const Frame& here = frames_.back();
    Frame there{compose(transition->isometry, here.from_base, precision), apply(transition->matrix, here.q, precision)};
    frames_.push_back(std::move(there));
    return true;
  }

  /// Whether no edge before that of `entry` certainly separates its triangle from q, and α is not certainly too large.
  bool is_child(std::uint32_t entry) {
    const BallVector& q = frames_.back().q;
    for (std::uint32_t dart = entry - entry % 3; dart < entry; ++dart) {
      dot(value_.get(), plane_.line(dart), q, plane_.precision());
      if (certainly_negative(value_.get()) == Tri::yes) return false;
    }
    dot(value_.get(), plane_.alpha(entry / 3), q, plane_.precision());
    return certainly_less(bound_.get(), value_.get()) != Tri::yes;
  }

  /// Counts the triangle and reports its corners that are lifts of the vertex. False if the search must end.
  bool visit(const Step& step) {
    if (++outcome_.visits > limit_) {
      outcome_.limit_reached = true;
      return false;
    }
    for (std::uint32_t dart = 3 * step.triangle; dart < 3 * step.triangle + 3; ++dart) {
      if (start(net_, dart) != vertex_) continue;
      BallIsometry element =
          compose(inverse(frames_.back().from_base), plane_.label(corner_label(net_, dart)), plane_.precision());
      choose_sign(element);
      const LabelProduct product = [&] { return labels_to(dart); };
      if (report_(element, product) == Search::stop) return false;
    }
    return true;
  }

  /// The labels of the way from the vertex at the root to the corner of the last triangle where the dart starts, and
  /// back by that corner's own: (T_k ⋯ T_1 L_root)⁻¹ L_dart with T = L_there L_here⁻¹ across each dart.
  [[nodiscard]] std::vector<SignedLabel> labels_to(std::uint32_t dart) const {
    std::vector<SignedLabel> product{{corner_label(net_, root_), true}};
    for (std::size_t i = 1; i < path_.size(); ++i) {
      const std::uint32_t there = 3 * path_[i].triangle + path_[i].entry;
      product.push_back({corner_label(net_, opposite(net_, there)), false});
      product.push_back({corner_label(net_, next_dart(there)), true});
    }
    product.push_back({corner_label(net_, dart), false});
    return product;
  }

  const LiftedPlane& plane_;
  const Document& net_;
  std::uint32_t root_;  ///< The dart that leaves the vertex in the first triangle.
  std::uint32_t vertex_;
  std::uint64_t limit_;
  const std::function<Search(const BallIsometry&, const LabelProduct&)>& report_;
  std::vector<Frame> frames_;
  std::vector<Step> path_;
  Ball cosh_shift_;
  Ball bound_;
  Ball value_;
  OrbitOutcome outcome_;
};

}  // namespace

OrbitOutcome search_orbit(const LiftedPlane& plane, std::uint32_t dart, const Ball& cosh_distance,
                          const Ball& sinh_distance, const Ball& tanh_radius, std::uint64_t limit,
                          const std::function<Search(const BallIsometry&, const LabelProduct&)>& report) {
  OrbitSearch search(plane, dart, limit, report);
  search.set_bound(cosh_distance, sinh_distance, tanh_radius);
  return search.run();
}

}  // namespace epsnet::certify
