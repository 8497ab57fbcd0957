#include "certify/gluing_check.h"

#include <algorithm>
#include <compare>
#include <set>
#include <span>
#include <string>

#include "certify/document/darts.h"
#include "certify/numbers/parallel.h"
#include "certify/surface_check.h"

namespace epsnet::certify {
namespace {

/// The equation L_a L_b⁻¹ = L_c L_d⁻¹ of isometries from chart `chart`.
struct Equation {
  std::array<std::uint32_t, 4> labels;
  std::uint32_t chart;
  auto operator<=>(const Equation&) const = default;
};

struct Item {
  Equation equation;
  std::uint32_t dart;  ///< The first dart with this equation.
  Tri holds = Tri::unknown;
};

/// Numbers in increasing order, each once.
class SortedNumbers {
 public:
  /// add(x, numbers) appends the numbers of x, for every x of the range.
  template <class Range, class Add>
  SortedNumbers(const Range& range, const Add& add) {
    for (const auto& x : range) add(x, numbers_);
    std::sort(numbers_.begin(), numbers_.end());
    numbers_.erase(std::unique(numbers_.begin(), numbers_.end()), numbers_.end());
  }

  [[nodiscard]] std::size_t size() const { return numbers_.size(); }
  [[nodiscard]] std::uint32_t operator[](std::size_t i) const { return numbers_[i]; }
  [[nodiscard]] std::size_t index(std::uint32_t number) const {
    return static_cast<std::size_t>(std::lower_bound(numbers_.begin(), numbers_.end(), number) - numbers_.begin());
  }
  [[nodiscard]] std::span<const std::uint32_t> values() const { return numbers_; }

 private:
  std::vector<std::uint32_t> numbers_;
};

/// The equations that are not trivial, each with its first dart, in the order of these.
std::vector<Item> collect(const NetDocument& document) {
  std::set<Equation> seen;
  std::vector<Item> items;
  for (std::uint32_t dart = 0; dart < 3 * document.triangles.size(); ++dart) {
    const std::uint32_t other = opposite(document, dart);
    if (other < dart) continue;
    const std::uint32_t a = corner_label(document, dart);
    const std::uint32_t b = corner_label(document, next_dart(other));
    const std::uint32_t c = corner_label(document, next_dart(dart));
    const std::uint32_t d = corner_label(document, other);
    // The same numbers twice: the same products; and a label times its own inverse is 1. Label number 0 counts as a
    // number here: for it, the charts at its two ends are the same one.
    if ((a == c && b == d) || (a == b && c == d)) continue;
    const Equation equation{{a, b, c, d}, chart_of_triangle(document, other / 3)};
    if (seen.insert(equation).second) items.push_back({equation, dart});
  }
  return items;
}

/// Whether L_a L_b⁻¹ = L_c L_d⁻¹, from the displacement of `base`, the inscribed disk's centre, by their quotient. A
/// label that is null is the identity.
Tri holds(const std::array<const BallIsometry*, 4>& labels, const BallIsometry& base, const Ball& sinh_radius,
          slong precision) {
  const auto quotient = [&](const BallIsometry* f, const BallIsometry* g) {
    BallIsometry result = g == nullptr ? base : compose(inverse(*g), base, precision);
    return f == nullptr ? result : compose(*f, result, precision);
  };
  const BallIsometry difference =
      compose(inverse(quotient(labels[2], labels[3])), quotient(labels[0], labels[1]), precision);
  return is_identity(difference, sinh_radius, precision);
}

std::string edge_text(const Item& item) {
  const auto& l = item.equation.labels;
  return "the edge of dart " + std::to_string(item.dart) + " (triangle " + std::to_string(item.dart / 3) +
         "), labels " + std::to_string(l[0]) + ", " + std::to_string(l[2]) + " on one side and " +
         std::to_string(l[1]) + ", " + std::to_string(l[3]) + " on the other";
}

}  // namespace

Tri is_identity(const BallIsometry& element, const Ball& sinh_radius, slong precision) {
  Ball displacement, bound;
  half_displacement_squared(displacement.get(), element, precision);
  arb_sqr(bound.get(), sinh_radius.get(), precision);
  // sinh²(d/2) < sinh²(r) with the displacement d and the radius r: d < 2r, so the quotient is 1.
  if (certainly_less(displacement.get(), bound.get()) == Tri::yes) return Tri::yes;
  return certainly_positive(displacement.get()) == Tri::yes ? Tri::no : Tri::unknown;
}

GluingOutcome check_gluing(const NetDocument& document, const LabelEvaluator& evaluator, const LabelParts& parts,
                           long max_precision, unsigned threads) {
  std::vector<Item> items = collect(document);
  GluingOutcome outcome;
  outcome.report.rule = "gluing";
  outcome.identities = items.size();
  outcome.max_precision = 0;

  // One disk for each tile that carries an equation; a tile without a disk (never seen) leaves its equations undecided.
  const SortedNumbers charts(items, [](const Item& item, auto& numbers) { numbers.push_back(item.equation.chart); });
  const SortedNumbers tiles(
      items, [&](const Item& item, auto& numbers) { numbers.push_back(document.charts[item.equation.chart].tile); });
  std::vector<std::optional<InscribedDisk>> disks(tiles.size());
  const auto disk_of = [&](std::uint32_t chart) -> const std::optional<InscribedDisk>& {
    return disks[tiles.index(document.charts[chart].tile)];
  };

  std::vector<std::size_t> pending(items.size());
  for (std::size_t i = 0; i < pending.size(); ++i) pending[i] = i;
  std::string why = ", with " + std::to_string(max_precision) + " bits";
  try {
    for_each_parallel(tiles.size(), threads, [&](unsigned, std::size_t i) {
      disks[i] = inscribed_disk(document.surface, tiles[i], max_precision, parts.budget);
    });
    for (slong precision = 64; !pending.empty(); precision = std::min(2 * precision, max_precision)) {
      const auto bits_used = static_cast<std::uint64_t>(precision);
      parts.budget.spend(100 * ball_work(bits_used), pending.size());
      for (const std::uint32_t chart : charts.values()) {
        const std::size_t disk_bits = disk_of(chart) ? bits(disk_of(chart)->centre) : 0;
        parts.budget.spend(to_balls_work(bits(parts.frames[chart]) + disk_bits, bits_used));
      }
      outcome.max_precision = bits_used;
      const SortedNumbers numbers(pending, [&](std::size_t i, auto& result) {
        for (const std::uint32_t number : items[i].equation.labels) {
          if (number != 0) result.push_back(number);
        }
      });
      const std::vector<BallIsometry> labels =
          evaluator.evaluate(numbers.values(), precision, std::min(4 * precision, 2 * max_precision), threads);
      // From 0 to the disk's centre, in the coordinates of each chart.
      std::vector<BallIsometry> bases(charts.size());
      for_each_parallel(charts.size(), threads, [&](unsigned, std::size_t i) {
        const auto& disk = disk_of(charts[i]);
        if (disk) {
          bases[i] = to_balls(compose(inverse(parts.frames[charts[i]]), translation_to(disk->centre)), precision);
        }
      });
      for_each_parallel(pending.size(), threads, [&](unsigned, std::size_t p) {
        Item& item = items[pending[p]];
        const auto& disk = disk_of(item.equation.chart);
        if (!disk) return;
        std::array<const BallIsometry*, 4> factors{};
        for (std::size_t i = 0; i < 4; ++i) {
          const std::uint32_t number = item.equation.labels[i];
          factors[i] = number == 0 ? nullptr : &labels[numbers.index(number)];
        }
        item.holds = holds(factors, bases[charts.index(item.equation.chart)], disk->sinh_radius, precision);
      });
      const auto wrong =
          std::find_if(items.begin(), items.end(), [](const Item& item) { return item.holds == Tri::no; });
      // Only an equation before the first that is wrong can change the answer.
      std::erase_if(pending, [&](std::size_t i) {
        return items[i].holds != Tri::unknown || items.begin() + static_cast<std::ptrdiff_t>(i) > wrong;
      });
      if (precision >= max_precision) break;
    }
  } catch (const BudgetSpent& spent) {
    why = std::string(": ") + spent.what();
  }

  for (const Tri wrong : {Tri::no, Tri::unknown}) {
    const auto found = std::find_if(items.begin(), items.end(), [&](const Item& item) { return item.holds == wrong; });
    if (found == items.end()) continue;
    outcome.report.verdict = wrong == Tri::no ? Verdict::refuted : Verdict::undecided;
    outcome.report.text =
        edge_text(*found) + (wrong == Tri::no ? ": the two triangles do not fit, the labels differ in the group"
                                              : ": not decided whether the labels agree in the group" + why);
    return outcome;
  }
  outcome.report.verdict = Verdict::verified;
  outcome.report.text = "the triangles fit across every edge; " + std::to_string(items.size()) +
                        " different equations of labels hold in the group of the surface";
  return outcome;
}

}  // namespace epsnet::certify
