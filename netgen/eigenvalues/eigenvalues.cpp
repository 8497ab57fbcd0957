#include "netgen/eigenvalues/eigenvalues.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
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
#include "netgen/surfaces/group.h"

namespace epsnet {
namespace {

using certify::EigenvaluesDocument;
using certify::Interval;
using Eigenfunctions = EigenvaluesDocument::Eigenfunctions;

constexpr std::uint32_t kMostCount = 1000;
constexpr int kMostDigits = 10;
/// Functions around vertices are no farther from them than 1.7 times that.
constexpr double kGreatestEpsilon = 1;
/// So many digits are got by matrices alone; with phases, at most.
constexpr int kDigitsOfMatrices = 2;
constexpr int kMostDigitsWithPhases = 3;
/// With phases, what is less is enclosed by an interval that begins with 0.
constexpr double kNearZero = 1e-6;
constexpr double kMostTriangles = 1e7;
constexpr const char* kRounding =
    "rounding errors are too large in triangles as thin as those around a closed geodesic that is so short";
constexpr const char* kTooLarge =
    "epsilon is too large: triangles of its net have quarters without a circumscribed circle";

[[nodiscard]] bool many_digits(const EigenvaluesOptions& options) {
  return options.phases.empty() && options.digits.value_or(options.below ? 1 : 9) > kDigitsOfMatrices;
}

/// Of the first eigenvalues of the matrices, so many are not those of a document: that of the constant functions, which
/// are no functions with phases.
[[nodiscard]] std::uint32_t left_out(const EigenvaluesOptions& options) { return options.phases.empty() ? 1 : 0; }

void check(const EigenvaluesOptions& options, std::uint32_t genus) {
  if (options.count < 1 || options.count > kMostCount) throw std::invalid_argument("count is not from 1 to 1000");
  if (options.below && !(*options.below > 0 && *options.below <= 1e4))
    throw std::invalid_argument("below is not a positive number of at most 10000");
  if (options.digits && (*options.digits < 1 || *options.digits > kMostDigits))
    throw std::invalid_argument("digits is not from 1 to 10");
  if (!options.phases.empty() && options.digits.value_or(kDigitsOfMatrices) > kMostDigitsWithPhases)
    throw std::invalid_argument("digits is not from 1 to 3, and with phases there are no more");
  if (options.box && options.phases.empty()) throw std::invalid_argument("box is given without phases");
  if (options.box && (*options.box <= 0 || *options.box > Rational(1, 2)))
    throw std::invalid_argument("box is not more than 0 and at most 1/2");
  if (!options.epsilon) return;
  const auto epsilon = static_cast<double>(options.epsilon->value());
  if (many_digits(options) && epsilon > kGreatestEpsilon)
    throw NetError("epsilon is more than 1, which is too much for more than 2 digits");
  // A net has about so many triangles (thesis, Theorem III.1 and IV.6.2).
  const double triangles = 2 * 0.54 * 16 * (genus - 1) / (epsilon * epsilon);
  if (triangles > kMostTriangles) throw NetError("epsilon is so small that a net has more than 10000000 triangles");
}

/// In which the rows of the matrices are eliminated. The same for all phases.
struct Orders {
  std::vector<std::uint32_t> sides;
  std::vector<std::uint32_t> vertices;
};

/// The triangles at one size, and what their matrices say of the first eigenvalues, those that are left out excepted.
struct Level {
  /// With phases `turns` are those of the labels.
  Level(const NetGeometry& geometry, std::uint32_t times, const std::vector<double>& turns)
      : halvings(times),
        elements(geometry, times, turns),
        lower(elements.lower()),
        upper(elements.upper()),
        interpolation(elements.interpolation()) {}

  /// σ for which the eigenvalues that are counted are those less than τ.
  [[nodiscard]] double sigma(double tau) const { return sigma_for(tau, interpolation); }

  std::uint32_t halvings;
  Elements elements;
  ElementMatrices lower;
  ElementMatrices upper;
  double interpolation;
  std::shared_ptr<const Orders> orders = {};
  std::vector<double> least = {};      ///< λ_k is at least that,
  std::vector<double> greatest = {};   ///< at most that,
  std::vector<double> estimates = {};  ///< and about that.
  Eigen::MatrixXd vectors = {};        ///< By vertex and k; without phases.
};

/// Eigenvalues k = first, …, last − 1 that are near each other, as places in the lists of a level.
struct Group {
  std::size_t first;
  std::size_t last;
};

/// What searches on one surface share: the net, and orders of elimination.
class SharedNet {
 public:
  SharedNet(const Surface& surface, const EigenvaluesOptions& options) : surface_(surface), options_(options) {
    set(options.epsilon.value_or(epsilon_for(surface.genus(), options)));
  }

  /// Not while a search is running.
  void set(const Length& epsilon) {
    NetOptions net_options;
    net_options.threads = options_.threads;
    // A second net is a part of making the matrices.
    net_options.progress = [&](std::string_view what, double share) {
      geometry_ ? report_matrices() : report(what, share);
    };
    certify::NetDocument net = compute_net(surface_, epsilon, net_options).document;
    geometry_.reset();
    orders_.clear();
    document_ = std::move(net);
    geometry_.emplace(document_);
  }
  [[nodiscard]] const certify::NetDocument& document() const { return document_; }
  [[nodiscard]] const NetGeometry& geometry() const { return *geometry_; }

  /// The orders for the matrices of a level.
  [[nodiscard]] std::shared_ptr<const Orders> orders(const Level& level) {
    const std::lock_guard lock(mutex_);
    std::shared_ptr<const Orders>& known = orders_[level.halvings];
    if (!known) {
      known = std::make_shared<const Orders>(
          Orders{elimination_order(level.lower.energy), elimination_order(level.upper.energy)});
    }
    return known;
  }

  void report(std::string_view what, double share) {
    const std::lock_guard lock(reporting_);
    if (options_.progress) options_.progress(what, share);
  }
  /// Reports the share of the characters for which the work is done; it never goes back.
  void report_matrices(double share = 0) {
    const std::lock_guard lock(reporting_);
    share_ = std::max(share_, share);
    if (options_.progress) options_.progress("eigenvalues of matrices", share_);
  }

 private:
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

  const Surface& surface_;
  const EigenvaluesOptions& options_;
  certify::NetDocument document_;
  std::optional<NetGeometry> geometry_;
  std::mutex mutex_;
  std::map<std::uint32_t, std::shared_ptr<const Orders>> orders_;  ///< By halvings.
  std::mutex reporting_;
  double share_ = 0;
};

/// The search for the eigenvalues of functions, or for one character.
class Search {
 public:
  Search(SharedNet& net, const EigenvaluesOptions& options, const ById<SideId, Rational>& phases, unsigned threads)
      : net_(net),
        options_(options),
        phases_(phases),
        threads_(threads),
        left_out_(left_out(options)),
        // As the last ones may be equal.
        more_(std::max(8U, options.count / 4)) {}

  /// Goes on at the present size of triangles: until the document is there but for its net, or smaller ones are needed.
  void run() {
    if (!phases_.empty() && turns_.empty()) turns_ = turns_of_labels(net_.document(), phases_);
    if (options_.below && !options_.digits) return count_below();
    const bool functions_too = many_digits(options_);
    while (!done_ && excess_ <= 1) {
      const std::optional<Level> level = separated(functions_too);
      if (!level) continue;
      const std::vector<Group> groups = groups_of(*level, functions_too);
      std::vector<std::optional<std::vector<Eigenfunctions>>> rows(groups.size());
      if (functions_too) rows = functions(*level, groups);
      write(*level, groups, rows);
    }
  }

  [[nodiscard]] bool is_done() const { return done_; }
  /// How much narrower enclosures must be; at most 1 if that is not known.
  [[nodiscard]] double excess() const { return excess_; }
  [[nodiscard]] std::uint32_t halvings() const { return halvings_; }
  /// Begins again with triangles of another size.
  void continue_with(std::uint32_t halvings) {
    halvings_ = halvings;
    excess_ = 0;
    done_ = false;
    turns_.clear();
    document_ = {};
  }
  [[nodiscard]] EigenvaluesDocument document() {
    EigenvaluesDocument result = std::move(document_);
    result.net = net_.document();
    return result;
  }

 private:
  [[nodiscard]] Level level(std::uint32_t halvings) const {
    const double triangles = static_cast<double>(net_.document().triangles.size()) * std::pow(4.0, halvings);
    if (triangles > kMostTriangles) {
      throw NetError(std::string(options_.below ? "an eigenvalue is so near to the bound"
                                                : "the eigenvalues are so near to each other") +
                     " that to tell them apart takes more than 10000000 triangles");
    }
    net_.report_matrices();
    Level result(net_.geometry(), halvings, turns_);
    if (!std::isfinite(result.interpolation)) {
      const bool too_large = options_.epsilon && static_cast<double>(options_.epsilon->value()) > kGreatestEpsilon;
      throw NetError(too_large ? kTooLarge : kRounding);
    }
    result.orders = net_.orders(result);
    return result;
  }

  /// A level at which so many eigenvalues are told from the others, and enclosed as narrowly as is asked for; nothing
  /// if the present one is not.
  [[nodiscard]] std::optional<Level> separated(bool functions_too) {
    Level now = level(halvings_);
    std::uint32_t count = options_.count;
    if (options_.below) {
      const certify::Inertia below =
          inertia(now.upper, now.orders->vertices, *options_.below, certify::Bound::lower, threads_);
      count = std::max(below.negative, left_out_ + 1) - left_out_;
    }
    const std::uint32_t asked = count + more_;
    if (now.elements.vertices() < 4 * asked) {
      ++halvings_;
      return std::nullopt;
    }
    bound(now, asked);
    const auto end = end_of(now, count, functions_too);
    const double excess = end ? excess_of(now, *end, functions_too) : HUGE_VAL;
    if (excess <= 1) {
      now.least.resize(*end + 1);
      now.greatest.resize(*end + 1);
      now.estimates.resize(*end + 1);
      return now;
    }
    before_ = now.greatest;
    if (!end) {
      ++halvings_;
      more_ += std::max(8U, count / 4);
    } else if (functions_too) {
      ++halvings_;
    } else {
      // Those that are told from the others will be so by smaller triangles.
      more_ = std::max(static_cast<std::uint32_t>(*end), count) + 2 - count;
      excess_ = excess;
    }
    return std::nullopt;
  }

  /// Sets what the matrices of a level say of the first eigenvalues.
  void bound(Level& now, std::uint32_t asked) const {
    std::array<DiscreteSpectrum, 2> spectra;
    certify::for_each_parallel(spectra.size(), threads_, [&](unsigned, std::size_t i) {
      spectra[i] = i == 0 ? first_eigenvalues(now.lower, now.orders->sides, asked + left_out_)
                          : first_eigenvalues(now.upper, now.orders->vertices, asked + left_out_);
    });
    const auto& [lower, upper] = spectra;
    for (std::size_t k = 0; k < asked; ++k) {
      const double mu = lower.values[k + left_out_];
      const double greatest = upper.values[k + left_out_];
      now.least.push_back(mu / (1 + now.interpolation * mu));
      now.greatest.push_back(greatest);
      // The error of the matrices is divided by four with each halving.
      const double above = k < before_.size() ? (4 * greatest - before_[k]) / 3 : greatest;
      now.estimates.push_back(std::clamp(above, now.least.back(), std::max(now.least.back(), greatest)));
    }
    if (phases_.empty()) now.vectors = upper.vectors.rightCols(upper.vectors.cols() - 1);
  }

  /// How much wider than is asked for the widest of the first n enclosures is.
  [[nodiscard]] double excess_of(const Level& now, std::size_t n, bool functions_too) const {
    if (n == 0) return 0;
    double widest = 0;
    // Functions are sought from estimates.
    for (std::size_t k = functions_too ? n - 1 : 0; k < n; ++k) {
      if (!phases_.empty() && now.greatest[k] < kNearZero) continue;
      widest = std::max(widest, (now.greatest[k] - now.least[k]) / now.least[k]);
    }
    // What matrices say is stated with a margin on both sides.
    return functions_too ? widest / kGreatestError
                         : (widest + 2 * kMargin) * std::pow(10.0, options_.digits.value_or(kDigitsOfMatrices));
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
    const auto in_each = std::max(1U, threads_ / static_cast<unsigned>(groups.size()));
    const LocalFunctions local(net_.geometry(), level.estimates.back(), options_.digits.value_or(9), in_each);
    std::size_t done = 0;
    std::mutex reporting;
    certify::for_each_parallel(groups.size(), threads_, [&](unsigned, std::size_t i) {
      result[i] = functions(level, groups[i], local);
      const std::lock_guard lock(reporting);
      net_.report("eigenfunctions", static_cast<double>(++done) / static_cast<double>(groups.size()));
    });
    return result;
  }

  /// Nothing unless all are found.
  [[nodiscard]] std::optional<std::vector<Eigenfunctions>> functions(const Level& level, const Group& group,
                                                                     const LocalFunctions& local) const {
    const auto vertices = static_cast<Eigen::Index>(net_.document().vertices.size());
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
        if (part.in.lower > 0) at_most(level, part.in.lower, part.first);
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
      const certify::Inertia least = inertia(now.upper, now.orders->vertices, below, certify::Bound::lower, threads_);
      // 0 is less, if it is left out.
      const std::uint32_t certainly = least.proved ? std::max(least.negative, left_out_) : left_out_;
      const certify::Inertia most =
          inertia(now.lower, now.orders->sides, sigma, certify::Bound::upper, threads_, certainly);
      if (!most.proved) continue;
      if (most.negative > certainly) {
        // Smaller triangles have more rows with pivots that are near 0.
        worse = most.negative - certainly > before ? worse + 1 : 0;
        if (worse == kMostTimes) throw NetError(kRounding);
        before = most.negative - certainly;
        continue;
      }
      const std::size_t count = certainly - left_out_;
      at_most(now, below, count);
      if (count > 0) {
        at_least(below, count);
        document_.eigenvalues.push_back({{0, below}, static_cast<std::uint32_t>(count)});
      }
      document_.next = below;
      return finish(now);
    }
  }

  /// A number that all but the first k are at least, which `certify` can prove: near the bound of the matrices, and
  /// more than `from`, which that is. Where a pivot is too near 0 for a proof, or λ is so small that rounding counts, a
  /// number beside serves.
  [[nodiscard]] double proved_least(const Level& level, std::size_t k, double from) const {
    const double bound = level.least[k];
    if (!phases_.empty() && bound < kNearZero) return 0;
    const std::uint64_t most = k + left_out_;
    double below = 0;
    double margin = kMargin;
    for (int i = 1; i <= kMostTrials; ++i, margin *= 4) {
      below = bound - std::min(margin * bound, (bound - from) * i / (i + 1));
      const certify::Inertia found =
          inertia(level.lower, level.orders->sides, level.sigma(below), certify::Bound::upper, threads_, most);
      if (found.proved && found.negative <= most) break;
    }
    return below;
  }

  /// The same for a number that the first k are less than.
  [[nodiscard]] double proved_greatest(const Level& level, std::size_t k) const {
    const double bound = phases_.empty() ? level.greatest[k - 1] : std::max(level.greatest[k - 1], kNearZero);
    const std::uint64_t least = k + left_out_;
    double below = 0;
    double margin = kMargin;
    for (int i = 1; i <= kMostTrials; ++i, margin *= 4) {
      below = bound * (1 + margin);
      const certify::Inertia found =
          inertia(level.upper, level.orders->vertices, below, certify::Bound::lower, threads_, least);
      if (found.proved && found.negative >= least) break;
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
    document_.side_order = level.orders->sides;
    if (!document_.at_least.empty()) document_.vertex_order = level.orders->vertices;
    for (const Rational& phase : phases_) document_.phases.push_back(phase.str());
    done_ = true;
  }

  static constexpr int kMostTrials = 5;
  static constexpr double kMargin = 3e-4;         ///< Relative; shifts of the matrices by rounding are less.
  static constexpr double kError = 0.01;          ///< Relative, of estimates.
  static constexpr double kGreatestError = 0.12;  ///< Between the matrices' bounds.

  SharedNet& net_;
  const EigenvaluesOptions& options_;
  const ById<SideId, Rational>& phases_;  ///< Empty for functions on the surface.
  unsigned threads_;
  std::uint32_t left_out_;
  std::uint32_t more_;          ///< Eigenvalues that are computed beyond those that are asked for.
  std::uint32_t halvings_ = 0;  ///< Of the present level.
  std::vector<double> turns_;   ///< By label, its phase.
  std::vector<double> before_;  ///< About what the matrices say that were halved once less: at most that.
  double excess_ = 0;
  bool done_ = false;
  EigenvaluesDocument document_;  ///< Without its net.
};

/// Makes triangles so small that enclosures, which are as wide as triangles are large, are narrower by about this
/// factor, or some of it. Halving alone may make four times as many as are needed; so the net becomes finer, if it may.
/// Returns how often they are to be halved, and the factor that is left to a net.
std::pair<std::uint32_t, double> finer(std::uint32_t halvings, double factor, bool net_may) {
  constexpr double kMost = 12;  // Predictions from large triangles are bad.
  constexpr double kRoom = 1.1;
  // Nearly as much as halving once more.
  constexpr double kByNet = 3;
  double rest = std::min(net_may ? kRoom * factor : factor, kMost);
  for (; rest > (net_may ? kByNet : 1); rest /= 4) ++halvings;
  return {halvings, std::max(rest, 1.0)};
}

/// Runs searches that share a net until all are done.
void run_all(SharedNet& net, std::vector<Search>& searches, const EigenvaluesOptions& options) {
  const unsigned threads = certify::thread_count(options.threads);
  for (;;) {
    std::vector<Search*> open;
    for (Search& search : searches) {
      if (!search.is_done()) open.push_back(&search);
    }
    if (open.empty()) return;
    std::atomic<std::size_t> ended = searches.size() - open.size();
    certify::for_each_parallel(open.size(), threads, [&](unsigned, std::size_t i) {
      open[i]->run();
      if (open[i]->is_done() && searches.size() > 1)
        net.report_matrices(static_cast<double>(++ended) / static_cast<double>(searches.size()));
    });
    std::vector<Search*> coarse;
    double excess = 1;
    for (Search* search : open) {
      if (search->excess() <= 1) continue;
      coarse.push_back(search);
      excess = std::max(excess, search->excess());
    }
    if (coarse.empty()) continue;
    // A finer net is one for all.
    constexpr std::size_t kFew = 8;
    const bool net_may = !options.epsilon && kFew * coarse.size() >= searches.size();
    const auto [halvings, rest] = finer(coarse.front()->halvings(), excess, net_may);
    if (net_may && rest > 1) {
      // A decimal of few digits.
      constexpr double kDigits = 1e4;
      net.set(Length(std::floor(net.geometry().epsilon().get_d() / std::sqrt(rest) * kDigits) / kDigits));
      for (Search& search : searches) search.continue_with(halvings);
    } else {
      for (Search* search : coarse) search->continue_with(finer(search->halvings(), search->excess(), false).first);
    }
  }
}

}  // namespace

EigenvaluesDocument unproved::eigenvalues(const Surface& surface, const EigenvaluesOptions& options) {
  check(options, surface.genus());
  const ById<SideId, Rational> phases =
      options.phases.empty() ? ById<SideId, Rational>() : phases_of_sides(surface, options.phases);
  SharedNet net(surface, options);
  std::vector<Search> searches;
  searches.emplace_back(net, options, phases, certify::thread_count(options.threads));
  run_all(net, searches, options);
  EigenvaluesDocument result = searches.front().document();
  if (options.box) widen(result, CharacterDirections(surface, net.geometry()), *options.box);
  return result;
}

Certified<EigenvaluesDocument> eigenvalues(const Surface& surface, const EigenvaluesOptions& options) {
  EigenvaluesDocument document = unproved::eigenvalues(surface, options);
  try {
    certify::Certificate certificate = proof_of(document, options.threads, options.progress);
    return {std::move(document), std::move(certificate)};
  } catch (const NotCertifiedError& error) {
    if (error.certificate().verdict != certify::Verdict::undecided || error.certificate().rule != "eigenfunctions")
      throw;
  }
  // The checker may not take as much work as the functions need, near a short closed geodesic: matrices alone.
  EigenvaluesOptions rough = options;
  rough.digits = kDigitsOfMatrices;
  return proved(unproved::eigenvalues(surface, rough), options.threads, options.progress);
}

std::vector<TorusPoint> torus_path(const std::vector<TorusPoint>& corners, std::uint32_t steps) {
  if (corners.empty()) throw std::invalid_argument("a path has no corner");
  if (steps == 0) throw std::invalid_argument("steps is not positive");
  std::vector<TorusPoint> result{corners.front()};
  for (std::size_t i = 1; i < corners.size(); ++i) {
    const TorusPoint& from = corners[i - 1];
    const TorusPoint& to = corners[i];
    if (from.size() != to.size()) throw std::invalid_argument("points of a path have different numbers of phases");
    for (std::uint32_t step = 1; step <= steps; ++step) {
      TorusPoint& point = result.emplace_back();
      for (std::size_t j = 0; j < from.size(); ++j)
        point.push_back(from[j] + (to[j] - from[j]) * Rational(step) / steps);
    }
  }
  return result;
}

std::vector<std::vector<Interval>> bands(const Surface& surface, const std::vector<TorusPoint>& points,
                                         const BandsOptions& options) {
  std::vector<std::vector<Interval>> result(points.size());
  if (points.empty()) return result;
  EigenvaluesOptions of_each{.count = options.count,
                             .digits = options.digits.value_or(kDigitsOfMatrices),
                             .epsilon = options.epsilon,
                             .phases = points.front(),
                             .threads = options.threads,
                             .progress = options.progress};
  check(of_each, surface.genus());
  std::vector<ById<SideId, Rational>> phases;
  phases.reserve(points.size());
  for (const TorusPoint& point : points) phases.push_back(phases_of_sides(surface, point));
  SharedNet net(surface, of_each);
  const unsigned threads = certify::thread_count(options.threads);
  const auto in_each = static_cast<unsigned>(std::max<std::size_t>(1, threads / points.size()));
  std::vector<Search> searches;
  searches.reserve(phases.size());
  for (const ById<SideId, Rational>& of_point : phases) searches.emplace_back(net, of_each, of_point, in_each);
  run_all(net, searches, of_each);
  std::mutex mutex;
  std::size_t done = 0;
  certify::for_each_parallel(points.size(), threads, [&](unsigned, std::size_t i) {
    const EigenvaluesDocument document = searches[i].document();
    (void)proof_of(document, in_each);
    for (const auto& [in, count] : document.eigenvalues)
      result[i].insert(result[i].end(), std::min<std::size_t>(count, options.count - result[i].size()), in);
    const std::lock_guard lock(mutex);
    if (options.each) options.each(i, document);
    net.report("certificates", static_cast<double>(++done) / static_cast<double>(points.size()));
  });
  return result;
}

}  // namespace epsnet
