#include <algorithm>
#include <bit>
#include <concepts>
#include <gmpxx.h>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "certify/base/text.h"
#include "certify/claims/curves/crossings.h"
#include "certify/claims/curves/fields.h"
#include "certify/claims/geodesics/axis_crossings.h"
#include "certify/claims/geodesics/sequences.h"
#include "certify/claims/isometries/frames.h"
#include "certify/claims/net/claim.h"
#include "certify/lifted/lifted_plane.h"
#include "certify/net/labels.h"
#include "certify/net/numbering.h"
#include "certify/net/structure.h"
#include "certify/numbers/ball.h"
#include "certify/numbers/parallel.h"
#include "certify/verdict/verification.h"

namespace epsnet::certify {
namespace {

/// Programs that keep all numbers in binary64 read integers up to this one exactly.
constexpr std::int64_t kMostInteger = std::int64_t{1} << 53;

Problem integer_problem(const char* member, std::int64_t value) {
  if (-kMostInteger <= value && value <= kMostInteger) return std::nullopt;
  return std::string(member) + ": " + std::to_string(value) + " is larger than 2^53";
}

Problem integer_problem(const char* member, std::uint64_t value) {
  if (value <= static_cast<std::uint64_t>(kMostInteger)) return std::nullopt;
  return std::string(member) + ": " + std::to_string(value) + " is larger than 2^53";
}

Problem curve_problem(const CurvesDocument& document, const SurfaceSides& sides, const CurvesDocument::Curve& curve) {
  const auto& [vertex, word, length, power, self_intersections, homology] = curve;
  if (vertex >= document.net.vertices.size()) return "vertex " + std::to_string(vertex) + " does not exist";
  const std::uint32_t tile = document.net.charts[document.net.vertices[vertex].chart].tile;
  if (auto problem = word_problem(sides, word, tile, tile, "vertex " + std::to_string(vertex))) return problem;
  if (!is_length(length) || length.lower == 0) {
    return "the length " + to_string(length) + " is not 0 < lo <= hi";
  }
  if (power == 0) return "power: 0, expected at least 1";
  if (auto problem = integer_problem("self_intersections", self_intersections)) return problem;
  if (homology.size() != document.basis.size()) {
    return "homology: " + counted(homology.size(), "integer", "integers") +
           ", expected one for each curve of the basis, " + std::to_string(document.basis.size());
  }
  for (const std::int64_t coefficient : homology) {
    if (auto problem = integer_problem("homology", coefficient)) return problem;
  }
  return std::nullopt;
}

Problem pairs_problem(const CurvesDocument& document) {
  const std::size_t count = document.curves.size();
  const std::size_t expected = count == 0 ? 0 : count * (count - 1) / 2;
  if (document.pairs.size() != expected) {
    return "pairs: " + counted(document.pairs.size(), "row", "rows") + ", expected one for each two curves, " +
           std::to_string(expected);
  }
  std::uint32_t first = 0;
  std::uint32_t second = 0;
  return first_row_problem("pairs", document.pairs, [&](const CurvesDocument::Pair& pair) -> Problem {
    if (++second == count) second = ++first + 1;
    if (pair.first != first || pair.second != second) {
      return "curves " + std::to_string(pair.first) + " and " + std::to_string(pair.second) + ", expected " +
             std::to_string(first) + " and " + std::to_string(second);
    }
    if (auto problem = integer_problem("intersections", pair.intersections)) return problem;
    return integer_problem("algebraic", pair.algebraic);
  });
}

Problem basis_problem(const CurvesDocument& document) {
  std::vector<bool> seen(document.curves.size());
  return first_row_problem("basis", document.basis, [&](std::uint32_t curve) -> Problem {
    const std::string name = "curve " + std::to_string(curve);
    if (curve >= seen.size()) return name + " does not exist";
    if (seen[curve]) return name + " occurs twice";
    seen[curve] = true;
    return std::nullopt;
  });
}

Problem filling_problem(const CurvesDocument& document) {
  return first_row_problem("filling", document.filling, [&](const std::vector<std::uint32_t>& set) -> Problem {
    for (std::size_t k = 0; k < set.size(); ++k) {
      const std::string name = "curve " + std::to_string(set[k]);
      if (set[k] >= document.curves.size()) return name + " does not exist";
      if (k > 0 && set[k] <= set[k - 1])
        return name + " follows " + std::to_string(set[k - 1]) + ", expected ascending order";
    }
    return std::nullopt;
  });
}

}  // namespace

Problem structure_problem(const CurvesDocument& document) {
  if (auto problem = whole_net_problem(document.net)) return problem;
  const SurfaceSides sides(document.net.surface);
  if (auto problem = first_row_problem("curves", document.curves, [&](const CurvesDocument::Curve& curve) {
        return curve_problem(document, sides, curve);
      })) {
    return problem;
  }
  if (auto problem = pairs_problem(document)) return problem;
  if (auto problem = basis_problem(document)) return problem;
  return filling_problem(document);
}

std::uint64_t least_bytes(const CurvesDocument& document) {
  std::uint64_t bytes = least_bytes(document.net) + 54 * document.pairs.size() + 2 * document.basis.size();
  for (const CurvesDocument::Curve& curve : document.curves) {
    bytes += 80 + least_bytes(curve.word) + 2 * curve.homology.size();
  }
  for (const auto& set : document.filling) bytes += 3 + 2 * set.size();
  return bytes;
}

namespace {

using Curve = CurvesDocument::Curve;
using CurvePair = CurvesDocument::Pair;

constexpr const char* kCurveLengths = "lengths";
constexpr const char* kPowers = "powers";
constexpr const char* kIntersections = "intersections";
constexpr const char* kHomology = "homology";
constexpr const char* kFilling = "filling";

constexpr slong kFirstBitsOfCurves = 128;

std::string curve_name(std::size_t i) { return "curve " + std::to_string(i); }

/// Of an integer of at most 2⁵³ in absolute value, whatever its type.
mpz_class integer(std::integral auto value) { return mpz_class(static_cast<double>(value)); }

/// The determinant by Bareiss' elimination, in which all quotients are integers.
mpz_class determinant_of(std::vector<std::vector<mpz_class>> rows) {
  mpz_class divisor = 1;
  int sign = 1;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const auto pivot = std::find_if(rows.begin() + static_cast<std::ptrdiff_t>(k), rows.end(),
                                    [&](const auto& row) { return row[k] != 0; });
    if (pivot == rows.end()) return 0;
    if (pivot - rows.begin() != static_cast<std::ptrdiff_t>(k)) {
      std::swap(*pivot, rows[k]);
      sign = -sign;
    }
    for (std::size_t i = k + 1; i < rows.size(); ++i) {
      for (std::size_t j = k + 1; j < rows.size(); ++j) {
        rows[i][j] = (rows[i][j] * rows[k][k] - rows[i][k] * rows[k][j]) / divisor;
      }
    }
    divisor = rows[k][k];
  }
  return sign * divisor;
}

/// A curve as a power of a primitive closed geodesic.
struct PowerOf {
  std::uint32_t root;  ///< The number of the geodesic.
  mpz_class exponent;
  int direction;
};

class CurvesCheck {
 public:
  CurvesCheck(const CurvesDocument& document, Verification& run, Crossings crossings)
      : document_(document),
        run_(run),
        net_(with_curves_as_labels(document)),
        parts_(label_parts(std::move(crossings), net_.charts, run.budget())),
        evaluator_(net_, parts_),
        first_darts_(first_darts(net_)),
        rules_(own_rules(document)) {}

  void ask() {
    try {
      with_rising_precision(
          run_.options().max_precision,
          [&](slong precision) {
            run_.used(static_cast<std::uint64_t>(precision));
            pass(precision);
            return is_decided();
          },
          kFirstBitsOfCurves);
    } catch (const BudgetSpent& spent) {
      rules_.give_up(spent.what());
    }
    rules_.conclude(run_);
  }

 private:
  static NetDocument with_curves_as_labels(const CurvesDocument& document) {
    NetDocument net = document.net;
    for (const Curve& curve : document.curves) {
      const std::uint32_t chart = net.vertices[curve.vertex].chart;
      net.labels.push_back({chart, chart, curve.word});
    }
    return net;
  }

  void report(const char* rule, Verdict verdict, std::string text) { rules_.report({rule, verdict, std::move(text)}); }
  [[nodiscard]] bool is_verified(const char* rule) const { return rules_.verdict(rule) == Verdict::verified; }

  /// Whether more bits can change nothing.
  [[nodiscard]] bool is_decided() const {
    for (const char* rule : {kCurveLengths, kPowers, kIntersections, kHomology, kFilling}) {
      if (rules_.verdict(rule) == Verdict::refuted) return true;
    }
    return !rules_.open(kCurveLengths) && !rules_.open(kPowers) && !rules_.open(kIntersections) &&
           !rules_.open(kFilling);
  }

  /// All open rules at one precision, until one of them is not verified.
  void pass(slong precision) {
    bits_ = std::to_string(precision) + " bits";
    run_.progress(kCurveLengths);
    const LiftedPlane plane(net_, evaluator_, parts_, precision, run_.options().max_precision, run_.threads());
    if (rules_.open(kCurveLengths)) check_lengths(plane);
    if (!is_verified(kCurveLengths)) return;
    run_.progress(kPowers);
    const MovedNet moved(plane);
    std::vector<PowerOf> powers;
    const auto roots = find_roots(moved, powers);
    if (!roots) return doubt_all("not decided which edges the geodesics cross, with " + bits_);
    if (rules_.open(kPowers)) check_powers(powers);
    if (!is_verified(kPowers)) return;
    run_.progress(kIntersections);
    const auto points = crossing_points(moved, *roots);
    if (!points) return doubt_all("not decided where the geodesics cross, with " + bits_);
    if (rules_.open(kIntersections)) check_intersections(powers, crossing_numbers(plane, *points));
    if (!is_verified(kIntersections)) return;
    run_.progress(kHomology);
    if (rules_.open(kHomology)) check_homology();
    if (!is_verified(kHomology)) return;
    run_.progress(kFilling);
    check_filling(plane, powers, *points);
  }

  void doubt_all(const std::string& why) {
    for (const char* rule : {kPowers, kIntersections, kFilling}) rules_.doubt(rule, why);
  }

  /// The element that translates along the geodesic of a curve, in its direction.
  [[nodiscard]] BallIsometry element(const LiftedPlane& plane, std::size_t i) const {
    BallIsometry result = inverse(plane.label(static_cast<std::uint32_t>(document_.net.labels.size() + 1 + i)));
    choose_sign(result);
    return result;
  }

  // Rule lengths.

  void check_lengths(const LiftedPlane& plane) {
    struct Answer {
      Tri is_long = Tri::unknown;
      Tri is_short = Tri::unknown;
    };
    std::vector<Answer> answers(document_.curves.size());
    for_each_parallel(answers.size(), run_.threads(), [&](unsigned, std::size_t i) {
      const Ball cosh_half = cosh_half_length(element(plane, i));
      const auto& [lower, upper] = document_.curves[i].length;
      answers[i] = {certainly_less(cosh(half(Ball::exactly(lower))), cosh_half),
                    certainly_less(cosh_half, cosh(half(Ball::exactly(upper))))};
    });
    for (const Tri wanted : {Tri::no, Tri::unknown}) {
      const auto found = std::find_if(answers.begin(), answers.end(), [&](const Answer& answer) {
        return answer.is_long == wanted || answer.is_short == wanted;
      });
      if (found == answers.end()) continue;
      const auto i = static_cast<std::size_t>(found - answers.begin());
      const std::string claimed = to_string(document_.curves[i].length);
      if (found->is_long == Tri::no) {
        return report(kCurveLengths, Verdict::refuted,
                      curve_name(i) + " is null-homotopic, or shorter than a length in " + claimed);
      }
      const std::string actual =
          " has a length in " + to_string(translation_length(element(plane, i), plane.precision()));
      if (wanted == Tri::no)
        return report(kCurveLengths, Verdict::refuted, curve_name(i) + actual + ", not in " + claimed);
      return report(kCurveLengths, Verdict::undecided,
                    curve_name(i) + actual + ", not decided whether in " + claimed + ", with " + bits_);
    }
    report(kCurveLengths, Verdict::verified,
           counted(answers.size(), "closed geodesic has its length in its interval",
                   "closed geodesics have lengths in their intervals"));
  }

  // Rule powers.

  /// The different primitive closed geodesics of the curves, each once, and what power of which each curve is. Nullopt
  /// if the precision is too low.
  [[nodiscard]] std::optional<std::vector<AxisCrossings>> find_roots(const MovedNet& moved,
                                                                     std::vector<PowerOf>& powers) const {
    if (!moved.valid()) return std::nullopt;
    std::vector<AxisCrossings> found(document_.curves.size());
    std::vector<LeastSequence> sequences(found.size());
    for_each_parallel(found.size(), run_.threads(), [&](unsigned, std::size_t i) {
      auto crossings = axis_crossings(moved, first_darts_[document_.curves[i].vertex], element(moved.plane(), i));
      if (!crossings) return;
      sequences[i] = least_sequence(codes_of(moved.plane().net(), crossings->darts));
      const std::size_t period = crossings->darts.size() / sequences[i].exponent;
      crossings->darts.resize(period);
      crossings->axes.resize(period);
      found[i] = *std::move(crossings);
    });
    std::map<std::vector<std::uint32_t>, std::pair<std::uint32_t, bool>> known;  // With the direction of the first one.
    std::vector<AxisCrossings> roots;
    for (std::size_t i = 0; i < found.size(); ++i) {
      if (found[i].darts.empty()) return std::nullopt;
      const bool backwards = sequences[i].backwards;
      const auto [place, is_new] =
          known.try_emplace(sequences[i].root, static_cast<std::uint32_t>(roots.size()), backwards);
      if (is_new) roots.push_back(std::move(found[i]));
      powers.push_back({place->second.first, sequences[i].exponent, place->second.second == backwards ? 1 : -1});
    }
    return roots;
  }

  /// Codes of darts, any ones of which opposite darts have c and c ^ 1.
  [[nodiscard]] static std::vector<std::uint32_t> codes_of(const NetDocument& net, std::vector<std::uint32_t> darts) {
    for (std::uint32_t& dart : darts) {
      const std::uint32_t other = opposite(net, dart);
      dart = dart < other ? 2 * dart : 2 * other + 1;
    }
    return darts;
  }

  void check_powers(const std::vector<PowerOf>& powers) {
    for (std::size_t i = 0; i < powers.size(); ++i) {
      const std::uint32_t claimed = document_.curves[i].power;
      if (powers[i].exponent == claimed) continue;
      return report(kPowers, Verdict::refuted,
                    curve_name(i) + " is power " + powers[i].exponent.get_str() + " of a primitive one, not power " +
                        std::to_string(claimed));
    }
    const auto primitive = std::count_if(document_.curves.begin(), document_.curves.end(),
                                         [](const Curve& curve) { return curve.power == 1; });
    report(kPowers, Verdict::verified,
           std::to_string(primitive) + " of " + counted(powers.size(), "curve", "curves") + " are primitive");
  }

  // Rule intersections.

  void check_intersections(const std::vector<PowerOf>& powers, const CrossingNumbers& numbers) {
    // Each point where a geodesic crosses itself is one of both passages.
    const auto self = [&](std::uint32_t root) { return integer(numbers.points[root][root] / 2); };
    const auto differs = [&](const std::string& what, const mpz_class& actual, const mpz_class& claimed) {
      if (actual == claimed) return false;
      report(kIntersections, Verdict::refuted, what + " is " + actual.get_str() + ", not " + claimed.get_str());
      return true;
    };
    for (std::size_t i = 0; i < powers.size(); ++i) {
      const auto& [root, exponent, direction] = powers[i];
      const mpz_class actual = exponent * exponent * self(root) + exponent - 1;
      if (differs("the self-intersection number of " + curve_name(i), actual,
                  integer(document_.curves[i].self_intersections)))
        return;
    }
    run_.budget().spend(200, document_.pairs.size());
    for (const CurvePair& pair : document_.pairs) {
      const auto& [root, exponent, direction] = powers[pair.first];
      const auto& [other, other_exponent, other_direction] = powers[pair.second];
      const mpz_class times = exponent * other_exponent;
      // Of one geodesic with itself: twice the number of its double points, as of two parallel curves.
      const mpz_class points = integer(numbers.points[root][other]);
      const mpz_class signs = integer(std::int64_t{direction} * other_direction * numbers.signs[root][other]);
      const std::string names = " of " + curve_name(pair.first) + " and " + curve_name(pair.second);
      if (differs("the geometric intersection number" + names, times * points, integer(pair.intersections)) ||
          differs("the algebraic intersection number" + names, times * signs, integer(pair.algebraic)))
        return;
    }
    report(kIntersections, Verdict::verified,
           "those of " + counted(powers.size(), "curve", "curves") + " with themselves, and of " +
               counted(document_.pairs.size(), "pair", "pairs"));
  }

  // Rule homology.

  /// The algebraic intersection number of two curves of the file, as it says.
  [[nodiscard]] mpz_class algebraic(std::size_t first, std::size_t second) const {
    if (first == second) return 0;
    if (second < first) return -algebraic(second, first);
    const std::size_t before = first * (2 * document_.curves.size() - first - 1) / 2;
    return integer(document_.pairs[before + second - first - 1].algebraic);
  }

  void check_homology() {
    const std::vector<std::uint32_t>& basis = document_.basis;
    const std::uint64_t expected = 2 * run_.certificate().counts.genus;
    if (basis.size() != expected) {
      return report(
          kHomology, Verdict::refuted,
          "the basis has " + counted(basis.size(), "curve", "curves") + ", expected " + std::to_string(expected));
    }
    const std::uint64_t size = basis.size();
    run_.budget().spend(memory_work(32), size * size);
    std::vector<std::vector<mpz_class>> matrix(size, std::vector<mpz_class>(size));
    std::uint64_t bits = 1;
    for (std::size_t j = 0; j < size; ++j) {
      for (std::size_t k = 0; k < size; ++k) {
        matrix[j][k] = algebraic(basis[j], basis[k]);
        bits = std::max<std::uint64_t>(bits, mpz_sizeinbase(matrix[j][k].get_mpz_t(), 2));
      }
    }
    // By Hadamard's inequality, of all minors.
    bits = size * (bits + static_cast<std::uint64_t>(std::bit_width(size)));
    run_.budget().spend(100 + 3 * product_work(bits), size * size * size / 3 + 1);
    const mpz_class determinant = determinant_of(matrix);
    if (abs(determinant) != 1) {
      return report(kHomology, Verdict::refuted,
                    "the algebraic intersection numbers of the basis have the determinant " + shown(determinant) +
                        ", expected 1");
    }
    for (std::size_t i = 0; i < document_.curves.size(); ++i) {
      run_.budget().spend(20, size * size);
      for (std::size_t k = 0; k < size; ++k) {
        mpz_class sum;
        for (std::size_t j = 0; j < size; ++j) sum += matrix[j][k] * integer(document_.curves[i].homology[j]);
        if (sum == algebraic(i, basis[k])) continue;
        return report(kHomology, Verdict::refuted,
                      curve_name(i) + " has another class: with " + curve_name(basis[k]) +
                          " of the basis it has the algebraic intersection number " + algebraic(i, basis[k]).get_str() +
                          ", and the class has " + sum.get_str());
      }
    }
    report(kHomology, Verdict::verified,
           "the classes of " + counted(document_.curves.size(), "curve", "curves") + " in a basis of " +
               std::to_string(size));
  }

  static std::string shown(const mpz_class& number) {
    const std::string digits = number.get_str();
    return digits.size() <= 40 ? digits : "of " + std::to_string(digits.size()) + " digits";
  }

  // Rule filling.

  void check_filling(const LiftedPlane& plane, const std::vector<PowerOf>& powers,
                     const std::vector<std::vector<CrossingPoint>>& points) {
    const std::int64_t euler = 2 - 2 * static_cast<std::int64_t>(run_.certificate().counts.genus);
    for (std::size_t row = 0; row < document_.filling.size(); ++row) {
      std::vector<std::uint32_t> roots;
      for (const std::uint32_t curve : document_.filling[row]) roots.push_back(powers[curve].root);
      std::sort(roots.begin(), roots.end());
      roots.erase(std::unique(roots.begin(), roots.end()), roots.end());
      const auto answer = fill(plane, points, roots, euler);
      const std::string name = "set " + std::to_string(row);
      if (!answer) {
        return rules_.doubt(kFilling, name + ": not decided in which order the geodesics cross, with " + bits_);
      }
      if (!*answer) {
        return report(kFilling, Verdict::refuted,
                      name + " does not fill: a component of the complement of its geodesics is no disk");
      }
    }
    report(kFilling, Verdict::verified, counted(document_.filling.size(), "set fills", "sets fill") + " the surface");
  }

  const CurvesDocument& document_;
  Verification& run_;
  NetDocument net_;  ///< With the words of the curves as further labels.
  LabelParts parts_;
  LabelEvaluator evaluator_;
  std::vector<std::uint32_t> first_darts_;
  OpenRules rules_;
  std::string bits_;
};

}  // namespace

RuleNames own_rules(const CurvesDocument& /*document*/) {
  return {kCurveLengths, kPowers, kIntersections, kHomology, kFilling};
}

Claim claim_of(const CurvesDocument& document) {
  const auto ask = [&document](Verification& run, Crossings crossings) {
    CurvesCheck(document, run, std::move(crossings)).ask();
  };
  return {document.net,
          counted(document.curves.size(), "closed curve has", "closed curves have") +
              " the lengths, powers, intersection numbers and homology classes as stated" +
              (document.filling.empty()
                   ? ""
                   : ", and " + counted(document.filling.size(), "set fills", "sets fill") + " the surface"),
          own_rules(document), ask};
}

}  // namespace epsnet::certify
