#include "certify/claims/geodesics/orbit_search.h"

#include <array>
#include <optional>
#include <vector>

#include "certify/net/darts.h"

namespace epsnet::certify {
namespace {

/// Bits that a point must be known to; with fewer, nothing would be pruned.
constexpr slong kLeastAccuracy = 16;
/// The weights of q in its triangle, in thousandths, the vertex first: near the vertex, but on no line of the surface's
/// symmetries, so that balls can nearly always tell on which side of an edge it lies.
constexpr std::array<ulong, 3> kWeights{967, 22, 11};
constexpr std::uint32_t kNoEdge = 3;
/// Operations of balls that a visit takes.
constexpr std::uint64_t kVisitOperations = 40;

class OrbitSearch {
 public:
  OrbitSearch(const LiftedPlane& plane, std::uint32_t dart, std::uint64_t limit,
              const std::function<Search(const BallIsometry&, const LabelProduct&)>& report)
      : plane_(plane), net_(plane.net()), root_(dart), limit_(limit), report_(report) {
    place_root();
  }

  /// The greatest value at q of the α of gΔ, Δ the root, if gṽ is within D of the vertex: α(q) = cosh d(q, C)/cosh R
  /// ≤ cosh(D' + R)/cosh R = cosh D' + sinh D' tanh R with D' = D + d(q, ṽ) and R the circumradius of Δ.
  void set_bound(const Ball& cosh_distance, const Ball& sinh_distance) {
    const Precision scope(plane_.precision());
    // α is the product with a vector of square −1/cosh²R.
    const BallVector& alpha = plane_.alpha(root_ / 3);
    const Ball tanh_radius = sqrt_of_nonnegative(lorentz_product(alpha, alpha, plane_.precision()) + 1);
    const Ball sinh_shift = sqrt_of_nonnegative(sqr(cosh_shift_) - 1);
    const Ball sinh_sum = sinh_distance * cosh_shift_ + cosh_distance * sinh_shift;
    const Ball cosh_sum = cosh_distance * cosh_shift_ + sinh_distance * sinh_shift;
    bound_ = cosh_sum + sinh_sum * tanh_radius;
  }

  OrbitOutcome run() {
    if (!is_finite(bound_) || !accurate(frames_.back()) || !visit(path_.back())) return outcome_;
    while (!path_.empty()) {
      Step& step = path_.back();
      if (step.next_edge == 3) {
        leave();
        continue;
      }
      const std::uint32_t edge = step.next_edge++;
      // Across the edge of entry is the parent, which is no child: q is beyond that edge.
      if (edge != step.entry && !try_child(3 * step.triangle + edge)) return outcome_;
    }
    outcome_.complete = true;
    return outcome_;
  }

 private:
  /// The chart of a visited triangle: shared by all visited next to each other in one chart. Most are left before
  /// anything is reported there, so the way from the chart of the vertex is put together when it is asked for.
  struct Frame {
    const BallIsometry* from_previous;  ///< Null for the first.
    BallVector q;
    std::optional<BallIsometry> from_base;
  };

  /// A lifted triangle on the way from the root: the edge by which it was entered and the next edge to leave it by.
  struct Step {
    std::uint32_t triangle;
    std::uint32_t entry;
    std::uint32_t next_edge;
    bool own_frame;
  };

  void place_root() {
    const slong precision = plane_.precision();
    Frame frame{nullptr, {}, plane_.label(corner_label(net_, root_))};
    std::uint32_t corner = root_;
    for (const ulong weight : kWeights) {
      for (std::size_t i = 0; i < 3; ++i) {
        arb_addmul_ui(frame.q[i].get(), plane_.corner(corner)[i].get(), weight, precision);
      }
      corner = next_dart(corner);
    }
    const Precision scope(precision);
    const Ball scale = rsqrt(-lorentz_product(frame.q, frame.q, precision));
    for (Ball& x : frame.q) x = x * scale;
    cosh_shift_ = -lorentz_product(frame.q, plane_.corner(root_), precision);
    frames_.push_back(std::move(frame));
    path_.push_back({root_ / 3, kNoEdge, 0, true});
  }

  void leave() {
    if (path_.back().own_frame) frames_.pop_back();
    path_.pop_back();
  }

  [[nodiscard]] static bool accurate(const Frame& frame) {
    return is_finite(frame.q[2]) && arb_rel_accuracy_bits(frame.q[2].get()) >= kLeastAccuracy;
  }

  /// Visits the neighbour across a dart of the last triangle if it may be that one's child and is near enough. False if
  /// the search must end.
  bool try_child(std::uint32_t dart) {
    // The child has this edge between itself and q: q is strictly on our side of it. Left out only if certainly not.
    dot(value_, plane_.line(dart), frames_.back().q, plane_.precision());
    if (certainly_positive(value_) == Tri::no) return true;
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
    frames_.push_back(
        {&transition->isometry, apply(transition->matrix, frames_.back().q, plane_.precision()), std::nullopt});
    return true;
  }

  /// From the chart of the vertex to the current one.
  const BallIsometry& from_base() {
    std::size_t known = frames_.size() - 1;
    while (!frames_[known].from_base) --known;
    for (; known + 1 < frames_.size(); ++known) {
      frames_[known + 1].from_base =
          compose(*frames_[known + 1].from_previous, *frames_[known].from_base, plane_.precision());
    }
    return *frames_.back().from_base;
  }

  /// Whether no edge before that of `entry` certainly separates its triangle from q, and α is not certainly too large.
  bool is_child(std::uint32_t entry) {
    const BallVector& q = frames_.back().q;
    for (std::uint32_t dart = entry - entry % 3; dart < entry; ++dart) {
      dot(value_, plane_.line(dart), q, plane_.precision());
      if (certainly_negative(value_) == Tri::yes) return false;
    }
    // The bound minus α(q): cheaper than a comparison of the two.
    arb_dot(value_.get(), bound_.get(), 1, plane_.alpha(entry / 3)[0].get(), 1, q[0].get(), 1, 3, plane_.precision());
    return certainly_negative(value_) != Tri::yes;
  }

  /// Counts the triangle and reports the element that takes the root to it, if there is one. False if the search must
  /// end.
  bool visit(const Step& step) {
    plane_.spend(kVisitOperations);
    if (++outcome_.visits > limit_) {
      outcome_.limit_reached = true;
      return false;
    }
    if (step.triangle != root_ / 3) return true;
    BallIsometry element = compose(inverse(from_base()), plane_.label(corner_label(net_, root_)), plane_.precision());
    choose_sign(element);
    return report_(element, [&] { return labels_to_end(); }) == Search::go_on;
  }

  /// The labels of the way from the vertex at the root to its lift in the last triangle, and back by that corner's own:
  /// (T_k ⋯ T_1 L_root)⁻¹ L_root with T = L_there L_here⁻¹ across each dart.
  [[nodiscard]] std::vector<SignedLabel> labels_to_end() const {
    std::vector<SignedLabel> product{{corner_label(net_, root_), true}};
    for (std::size_t i = 1; i < path_.size(); ++i) {
      const std::uint32_t there = 3 * path_[i].triangle + path_[i].entry;
      product.push_back({corner_label(net_, opposite(net_, there)), false});
      product.push_back({corner_label(net_, next_dart(there)), true});
    }
    product.push_back({corner_label(net_, root_), false});
    return product;
  }

  const LiftedPlane& plane_;
  const NetDocument& net_;
  std::uint32_t root_;  ///< The dart that leaves the vertex in the first triangle.
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
                          const Ball& sinh_distance, std::uint64_t limit,
                          const std::function<Search(const BallIsometry&, const LabelProduct&)>& report) {
  OrbitSearch search(plane, dart, limit, report);
  search.set_bound(cosh_distance, sinh_distance);
  return search.run();
}

}  // namespace epsnet::certify
