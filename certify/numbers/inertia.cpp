#include "certify/numbers/inertia.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <utility>

#include "certify/base/error.h"
#include "certify/numbers/ball.h"
#include "certify/numbers/parallel.h"

namespace epsnet::certify {
namespace {

constexpr std::uint32_t kNone = ~std::uint32_t{0};
/// Products of three such numbers, and sums of 2²⁸ of these, are less than 2⁵⁰⁰.
constexpr double kGreatest = 0x1p150;

/// In which order columns are eliminated, and what each leaves behind: the column that is eliminated first among those
/// below the diagonal of the factor is its parent, and a column comes after its children.
struct EliminationTree {
  std::vector<std::uint32_t> parent;
  std::vector<std::uint32_t> below;  ///< By column: the number of entries of the factor below the diagonal.
};

/// By row its entries left of the diagonal, as columns.
struct Rows {
  std::vector<std::size_t> first;
  std::vector<std::uint32_t> columns;

  [[nodiscard]] std::span<const std::uint32_t> operator[](std::uint32_t row) const {
    return std::span(columns).subspan(first[row], first[row + 1] - first[row]);
  }
};

Rows rows_of(std::uint32_t size, std::span<const MatrixEntry> entries) {
  Rows rows{std::vector<std::size_t>(size + 1), {}};
  for (const MatrixEntry& entry : entries) rows.first[entry.row + 1] += entry.row != entry.column ? 1 : 0;
  std::partial_sum(rows.first.begin(), rows.first.end(), rows.first.begin());
  rows.columns.resize(rows.first.back());
  std::vector<std::size_t> next(rows.first.begin(), rows.first.end() - 1);
  for (const MatrixEntry& entry : entries) {
    if (entry.row != entry.column) rows.columns[next[entry.row]++] = entry.column;
  }
  return rows;
}

/// Liu's algorithm: ancestors are shortened to where they lead.
std::vector<std::uint32_t> parents(const Rows& rows, std::uint32_t size) {
  std::vector<std::uint32_t> parent(size, kNone);
  std::vector<std::uint32_t> ancestor(size, kNone);
  for (std::uint32_t row = 0; row < size; ++row) {
    for (std::uint32_t column : rows[row]) {
      while (column != kNone && column < row) {
        const std::uint32_t next = ancestor[column];
        ancestor[column] = row;
        if (next == kNone) parent[column] = row;
        column = next;
      }
    }
  }
  return parent;
}

/// Row i of the factor has an entry in column j if j is between an entry of the matrix in this row and i in the tree.
EliminationTree elimination_tree(std::uint32_t size, std::span<const MatrixEntry> entries, const Budget& budget) {
  const Rows rows = rows_of(size, entries);
  EliminationTree tree{parents(rows, size), std::vector<std::uint32_t>(size)};
  std::vector<std::uint32_t> seen(size, kNone);
  for (std::uint32_t row = 0; row < size; ++row) {
    seen[row] = row;
    std::uint64_t entries_of_row = 1;
    for (std::uint32_t column : rows[row]) {
      for (; seen[column] != row; column = tree.parent[column], ++entries_of_row) {
        seen[column] = row;
        ++tree.below[column];
      }
    }
    budget.spend(2 * entries_of_row);
  }
  return tree;
}

/// The columns of a tree such that each comes after its children and the descendants of each are one after the other.
std::vector<std::uint32_t> postorder(const std::vector<std::uint32_t>& parent) {
  const auto size = static_cast<std::uint32_t>(parent.size());
  std::vector<std::uint32_t> child(size + 1, kNone);  // The first one; of the roots, at the end.
  std::vector<std::uint32_t> sibling(size, kNone);
  for (std::uint32_t column = size; column-- > 0;) {
    std::uint32_t& first = child[parent[column] == kNone ? size : parent[column]];
    sibling[column] = first;
    first = column;
  }
  std::vector<std::uint32_t> order;
  std::vector<std::uint32_t> open;
  const auto descend = [&](std::uint32_t column) {
    for (; column != kNone; column = child[column]) open.push_back(column);
  };
  descend(child[size]);
  while (!open.empty()) {
    const std::uint32_t column = open.back();
    open.pop_back();
    order.push_back(column);
    descend(sibling[column]);
  }
  return order;
}

/// A part of the factor that is dense: columns `first` to `last` − 1, of which each but the last has the next one as
/// its parent and the same rows below.
struct Panel {
  std::uint32_t first;
  std::uint32_t last;
  std::uint32_t below;  ///< Rows below all of them.

  [[nodiscard]] std::uint64_t columns() const { return last - first; }
  [[nodiscard]] std::uint64_t rows() const { return columns() + below; }
};

std::vector<Panel> panels_of(const EliminationTree& tree) {
  std::vector<Panel> panels;
  for (std::uint32_t column = 0; column < tree.parent.size(); ++column) {
    const bool continued =
        column > 0 && tree.parent[column - 1] == column && tree.below[column - 1] == tree.below[column] + 1;
    if (!continued) panels.push_back({column, column, 0});
    panels.back().last = column + 1;
    panels.back().below = tree.below[column];
  }
  return panels;
}

constexpr std::uint32_t kColumnsOfBlock = 48;  ///< Columns that are eliminated together.

/// How many additions a term of a sum of the factorization passes through, at most: those of the columns of its block;
/// in its panel one for each child and each block; and in all panels above one for each block, and, as what children
/// leave is added from the last child to the first, one for the child that it comes from and each before it.
double most_additions(const std::vector<Panel>& panels, const std::vector<std::uint32_t>& parent,
                      const std::vector<std::size_t>& children) {
  const auto blocks = [&](std::size_t p) {
    return std::ceil(static_cast<double>(panels[p].columns()) / kColumnsOfBlock);
  };
  std::vector<std::size_t> left = children;
  std::vector<double> above_panel(panels.size());
  double most = 0;
  std::uint32_t widest = 0;
  for (std::size_t p = panels.size(); p-- > 0;) {
    if (parent[p] != kNone)
      above_panel[p] = static_cast<double>(left[parent[p]]--) + blocks(parent[p]) + above_panel[parent[p]];
    most = std::max(most, static_cast<double>(children[p]) + blocks(p) + above_panel[p]);
    widest = std::max(widest, static_cast<std::uint32_t>(panels[p].columns()));
  }
  return most + 2 * std::min(widest, kColumnsOfBlock);
}

/// A square matrix by columns, of which what is above the diagonal is not used.
class Square {
 public:
  explicit Square(std::size_t size) : size_(size), values_(size * size) {}
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] double* column(std::size_t j) { return values_.data() + j * size_; }
  [[nodiscard]] const double* column(std::size_t j) const { return values_.data() + j * size_; }

 private:
  std::size_t size_;
  std::vector<double> values_;
};

/// What a panel leaves to its ancestors: what is to be added to the matrix of these rows.
struct Update {
  std::vector<std::uint32_t> rows;
  Square matrix;
};

/// A block of four columns from `from` on loses L·W, L and W by columns: rows × depth, and depth rows of four.
void subtract(double* const (&to)[4], std::size_t rows, const double* factor, std::size_t stride, const double* weights,
              std::size_t depth) {
  constexpr std::size_t kRows = 4;
  std::size_t i = 0;
  for (; i + kRows <= rows; i += kRows) {
    double sums[4][kRows] = {};
    for (std::size_t k = 0; k < depth; ++k) {
      const double* l = factor + k * stride + i;
      const double* w = weights + 4 * k;
      for (std::size_t j = 0; j < 4; ++j) {
        for (std::size_t r = 0; r < kRows; ++r) sums[j][r] += l[r] * w[j];
      }
    }
    for (std::size_t j = 0; j < 4; ++j) {
      for (std::size_t r = 0; r < kRows; ++r) to[j][i + r] -= sums[j][r];
    }
  }
  for (; i < rows; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      double sum = 0;
      for (std::size_t k = 0; k < depth; ++k) sum += factor[k * stride + i] * weights[4 * k + j];
      to[j][i] -= sum;
    }
  }
}

/// Eliminates the columns of a matrix, panel by panel.
class Elimination {
 public:
  Elimination(std::uint32_t size, std::span<const MatrixEntry> entries, const std::vector<double>& diagonal,
              unsigned threads)
      : entries_(entries), diagonal_(diagonal), threads_(threads), seen_(size, kNone), place_(size), errors_(size) {}

  /// Panels come in their order.
  void eliminate(const Panel& panel, std::size_t children) {
    std::vector<std::uint32_t> rows = rows_of(panel, children);
    Square front(rows.size());
    for (std::uint32_t i = 0; i < rows.size(); ++i) place_[rows[i]] = i;
    add_entries(panel, front);
    for (std::size_t i = 0; i < children; ++i) {
      add(updates_.back(), front);
      updates_.pop_back();
    }
    const std::size_t columns = panel.columns();
    factor(front, columns);
    count(rows, front, columns);
    if (panel.below == 0) return;
    Update update{{rows.begin() + static_cast<std::ptrdiff_t>(columns), rows.end()}, Square(panel.below)};
    for (std::size_t j = 0; j < panel.below; ++j)
      std::copy(front.column(columns + j) + columns + j, front.column(columns + j) + rows.size(),
                update.matrix.column(j) + j);
    updates_.push_back(std::move(update));
  }

  [[nodiscard]] std::uint32_t negative() const { return negative_; }
  /// Whether all numbers are those for which Lemma 36.1 holds.
  [[nodiscard]] bool in_range() const { return in_range_; }
  /// By row i: the sum of |l_ik||d_k||l_jk| for all k and j, rounded.
  [[nodiscard]] const std::vector<double>& errors() const { return errors_; }

 private:
  /// In increasing order: those of the panel, of its entries, and what its children leave.
  [[nodiscard]] std::vector<std::uint32_t> rows_of(const Panel& panel, std::size_t children) {
    std::vector<std::uint32_t> rows(panel.columns());
    std::iota(rows.begin(), rows.end(), panel.first);
    const auto take = [&](std::uint32_t row) {
      if (row < panel.last || seen_[row] == panel.first) return;
      seen_[row] = panel.first;
      rows.push_back(row);
    };
    for (std::size_t i = updates_.size() - children; i < updates_.size(); ++i) {
      for (const std::uint32_t row : updates_[i].rows) take(row);
    }
    for (std::size_t i = next_entry_; i < entries_.size() && entries_[i].column < panel.last; ++i)
      take(entries_[i].row);
    std::sort(rows.begin(), rows.end());
    ensure(rows.size() == panel.rows(), "a panel has other rows than were counted");
    return rows;
  }

  void add_entries(const Panel& panel, Square& front) {
    for (; next_entry_ < entries_.size() && entries_[next_entry_].column < panel.last; ++next_entry_) {
      const auto& [row, column, value, error] = entries_[next_entry_];
      front.column(place_[column])[place_[row]] += row == column ? diagonal_[row] : value;
    }
  }

  void add(const Update& update, Square& front) const {
    for (std::size_t j = 0; j < update.rows.size(); ++j) {
      double* to = front.column(place_[update.rows[j]]);
      const double* from = update.matrix.column(j);
      for (std::size_t i = j; i < update.rows.size(); ++i) to[place_[update.rows[i]]] += from[i];
    }
  }

  /// Replaces the first columns by those of L below the diagonal and D on it, the others by what is left to eliminate.
  void factor(Square& front, std::size_t columns) const {
    const std::size_t size = front.size();
    for (std::size_t first = 0; first < columns; first += kColumnsOfBlock) {
      const std::size_t last = std::min(first + kColumnsOfBlock, columns);
      for (std::size_t k = first; k < last; ++k) {
        double* pivot = front.column(k);
        const double d = pivot[k];
        for (std::size_t i = k + 1; i < size; ++i) pivot[i] /= d;
        for (std::size_t j = k + 1; j < last; ++j) {
          double* to = front.column(j);
          const double weight = pivot[j] * d;
          for (std::size_t i = j; i < size; ++i) to[i] -= pivot[i] * weight;
        }
      }
      if (last < size) subtract_block(front, first, last);
    }
  }

  /// Takes columns first to last − 1, which are done, off those behind them.
  void subtract_block(Square& front, std::size_t first, std::size_t last) const {
    constexpr std::size_t kWorth = 400;  // Threads are worth their while.
    const std::size_t size = front.size();
    const std::size_t depth = last - first;
    const std::size_t groups = (size - last + 3) / 4;
    for_each_parallel((groups + 15) / 16, size - last > kWorth ? threads_ : 1, [&](unsigned, std::size_t task) {
      std::vector<double> weights(4 * depth);
      std::vector<double> beyond(size);  // Columns behind the last one.
      for (std::size_t group = 16 * task; group < std::min(groups, 16 * (task + 1)); ++group) {
        const std::size_t column = last + 4 * group;
        double* to[4];
        for (std::size_t j = 0; j < 4; ++j) {
          const bool there = column + j < size;
          to[j] = there ? front.column(column + j) + column : beyond.data();
          for (std::size_t k = 0; k < depth; ++k) {
            const double* pivot = front.column(first + k);
            weights[4 * k + j] = there ? pivot[column + j] * pivot[first + k] : 0;
          }
        }
        subtract(to, size - column, front.column(first) + column, size, weights.data(), depth);
      }
    });
  }

  /// Signs of pivots, and what bounds the rounding errors.
  void count(const std::vector<std::uint32_t>& rows, const Square& front, std::size_t columns) {
    for (std::size_t k = 0; k < columns; ++k) {
      const double* column = front.column(k);
      const double d = column[k];
      if (d < 0) ++negative_;
      double sum = 1;
      for (std::size_t i = k + 1; i < rows.size(); ++i) sum += std::abs(column[i]);
      // What is not a number is not less.
      if (!(sum < kGreatest && 0 < std::abs(d) && std::abs(d) < kGreatest)) in_range_ = false;
      const double weight = std::abs(d) * sum;
      errors_[rows[k]] += weight;
      for (std::size_t i = k + 1; i < rows.size(); ++i) errors_[rows[i]] += std::abs(column[i]) * weight;
    }
  }

  std::span<const MatrixEntry> entries_;
  std::size_t next_entry_ = 0;
  const std::vector<double>& diagonal_;
  unsigned threads_;
  std::vector<std::uint32_t> seen_;   ///< By row: the first column of the last panel that it was a row of.
  std::vector<std::uint32_t> place_;  ///< By row, in the front.
  std::vector<Update> updates_;
  std::uint32_t negative_ = 0;
  bool in_range_ = true;
  std::vector<double> errors_;
};

/// Entries with other rows and columns, sorted, those of the same place added. Errors are rounded up.
std::vector<MatrixEntry> merged(std::vector<MatrixEntry> entries) {
  std::sort(entries.begin(), entries.end(), [](const MatrixEntry& x, const MatrixEntry& y) {
    return std::pair(x.column, x.row) < std::pair(y.column, y.row);
  });
  std::vector<MatrixEntry> result;
  for (const MatrixEntry& entry : entries) {
    if (!result.empty() && result.back().row == entry.row && result.back().column == entry.column) {
      MatrixEntry& last = result.back();
      last.value += entry.value;
      // The sum is rounded by at most half a unit in the last place of its value.
      last.error = above(above(last.error + entry.error) + std::abs(last.value) * 0x1p-52);
    } else {
      result.push_back(entry);
    }
  }
  return result;
}

}  // namespace

SparseMatrix::SparseMatrix(std::uint32_t size, std::vector<MatrixEntry> entries) : size_(size) {
  for (std::uint32_t i = 0; i < size; ++i) entries.push_back({i, i, 0, 0});
  entries_ = merged(std::move(entries));
}

Inertia SparseMatrix::negative_eigenvalues(Bound bound, const Budget& budget, unsigned threads,
                                           std::optional<std::uint64_t> wanted) const {
  budget.spend(100, entries_.size());
  // Columns are put so that each comes right after its descendants: the same factor, in another order.
  const std::vector<std::uint32_t> order = postorder(parents(rows_of(size_, entries_), size_));
  std::vector<std::uint32_t> place(size_);
  for (std::uint32_t i = 0; i < size_; ++i) place[order[i]] = i;
  std::vector<MatrixEntry> entries;
  entries.reserve(entries_.size());
  for (const MatrixEntry& entry : entries_) {
    const auto [column, row] = std::minmax(place[entry.row], place[entry.column]);
    entries.push_back({row, column, entry.value, entry.error});
  }
  entries = merged(std::move(entries));
  const EliminationTree tree = elimination_tree(size_, entries, budget);
  const std::vector<Panel> panels = panels_of(tree);

  // By row: the sums of errors and of absolute values, a little too large.
  std::vector<double> errors(size_);
  std::vector<double> sums(size_);
  std::vector<double> pivots(size_);
  for (const auto& [row, column, value, error] : entries) {
    errors[row] = above(errors[row] + error);
    sums[row] = above(sums[row] + std::abs(value));
    if (row == column) {
      pivots[row] = value;
    } else {
      errors[column] = above(errors[column] + error);
      sums[column] = above(sums[column] + std::abs(value));
    }
  }

  // By panel, its parent and the number of its children; and how much is to be computed and kept.
  std::vector<std::uint32_t> parent(panels.size(), kNone);
  std::vector<std::size_t> children(panels.size());
  std::vector<std::uint32_t> panel_of(size_);
  for (std::uint32_t p = 0; p < panels.size(); ++p) {
    for (std::uint32_t column = panels[p].first; column < panels[p].last; ++column) panel_of[column] = p;
  }
  std::uint64_t work = 0;
  std::uint64_t kept = 0;
  std::uint64_t most_kept = 0;
  std::vector<std::uint64_t> open;
  for (std::uint32_t p = 0; p < panels.size(); ++p) {
    const Panel& panel = panels[p];
    const std::uint64_t rows = panel.rows();
    most_kept = std::max(most_kept, kept + rows * rows + std::uint64_t{panel.below} * panel.below);
    for (std::size_t i = 0; i < children[p]; ++i) {
      kept -= open.back();
      open.pop_back();
    }
    if (panel.below > 0) {
      open.push_back(std::uint64_t{panel.below} * panel.below);
      kept += open.back();
      parent[p] = panel_of[tree.parent[panel.last - 1]];
      ++children[parent[p]];
    }
    // Half of the squares of the numbers of rows that are left, column by column, of which a core does three in a
    // nanosecond; and what is moved.
    work += (rows * rows * rows - std::uint64_t{panel.below} * panel.below * panel.below) / 18 + 4 * rows * rows;
  }
  budget.require(memory_work(sizeof(double)), most_kept);
  budget.spend(2, most_kept);

  // `share` of the sums is set aside for rounding errors.
  const auto factored = [&](double share) -> Inertia {
    budget.spend(1, work);
    std::vector<double> shifts(size_);
    std::vector<double> diagonal(size_);
    for (std::uint32_t i = 0; i < size_; ++i) {
      shifts[i] = sums[i] * share;
      // What is added is rounded towards what is to be proved.
      const double added = above(above(errors[i] + shifts[i]) + std::abs(pivots[i]) * 0x1p-52);
      diagonal[i] = pivots[i] + (bound == Bound::upper ? -added : added);
    }
    Elimination elimination(size_, entries, diagonal, threads);
    for (std::size_t p = 0; p < panels.size(); ++p) elimination.eliminate(panels[p], children[p]);

    // A little more than in the lemma, for the rounding of the sums.
    const double rounding = (most_additions(panels, parent, children) + 3) * 0x1.1p-53;
    const double underflow = (size_ + 3.0) * size_ * 0x1p-499;
    bool proved = elimination.in_range();
    for (std::uint32_t i = 0; i < size_; ++i)
      proved = proved && sums[i] < kGreatest && elimination.errors()[i] * rounding + underflow < shifts[i];
    return {elimination.negative(), proved};
  };
  const Inertia usual = factored(0x1p-32);
  if (!usual.proved) return factored(0x1p-26);
  if (!wanted || (bound == Bound::upper ? usual.negative <= *wanted : usual.negative >= *wanted)) return usual;
  // Eigenvalues of a matrix that are very near 0: little is lost by rounding if all small pivots belong to them.
  const Inertia finer = factored(0x1p-40);
  return finer.proved ? finer : usual;
}

}  // namespace epsnet::certify
