#include "certify/base/nearest_name.h"

#include <algorithm>
#include <cstddef>

namespace epsnet::certify {
namespace {

/// The optimal string alignment distance.
std::size_t typing_errors(const std::string& a, const std::string& b) {
  std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) {
    for (std::size_t k = 0; k <= b.size(); ++k) {
      if (i == 0 || k == 0) {
        d[i][k] = i + k;
        continue;
      }
      d[i][k] = std::min({d[i - 1][k] + 1, d[i][k - 1] + 1, d[i - 1][k - 1] + (a[i - 1] == b[k - 1] ? 0 : 1)});
      if (i > 1 && k > 1 && a[i - 1] == b[k - 2] && a[i - 2] == b[k - 1])
        d[i][k] = std::min(d[i][k], d[i - 2][k - 2] + 1);
    }
  }
  return d[a.size()][b.size()];
}

}  // namespace

std::string nearest_name(const std::string& typed, const std::vector<std::string>& names) {
  constexpr std::size_t kLongest = 40;
  if (typed.empty() || typed.size() > kLongest) return "";
  const auto bare = [](const std::string& name) {
    return name.substr(std::min(name.find_first_not_of('-'), name.size()));
  };
  const std::string meant = bare(typed);
  std::size_t least = meant.size() / 3 + 1;
  std::string nearest;
  for (const std::string& name : names) {
    const std::string candidate = bare(name);
    const std::size_t errors = meant.size() > 1 && candidate.starts_with(meant) ? 0 : typing_errors(meant, candidate);
    if (errors < least || (errors == least && nearest.empty() && errors < candidate.size())) {
      least = errors;
      nearest = name;
    }
  }
  return nearest;
}

}  // namespace epsnet::certify
