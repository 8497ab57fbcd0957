#include "netgen/surfaces/coset_enumeration.h"

#include <algorithm>
#include <stdexcept>

namespace epsnet {
namespace {

constexpr std::array kRotations{Rotation::x, Rotation::x_inverse, Rotation::y};

RotationWord power(const RotationWord& word, std::uint32_t exponent) {
  RotationWord result;
  for (std::uint32_t i = 0; i < exponent; ++i) result.insert(result.end(), word.begin(), word.end());
  return result;
}

}  // namespace

RotationWord inverse(const RotationWord& word) {
  RotationWord result(word.rbegin(), word.rend());
  for (Rotation& g : result) g = inverse(g);
  return result;
}

RotationWord parse_rotations(std::string_view text) {
  RotationWord result;
  for (const char letter : text) {
    result.push_back(letter == 'x' ? Rotation::x : letter == 'X' ? Rotation::x_inverse : Rotation::y);
  }
  return result;
}

std::vector<RotationWord> triangle_relators(RegularTile type) {
  return {power({Rotation::x}, type.p), {Rotation::y, Rotation::y}, power({Rotation::x, Rotation::y}, type.q)};
}

CosetTable::CosetTable(const std::vector<RotationWord>& relators, std::size_t most)
    : products_{Row{kUnknown, kUnknown, kUnknown}}, same_as_{0}, alive_(1) {
  // Elements that have been identified with others stay in the table until the end.
  const std::size_t most_rows = 20 * most;
  closed_ = true;
  for (std::uint32_t element = 0; element < products_.size() && closed_; ++element) {
    for (const RotationWord& relator : relators) {
      if (same_as_[element] == element) scan(element, relator);
    }
    for (const Rotation g : kRotations) {
      if (same_as_[element] == element && entry(element, g) == kUnknown) define(element, g);
    }
    closed_ = alive_ <= most && products_.size() <= most_rows;
  }
  renumber();
}

std::optional<std::uint32_t> CosetTable::product(std::uint32_t element, Rotation g) const {
  const std::uint32_t result = products_[element][static_cast<std::size_t>(g)];
  return result == kUnknown ? std::nullopt : std::optional(result);
}

std::optional<std::uint32_t> CosetTable::product(std::uint32_t element, const RotationWord& word) const {
  for (const Rotation g : word) {
    element = products_[element][static_cast<std::size_t>(g)];
    if (element == kUnknown) return std::nullopt;
  }
  return element;
}

DartMap CosetTable::map() const {
  DartMap result;
  for (const Row& row : products_) {
    result.rotation.push_back(row[static_cast<std::size_t>(Rotation::x)]);
    result.edges.push_back(row[static_cast<std::size_t>(Rotation::y)]);
  }
  return result;
}

void CosetTable::define(std::uint32_t element, Rotation g) {
  const auto product = static_cast<std::uint32_t>(products_.size());
  products_.push_back({kUnknown, kUnknown, kUnknown});
  same_as_.push_back(product);
  ++alive_;
  entry(element, g) = product;
  entry(product, inverse(g)) = element;
}

std::uint32_t CosetTable::alive(std::uint32_t element) {
  while (same_as_[element] != element) element = same_as_[element] = same_as_[same_as_[element]];
  return element;
}

/// Two numbers are the same element; then so are their products.
void CosetTable::identify(std::uint32_t a, std::uint32_t b) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pending{{a, b}};
  while (!pending.empty()) {
    const auto [first, second] = pending.back();
    pending.pop_back();
    const auto [kept, gone] = std::minmax({alive(first), alive(second)});
    if (kept == gone) continue;
    same_as_[gone] = kept;
    --alive_;
    for (const Rotation g : kRotations) {
      const std::uint32_t product = entry(gone, g);
      if (product == kUnknown) continue;
      entry(gone, g) = kUnknown;
      if (entry(product, inverse(g)) == gone) entry(product, inverse(g)) = kUnknown;
      const std::uint32_t from = alive(gone);
      const std::uint32_t to = alive(product);
      if (entry(from, g) != kUnknown) {
        pending.emplace_back(entry(from, g), to);
      } else if (entry(to, inverse(g)) != kUnknown) {
        pending.emplace_back(entry(to, inverse(g)), from);
      } else {
        entry(from, g) = to;
        entry(to, inverse(g)) = from;
      }
    }
  }
}

/// Follows a relator from an element on, forwards and backwards, and defines the products that are missing but one: the
/// end is the element again.
void CosetTable::scan(std::uint32_t element, const RotationWord& relator) {
  std::uint32_t front = element;
  std::uint32_t back = element;
  std::size_t first = 0;
  std::size_t last = relator.size();
  while (true) {
    while (first < last && entry(front, relator[first]) != kUnknown) front = entry(front, relator[first++]);
    while (last > first && entry(back, inverse(relator[last - 1])) != kUnknown) {
      back = entry(back, inverse(relator[--last]));
    }
    if (first == last) {
      identify(front, back);
      return;
    }
    if (first + 1 == last) {
      entry(front, relator[first]) = back;
      entry(back, inverse(relator[first])) = front;
      return;
    }
    define(front, relator[first]);
  }
}

/// Leaves out the numbers that are the same as others.
void CosetTable::renumber() {
  std::vector<std::uint32_t> number(products_.size(), kUnknown);
  std::vector<std::uint32_t> order{0};
  number[0] = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    for (const std::uint32_t product : products_[order[i]]) {
      if (product == kUnknown || number[product] != kUnknown) continue;
      number[product] = static_cast<std::uint32_t>(order.size());
      order.push_back(product);
    }
  }
  std::vector<Row> rows;
  rows.reserve(order.size());
  for (const std::uint32_t element : order) {
    Row row = products_[element];
    for (std::uint32_t& product : row) product = product == kUnknown ? kUnknown : number[product];
    rows.push_back(row);
  }
  products_ = std::move(rows);
  same_as_.clear();
}

}  // namespace epsnet
