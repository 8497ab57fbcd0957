#include "netgen/eigenvalues/window_search.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace epsnet {
namespace {

using certify::EigenvaluesDocument;
using certify::Interval;

/// Finds windows with eigenvalues, gaps without, and what proves them.
class Search {
 public:
  Search(Prover& prover, std::uint64_t count, const Progress& progress, EigenvaluesDocument& document)
      : prover_(prover), count_(count), progress_(progress), document_(document) {}

  /// False if nothing can be said.
  [[nodiscard]] bool run() {
    find_windows();
    std::uint64_t found = 0;
    std::size_t used = 0;
    for (; used < windows_.size() && (count_ == 0 || found < count_); ++used) {
      report("eigenvalues", static_cast<double>(used) / static_cast<double>(windows_.size()));
      examine(used);
      found += document_.windows.back().least;
    }
    for (std::size_t i = 0; i <= used; ++i) {
      if (!cover(gap(i))) return false;
    }
    document_.eigenvalues_up_to = gap(used).upper;
    if (used == windows_.size() && (count_ == 0 || found < count_)) add_last_window(gap(used));
    return document_.eigenvalues_up_to > 0;
  }

 private:
  void report(std::string_view what, double share) const {
    if (progress_) progress_(what, share);
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
  std::uint64_t count_;  ///< 0: as many as there are.
  const Progress& progress_;
  EigenvaluesDocument& document_;
  std::vector<Interval> windows_;
  double end_ = 0;  ///< Of the gap behind the last window.
};

}  // namespace

bool find_windows(Prover& prover, std::uint64_t count, const Progress& progress, EigenvaluesDocument& document) {
  return Search(prover, count, progress, document).run();
}

}  // namespace epsnet
