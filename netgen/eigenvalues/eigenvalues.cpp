#include "netgen/eigenvalues/eigenvalues.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "certify/numbers/inertia.h"
#include "certify/numbers/parallel.h"
#include "netgen/eigenvalues/elements.h"
#include "netgen/eigenvalues/local_functions.h"
#include "netgen/lifts/lifts.h"
#include "netgen/nets/certified_net.h"

namespace epsnet {
namespace {

using certify::EigenvaluesDocument;
using certify::Interval;
using Eigenfunctions = EigenvaluesDocument::Eigenfunctions;

constexpr std::uint32_t kMostCount = 1000;
constexpr int kMostDigits = 10;
/// Functions around vertices are no farther from them than 1.7 times that.
constexpr double kGreatestEpsilon = 1;
/// So many digits are got by matrices alone.
constexpr int kDigitsOfMatrices = 2;
constexpr double kMostTriangles = 1e7;
constexpr const char* kRounding =
    "rounding errors are too large in triangles as thin as those around a closed geodesic that is so short";

[[nodiscard]] bool many_digits(const EigenvaluesOptions& options) {
  return options.digits.value_or(options.below ? 1 : 9) > kDigitsOfMatrices;
}

void check(const EigenvaluesOptions& options, std::uint32_t genus) {
  if (options.count < 1 || options.count > kMostCount) throw std::invalid_argument("count is not from 1 to 1000");
  if (options.below && !(*options.below > 0 && *options.below <= 1e4))
    throw std::invalid_argument("below is not a positive number of at most 10000");
  if (options.digits && (*options.digits < 1 || *options.digits > kMostDigits))
    throw std::invalid_argument("digits is not from 1 to 10");
  if (!options.epsilon) return;
  const auto epsilon = static_cast<double>(options.epsilon->value());
  if (many_digits(options) && epsilon > kGreatestEpsilon)
    throw NetError("epsilon is more than 1, which is too much for more than 2 digits");
  // A net has about so many triangles (thesis, Theorem III.1 and IV.6.2).
  const double triangles = 2 * 0.54 * 16 * (genus - 1) / (epsilon * epsilon);
  if (triangles > kMostTriangles) throw NetError("epsilon is so small that a net has more than 10000000 triangles");
}

/// The triangles at one size, and what their matrices say of the first eigenvalues, by index from λ₁ on.
struct Level {
  Level(const NetGeometry& geometry, std::uint32_t times)
      : halvings(times),
        elements(geometry, times),
        lower(elements.lower()),
        upper(elements.upper()),
        side_order(elimination_order(lower.energy)),
        vertex_order(elimination_order(upper.energy)),
        interpolation(elements.interpolation()) {}

  /// σ for which the eigenvalues that are counted are those less than τ.
  [[nodiscard]] double sigma(double tau) const {
    const double room = 1 - interpolation * (1 + 1e-10) * tau;
    return room > 0 ? tau / room * (1 + 1e-12) : HUGE_VAL;
  }

  std::uint32_t halvings;
  Elements elements;
  ElementMatrices lower;
  ElementMatrices upper;
  std::vector<std::uint32_t> side_order;
  std::vector<std::uint32_t> vertex_order;
  double interpolation;
  std::vector<double> least;      ///< λ_k is at least that,
  std::vector<double> greatest;   ///< at most that,
  std::vector<double> estimates;  ///< and about that.
  Eigen::MatrixXd vectors;        ///< By vertex and k.
};

/// Eigenvalues k = first, …, last − 1 that are near each other, as places in the lists of a level.
struct Group {
  std::size_t first;
  std::size_t last;
};

class Search {
 public:
  Search(const Surface& surface, const EigenvaluesOptions& options) : surface_(surface), options_(options) {
    set_net(options.epsilon.value_or(epsilon_for(surface.genus(), options)));
  }

  [[nodiscard]] EigenvaluesDocument result() && {
    const bool functions_too = many_digits(options_);
    if (options_.below && !options_.digits) {
      count_below();
    } else {
      const Level level = separated(functions_too);
      const std::vector<Group> groups = groups_of(level, functions_too);
      std::vector<std::optional<std::vector<Eigenfunctions>>> rows(groups.size());
      if (functions_too) rows = functions(level, groups);
      write(level, groups, rows);
    }
    return std::move(document_);
  }

 private:
  void set_net(const Length& epsilon) {
    NetOptions net_options;
    net_options.threads = options_.threads;
    // A second net is a part of making the matrices.
    net_options.progress = [&](std::string_view what, double share) {
      geometry_ ? report("matrices", 0) : report(what, share);
    };
    certify::NetDocument net = compute_net(surface_, epsilon, net_options).document;
    geometry_.reset();
    document_.net = std::move(net);
    geometry_.emplace(document_.net);
  }

  /// Functions around vertices are sought in disks of which λ is no eigenvalue.
  static Length epsilon_for(std::uint32_t genus, const EigenvaluesOptions& options) {
    const double by_weyl = options.count / (genus - 1.0) + 3;
    const double greatest = options.below ? *options.below : by_weyl;
    constexpr std::array<std::pair<double, const char*>, 8> kLengths{{{0.6, "0.6"},
                                                                      {0.5, "0.5"},
                                                                      {0.4, "0.4"},
                                                                      {0.3, "0.3"},
                                                                      {0.2, "0.2"},
                                                                      {0.15, "0.15"},
                                                                      {0.1, "0.1"},
                                                                      {0.05, "0.05"}}};
    for (const auto& [epsilon, text] : kLengths) {
      if (epsilon * std::sqrt(greatest) < 1.6) return Length(text);
    }
    return Length(kLengths.back().second);
  }

  void report(std::string_view what, double share) const {
    if (options_.progress) options_.progress(what, share);
  }

  [[nodiscard]] Level level(std::uint32_t halvings) const {
    const double triangles = static_cast<double>(document_.net.triangles.size()) * std::pow(4.0, halvings);
    if (triangles > kMostTriangles) {
      throw NetError(
          "the eigenvalues are so near to each other that to tell them apart takes more than 10000000 "
          "triangles");
    }
    report("matrices", 0);
    Level result(*geometry_, halvings);
    if (!std::isfinite(result.interpolation)) throw NetError(kRounding);
    return result;
  }

  /// A level at which so many eigenvalues are told from the others, and enclosed as narrowly as is asked for.
  [[nodiscard]] Level separated(bool functions_too) {
    std::vector<double> before;
    std::uint32_t halvings = 0;
    // As the last ones may be equal.
    std::uint32_t more = std::max(8U, options_.count / 4);
    for (;;) {
      Level now = level(halvings);
      std::uint32_t count = options_.count;
      if (options_.below) {
        const certify::Inertia below =
            inertia(now.upper, now.vertex_order, *options_.below, certify::Bound::lower, options_.threads);
        count = std::max(below.negative, 2U) - 1;
      }
      const std::uint32_t asked = count + more;
      if (now.elements.vertices() < 4 * asked) {
        ++halvings;
        continue;
      }
      bound(now, asked, before);
      const auto end = end_of(now, count, functions_too);
      const double excess = end ? excess_of(now, *end, functions_too) : HUGE_VAL;
      if (excess <= 1) {
        now.least.resize(*end + 1);
        now.greatest.resize(*end + 1);
        now.estimates.resize(*end + 1);
        return now;
      }
      before = now.greatest;
      if (!end) {
        ++halvings;
        more += std::max(8U, count / 4);
      } else if (functions_too) {
        ++halvings;
      } else {
        // Those that are told from the others will be so by smaller triangles.
        more = std::max(static_cast<std::uint32_t>(*end), count) + 2 - count;
        halvings = finer(halvings, excess);
      }
    }
  }

  /// Sets what the matrices of a level say of the first eigenvalues; `before` is at most what those say that were
  /// halved once less.
  void bound(Level& now, std::uint32_t asked, const std::vector<double>& before) const {
    std::array<DiscreteSpectrum, 2> spectra;
    certify::for_each_parallel(spectra.size(), certify::thread_count(options_.threads), [&](unsigned, std::size_t i) {
      spectra[i] = i == 0 ? first_eigenvalues(now.lower, now.side_order, asked + 1)
                          : first_eigenvalues(now.upper, now.vertex_order, asked + 1);
    });
    const auto& [lower, upper] = spectra;
    for (std::size_t k = 1; k <= asked; ++k) {
      now.least.push_back(lower.values[k] / (1 + now.interpolation * lower.values[k]));
      now.greatest.push_back(upper.values[k]);
      // The error of the matrices is divided by four with each halving.
      const double above = k <= before.size() ? (4 * upper.values[k] - before[k - 1]) / 3 : upper.values[k];
      now.estimates.push_back(std::clamp(above, now.least.back(), now.greatest.back()));
    }
    now.vectors = upper.vectors.rightCols(upper.vectors.cols() - 1);
  }

  /// How much wider than is asked for the widest of the first n enclosures is.
  [[nodiscard]] double excess_of(const Level& now, std::size_t n, bool functions_too) const {
    if (n == 0) return 0;
    double widest = 0;
    // Functions are sought from estimates.
    for (std::size_t k = functions_too ? n - 1 : 0; k < n; ++k)
      widest = std::max(widest, (now.greatest[k] - now.least[k]) / now.least[k]);
    // What matrices say is stated with a margin on both sides.
    return functions_too ? widest / kGreatestError
                         : (widest + 2 * kMargin) * std::pow(10.0, options_.digits.value_or(1));
  }

  /// Makes triangles so small that enclosures, which are as wide as triangles are large, are narrower by about this
  /// factor, or some of it. Halving alone may make four times as many as are needed; so the net becomes finer, if it
  /// may. Returns how often they are to be halved.
  [[nodiscard]] std::uint32_t finer(std::uint32_t halvings, double factor) {
    constexpr double kMost = 12;  // Predictions from large triangles are bad.
    constexpr double kRoom = 1.1;
    // Nearly as much as halving once more.
    constexpr double kByNet = 3;
    double rest = std::min(options_.epsilon ? factor : kRoom * factor, kMost);
    for (; rest > (options_.epsilon ? 1 : kByNet); rest /= 4) ++halvings;
    if (rest > 1) {
      // A decimal of few digits.
      constexpr double kDigits = 1e4;
      set_net(Length(std::floor(geometry_->epsilon().get_d() / std::sqrt(rest) * kDigits) / kDigits));
    }
    return halvings;
  }

  /// The number of the first eigenvalues that are told from all others: the least one that is enough.
  [[nodiscard]] std::optional<std::size_t> end_of(const Level& now, std::size_t count, bool functions_too) const {
    if (options_.below) {
      // All that may be less, and none of those that are certainly not.
      const auto certainly = static_cast<std::size_t>(
          std::lower_bound(now.greatest.begin(), now.greatest.end(), *options_.below) - now.greatest.begin());
      const auto perhaps = static_cast<std::size_t>(
          std::lower_bound(now.least.begin(), now.least.end(), *options_.below) - now.least.begin());
      if (certainly != perhaps) return std::nullopt;
      if (certainly == 0) return certainly;
      count = certainly;
    }
    for (std::size_t n = count; n + 1 < now.least.size(); ++n) {
      const double last = functions_too ? now.estimates[n - 1] * (1 + kError) : now.greatest[n - 1] * (1 + 2 * kMargin);
      if (now.least[n] > last) return n;
    }
    return std::nullopt;
  }

  /// The first eigenvalues of a level, all but the last one in its lists.
  [[nodiscard]] static std::vector<Group> groups_of(const Level& level, bool functions_too) {
    std::vector<Group> result;
    const std::size_t count = level.least.size() - 1;
    for (std::size_t k = 0; k < count; ++k) {
      const bool near = k > 0 && (functions_too ? level.estimates[k] < level.estimates[k - 1] * (1 + kError)
                                                : level.least[k] <= level.greatest[k - 1] * (1 + 2 * kMargin));
      if (near) {
        result.back().last = k + 1;
      } else {
        result.push_back({k, k + 1});
      }
    }
    return result;
  }

  /// By group; nothing where functions are not found.
  [[nodiscard]] std::vector<std::optional<std::vector<Eigenfunctions>>> functions(
      const Level& level, const std::vector<Group>& groups) const {
    std::vector<std::optional<std::vector<Eigenfunctions>>> result(groups.size());
    if (groups.empty()) return result;
    // Groups in parallel; threads that are left over, in each of them.
    const unsigned threads = certify::thread_count(options_.threads);
    const auto in_each = std::max(1U, threads / static_cast<unsigned>(groups.size()));
    const LocalFunctions local(*geometry_, level.estimates.back(), options_.digits.value_or(9), in_each);
    std::size_t done = 0;
    std::mutex reporting;
    certify::for_each_parallel(groups.size(), threads, [&](unsigned, std::size_t i) {
      result[i] = functions(level, groups[i], local);
      const std::lock_guard lock(reporting);
      report("eigenfunctions", static_cast<double>(++done) / static_cast<double>(groups.size()));
    });
    return result;
  }

  /// Nothing unless all are found.
  [[nodiscard]] std::optional<std::vector<Eigenfunctions>> functions(const Level& level, const Group& group,
                                                                     const LocalFunctions& local) const {
    const auto vertices = static_cast<Eigen::Index>(document_.net.vertices.size());
    const auto [first, last] = group;
    const std::vector<double> lambdas(level.estimates.begin() + static_cast<std::ptrdiff_t>(first),
                                      level.estimates.begin() + static_cast<std::ptrdiff_t>(last));
    // With the functions of some eigenvalues beside them, as near ones are hard to tell apart.
    constexpr std::size_t kBeside = 8;
    std::vector<std::size_t> columns;
    for (std::size_t k = first; k < last; ++k) columns.push_back(k);
    for (std::size_t k = first - std::min(first, kBeside); k < first; ++k) columns.push_back(k);
    for (std::size_t k = last; k < std::min(last + kBeside, static_cast<std::size_t>(level.vectors.cols())); ++k)
      columns.push_back(k);
    Eigen::MatrixXd values(vertices, static_cast<Eigen::Index>(columns.size()));
    for (std::size_t j = 0; j < columns.size(); ++j) {
      values.col(static_cast<Eigen::Index>(j)) =
          level.vectors.col(static_cast<Eigen::Index>(columns[j])).head(vertices);
    }
    auto rows = local.near(lambdas, values);
    std::size_t found = 0;
    for (const Eigenfunctions& row : rows.value_or(std::vector<Eigenfunctions>())) {
      found += row.functions.size();
      // Those of other eigenvalues.
      if (row.in.lower < level.least[first] || row.in.upper > level.greatest[last - 1]) found = last;
    }
    if (found != last - first) rows.reset();
    return rows;
  }

  void write(const Level& level, const std::vector<Group>& groups,
             std::vector<std::optional<std::vector<Eigenfunctions>>>& rows) {
    const std::size_t count = level.least.size() - 1;
    struct Part {
      std::size_t first;
      std::size_t last;
      Interval in;
      std::optional<Eigenfunctions> functions;  ///< Otherwise matrices enclose.
    };
    const auto by_matrices = [&](std::size_t first, std::size_t last) {
      return Part{first, last, {proved_least(level, first, 0), proved_greatest(level, last)}, std::nullopt};
    };
    // What matrices enclose may contain what functions enclose beside it; and functions that are not told apart are
    // left out.
    std::vector<Part> parts;
    const auto add = [&](Part next) {
      while (!parts.empty() && next.in.lower <= parts.back().in.upper) {
        next = by_matrices(parts.back().first, next.last);
        parts.pop_back();
      }
      parts.push_back(std::move(next));
    };
    for (std::size_t i = 0; i < groups.size(); ++i) {
      std::size_t first = groups[i].first;
      if (!rows[i]) {
        add(by_matrices(first, groups[i].last));
        continue;
      }
      for (Eigenfunctions& row : *rows[i]) {
        const std::size_t last = first + row.functions.size();
        const Interval in = row.in;
        add({first, last, in, std::move(row)});
        first = last;
      }
    }
    for (Part& part : parts) {
      if (part.functions) {
        document_.eigenfunctions.push_back(*std::move(part.functions));
      } else {
        at_most(level, part.in.lower, part.first);
        at_least(part.in.upper, part.last);
      }
      document_.eigenvalues.push_back({part.in, static_cast<std::uint32_t>(part.last - part.first)});
    }
    const double least = level.least[count];
    const double end = parts.empty() ? 0 : parts.back().in.upper;
    if (end >= least) {
      throw NetError(many_digits(options_)
                         ? "the functions of some of these eigenvalues were not found; with 2 digits there are none"
                         : "the matrices do not tell these eigenvalues from the next one; more digits make them finer");
    }
    const double next = proved_least(level, count, end);
    at_most(level, next, count);
    document_.next = next;
    finish(level);
  }

  /// Only how many there are, as soon as matrices say the same from both sides.
  void count_below() {
    const double below = *options_.below;
    constexpr int kMostTimes = 2;
    std::uint32_t before = std::numeric_limits<std::uint32_t>::max();
    int worse = 0;
    for (std::uint32_t halvings = 0;; ++halvings) {
      const Level now = level(halvings);
      const double sigma = now.sigma(below);
      if (!std::isfinite(sigma)) continue;
      const certify::Inertia least =
          inertia(now.upper, now.vertex_order, below, certify::Bound::lower, options_.threads);
      // 0 is less.
      const std::uint32_t certainly = least.proved ? std::max(least.negative, 1U) : 1;
      const certify::Inertia most =
          inertia(now.lower, now.side_order, sigma, certify::Bound::upper, options_.threads, certainly);
      if (!most.proved) continue;
      if (most.negative > certainly) {
        // Smaller triangles have more rows with pivots that are near 0.
        worse = most.negative - certainly > before ? worse + 1 : 0;
        if (worse == kMostTimes) throw NetError(kRounding);
        before = most.negative - certainly;
        continue;
      }
      const std::size_t count = certainly - 1;
      at_most(now, below, count);
      if (count > 0) {
        at_least(below, count);
        document_.eigenvalues.push_back({{0, below}, static_cast<std::uint32_t>(count)});
      }
      document_.next = below;
      return finish(now);
    }
  }

  /// A number that λ_{k + 1} is at least, which `certify` can prove: near the bound of the matrices, and more than
  /// `from`, which that is. Where a pivot is too near 0 for a proof, or λ is so small that
  /// rounding counts, a number beside serves.
  [[nodiscard]] double proved_least(const Level& level, std::size_t k, double from) const {
    const double bound = level.least[k];
    double below = 0;
    double margin = kMargin;
    for (int i = 1; i <= kMostTrials; ++i, margin *= 4) {
      below = bound - std::min(margin * bound, (bound - from) * i / (i + 1));
      const certify::Inertia found =
          inertia(level.lower, level.side_order, level.sigma(below), certify::Bound::upper, options_.threads, k + 1);
      if (found.proved && found.negative <= k + 1) break;
    }
    return below;
  }

  /// The same for a number that λ_k is less than.
  [[nodiscard]] double proved_greatest(const Level& level, std::size_t k) const {
    double below = 0;
    double margin = kMargin;
    for (int i = 1; i <= kMostTrials; ++i, margin *= 4) {
      below = level.greatest[k - 1] * (1 + margin);
      const certify::Inertia found =
          inertia(level.upper, level.vertex_order, below, certify::Bound::lower, options_.threads, k + 1);
      if (found.proved && found.negative >= k + 1) break;
    }
    return below;
  }

  void at_most(const Level& level, double below, std::size_t count) {
    document_.at_most.push_back({below, static_cast<std::uint32_t>(count), level.sigma(below)});
  }
  void at_least(double below, std::size_t count) {
    document_.at_least.push_back({below, static_cast<std::uint32_t>(count)});
  }

  void finish(const Level& level) {
    document_.halvings = level.halvings;
    document_.side_order = level.side_order;
    if (!document_.at_least.empty()) document_.vertex_order = level.vertex_order;
  }

  static constexpr int kMostTrials = 5;
  static constexpr double kMargin = 3e-4;         ///< Relative; shifts of the matrices by rounding are less.
  static constexpr double kError = 0.01;          ///< Relative, of estimates.
  static constexpr double kGreatestError = 0.12;  ///< Between the matrices' bounds.

  const Surface& surface_;
  const EigenvaluesOptions& options_;
  EigenvaluesDocument document_;
  std::optional<NetGeometry> geometry_;  ///< Of the document's net.
};

}  // namespace

EigenvaluesDocument unproved::eigenvalues(const Surface& surface, const EigenvaluesOptions& options) {
  check(options, surface.genus());
  return Search(surface, options).result();
}

Certified<EigenvaluesDocument> eigenvalues(const Surface& surface, const EigenvaluesOptions& options) {
  return proved(unproved::eigenvalues(surface, options), options.threads, options.progress);
}

}  // namespace epsnet
