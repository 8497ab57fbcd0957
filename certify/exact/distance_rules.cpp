#include <memory>
#include <set>
#include <string>
#include <tuple>

#include "certify/exact/claim_rules.h"

namespace epsnet::exact {
namespace {

/// The entries of an isometry in lowest terms and with one of the two signs: equal for equal isometries.
using Key = std::tuple<mpz_class, mpz_class, mpz_class, mpz_class>;

Key key_of(Isometry f) {
  reduce(f);
  Key key{f.a.re, f.a.im, f.b.re, f.b.im};
  const Key opposite{-f.a.re, -f.a.im, -f.b.re, -f.b.im};
  return std::max(key, opposite);
}

std::string path_name(std::size_t i) { return "path " + number(i); }

/// sinh² of half a distance.
struct HalfDistance {
  mpz_class numerator;
  mpz_class denominator;
};

class DistanceRules {
 public:
  DistanceRules(const DistanceDocument& document, NetRules& net)
      : document_(document), net_(net), chart_(document.net.vertices[0].chart) {}

  /// W_i and their lengths.
  void check_paths() {
    lower_ = squared_sinh(document_.distance[0] / 2);
    upper_ = squared_sinh(document_.distance[1] / 2);
    for (std::size_t i = 0; i < document_.paths.size(); ++i) {
      const Isometry element = net_.value(chart_, document_.paths[i]);
      if (!keys_.insert(key_of(element)).second) throw Refutation{path_name(i) + " is another one again"};
      elements_.push_back(element);
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
      if (n * lengths_[0].denominator != lengths_[0].numerator * d) throw Refutation{"the lengths differ"};
    }
  }

  /// Each path behind the loop of each dart is longer, or a path of the file.
  void check_nearest() {
    for (Index dart = 0; dart < net_.darts(); ++dart) {
      const Isometry loop =
          net_.product(inverse(net_.label(net_.label_number(dart))), net_.label(net_.label_number(next(dart))));
      for (std::size_t i = 0; i < elements_.size(); ++i) {
        const Isometry element = net_.product(elements_[i], loop);
        if (keys_.contains(key_of(element))) continue;
        const Answer more = is_more(length(element));
        const std::string name = "the loop along dart " + number(dart) + ", then " + path_name(i);
        if (more == Answer::no) throw Refutation{"a path is missing: " + name};
        if (more == Answer::unknown) throw TooLarge{name + ": its length is too close to the distance"};
      }
    }
  }

 private:
  /// Of the path with the element g, from the vertex to g⁻¹ of the point.
  HalfDistance length(const Isometry& g) {
    const Point& p = document_.net.vertices[0].z;
    const Point end = net_.image(inverse(g), document_.point);
    return {squared_difference(p, end), gap(p) * gap(end)};
  }

  /// Whether it is more than the upper end. The two are equal only if both are 0.
  [[nodiscard]] Answer is_more(const HalfDistance& x) const {
    if (document_.distance[1] == 0) return x.numerator > 0 ? Answer::yes : Answer::no;
    return !is_less(x.numerator, x.denominator, upper_);
  }

  const DistanceDocument& document_;
  NetRules& net_;
  Index chart_;
  SquaredSinh lower_;
  SquaredSinh upper_;
  std::vector<Isometry> elements_;
  std::vector<HalfDistance> lengths_;
  std::set<Key> keys_;
};

}  // namespace

std::vector<Rule> distance_rules(const DistanceDocument& document, NetRules& net) {
  expect_less(document.tile, document.net.tiles.size(), "tile");
  if (gap(document.point) <= 0) throw Malformed("the point is not in the disk");
  if (document.paths.empty()) throw Malformed("there is no path");
  const Index tile = document.net.charts[document.net.vertices[0].chart].first;
  for (const std::vector<Index>& path : document.paths) net.expect_path(path, tile, document.tile);
  const auto rules = std::make_shared<DistanceRules>(document, net);
  return {{"paths", [rules] { rules->check_paths(); }},
          {"equal", [rules] { rules->check_equal(); }},
          {"nearest", [rules] { rules->check_nearest(); }}};
}

}  // namespace epsnet::exact
