#include "certify/exact/inertia.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "certify/exact/interval.h"
#include "certify/exact/loops.h"

namespace epsnet::exact {
namespace {

__extension__ using Wide = __int128;

constexpr Index kNone = 0xFFFFFFFFU;
constexpr int kFraction = 50;                             ///< Bits of L behind the point; products have twice as many.
constexpr double kMostSquares = 1L << 26;                 ///< The squares of a row of L have a lesser sum.
constexpr Wide kShift = Wide{1} << (2 * kFraction - 31);  ///< Of the diagonal: 2⁻³¹, more than E needs.

[[noreturn]] void give_inertia_up() { give_up("the signs of the eigenvalues of a matrix are not decided"); }

/// Multiples of 2⁻⁵⁰ below and above the number.
struct Rounded {
  Wide lower;
  Wide upper;
};
Rounded rounded(const Interval& x) {
  const double lower = std::floor(std::ldexp(x.lower(), kFraction));
  const double upper = std::ceil(std::ldexp(x.upper(), kFraction));
  constexpr double kMost = 1L << 60;
  constexpr double kWidest = 1L << 30;
  if (!(-kMost < lower && upper < kMost && upper - lower < kWidest)) give_inertia_up();
  return {static_cast<std::int64_t>(lower), static_cast<std::int64_t>(upper)};
}

}  // namespace

Inertia::Inertia(std::vector<Rows> rows, std::size_t functions, std::size_t most_operations, Values values)
    : parts_(values == Values::real ? 1 : 2), rows_(std::move(rows)) {
  const std::size_t size = parts_ * functions;
  entries_.resize(size);
  parent_.resize(size, kNone);
  below_.resize(size);
  std::vector<std::vector<Index>> columns(size);
  for (std::size_t i = 0; i < size; ++i) columns[i].push_back(static_cast<Index>(i));
  for (const Rows& three : rows_) {
    for (Index i = 0; i < 3 * parts_; ++i) {
      const Index row = row_of(three[i / parts_], i % parts_);
      for (Index j = 0; j < 3 * parts_; ++j) {
        const Index column = row_of(three[j / parts_], j % parts_);
        if (column < row) columns[row].push_back(column);
      }
    }
  }
  for (std::size_t i = 0; i < size; ++i) {
    std::sort(columns[i].begin(), columns[i].end());
    columns[i].erase(std::unique(columns[i].begin(), columns[i].end()), columns[i].end());
    for (const Index column : columns[i]) entries_[i].push_back({column, {}, {}});
  }
  find_columns(most_operations);
}

/// From the columns with entries of the matrix to all that elimination fills: up the tree of the parents.
template <class Visit>
void Inertia::each_column(std::size_t i, std::vector<Index>& seen, const Visit& visit) const {
  seen[i] = static_cast<Index>(i);
  for (const Entry& entry : entries_[i]) {
    for (Index k = entry.column; seen[k] != i; k = parent_[k]) {
      seen[k] = static_cast<Index>(i);
      visit(k);
    }
  }
}

void Inertia::find_columns(std::size_t most_operations) {
  std::vector<Index> seen(below_.size(), kNone);
  std::size_t operations = 0;  // Squares of 1 + the numbers of entries.
  for (std::size_t i = 0; i < below_.size(); ++i) {
    operations += 1;
    each_column(i, seen, [&](Index k) {
      if (parent_[k] == kNone) parent_[k] = static_cast<Index>(i);
      operations += 2 * ++below_[k] + 1;
      if (operations > most_operations) throw LeftOut{"matrices that take so much work"};
    });
  }
}

void Inertia::add(Index row, Index column, const Interval& energy, const Interval& mass) {
  if (row < column) return;
  Entry& sum = *std::lower_bound(entries_[row].begin(), entries_[row].end(), column,
                                 [](const Entry& entry, Index k) { return entry.column < k; });
  sum.energy = sum.energy + energy;
  sum.mass = sum.mass + mass;
}

void Inertia::add(std::size_t triangle, const LocalForms& forms) {
  const Rows& rows = rows_[triangle];
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) add(rows[i], rows[j], forms.energy[i][j], forms.mass[i][j]);
  }
}

void Inertia::add(std::size_t triangle, const LocalForms& forms, const std::array<Turn, 3>& turns) {
  const Rows& rows = rows_[triangle];
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      // The number in row i and column j is that of the form times e^{i(φ_j − φ_i)}.
      const Interval cosine = turns[i][0] * turns[j][0] + turns[i][1] * turns[j][1];
      const Interval sine = turns[i][0] * turns[j][1] - turns[i][1] * turns[j][0];
      for (Index part = 0; part < parts_; ++part) {
        for (Index other = 0; other < parts_; ++other) {
          const Interval factor = part == other ? cosine : part == 1 ? sine : -sine;
          add(row_of(rows[i], part), row_of(rows[j], other), factor * forms.energy[i][j], factor * forms.mass[i][j]);
        }
      }
    }
  }
}

class Inertia::Factorisation {
 public:
  Factorisation(const Inertia& matrix, const Interval& sigma, Bound bound)
      : matrix_(matrix), sigma_(sigma), bound_(bound), columns_(matrix.below_.size()), seen_(columns_.size(), kNone) {
    std::size_t entries = 0;
    for (std::size_t k = 0; k < columns_.size(); ++k) {
      columns_[k].begin = columns_[k].end = entries;
      entries += matrix.below_[k];
    }
    row_.resize(entries);
    value_.resize(entries);
    for (std::size_t i = 0; i < columns_.size(); ++i) add_row(i);
  }

  /// E, or −E, is diagonally dominant, with a diagonal that is not negative.
  [[nodiscard]] bool is_proved() const {
    return std::all_of(columns_.begin(), columns_.end(), [](const Column& column) { return column.slack >= 0; });
  }
  [[nodiscard]] std::size_t negative() const {
    return static_cast<std::size_t>(
        std::count_if(columns_.begin(), columns_.end(), [](const Column& column) { return column.sign < 0; }));
  }

 private:
  /// Of L, or the row of the same number.
  struct Column {
    std::size_t begin;  ///< Of its entries below the diagonal.
    std::size_t end;
    Wide sum = 0;  ///< Of the row that is computed: K less what the columns before make of it. In multiples of 2⁻¹⁰⁰.
    Wide slack = 0;  ///< The diagonal of E, or −E, less the absolute values beside it.
    Wide diagonal = 0;
    int sign = 1;
  };

  void add_row(std::size_t i) {
    std::vector<std::size_t> before;
    matrix_.each_column(i, seen_, [&](Index k) { before.push_back(k); });
    std::sort(before.begin(), before.end());
    set_matrix(i);
    double squares = 0;
    for (const std::size_t k : before) {
      Column& column = columns_[k];
      const Wide quotient = column.sum / column.diagonal;
      lose(i, k, column.sum % column.diagonal);
      column.sum = 0;
      expect_small(squares, quotient);
      for (std::size_t at = column.begin; at < column.end; ++at) columns_[row_[at]].sum -= quotient * value_[at];
      const Wide value = column.sign * quotient;
      columns_[i].sum -= quotient * value;
      row_[column.end] = static_cast<Index>(i);
      value_[column.end++] = static_cast<std::int64_t>(value);
    }
    Column& own = columns_[i];
    own.sign = own.sum < 0 ? -1 : 1;
    own.diagonal = static_cast<Wide>(std::sqrt(std::abs(static_cast<double>(own.sum))));
    if (own.diagonal == 0) give_inertia_up();
    expect_small(squares, own.diagonal);
    const Wide left = own.sum - own.sign * own.diagonal * own.diagonal;
    own.slack += kShift + (bound_ == Bound::at_most ? left : -left);
    own.sum = 0;
  }

  /// Row i of K, with the diagonal shifted by more than what is lost.
  void set_matrix(std::size_t i) {
    for (const Entry& entry : matrix_.entries_[i]) {
      const auto [lower, upper] = rounded(entry.energy - sigma_ * entry.mass);
      Wide& sum = columns_[entry.column].sum;
      if (entry.column < i) {
        sum = lower << kFraction;
        lose(i, entry.column, (upper - lower) << kFraction);
      } else {
        sum = bound_ == Bound::at_most ? (lower << kFraction) - kShift : (upper << kFraction) + kShift;
      }
    }
  }
  void lose(std::size_t i, std::size_t k, Wide error) {
    if (error < 0) error = -error;
    columns_[i].slack -= error;
    columns_[k].slack -= error;
  }
  /// Adds the square of an entry of L to those of its row. As their sum is small, no sum of products of entries of two
  /// rows overflows, by Schwarz' inequality.
  static void expect_small(double& squares, Wide entry) {
    const double value = std::ldexp(static_cast<double>(entry), -kFraction);
    squares += value * value;
    if (!(squares < kMostSquares)) give_inertia_up();
  }

  const Inertia& matrix_;
  const Interval& sigma_;
  Bound bound_;
  std::vector<Column> columns_;
  std::vector<Index> seen_;
  std::vector<Index> row_;  ///< By entry of L below the diagonal.
  std::vector<std::int64_t> value_;
};

std::size_t Inertia::negative(const Interval& sigma, Bound bound) const {
  const Factorisation factors(*this, sigma, bound);
  if (!factors.is_proved()) give_inertia_up();
  // Each eigenvalue is there `parts_` times: half of the number, rounded to the better bound, which is an integer.
  return (factors.negative() + (bound == Bound::at_least ? parts_ - 1 : 0)) / parts_;
}

// Sections of line bundles.

namespace {

mpz_class whole_part(const mpq_class& x) {
  mpz_class result;
  mpz_fdiv_q(result.get_mpz_t(), x.get_num_mpz_t(), x.get_den_mpz_t());
  return result;
}

mpq_class modulo_1(const mpq_class& x) { return x - whole_part(x); }

}  // namespace

LineBundle::LineBundle(std::vector<mpq_class> phases, const NetStructure& net)
    : phases_(std::move(phases)), net_(net) {}

void LineBundle::check() const {
  each_relation(net_, [&](const std::vector<Index>& sides, const std::string& name) {
    mpq_class sum;
    for (const Index s : sides) sum += phases_[s];
    if (sum.get_den() != 1) throw Refutation{"the phases of " + name + " do not add up to an integer"};
  });
}

Inertia::Values LineBundle::values() const {
  const auto is_half = [](const mpq_class& x) { return x.get_den() <= 2; };
  return std::all_of(phases_.begin(), phases_.end(), is_half) ? Inertia::Values::real : Inertia::Values::complex;
}

mpq_class LineBundle::of_label(Index label) const {
  mpq_class sum;
  if (label != 0) {
    for (const Index s : net_.net().labels[label - 1].word) sum += phases_[s];
  }
  return modulo_1(sum);
}

std::vector<mpq_class> LineBundle::across(Index halvings) const {
  std::map<Index, mpq_class> labels;
  const auto from_vertex = [&](Index dart) -> const mpq_class& {
    const Index label = net_.label_number(dart);
    const auto found = labels.find(label);
    return found != labels.end() ? found->second : labels.emplace(label, of_label(label)).first->second;
  };
  std::vector<mpq_class> result;
  // The vertex where a dart starts is that where the opposite one ends.
  for (Index dart = 0; dart < net_.darts(); ++dart)
    result.push_back(modulo_1(from_vertex(dart) - from_vertex(next(net_.opposite(dart)))));
  // Parts of a triangle have its frame.
  for (; halvings > 0; --halvings) {
    std::vector<mpq_class> halves(4 * result.size());
    for (Index dart = 0; dart < result.size(); ++dart)
      halves[first_half(dart)] = halves[second_half(dart)] = result[dart];
    result = std::move(halves);
  }
  return result;
}

std::vector<mpq_class> LineBundle::of_starts(const HalvedNet& halved, Index halvings) const {
  const std::vector<mpq_class> transitions = across(halvings);
  std::vector<mpq_class> result(transitions.size());
  std::vector<bool> seen(result.size());
  for (Index first = 0; first < result.size(); ++first) {
    // Around the vertex, from the triangle of the first dart, whose frame is the vertex's.
    mpq_class sum;
    for (Index dart = first; !seen[dart];) {
      seen[dart] = true;
      result[dart] = sum;
      dart = halved.opposite[previous(dart)];
      sum = modulo_1(sum + transitions[dart]);
    }
  }
  return result;
}

std::vector<mpq_class> LineBundle::of_sides(const HalvedNet& halved, Index halvings) const {
  std::vector<mpq_class> result = across(halvings);
  for (Index dart = 0; dart < result.size(); ++dart) {
    if (dart < halved.opposite[dart]) result[dart] = 0;
  }
  return result;
}

Inertia::Turn LineBundle::turn(const mpq_class& phase) {
  const mpz_class quarters = whole_part(4 * phase);
  const mpq_class rest = phase - mpq_class(quarters) / 4;  // Less than a quarter.
  Inertia::Turn result{1, 0};
  if (rest != 0) {
    const Interval angle = 2 * Interval(rest) * Interval::pi();
    result = {cos(angle), sin(angle)};
  }
  for (mpz_class i = 0; i < quarters; ++i) result = {-result[1], result[0]};
  return result;
}

}  // namespace epsnet::exact
