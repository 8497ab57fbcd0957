#include "certify/net/gluing_check.h"

#include <algorithm>
#include <compare>
#include <iterator>
#include <numeric>
#include <set>
#include <string>

#include "certify/base/counted.h"
#include "certify/net/darts.h"
#include "certify/net/surface_check.h"
#include "certify/numbers/parallel.h"
#include "certify/numbers/precision.h"

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

bool has_no_label(const NetDocument::Triangle& triangle) { return triangle.label[0] == 0 && triangle.label[1] == 0; }

/// The equations of darts of triangles from the first to before the last one that are not trivial, each with its first
/// dart, in the order of these.
std::vector<Item> collect(const NetDocument& document, std::size_t first, std::size_t last) {
  std::set<Equation> seen;
  std::vector<Item> items;
  for (auto t = static_cast<std::uint32_t>(first); t < last; ++t) {
    const NetDocument::Triangle& triangle = document.triangles[t];
    for (std::uint32_t dart = 3 * t; dart < 3 * t + 3; ++dart) {
      const std::uint32_t other = triangle.opposite[dart - 3 * t];
      if (other < dart) continue;
      if (has_no_label(triangle) && has_no_label(triangle_at(document, other / 3))) continue;
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
  }
  return items;
}

/// The equations of all darts.
std::vector<Item> collect(const NetDocument& document, unsigned threads) {
  std::set<Equation> seen;
  std::vector<Item> items;
  for (const std::vector<Item>&some :
       results_of_blocks(document.triangles.size(), threads,
                         [&](std::size_t first, std::size_t last) { return collect(document, first, last); })) {
    std::copy_if(some.begin(), some.end(), std::back_inserter(items),
                 [&](const Item& item) { return seen.insert(item.equation).second; });
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

/// The equations, and which of them hold.
class GluingChecker {
 public:
  GluingChecker(const NetDocument& document, const LabelEvaluator& evaluator, const LabelParts& parts,
                long max_precision, unsigned threads)
      : document_(document),
        evaluator_(evaluator),
        parts_(parts),
        max_precision_(max_precision),
        threads_(threads),
        items_(collect(document, threads)),
        pending_(items_.size()),
        charts_(increasing(items_, [](const Item& item, auto& charts) { charts.push_back(item.equation.chart); })),
        tiles_(increasing(charts_, [&](std::uint32_t c, auto& tiles) { tiles.push_back(document.charts[c].tile); })),
        disks_(tiles_.size()) {
    std::iota(pending_.begin(), pending_.end(), std::size_t{0});
  }

  GluingOutcome run() {
    std::string why = ", with " + std::to_string(max_precision_) + " bits";
    try {
      find_disks();
      const auto attempt = [&](slong precision) {
        decide(precision);
        return pending_.empty();
      };
      if (!pending_.empty()) with_rising_precision(max_precision_, attempt);
    } catch (const BudgetSpent& spent) {
      why = std::string(": ") + spent.what();
    }
    return {report(why), items_.size(), bits_used_};
  }

 private:
  /// One disk for each tile that carries an equation; a tile without a disk (never seen) leaves its equations
  /// undecided.
  void find_disks() {
    for_each_parallel(tiles_.size(), threads_, [&](unsigned, std::size_t i) {
      disks_[i] = inscribed_disk(document_.surface, tiles_[i], max_precision_, parts_.budget);
    });
  }

  [[nodiscard]] const std::optional<InscribedDisk>& disk_of(std::uint32_t chart) const {
    return disks_[place_of(document_.charts[chart].tile, tiles_)];
  }

  /// Asks all that are pending, and forgets those that are decided.
  void decide(slong precision) {
    spend(precision);
    bits_used_ = static_cast<std::uint64_t>(precision);
    const std::vector<std::uint32_t> numbers = increasing(pending_, [&](std::size_t i, auto& result) {
      for (const std::uint32_t number : items_[i].equation.labels) {
        if (number != 0) result.push_back(number);
      }
    });
    const std::vector<BallIsometry> labels =
        evaluator_.evaluate(numbers, precision, std::min(4 * precision, 2 * max_precision_), threads_);
    const std::vector<BallIsometry> bases = bases_of_charts(precision);
    for_each_parallel(pending_.size(), threads_, [&](unsigned, std::size_t p) {
      Item& item = items_[pending_[p]];
      const auto& disk = disk_of(item.equation.chart);
      if (!disk) return;
      std::array<const BallIsometry*, 4> factors{};
      for (std::size_t i = 0; i < 4; ++i) {
        const std::uint32_t number = item.equation.labels[i];
        factors[i] = number == 0 ? nullptr : &labels[place_of(number, numbers)];
      }
      item.holds = holds(factors, bases[place_of(item.equation.chart, charts_)], disk->sinh_radius, precision);
    });
    forget_decided();
  }

  void spend(slong precision) const {
    const auto bits_used = static_cast<std::uint64_t>(precision);
    parts_.budget.spend(100 * ball_work(bits_used), pending_.size());
    for (const std::uint32_t chart : charts_) {
      const std::size_t disk_bits = disk_of(chart) ? bits(disk_of(chart)->centre) : 0;
      parts_.budget.spend(to_balls_work(bits(parts_.frames[chart]) + disk_bits, bits_used));
    }
  }

  /// From 0 to the disk's centre, in the coordinates of each chart.
  [[nodiscard]] std::vector<BallIsometry> bases_of_charts(slong precision) const {
    std::vector<BallIsometry> bases(charts_.size());
    for_each_parallel(charts_.size(), threads_, [&](unsigned, std::size_t i) {
      const auto& disk = disk_of(charts_[i]);
      if (disk) {
        bases[i] = to_balls(compose(inverse(parts_.frames[charts_[i]]), translation_to(disk->centre)), precision);
      }
    });
    return bases;
  }

  /// Only an equation before the first that is wrong can change the answer.
  void forget_decided() {
    const auto wrong =
        std::find_if(items_.begin(), items_.end(), [](const Item& item) { return item.holds == Tri::no; });
    std::erase_if(pending_, [&](std::size_t i) {
      return items_[i].holds != Tri::unknown || items_.begin() + static_cast<std::ptrdiff_t>(i) > wrong;
    });
  }

  [[nodiscard]] RuleReport report(const std::string& why) const {
    for (const Tri wrong : {Tri::no, Tri::unknown}) {
      const auto found =
          std::find_if(items_.begin(), items_.end(), [&](const Item& item) { return item.holds == wrong; });
      if (found == items_.end()) continue;
      return {"gluing", wrong == Tri::no ? Verdict::refuted : Verdict::undecided,
              edge_text(*found) + (wrong == Tri::no ? ": the two triangles do not fit, the labels differ in the group"
                                                    : ": not decided whether the labels agree in the group" + why)};
    }
    return {"gluing", Verdict::verified,
            "the triangles fit across every edge; " +
                counted(items_.size(), "equation of labels holds", "different equations of labels hold") +
                " in the group of the surface"};
  }

  const NetDocument& document_;
  const LabelEvaluator& evaluator_;
  const LabelParts& parts_;
  slong max_precision_;
  unsigned threads_;
  std::vector<Item> items_;
  std::vector<std::size_t> pending_;  ///< Those that are not decided and matter.
  std::vector<std::uint32_t> charts_;
  std::vector<std::uint32_t> tiles_;
  std::vector<std::optional<InscribedDisk>> disks_;  ///< By place in tiles_.
  std::uint64_t bits_used_ = 0;
};

}  // namespace

Tri is_identity(const BallIsometry& element, const Ball& sinh_radius, slong precision) {
  const Precision scope(precision);
  // sinh²(d/2) = |b|² < sinh²(r) with the displacement d and the radius r: d < 2r, so the quotient is 1.
  const Ball displacement = norm(element.b);
  if (certainly_less(displacement, sqr(sinh_radius)) == Tri::yes) return Tri::yes;
  return certainly_positive(displacement) == Tri::yes ? Tri::no : Tri::unknown;
}

GluingOutcome check_gluing(const NetDocument& document, const LabelEvaluator& evaluator, const LabelParts& parts,
                           long max_precision, unsigned threads) {
  return GluingChecker(document, evaluator, parts, max_precision, threads).run();
}

}  // namespace epsnet::certify
