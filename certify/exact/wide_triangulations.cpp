#include "certify/exact/wide_triangulations.h"

#include <array>

namespace epsnet::exact {

Answer is_delaunay_and_wide(const std::vector<Index>& opposite, const std::vector<Interval>& h, const Interval& least) {
  std::vector<Interval> kappa(h.size()), areas;
  Interval all = -Interval(static_cast<long>(h.size() / 3) - 2) * Interval::pi();
  Answer result = Answer::yes;
  Answer wide = Answer::no;
  for (std::size_t t = 0; t < h.size(); t += 3) {
    const std::array<Interval, 3> x{h[t], h[t + 1], h[t + 2]};
    const Interval k = 4 * x[0] * x[1] - square(x[0] + x[1] - x[2]);
    const Interval product = 4 * x[0] * x[1] * x[2];
    result = both(result, is_less(0, k));
    for (std::size_t i = 0; i < 3; ++i) kappa[t + i] = (x[(i + 1) % 3] + x[(i + 2) % 3] - x[i]) / sqrt(k);
    areas.push_back(2 * arctan(sqrt(k + product) / (2 + x[0] + x[1] + x[2])));
    all = all + areas.back();
    wide = either(wide, !is_less(product, k * least));
  }
  for (std::size_t dart = 0; dart < h.size(); ++dart) {
    result = both(result, is_less(0, kappa[dart] + kappa[opposite[dart]]));
  }
  for (const Interval& area : areas) result = both(result, is_less(all, area));
  return both(result, wide);
}

}  // namespace epsnet::exact
