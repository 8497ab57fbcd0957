#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "certify/exact/claim_rules.h"

namespace epsnet::exact {
namespace {

/// Bits of elements that are compared with those of all paths: some seconds.
constexpr std::size_t kMostComparedBits = 4'000'000'000;

std::string path_name(std::size_t i) { return "path " + number(i); }

/// sinh² of half a distance.
template <class R>
struct HalfDistance {
  R numerator;
  R denominator;
};

template <class R>
class DistanceRules {
 public:
  DistanceRules(const DistanceDocument& document, NetRules<R>& net)
      : document_(document), net_(net), chart_(document.net.vertices[0].chart) {}

  /// W_i and their lengths.
  void check_paths() {
    lower_ = squared_sinh(document_.distance[0] / 2);
    upper_ = squared_sinh(document_.distance[1] / 2);
    for (std::size_t i = 0; i < document_.paths.size(); ++i) {
      const Isometry<R> element = net_.value(chart_, document_.paths[i]);
      if (is_listed(element)) throw Refutation{path_name(i) + " is another one again"};
      elements_.push_back(element);
      bits_of_elements_ += bits(element);
      lengths_.push_back(length(element));
      const auto& [n, d] = lengths_.back();
      const Answer outside = either(is_less(n, d, lower_), is_more(lengths_.back()));
      if (outside == Answer::yes) throw Refutation{path_name(i) + " has another length"};
      if (outside == Answer::unknown) throw TooLarge{path_name(i) + ": its length is nearly an end of the distance"};
    }
  }

  void check_equal() const {
    if (!document_.equal) return;
    for (const auto& [n, d] : lengths_) {
      if (sgn(R(n * lengths_[0].denominator - lengths_[0].numerator * d)) != 0) throw Refutation{"the lengths differ"};
    }
  }

  /// Each path behind the loop of each dart is longer, or a path of the file.
  void check_nearest() {
    for (Index dart = 0; dart < net_.darts(); ++dart) {
      const Isometry<R> loop = net_.element(dart);
      for (std::size_t i = 0; i < elements_.size(); ++i) {
        const Isometry<R> element = net_.product(elements_[i], loop);
        const Answer more = is_more(length(element));
        if (more == Answer::yes || is_listed(element)) continue;
        const std::string name = "the loop along dart " + number(dart) + ", then " + path_name(i);
        if (more == Answer::no) throw Refutation{"a path is missing: " + name};
        throw TooLarge{name + ": its length is too close to the distance"};
      }
    }
  }

 private:
  [[nodiscard]] bool is_listed(const Isometry<R>& element) {
    spend(bits(element) * elements_.size() + bits_of_elements_,
          "comparing " + number(document_.paths.size()) + " paths, two at a time,");
    return std::any_of(elements_.begin(), elements_.end(),
                       [&](const auto& other) { return are_equal(element, other); });
  }

  void spend(std::size_t compared, const std::string& what) {
    if (compared > bits_left_) throw TooLarge{what + " takes more than " + number(kMostComparedBits) + " bits"};
    bits_left_ -= compared;
  }

  /// Of the path with the element g, from the vertex to g⁻¹ of the point.
  HalfDistance<R> length(const Isometry<R>& g) {
    const Point<R> p = point<R>(document_.net.vertices[0].z);
    const Point<R> q = point<R>(document_.point);
    // The digits of the point are multiplied by all of the numbers of the element.
    spend(bits(q) * bits(g) / 16, "the length of a path");
    const Point<R> end = net_.image(inverse(g), q);
    return {squared_difference(p, end), gap(p) * gap(end)};
  }

  /// Whether it is more than the upper end. The two are equal only if both are 0.
  [[nodiscard]] Answer is_more(const HalfDistance<R>& x) const {
    if (document_.distance[1] == 0) return sgn(x.numerator) > 0 ? Answer::yes : Answer::no;
    return !is_less(x.numerator, x.denominator, upper_);
  }

  const DistanceDocument& document_;
  NetRules<R>& net_;
  Index chart_;
  SquaredSinh lower_;
  SquaredSinh upper_;
  std::vector<Isometry<R>> elements_;
  std::vector<HalfDistance<R>> lengths_;
  std::size_t bits_of_elements_ = 0;
  std::size_t bits_left_ = kMostComparedBits;
};

}  // namespace

template <class R>
std::vector<Rule> distance_rules(const DistanceDocument& document, NetRules<R>& net) {
  expect_less(document.tile, document.net.tile_count(), "tile");
  if (gap(document.point) <= 0) throw Malformed("the point is not in the disk");
  if (document.paths.empty()) throw Malformed("there is no path");
  const Index tile = document.net.charts[document.net.vertices[0].chart].first;
  for (const std::vector<Index>& path : document.paths) net.expect_path(path, tile, document.tile);
  const auto rules = std::make_shared<DistanceRules<R>>(document, net);
  return {{"paths", [rules] { rules->check_paths(); }},
          {"equal", [rules] { rules->check_equal(); }},
          {"nearest", [rules] { rules->check_nearest(); }}};
}

template std::vector<Rule> distance_rules(const DistanceDocument& document, NetRules<mpz_class>& net);
template std::vector<Rule> distance_rules(const DistanceDocument& document, NetRules<Algebraic>& net);
template std::vector<Rule> distance_rules(const DistanceDocument& document, NetRules<FieldNumber>& net);

}  // namespace epsnet::exact
