#include "netgen/isometries/length_spectra.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "certify/base/text.h"

namespace epsnet {
namespace {

/// The lower and upper bounds of all lengths, each in order.
struct Bounds {
  std::vector<double> lower;
  std::vector<double> upper;

  explicit Bounds(const certify::GeodesicsDocument& spectrum) {
    for (const auto& geodesic : spectrum.geodesics) {
      lower.push_back(geodesic.length.lower);
      upper.push_back(geodesic.length.upper);
    }
    std::sort(lower.begin(), lower.end());
    std::sort(upper.begin(), upper.end());
  }
};

std::size_t count_up_to(const std::vector<double>& sorted, double length) {
  return static_cast<std::size_t>(std::upper_bound(sorted.begin(), sorted.end(), length) - sorted.begin());
}

/// Whether one surface has certainly more closed geodesics of length at most ℓ than the other one, for some ℓ up to
/// which the list of the other one is complete.
std::optional<std::string> certainly_more(const Bounds& some, const char* name, const Bounds& others,
                                          const char* other_name, const std::string& complete_up_to) {
  const mpq_class limit = certify::decimal(complete_up_to);
  for (const double length : some.upper) {
    if (mpq_class(length) > limit) return std::nullopt;
    const std::size_t least = count_up_to(some.upper, length);
    const std::size_t most = count_up_to(others.lower, length);
    if (least <= most) continue;
    return std::string(name) + " has at least " + std::to_string(least) +
           " primitive closed geodesics of length at most " + certify::shortest(length) + ", " + other_name +
           " at most " + std::to_string(most);
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::string> certain_difference(const certify::GeodesicsDocument& first,
                                              const certify::GeodesicsDocument& second) {
  const Bounds of_first(first);
  const Bounds of_second(second);
  const auto found = certainly_more(of_first, "the first surface", of_second, "the second one", second.up_to);
  return found ? found : certainly_more(of_second, "the second surface", of_first, "the first one", first.up_to);
}

}  // namespace epsnet
