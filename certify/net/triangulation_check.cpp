#include <algorithm>
#include <atomic>
#include <compare>
#include <iterator>
#include <numeric>
#include <set>
#include <string>
#include <vector>

#include "certify/base/text.h"
#include "certify/net/numbering.h"
#include "certify/net/rules.h"
#include "certify/net/structure.h"
#include "certify/numbers/ball.h"
#include "certify/numbers/parallel.h"

namespace epsnet::certify {
namespace {

std::string dart_name(std::size_t dart) {
  return "dart " + std::to_string(dart) + " (triangle " + std::to_string(dart / 3) + ", edge " +
         std::to_string(dart % 3) + ")";
}

/// Whether the opposite of dart 3t + i is another dart, with the opposite 3t + i, which ends where that one begins.
bool has_opposite(const NetDocument& document, std::uint32_t t, std::uint32_t i) {
  const NetDocument::Triangle& triangle = document.triangles[t];
  const std::uint32_t other = triangle.opposite[i];
  const NetDocument::Triangle& neighbour = triangle_at(document, other / 3);
  return other != 3 * t + i && neighbour.opposite[other % 3] == 3 * t + i &&
         neighbour.vertex[next_dart(other) % 3] == triangle.vertex[i];
}

/// Of a dart that has no such opposite.
std::string wrong_opposite(const NetDocument& document, std::uint32_t dart) {
  const std::uint32_t other = opposite(document, dart);
  if (other == dart) return dart_name(dart) + " is its own opposite";
  if (opposite(document, other) != dart) {
    return dart_name(dart) + " has the opposite dart " + std::to_string(other) + ", whose opposite is dart " +
           std::to_string(opposite(document, other));
  }
  return dart_name(dart) + " starts at vertex " + std::to_string(start(document, dart)) + ", but its opposite dart " +
         std::to_string(other) + " ends at vertex " + std::to_string(start(document, next_dart(other)));
}

Problem opposite_problem(const NetDocument& document, unsigned threads) {
  const auto problems =
      results_of_blocks(document.triangles.size(), threads, [&](std::size_t first, std::size_t last) -> Problem {
        for (auto t = static_cast<std::uint32_t>(first); t < last; ++t) {
          for (std::uint32_t i = 0; i < 3; ++i) {
            if (!has_opposite(document, t, i)) return wrong_opposite(document, 3 * t + i);
          }
        }
        return std::nullopt;
      });
  const auto found = std::find_if(problems.begin(), problems.end(), [](const Problem& x) { return x.has_value(); });
  return found == problems.end() ? std::nullopt : *found;
}

using AtomicNumbers = std::vector<std::atomic<std::uint32_t>>;

/// Whether the darts that leave a vertex form exactly one cycle, for all vertices: whether every vertex has a dart, and
/// the cycles of one dart of each, which have no dart in common, have all darts. Opposite darts have their ends
/// exchanged.
bool has_no_vertex_problem(const NetDocument& document, unsigned threads) {
  const std::size_t triangles = document.triangles.size();
  AtomicNumbers after_dart(document.vertices.size());  // Of each vertex some dart that leaves it, plus 1.
  for_each_block(triangles, threads, [&](std::size_t, std::size_t first, std::size_t last) {
    for (auto t = static_cast<std::uint32_t>(first); t < last; ++t) {
      for (std::uint32_t i = 0; i < 3; ++i) {
        after_dart[document.triangles[t].vertex[i]].store(3 * t + i + 1, std::memory_order_relaxed);
      }
    }
  });
  std::atomic<std::size_t> visited = 0;
  std::atomic<bool> all_met = true;
  for_each_block(after_dart.size(), threads, [&](std::size_t, std::size_t first, std::size_t last) {
    std::size_t here = 0;
    for (std::size_t v = first; v < last; ++v) {
      const std::uint32_t after = after_dart[v].load(std::memory_order_relaxed);
      if (after == 0) {
        all_met = false;
        return;
      }
      std::uint32_t dart = after - 1;
      do {
        dart = opposite(document, previous_dart(dart));
        ++here;
      } while (dart != after - 1);
    }
    visited += here;
  });
  return all_met && visited == 3 * triangles;
}

/// The darts that leave a vertex, each followed by the next one around it, form exactly one cycle.
Problem vertex_problem(const NetDocument& document) {
  std::vector<bool> visited(3 * document.triangles.size());
  std::vector<bool> met(document.vertices.size());
  for (std::uint32_t first = 0; first < visited.size(); ++first) {
    if (visited[first]) continue;
    const std::uint32_t vertex = start(document, first);
    if (met[vertex]) return "the darts leaving vertex " + std::to_string(vertex) + " form more than one cycle";
    met[vertex] = true;
    for (std::uint32_t dart = first; !visited[dart]; dart = opposite(document, previous_dart(dart)))
      visited[dart] = true;
  }
  for (std::size_t v = 0; v < met.size(); ++v) {
    if (!met[v]) return "vertex " + std::to_string(v) + " belongs to no triangle";
  }
  return std::nullopt;
}

/// Disjoint sets of numbers, united by several threads (R. J. Anderson and H. Woll, Wait-free parallel algorithms for
/// the union-find problem, STOC 1991). Parents are less than their children, so there are no cycles.
class Sets {
 public:
  /// parent(i) ≤ i is in the same set as i.
  template <class Parent>
  Sets(std::size_t count, unsigned threads, const Parent& parent) : parents_(count), threads_(threads) {
    for_each_block(count, threads_, [&](std::size_t, std::size_t first, std::size_t last) {
      for (auto i = static_cast<std::uint32_t>(first); i < last; ++i) {
        parents_[i].store(parent(i), std::memory_order_relaxed);
      }
    });
  }

  void unite(std::uint32_t x, std::uint32_t y) {
    // Nearly always, as parents are nearly always roots.
    if (parents_[x].load(std::memory_order_relaxed) == parents_[y].load(std::memory_order_relaxed)) return;
    for (;;) {
      x = root(x);
      y = root(y);
      if (x == y) return;
      if (x < y) std::swap(x, y);
      if (std::uint32_t expected = x; parents_[x].compare_exchange_weak(expected, y, std::memory_order_relaxed)) return;
    }
  }

  /// When all are united.
  [[nodiscard]] bool is_one() const {
    std::atomic<std::size_t> roots = 0;
    for_each_block(parents_.size(), threads_, [&](std::size_t, std::size_t first, std::size_t last) {
      std::size_t here = 0;
      for (std::size_t i = first; i < last; ++i) here += parents_[i].load(std::memory_order_relaxed) == i ? 1 : 0;
      roots += here;
    });
    return roots == 1;
  }

 private:
  /// Halves the way for the next one.
  [[nodiscard]] std::uint32_t root(std::uint32_t x) {
    for (;;) {
      const std::uint32_t parent = parents_[x].load(std::memory_order_relaxed);
      const std::uint32_t above = parents_[parent].load(std::memory_order_relaxed);
      if (parent == above) return parent;
      // Whatever other threads do, x is no root any more, and `above` is one of those that it leads to.
      parents_[x].store(above, std::memory_order_relaxed);
      x = above;
    }
  }

  AtomicNumbers parents_;
  unsigned threads_;
};

bool is_connected(const NetDocument& document, unsigned threads) {
  Sets sets(document.triangles.size(), threads, [&](std::uint32_t t) {
    std::uint32_t least = t;
    for (const std::uint32_t dart : document.triangles[t].opposite) least = std::min(least, dart / 3);
    return least;
  });
  for_each_block(document.triangles.size(), threads, [&](std::size_t, std::size_t first, std::size_t last) {
    for (auto t = static_cast<std::uint32_t>(first); t < last; ++t) {
      for (const std::uint32_t dart : document.triangles[t].opposite) {
        if (dart / 3 < t) sets.unite(t, dart / 3);
      }
    }
  });
  return sets.is_one();
}

Problem connection_problem(const NetDocument& document) {
  const auto missing = first_unreached(document.triangles.size(), [&](std::uint32_t t, const auto& visit) {
    for (const std::uint32_t dart : document.triangles[t].opposite) visit(dart / 3);
  });
  if (!missing) return std::nullopt;
  return "not connected: no path of edges leads from triangle 0 to triangle " + std::to_string(*missing);
}

Problem euler_problem(const NetDocument& document, std::uint64_t genus) {
  const auto vertices = static_cast<std::int64_t>(document.vertices.size());
  const auto triangles = static_cast<std::int64_t>(document.triangles.size());
  const std::int64_t edges = 3 * triangles / 2;
  const std::int64_t expected = 2 - 2 * static_cast<std::int64_t>(genus);
  if (vertices - edges + triangles == expected) return std::nullopt;
  return "V - E + F = " + std::to_string(vertices) + " - " + std::to_string(edges) + " + " + std::to_string(triangles) +
         " = " + std::to_string(vertices - edges + triangles) + ", expected " + std::to_string(expected) +
         " for genus " + std::to_string(genus);
}

}  // namespace

RuleReport check_map(const NetDocument& document, std::uint64_t genus, unsigned threads) {
  Problem problem;
  if (document.vertices.empty()) problem = "there is no vertex";
  if (!problem && document.triangles.empty()) problem = "there is no triangle";
  if (!problem) problem = opposite_problem(document, threads);
  // What is wrong is looked for by one thread, in the order of the file.
  if (!problem && !has_no_vertex_problem(document, threads)) problem = vertex_problem(document);
  if (!problem && !is_connected(document, threads)) problem = connection_problem(document);
  if (!problem) problem = euler_problem(document, genus);
  if (problem) return {"map", Verdict::refuted, *problem};
  const std::size_t triangles = document.triangles.size();
  return {"map", Verdict::verified,
          "a connected closed oriented surface of genus " + std::to_string(genus) + " made of " +
              counted(document.vertices.size(), "vertex", "vertices") + ", " + std::to_string(3 * triangles / 2) +
              " edges, " + std::to_string(triangles) + " triangles"};
}

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
        bases[i] = base_of(*disk, parts_.frames[charts_[i]], precision);
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
