#include <algorithm>
#include <atomic>
#include <memory>
#include <string>

#include "certify/base/text.h"
#include "certify/net/filter.h"
#include "certify/net/geometry_pass.h"
#include "certify/net/lifted_triangle.h"
#include "certify/net/numbering.h"
#include "certify/net/rules.h"
#include "certify/net/structure.h"
#include "certify/numbers/ball.h"
#include "certify/numbers/parallel.h"

namespace epsnet::certify {
namespace {

using namespace geometry;

/// Triangles handed to a thread at a time.
constexpr std::size_t kBlock = 2048;
/// Operations of balls that a triangle takes.
constexpr std::uint64_t kBallOperations = 150;

/// The measures that the filter settled and that may still be extreme: the largest circumradius, the longest or the
/// shortest edge. These are asked in balls all the same, so that enclosures do not depend on the filter.
class Candidates {
 public:
  struct Candidate {
    std::uint32_t triangle;
    Questions question;
    Interval measure;
  };

  void add(const Candidate& candidate) {
    if (candidate.question == kCoveringBit) {
      extremes_.add(kCircumradius, candidate.measure);
    } else {
      extremes_.add(kLongest, candidate.measure);
      extremes_.add(kShortestEdge, candidate.measure);
    }
    if (may_be_extreme(candidate)) candidates_.push_back(candidate);
  }

  [[nodiscard]] const Extremes& extremes() const { return extremes_; }
  /// Compares with others, too, from now on.
  void add(const Extremes& others) { extremes_.add(others); }

  /// Calls body(candidate) for those that may be extreme among all, in the order in which they were added.
  template <class Body>
  void for_each(const Body& body) const {
    for (const Candidate& candidate : candidates_) {
      if (may_be_extreme(candidate)) body(candidate);
    }
  }

 private:
  /// Balls that are called measured have intervals far narrower than this margin, so that one that is left out would
  /// have changed no end of an enclosure.
  [[nodiscard]] bool may_be_extreme(const Candidate& candidate) const {
    constexpr double kMargin = 1 + 0x1p-20;
    const auto [lower, upper] = candidate.measure;
    if (candidate.question == kCoveringBit) return upper * kMargin >= extremes_[kCircumradius]->lower;
    return upper * kMargin >= extremes_[kLongest]->lower || lower <= extremes_[kShortestEdge]->upper * kMargin;
  }

  Extremes extremes_;  ///< Of all that were added.
  std::vector<Candidate> candidates_;
};

/// The labels that triangles carry, in increasing order.
std::vector<std::uint32_t> used_labels(const NetDocument& document, unsigned threads) {
  std::vector<std::atomic<bool>> used(document.labels.size() + 1);
  for_each_block(document.triangles.size(), threads, [&](std::size_t, std::size_t first, std::size_t last) {
    for (std::size_t t = first; t < last; ++t) {
      for (const std::uint32_t number : document.triangles[t].label) {
        if (number != 0) used[number].store(true, std::memory_order_relaxed);
      }
    }
  });
  std::vector<std::uint32_t> numbers;
  for (std::uint32_t number = 1; number < used.size(); ++number) {
    if (used[number]) numbers.push_back(number);
  }
  return numbers;
}

/// Those that these triangles and their neighbours carry, likewise.
std::vector<std::uint32_t> labels_near(const NetDocument& document, const std::vector<std::uint32_t>& triangles) {
  return increasing(triangles, [&](std::uint32_t t, auto& numbers) {
    const auto use = [&](std::uint32_t triangle) {
      for (const std::uint32_t number : document.triangles[triangle].label) {
        if (number != 0) numbers.push_back(number);
      }
    };
    use(t);
    for (const std::uint32_t dart : document.triangles[t].opposite) use(dart / 3);
  });
}

/// The triangles that are still open, in file order, and what was found in the others.
class Questionnaire {
 public:
  Questionnaire(const NetDocument& document, const CollarMembers& collars) : document_(document), collars_(collars) {}

  /// Opens all questions but for those that the filter settles, if there is one, and that are no measures which may be
  /// extreme. At the beginning.
  void open(const Filter* filter, unsigned threads) {
    const std::size_t count = document_.triangles.size();
    struct Block {
      std::vector<std::uint32_t> triangles;
      std::vector<Questions> open;
      Candidates settled;
    };
    std::vector<Block> blocks((count + kBlock - 1) / kBlock);
    for_each_parallel(blocks.size(), threads, [&](unsigned, std::size_t b) {
      Block& block = blocks[b];
      std::array<std::uint32_t, Filter::kMost> triangles{};
      std::array<Questions, Filter::kMost> open{};
      std::array<Filter::Answer, Filter::kMost> answers;
      const std::size_t end = std::min(count, (b + 1) * kBlock);
      for (std::size_t first = b * kBlock; first < end; first += Filter::kMost) {
        const std::size_t size = std::min(Filter::kMost, end - first);
        for (std::size_t k = 0; k < size; ++k) {
          triangles[k] = static_cast<std::uint32_t>(first + k);
          open[k] = all_questions(triangles[k]);
        }
        if (filter != nullptr) filter->answer({triangles.data(), size}, {open.data(), size}, {answers.data(), size});
        for (std::size_t k = 0; k < size; ++k) {
          const Filter::Answer& answer = answers[k];
          if (answer.settled & kCoveringBit) block.settled.add({triangles[k], kCoveringBit, answer.circumradius});
          for (std::uint32_t i = 0; i < 3; ++i) {
            if (answer.settled & length_bit(i)) {
              block.settled.add({triangles[k], length_bit(i), answer.length[i]});
            }
          }
          if (open[k] == answer.settled) continue;
          block.triangles.push_back(triangles[k]);
          block.open.push_back(static_cast<Questions>(open[k] & ~answer.settled));
        }
      }
    });
    Extremes extremes;
    for (const Block& block : blocks) extremes.add(block.settled.extremes());
    for (Block& block : blocks) {
      block.settled.add(extremes);
      std::size_t k = 0;
      const auto take = [&] {
        triangles_.push_back(block.triangles[k]);
        open_.push_back(block.open[k++]);
      };
      block.settled.for_each([&](const Candidates::Candidate& candidate) {
        while (k < block.triangles.size() && block.triangles[k] <= candidate.triangle) take();
        if (triangles_.empty() || triangles_.back() != candidate.triangle) {
          triangles_.push_back(candidate.triangle);
          open_.push_back(0);
        }
        open_.back() = static_cast<Questions>(open_.back() | candidate.question);
      });
      while (k < block.triangles.size()) take();
    }
    is_open_ = true;
  }
  [[nodiscard]] bool is_open() const { return is_open_; }

  [[nodiscard]] const std::vector<std::uint32_t>& triangles() const { return triangles_; }
  [[nodiscard]] const std::vector<Questions>& open() const { return open_; }
  [[nodiscard]] const Findings& findings() const { return all_; }

  /// examine(worker, t, open, findings) for all that are open; it returns what stays open.
  template <class Examine>
  void ask(unsigned threads, const CheckOptions& options, const Examine& examine) {
    std::vector<Findings> found(blocks());
    // What is open changes together with what was found, so that an exception leaves both as they were.
    std::vector<Questions> open(open_.size());
    for_each_open(threads, [&](unsigned worker, std::size_t block, std::size_t k) {
      open[k] = examine(worker, triangles_[k], open_[k], found[block]);
      if (worker == 0 && options.progress && k % kBlock == 0) {
        options.progress("geometry", static_cast<double>(block) / static_cast<double>(found.size()));
      }
    });
    open_ = std::move(open);
    for (const Findings& findings : found) all_.add(findings);
    forget_settled();
  }

  /// decide(t, question, findings) for the open questions of some kinds; it says whether it could. In blocks that get
  /// longer, so that what comes first in the file does not wait for the rest; what a block finds counts when all of it
  /// is done, and BudgetSpent ends what is begun.
  template <class Decide>
  void ask_one_by_one(unsigned kinds, unsigned threads, const Decide& decide) {
    std::vector<std::pair<std::size_t, Questions>> questions;
    for (std::size_t k = 0; k < triangles_.size(); ++k) {
      for (unsigned bit = 1; bit <= kinds; bit <<= 1) {
        if (kinds & bit & open_[k]) questions.emplace_back(k, static_cast<Questions>(bit));
      }
    }
    std::size_t size = 1;
    for (std::size_t first = 0; first < questions.size(); first += size, size = std::min(2 * size, kBlock)) {
      const std::size_t count = std::min(size, questions.size() - first);
      std::vector<Findings> found(count);
      std::vector<char> decided(count, 0);
      for_each_parallel(count, threads, [&](unsigned, std::size_t i) {
        const auto [k, question] = questions[first + i];
        if (open_[k] & question) decided[i] = decide(triangles_[k], question, found[i]);
      });
      bool refuted = false;
      for (std::size_t i = 0; i < count; ++i) {
        if (!decided[i]) continue;
        for (const Rule rule : kRules) refuted = refuted || found[i].refuted[rule];
        const auto [k, question] = questions[first + i];
        open_[k] = static_cast<Questions>(open_[k] & ~question);
        all_.add(found[i]);
      }
      if (refuted) drop_idle();
    }
    forget_settled();
  }

  /// At the end. `all_asked`: the last pass asked everything that is open, so that all lengths were measured somehow;
  /// what was not measured may be anything.
  void finish(bool all_asked) {
    constexpr Interval kAnything{0, std::numeric_limits<double>::infinity()};
    if (!measures_dropped_ && (all_asked || std::none_of(open_.begin(), open_.end(), measures))) return;
    for (const Measure measure : kMeasures) all_.extremes.add(measure, kAnything);
  }

  /// The rule that is refuted, if questions of this rule were dropped for it.
  [[nodiscard]] std::optional<Rule> dropped_for(Rule rule) const { return dropped_for_[rule]; }

 private:
  [[nodiscard]] std::size_t blocks() const { return (triangles_.size() + kBlock - 1) / kBlock; }

  /// body(worker, block, k) for all triangles that are open, those of one block by one thread and in order.
  template <class Body>
  void for_each_open(unsigned threads, const Body& body) const {
    for_each_parallel(blocks(), threads, [&](unsigned worker, std::size_t block) {
      const std::size_t end = std::min(triangles_.size(), (block + 1) * kBlock);
      for (std::size_t k = block * kBlock; k < end; ++k) body(worker, block, k);
    });
  }

  [[nodiscard]] Questions all_questions(std::uint32_t t) const {
    Questions result = kOrientationBit | kCoveringBit;
    const auto& opposite = document_.triangles[t].opposite;
    for (std::uint32_t i = 0; i < 3; ++i) {
      if (3 * t + i < opposite[i]) result = static_cast<Questions>(result | delaunay_bit(i) | length_bit(i));
    }
    return result;
  }

  /// Whether a question asks for the circumradius or a length.
  static bool measures(Questions questions) { return (questions & ~(kOrientationBit | kDelaunayBits)) != 0; }

  /// Once a rule is refuted, only the rules before it, and itself at triangles before the one found, can change what
  /// the certificate says first. The rest is not asked any more.
  void drop_idle() {
    const auto refuted =
        std::find_if(kRules.begin(), kRules.end(), [&](Rule r) { return all_.refuted[r].has_value(); });
    if (refuted == kRules.end()) return;
    for (std::size_t k = 0; k < open_.size(); ++k) {
      Questions kept = 0;
      for (const Rule rule : kRules) {
        const Questions questions = questions_of(document_, collars_, rule, triangles_[k]);
        if (rule < *refuted || (rule == *refuted && triangles_[k] < all_.refuted[rule]->triangle)) {
          kept = static_cast<Questions>(kept | questions);
        } else if (open_[k] & questions) {
          dropped_for_[rule] = *refuted;
        }
      }
      measures_dropped_ = measures_dropped_ || measures(static_cast<Questions>(open_[k] & ~kept));
      open_[k] = static_cast<Questions>(open_[k] & kept);
    }
  }

  void forget_settled() {
    drop_idle();
    std::size_t kept = 0;
    for (std::size_t k = 0; k < triangles_.size(); ++k) {
      if (open_[k] == 0) continue;
      triangles_[kept] = triangles_[k];
      open_[kept++] = open_[k];
    }
    triangles_.resize(kept);
    open_.resize(kept);
  }

  const NetDocument& document_;
  const CollarMembers& collars_;
  std::vector<std::uint32_t> triangles_;
  std::vector<Questions> open_;
  bool is_open_ = false;
  Findings all_;
  std::array<std::optional<Rule>, 5> dropped_for_;
  bool measures_dropped_ = false;
};

/// Asks all questions, and says what the answers prove.
class GeometryChecker {
 public:
  GeometryChecker(const NetDocument& document, const LabelEvaluator& evaluator, const CheckOptions& options,
                  unsigned threads)
      : document_(document),
        evaluator_(evaluator),
        options_(options),
        threads_(threads),
        epsilon_(decimal(document.epsilon)),
        collars_(document),
        questions_(document, collars_),
        why_(", with " + std::to_string(options.max_precision) + " bits") {}

  GeometryOutcome run() {
    bool all_asked = false;
    try {
      // All are counted, whatever the filter settles, so that what a file may take does not depend on it.
      evaluator_.budget().spend(kBallOperations * ball_work(kFirstPrecision), document_.triangles.size());
      open_questions();
      const auto attempt = [&](slong precision) {
        all_asked = false;
        ask(precision);
        all_asked = is_last(precision);
        decide_exactly(precision);
        if (precision == kFirstPrecision) outcome_.triangles_beyond_64_bits = questions_.triangles().size();
        return questions_.triangles().empty();
      };
      if (!questions_.triangles().empty()) with_rising_precision(options_.max_precision, attempt);
    } catch (const BudgetSpent& spent) {
      why_ = std::string(": ") + spent.what();
      if (!questions_.is_open()) questions_.open(nullptr, threads_);
    }
    questions_.finish(all_asked);
    enclose();
    const std::array<std::string, 5> proved = proved_texts();
    for (const Rule rule : kRules) {
      if (rule == kThick && !collars_.pseudo()) break;
      outcome_.reports.push_back(report(rule));
      if (outcome_.reports.back().verdict == Verdict::verified) outcome_.reports.back().text = proved[rule];
    }
    return std::move(outcome_);
  }

 private:
  [[nodiscard]] bool is_last(slong precision) const { return precision >= options_.max_precision; }

  /// All of them, or those that the filter leaves, which needs the labels of all triangles.
  void open_questions() {
    const std::vector<std::uint32_t> numbers = used_labels(document_, threads_);
    labels_.emplace(values_of(numbers, kFirstPrecision));
    if (!options_.filter) return questions_.open(nullptr, threads_);
    const Precision scope(kFirstPrecision);
    const Ball radius = Ball::rounded(epsilon_);
    const auto squared_sinh = [](const Ball& x) { return outer_interval(sqr(sinh(x))); };
    const Filter filter(document_, collars_, numbers, *labels_, squared_sinh(radius), squared_sinh(half(radius)));
    questions_.open(&filter, threads_);
  }

  [[nodiscard]] LabelTable values_of(const std::vector<std::uint32_t>& numbers, slong precision) const {
    const slong cap = std::min(4 * precision, 2 * options_.max_precision);
    return {numbers, evaluator_.evaluate(numbers, precision, cap, threads_), document_.labels.size()};
  }

  /// All open questions, in balls.
  void ask(slong precision) {
    if (precision > kFirstPrecision) {
      evaluator_.budget().spend(kBallOperations * ball_work(static_cast<std::uint64_t>(precision)),
                                questions_.triangles().size());
      labels_.emplace(values_of(labels_near(document_, questions_.triangles()), precision));
    }
    const Pass pass(document_, collars_, *labels_, epsilon_, precision, is_last(precision));
    std::vector<std::unique_ptr<LiftedTriangle>> lifted(std::max(threads_, 1U));
    questions_.ask(threads_, options_, [&](unsigned worker, std::uint32_t t, Questions open, Findings& findings) {
      if (!lifted[worker]) lifted[worker] = std::make_unique<LiftedTriangle>();
      return pass.examine(t, open, *lifted[worker], findings);
    });
    outcome_.max_precision = static_cast<std::uint64_t>(precision);
  }

  /// What is left of the rules that have ties, once, when the precision is high enough.
  void decide_exactly(slong precision) {
    if (decided_exactly_ || !(precision >= kExactFromForEdges || is_last(precision))) return;
    decided_exactly_ = true;
    for (const unsigned kinds : {unsigned{kOrientationBit}, unsigned{kDelaunayBits}}) {
      questions_.ask_one_by_one(kinds, threads_, [&](std::uint32_t t, Questions question, Findings& findings) {
        return examine_exactly(document_, evaluator_, t, question, findings);
      });
    }
  }

  void enclose() {
    const Findings& all = questions_.findings();
    const Precision scope(128);
    outcome_.ties = all.ties;
    std::sort(outcome_.ties.begin(), outcome_.ties.end());
    const auto length = [&](Measure measure) -> std::optional<Interval> {
      const std::optional<Interval>& x = all.extremes[measure];
      return x ? std::optional(length_interval(*x, measure == kCircumradius ? 1 : 2)) : std::nullopt;
    };
    Enclosures& enclosures = outcome_.enclosures;
    enclosures.epsilon = outer_interval(Ball::rounded(epsilon_));
    enclosures.largest_circumradius = length(kCircumradius).value_or(Interval{});
    enclosures.longest_edge = length(kLongest).value_or(Interval{});
    enclosures.shortest_edge = length(kShortestEdge);
    enclosures.shortest_loop = length(kShortestLoop);
  }

  /// By rule.
  [[nodiscard]] std::array<std::string, 5> proved_texts() const {
    const std::string edges = std::to_string(3 * document_.triangles.size() / 2);
    return {"all " + std::to_string(document_.triangles.size()) + " triangles are strictly counterclockwise",
            "all " + edges + " edges are Delaunay, " + std::to_string(outcome_.ties.size()) + " of them exact ties",
            std::string("every circumradius") + (collars_.pseudo() ? " outside of collars" : "") +
                " is at most epsilon; the largest lies in " + to_string(outcome_.enclosures.largest_circumradius),
            outcome_.enclosures.shortest_edge
                ? std::string("every edge between different vertices") +
                      (collars_.pseudo() ? " that are not those of one collar" : "") +
                      " is at least epsilon long; the shortest lies in " + to_string(*outcome_.enclosures.shortest_edge)
                : std::string("there is only one vertex, every edge is a loop"),
            "every loop at a vertex of no collar is at least epsilon long"};
  }

  /// Without the text of a rule that is verified.
  [[nodiscard]] RuleReport report(Rule rule) const {
    const Findings& findings = questions_.findings();
    if (findings.refuted[rule]) return {kRuleNames[rule], Verdict::refuted, findings.refuted[rule]->text};
    for (std::size_t k = 0; k < questions_.triangles().size(); ++k) {
      const auto undecided = undecided_text(rule, questions_.triangles()[k], questions_.open()[k]);
      if (undecided) return {kRuleNames[rule], Verdict::undecided, *undecided + why_};
    }
    if (const auto refuted = questions_.dropped_for(rule)) {
      return {kRuleNames[rule], Verdict::undecided,
              std::string("not decided, as rule ") + kRuleNames[*refuted] + " is refuted"};
    }
    return {kRuleNames[rule], Verdict::verified, ""};
  }

  /// What a rule leaves open in triangle t, of which these questions are; nothing if that is nothing.
  [[nodiscard]] std::optional<std::string> undecided_text(Rule rule, std::uint32_t t, Questions open) const {
    const unsigned left = open & questions_of(document_, collars_, rule, t);
    if (left == 0) return std::nullopt;
    if (rule == kOrientation)
      return triangle_name(document_, t) + ": not decided whether it is strictly counterclockwise";
    if (rule == kCovering) {
      return triangle_name(document_, t) + ": not decided whether " +
             (collars_.has_triangle(t) ? "it has a circumcircle" : "the circumradius is at most epsilon");
    }
    std::uint32_t i = 0;
    while (!(left & (delaunay_bit(i) | length_bit(i)))) ++i;
    return edge_name(document_, 3 * t + i) + ": not decided whether it is " +
           (rule == kDelaunay ? "Delaunay" : "at least epsilon long");
  }

  const NetDocument& document_;
  const LabelEvaluator& evaluator_;
  const CheckOptions& options_;
  unsigned threads_;
  mpq_class epsilon_;
  CollarMembers collars_;
  Questionnaire questions_;
  std::optional<LabelTable> labels_;  ///< Those that open questions need, with the bits of the last pass.
  std::string why_;                   ///< Message suffix: why undecided questions stayed undecided.
  bool decided_exactly_ = false;
  GeometryOutcome outcome_;
};

}  // namespace

GeometryOutcome check_geometry(const NetDocument& document, const LabelEvaluator& evaluator,
                               const CheckOptions& options, unsigned threads) {
  return GeometryChecker(document, evaluator, options, threads).run();
}

}  // namespace epsnet::certify
