#include "netgen/eigenvalues/eigenvalues.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "certify/base/text.h"
#include "netgen/eigenvalues/eigenfunction.h"
#include "netgen/eigenvalues/prover.h"
#include "netgen/eigenvalues/trace_matrices.h"
#include "netgen/geodesics/geodesics.h"
#include "netgen/nets/certified_net.h"

namespace epsnet {
namespace {

using certify::EigenvaluesDocument;
using certify::Interval;

/// For the lengths of the geodesics of the document, the shortest first. Throws LimitError if they have too many
/// multiples.
Prover prover_of(const Surface& surface, const EigenvaluesDocument& document, const RealVector& lengths) {
  constexpr double kMostMultiples = 1e6;
  const double up_to = static_cast<double>(Length(document.up_to).value());
  double multiples = 0;
  for (const Real& length : lengths) multiples += std::floor(up_to / static_cast<double>(length));
  if (multiples > kMostMultiples) {
    throw LimitError("the closed geodesics have more than 1000000 multiples of length at most " + document.up_to +
                     "; the shortest one has the length " + certify::shortest(static_cast<double>(lengths.front())));
  }
  const TestSpace space{static_cast<Real>(Length(document.up_to).value()), document.order, document.degree};
  std::vector<Interval> known;
  for (const auto& function : document.eigenfunctions) known.push_back(function.in);
  return {space, trace_matrices(space, surface.genus(), lengths), std::move(known)};
}

constexpr double kOpen = 0.98;  ///< Where at most so many eigenvalues can be, there is none, provably.

/// Finds windows with eigenvalues, gaps without, and what proves them.
class Search {
 public:
  Search(Prover& prover, const EigenvaluesOptions& options, EigenvaluesDocument& document)
      : prover_(prover), options_(options), document_(document) {}

  /// False if nothing can be said.
  [[nodiscard]] bool run() {
    find_windows();
    std::uint64_t found = 0;
    std::size_t used = 0;
    for (; used < windows_.size() && (options_.count == 0 || found < options_.count); ++used) {
      report("eigenvalues", static_cast<double>(used) / static_cast<double>(windows_.size()));
      examine(used);
      found += document_.windows.back().least;
    }
    for (std::size_t i = 0; i <= used; ++i) {
      if (!cover(gap(i))) return false;
    }
    document_.eigenvalues_up_to = gap(used).upper;
    if (used == windows_.size() && (options_.count == 0 || found < options_.count)) add_last_window(gap(used));
    return document_.eigenvalues_up_to > 0;
  }

 private:
  void report(std::string_view what, double share) const {
    if (options_.progress) options_.progress(what, share);
  }

  /// Before window i, or behind the last one.
  [[nodiscard]] Interval gap(std::size_t i) const {
    return {i == 0 ? 0.0 : windows_[i - 1].upper, i < windows_.size() ? windows_[i].lower : end_};
  }

  /// λ where bound(λ) passes kOpen between a point where it is less and one where it is not.
  [[nodiscard]] double edge(double less, double more) const {
    for (int i = 0; i < 30; ++i) {
      const double middle = (less + more) / 2;
      (prover_.most_at(middle) < kOpen ? less : more) = middle;
    }
    return less;
  }

  /// The greatest of the bounds between three points, by golden section.
  [[nodiscard]] std::pair<double, double> peak(double lower, double upper) const {
    const double ratio = (std::sqrt(5.0) - 1) / 2;
    double x = upper - ratio * (upper - lower);
    double y = lower + ratio * (upper - lower);
    double at_x = prover_.most_at(x);
    double at_y = prover_.most_at(y);
    for (int i = 0; i < 50; ++i) {
      if (at_x > at_y) {
        upper = std::exchange(y, x);
        at_y = at_x;
        x = upper - ratio * (upper - lower);
        at_x = prover_.most_at(x);
      } else {
        lower = std::exchange(x, y);
        at_x = at_y;
        y = lower + ratio * (upper - lower);
        at_y = prover_.most_at(y);
      }
    }
    return {at_x > at_y ? x : y, std::max(at_x, at_y)};
  }

  /// Windows where the bound is kOpen or more; behind each of them there is a gap, and before it there is one or 0.
  /// They end where no gap follows.
  void find_windows() {
    const double support = static_cast<double>(prover_.space().support);
    const double step = static_cast<double>(prover_.space().step());
    const double greatest = 0.25 + 8.9 / (step * step);
    const double patience = 6;  // In units of the resolution, 2π/L, of r.
    const double stride = 0.35 / support;
    struct Sample {
      double lambda;
      double bound;
    };
    std::vector<Sample> samples;
    double last_gap = 0;
    for (double root = 0; root * root < greatest; root += stride) {
      samples.push_back({root * root, prover_.most_at(root * root)});
      if (samples.back().bound < kOpen) last_gap = root;
      if (root - last_gap > patience * 6.28 / support) break;
      report("bounds", std::min(root / 5, 1.0));
    }
    // From gap to gap; a peak that the samples miss is a local maximum of theirs.
    double opened = 0;  // The lower end of a window of samples.
    end_ = 0;
    for (std::size_t i = 1; i < samples.size(); ++i) {
      const Sample& before = samples[i - 1];
      const Sample& here = samples[i];
      if (before.bound < kOpen && here.bound < kOpen) {
        end_ = here.lambda;
        if (i + 1 < samples.size() && before.bound < here.bound && samples[i + 1].bound < here.bound) {
          const auto [top, bound] = peak(before.lambda, samples[i + 1].lambda);
          if (bound >= kOpen) windows_.push_back({edge(before.lambda, top), edge(samples[i + 1].lambda, top)});
        }
      } else if (before.bound < kOpen) {
        opened = edge(before.lambda, here.lambda);
        end_ = opened;
      } else if (here.bound < kOpen) {
        windows_.push_back({opened, edge(here.lambda, before.lambda)});
        end_ = here.lambda;
      }
    }
    // A window found from a sample may reach beyond the next one, or contain a known eigenvalue; other known ones have
    // windows of their own.
    for (const Interval& in : prover_.known()) {
      if (in.upper < end_) windows_.push_back(widened(in));
    }
    std::sort(windows_.begin(), windows_.end(), [](Interval x, Interval y) { return x.lower < y.lower; });
    std::vector<Interval> merged;
    for (const Interval& window : windows_) {
      if (!merged.empty() && window.lower <= merged.back().upper) {
        merged.back().upper = std::max(merged.back().upper, window.upper);
      } else {
        merged.push_back(window);
      }
    }
    windows_ = std::move(merged);
    if (!windows_.empty() && windows_.back().upper >= end_) end_ = std::nextafter(windows_.back().upper, HUGE_VAL);
  }

  /// So that what is outside has no point in common with it.
  static Interval widened(Interval in) { return {std::nextafter(in.lower, 0.0), std::nextafter(in.upper, HUGE_VAL)}; }
  /// The known eigenvalues in an interval.
  [[nodiscard]] std::vector<Interval> known_in(Interval in) const {
    std::vector<Interval> result;
    for (const Interval& known : prover_.known()) {
      if (in.lower < known.lower && known.upper < in.upper) result.push_back(known);
    }
    return result;
  }

  void add_at_most(const Trial& trial, Interval in, double count) {
    document_.at_most.push_back({in, static_cast<std::uint32_t>(count), trial.coefficients});
  }
  void add_at_least(const Prover::Weighted& weighted, const Trial& trial, Interval within, double count) {
    document_.at_least.push_back({weighted.in(), within, static_cast<std::uint32_t>(count), trial.coefficients});
  }

  /// Statements "none" for an interval in which the bound is less than kOpen. False if the search for them fails.
  [[nodiscard]] bool cover(Interval open) {
    double from = open.lower;
    while (from < open.upper) {
      std::optional<Trial> best;
      double reached = from;
      for (const double share : {1.0, 0.7, 0.5, 0.35, 0.25, 0.15, 0.1, 0.06, 0.03, 0.015, 0.007, 0.003, 0.001, 0.0}) {
        const Trial trial = prover_.best_at(from + share * (open.upper - from), open);
        double good = from + share * (open.upper - from);
        if (prover_.most_in(trial, {from, good}) != 0) continue;
        double bad = open.upper;
        if (prover_.most_in(trial, {from, bad}) == 0) good = bad;
        for (int i = 0; i < 16 && good < bad; ++i) {
          const double middle = (good + bad) / 2;
          (prover_.most_in(trial, {from, middle}) == 0 ? good : bad) = middle;
        }
        if (good > reached) {
          reached = good;
          best = trial;
        }
        if (best) break;
      }
      if (!best) return false;
      add_at_most(*best, {from, reached}, 0);
      from = reached;
    }
    return true;
  }

  /// The least number that can be proved to be the most in an interval, and by what.
  struct Cover {
    double count;
    std::vector<std::pair<Interval, Trial>> statements;
    std::vector<double> counts;
  };
  [[nodiscard]] Cover most_in(Interval in, int depth) {
    Cover best{HUGE_VAL, {}, {}};
    const double middle = (in.lower + in.upper) / 2;
    for (const auto& points : std::vector<std::vector<double>>{
             {middle}, {in.lower}, {in.upper}, {in.lower, in.upper}, {in.lower, middle, in.upper}}) {
      const auto trial = prover_.flat_on(points, in);
      if (!trial) continue;
      const double count = prover_.most_in(*trial, in);
      if (count < best.count) best = {count, {{in, *trial}}, {count}};
    }
    if (depth == 0 || best.count <= 1) return best;
    Cover first = most_in({in.lower, middle}, depth - 1);
    const Cover second = most_in({middle, in.upper}, depth - 1);
    if (first.count + second.count >= best.count) return best;
    first.count += second.count;
    first.statements.insert(first.statements.end(), second.statements.begin(), second.statements.end());
    first.counts.insert(first.counts.end(), second.counts.begin(), second.counts.end());
    return first;
  }

  void add(const Cover& most) {
    for (std::size_t k = 0; k < most.statements.size(); ++k)
      add_at_most(most.statements[k].second, most.statements[k].first, most.counts[k]);
  }

  /// The weights that are positive around a window, and that end in the gaps around it.
  [[nodiscard]] std::vector<Prover::Weighted> weights(std::size_t i) const {
    const Interval before = gap(i);
    const Interval behind = gap(i + 1);
    std::vector<Prover::Weighted> result;
    // Rounding must not lead out of the gaps.
    for (const double share : {1.0, 0.6, 0.3}) {
      const double upper = std::min(behind.upper, behind.lower + share * (behind.upper - behind.lower));
      for (const double other : {1.0, 0.6, 0.3}) {
        const double lower =
            i == 0 ? 0.0 : std::max(before.lower, before.upper - other * (before.upper - before.lower));
        result.emplace_back(prover_, Interval{lower, upper});
        if (i == 0) break;
      }
    }
    return result;
  }

  /// Counts the eigenvalues in window i, and encloses the smallest and the greatest one if they can be counted.
  void examine(std::size_t i) {
    const Interval in = windows_[i];
    const std::vector<Interval> known = known_in(in);
    const Cover most = most_in(in, in.upper - in.lower > 0.05 ? 3 : 0);
    add(most);
    const auto count = static_cast<std::uint32_t>(most.count);
    EigenvaluesDocument::Window window{in, static_cast<std::uint32_t>(known.size()), count, in, in};
    if (window.least < count) {
      const std::vector<Prover::Weighted> all = weights(i);
      window.least = std::max(window.least, add_least(in, all, most.count));
      if (window.least == count) {
        window.greatest.lower = limit(in, all, most.count, false);
        window.smallest.upper = limit(in, all, most.count, true);
      }
    }
    for (const Interval& one : known) {
      if (window.least < count) break;
      window.smallest.upper = std::min(window.smallest.upper, widened(one).upper);
      window.greatest.lower = std::max(window.greatest.lower, widened(one).lower);
    }
    document_.windows.push_back(window);
  }

  /// The greatest number of eigenvalues in a window that can be proved, with its statement; at most `most`.
  std::uint32_t add_least(Interval in, const std::vector<Prover::Weighted>& all, double most) {
    double least = 0;
    std::optional<Trial> best;
    const Prover::Weighted* best_weight = nullptr;
    for (const Prover::Weighted& weighted : all) {
      for (const double share : {0.5, 0.0, 1.0, 0.25, 0.75}) {
        const auto trial = weighted.best_at(in.lower + share * (in.upper - in.lower));
        const double count = trial ? std::min(prover_.least_in(weighted, *trial, in), most) : 0;
        if (count <= least) continue;
        least = count;
        best = trial;
        best_weight = &weighted;
      }
    }
    if (best) add_at_least(*best_weight, *best, in, least);
    return static_cast<std::uint32_t>(least);
  }

  /// A window that ends with the first known eigenvalue behind the last gap. False if there is none.
  [[nodiscard]] bool add_known_window(Interval open) {
    for (const Interval& known : prover_.known()) {
      if (known.lower <= open.upper) continue;
      const Interval in{open.upper, widened(known).upper};
      if (!document_.windows.empty() && document_.windows.back().in.upper >= in.lower) return true;
      const Cover most = most_in(in, 3);
      if (!(most.count < 1e6)) return true;
      add(most);
      document_.windows.push_back({in, 1, static_cast<std::uint32_t>(most.count), in, in});
      document_.eigenvalues_up_to = in.upper;
      return true;
    }
    return false;
  }

  /// A window with at least one eigenvalue, behind the last gap, from where there is no gap any more.
  void add_last_window(Interval open) {
    if (add_known_window(open)) return;
    for (const double share : {0.0, 0.3, 0.6}) {
      const double from = windows_.empty() ? 0.0 : open.lower + share * (open.upper - open.lower);
      const auto test = prover_.first_behind(from, open.upper);
      if (!test) continue;
      for (const double excess : {1e-12, 1e-9, 1e-6, 1e-3}) {
        const Interval in{open.upper, test->second + excess * (test->second - open.upper)};
        const Prover::Weighted weighted(prover_, {from, in.upper});
        if (!(in.lower < in.upper) || prover_.least_in(weighted, test->first, in) < 1) continue;
        if (!document_.windows.empty() && document_.windows.back().in.upper >= in.lower) return;
        const Cover most = most_in(in, 3);
        if (!(most.count < 1e6)) return;
        add(most);
        add_at_least(weighted, test->first, in, 1);
        document_.windows.push_back({in, 1, static_cast<std::uint32_t>(most.count), in, in});
        document_.eigenvalues_up_to = in.upper;
        return;
      }
    }
  }

  /// The end of the greatest part of a window, from its lower end on or, `mirrored`, from its upper end on, for which
  /// it can be proved that not all of its eigenvalues are there.
  double limit(Interval in, const std::vector<Prover::Weighted>& all, double count, bool mirrored) {
    const double start = mirrored ? in.upper : in.lower;
    const auto part = [&](double x) { return mirrored ? Interval{x, in.upper} : Interval{in.lower, x}; };
    const auto by_most = [&](double x) -> std::optional<Trial> {
      Trial trial = prover_.best_at(x, part(x));
      return prover_.most_in(trial, part(x)) < count ? std::optional(std::move(trial)) : std::nullopt;
    };
    double reached = start;
    std::optional<Trial> best;
    const Prover::Weighted* best_weight = nullptr;
    const auto extend = [&](const auto& prove, const Prover::Weighted* weighted) {
      // Only what reaches further than what is known is of use.
      double good = reached;
      double bad = mirrored ? in.lower : in.upper;
      for (int i = 0; i < 45 && good != bad; ++i) {
        // First the place next to what is known.
        const double middle = i == 0 ? good + (bad - good) * 0x1p-20 : good + (bad - good) / 2;
        auto trial = prove(middle);
        if (!trial) {
          if (i == 0) return;
          bad = middle;
          continue;
        }
        good = middle;
        best = std::move(trial);
        best_weight = weighted;
      }
      reached = good;
    };
    extend(by_most, nullptr);
    for (const Prover::Weighted& weighted : all) {
      extend(
          [&](double x) -> std::optional<Trial> {
            auto trial = weighted.best_at(x);
            if (!trial || prover_.least_in(weighted, *trial, part(x)) <= count) return std::nullopt;
            return trial;
          },
          &weighted);
    }
    if (!best) return start;
    if (best_weight == nullptr) {
      add_at_most(*best, part(reached), count - 1);
    } else {
      add_at_least(*best_weight, *best, part(reached), count + 1);
    }
    return reached;
  }

  Prover& prover_;
  const EigenvaluesOptions& options_;
  EigenvaluesDocument& document_;
  std::vector<Interval> windows_;
  double end_ = 0;  ///< Of the gap behind the last window.
};

std::uint32_t genus_of(const EigenvaluesDocument& document) {
  return static_cast<std::uint32_t>((document.net.triangles.size() - 2 * document.net.vertices.size()) / 4 + 1);
}

/// How many eigenvalues are counted exactly, and then how narrow the first window's two enclosures together are.
using Quality = std::pair<std::uint64_t, double>;
Quality quality_of(const EigenvaluesDocument& document) {
  std::uint64_t counted = 0;
  for (const auto& window : document.windows) counted += window.least == window.most ? window.most : 0;
  if (document.windows.empty()) return {counted, -HUGE_VAL};
  const auto& first = document.windows.front();
  return {counted, -std::abs(first.smallest.upper - first.greatest.lower)};
}

using Eigenfunctions = std::vector<EigenvaluesDocument::Eigenfunction>;

/// Adds functions of the eigenvalues within `reach` of `place` that are found and not known. Returns about where the
/// nearest eigenvalue is; nothing if the search says nothing.
std::optional<double> add_near(double place, double reach, const EigenfunctionSearch& search,
                               Eigenfunctions& functions) {
  const auto is_known = [&](double lower, double upper) {
    return std::any_of(functions.begin(), functions.end(),
                       [&](const auto& known) { return lower <= known.in.upper && known.in.lower <= upper; });
  };
  const std::vector<double> guesses = search.around(place);
  if (guesses.empty()) return std::nullopt;
  const double same = 1e-4 * reach;
  for (const double guess : guesses) {
    if (std::abs(guess - place) > reach || is_known(guess - same, guess + same)) continue;
    auto function = search.near(guess);
    if (function && !is_known(function->in.lower, function->in.upper)) functions.push_back(*std::move(function));
  }
  return guesses.front();
}

/// Adds functions of eigenvalues less than `end`, as surfaces with short geodesics have them. The constant functions,
/// of the eigenvalue 0, hide them from a search at greater places; so this one goes to smaller and smaller places,
/// where the trace formula leaves room for an eigenvalue.
void add_small_eigenfunctions(double end, const Prover& prover, const EigenfunctionSearch& search,
                              Eigenfunctions& functions) {
  constexpr int kHalvings = 12;
  double place = end;
  for (int i = 0; i < kHalvings; ++i, place /= 2) {
    if (prover.most_at(place) >= kOpen) add_near(place, place / 2, search, functions);
  }
}

/// Adds functions of eigenvalues behind those that are known, in increasing order, until there are `count` or none is
/// found any more. The place from which to search on is `from`.
void add_eigenfunctions(std::size_t count, const EigenfunctionSearch& search, double& from, Eigenfunctions& functions,
                        double stride) {
  constexpr double kLast = 40;
  while (from < kLast && functions.size() < count) {
    const double middle = from + stride / 2;
    const std::optional<double> nearest = add_near(middle, 0.75 * stride, search, functions);
    if (!nearest) break;
    // Where the nearest one is far, its place is a rough estimate.
    from += std::max(stride, std::abs(*nearest - middle) / 2);
  }
  std::sort(functions.begin(), functions.end(), [](const auto& x, const auto& y) { return x.lambda < y.lambda; });
}

/// A document with a spectrum and perhaps functions, completed by windows and what proves them.
EigenvaluesDocument with_windows(const Surface& surface, const EigenvaluesOptions& options,
                                 const EigenvaluesDocument& start, const RealVector& lengths) {
  // Which order is better depends on the surface: a high one on those whose eigenvalues are far apart.
  std::optional<Quality> quality;
  EigenvaluesDocument best;
  for (const std::uint32_t order : {8U, 12U}) {
    EigenvaluesDocument document = start;
    document.order = order;
    document.windows.clear();
    document.at_most.clear();
    document.at_least.clear();
    Prover prover = prover_of(surface, document, lengths);
    if (!Search(prover, options, document).run()) continue;
    const Quality found = quality_of(document);
    if (quality && found <= *quality) continue;
    quality = found;
    best = std::move(document);
  }
  if (!quality) {
    throw NetError("nothing can be said about the eigenvalues from closed geodesics of length at most " + start.up_to +
                   "; a length of 1 or more is needed");
  }
  return best;
}

/// From closed geodesics up to one length. Functions of `last`, if there is one, are taken over.
EigenvaluesDocument eigenvalues_from(const Surface& surface, const EigenvaluesOptions& options, const Length& up_to,
                                     const EigenvaluesDocument* last) {
  GeodesicsOptions geodesics_options;
  geodesics_options.threads = options.threads;
  geodesics_options.progress = options.progress;
  EigenvaluesDocument best;
  static_cast<certify::GeodesicsDocument&>(best) = spectrum(surface, up_to, geodesics_options);
  if (last != nullptr && last->net == best.net) best.eigenfunctions = last->eigenfunctions;
  const RealVector lengths = lengths_of(surface, best);
  // A few functions, which certify checks within the work that it allows by default; more if more eigenvalues are
  // wanted than these prove.
  constexpr std::size_t kBatch = 5;
  std::optional<EigenfunctionSearch> search;
  // Throws, before any work for eigenfunctions, if next to no length was asked for.
  if (up_to.value() < 1) static_cast<void>(with_windows(surface, options, best, lengths));
  if (options.eigenfunctions && best.eigenfunctions.empty()) search.emplace(best, options.threads, options.progress);
  // Eigenvalues are about 1/(g − 1) apart.
  const double stride = 1.0 / surface.genus();
  if (search) add_small_eigenfunctions(stride / 4, prover_of(surface, best, lengths), *search, best.eigenfunctions);
  double from = 0;
  for (std::size_t wanted = options.count == 0 ? kBatch : std::min<std::size_t>(options.count + 1, kBatch);;
       wanted += kBatch) {
    if (search) add_eigenfunctions(wanted, *search, from, best.eigenfunctions, stride);
    const bool all = !search || best.eigenfunctions.size() < wanted || options.count <= kBatch;
    best = with_windows(surface, options, best, lengths);
    if (all || quality_of(best).first >= options.count) return best;
  }
}

/// How narrow the intervals of the first `count` eigenvalues are; infinite if they are not counted.
double width_of_first(const EigenvaluesDocument& document, std::uint32_t count) {
  double width = 0;
  std::uint64_t found = 0;
  for (const EigenvaluesDocument::Window& window : document.windows) {
    if (found >= count || window.least != window.most) break;
    found += window.most;
    const bool simple = window.most == 1;
    width = std::max(width, simple ? window.smallest.upper - window.greatest.lower : window.in.upper - window.in.lower);
  }
  return found >= count ? width : HUGE_VAL;
}

/// From longer and longer closed geodesics, until the width is reached or the time is used.
EigenvaluesDocument eigenvalues_from_more(const Surface& surface, const EigenvaluesOptions& options) {
  constexpr double kFirstLength = 8;
  constexpr double kLeastStep = 0.25;
  const Length greatest = options.up_to.value_or(Length(options.seconds ? "30" : "16"));
  const std::uint32_t wanted = std::max(options.count, 1U);
  const auto start = std::chrono::steady_clock::now();
  const auto elapsed = [&] { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(); };
  std::optional<EigenvaluesDocument> best;
  double reached = HUGE_VAL;
  double length = kFirstLength;
  for (double before = 0;;) {
    const bool last = greatest.value() <= length;
    const Length up_to = last ? greatest : Length(length);
    try {
      best = eigenvalues_from(surface, options, up_to, best ? &*best : nullptr);
    } catch (const LimitError&) {
      if (!best) throw;
      break;
    }
    reached = width_of_first(*best, wanted);
    if (last || (options.width && reached < *options.width)) break;
    double step = 1;
    const double now = elapsed();
    if (options.seconds) {
      // The time is at most proportional to e^L, and a check takes as long again.
      const double more = std::log(std::max(*options.seconds - now, 0.0) / (2 * (now - before)));
      step = std::min(step, std::floor(more / kLeastStep) * kLeastStep);
      if (!(step > 0)) break;
    }
    before = now;
    length += step;
  }
  if (options.width && !(reached < *options.width)) {
    const std::string which =
        wanted == 1 ? "the first eigenvalue is" : "the first " + std::to_string(wanted) + " eigenvalues are";
    throw NetError(
        which + (reached < HUGE_VAL ? " enclosed to " + certify::shortest(reached) + " only" : " not counted") +
        " by closed geodesics of length at most " + best->up_to + ", expected " + certify::shortest(*options.width));
  }
  return *std::move(best);
}

}  // namespace

EigenvaluesDocument eigenvalues(const Surface& surface, const EigenvaluesOptions& options) {
  constexpr int kLongest = 30;
  if (options.up_to && options.up_to->value() > kLongest) throw std::invalid_argument("the length is more than 30");
  if (options.width && !(*options.width > 0)) throw std::invalid_argument("the width is not positive");
  if (options.seconds && !(*options.seconds > 0)) throw std::invalid_argument("the time is not positive");
  if (options.width || options.seconds) return eigenvalues_from_more(surface, options);
  return eigenvalues_from(surface, options, options.up_to.value_or(Length("10")), nullptr);
}

std::optional<double> length_to_count_first(const EigenvaluesDocument& document) {
  if (document.windows.empty()) return std::nullopt;
  const EigenvaluesDocument::Window& first = document.windows.front();
  if (first.least == first.most) return std::nullopt;
  const double up_to = static_cast<double>(Length(document.up_to).value());
  const double area = 2 * std::numbers::pi * (genus_of(document) - 1.0);
  return std::max(up_to + 1, area / 2 * std::sqrt(std::max(0.0, first.in.upper - 0.25)) + 3);
}

std::vector<double> eigenvalue_bounds(const Surface& surface, const EigenvaluesDocument& document,
                                      const std::vector<double>& lambdas) {
  const Prover prover = prover_of(surface, document, lengths_of(surface, document));
  std::vector<double> result;
  result.reserve(lambdas.size());
  for (const double lambda : lambdas) result.push_back(prover.most_at(lambda));
  return result;
}

}  // namespace epsnet
