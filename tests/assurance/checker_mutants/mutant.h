#pragma once

#include <cstddef>
#include <gmpxx.h>
#include <iterator>
#include <type_traits>
#include <utility>

/// Functions that the mutated copy of the checkers calls.
namespace mutant {

extern unsigned active;         ///< The mutant that runs; 0: none.
extern unsigned char* reached;  ///< One byte for each mutant, not 0 if its place was reached.

/// Whether this mutant is active; records that its place was reached.
inline bool at(unsigned number) {
  if (reached[number] == 0) reached[number] = 1;
  return number == active;
}

template <class T>
struct Value {
  using type = T;
};
template <class T, class U>
struct Value<__gmp_expr<T, U>> {
  using type = __gmp_expr<T, T>;
};

/// Returns the value of an expression; evaluates the lazy expressions of GMP to a number.
template <class T>
typename Value<std::decay_t<T>>::type value(T&& x) {
  return typename Value<std::decay_t<T>>::type(std::forward<T>(x));
}

template <class T>
T one_less(T count) {
  return count == 0 ? 0 : count - 1;
}
template <class T>
T at_most_one(T count) {
  return count == 0 ? 0 : 1;
}

/// A range without its first or last element if the mutant is active.
template <class Range, bool last>
struct Part {
  Range range;
  unsigned number;
  [[nodiscard]] auto begin() {
    auto it = std::begin(range);
    if (!last && at(number) && it != std::end(range)) ++it;
    return it;
  }
  [[nodiscard]] auto end() {
    const auto first = std::begin(range);
    const auto end = std::end(range);
    if (!last || !at(number) || first == end) return end;
    auto it = first;
    for (auto next = std::next(it); next != end; ++next) it = next;
    return it;
  }
};
template <class Range>
Part<Range, false> part(unsigned number, Range&& range) {
  return {std::forward<Range>(range), number};
}
template <class Range>
Part<Range, true> but_last(unsigned number, Range&& range) {
  return {std::forward<Range>(range), number};
}

/// A range of its first element alone if the mutant is active.
template <class Range>
struct First {
  Range range;
  unsigned number;
  [[nodiscard]] auto begin() { return std::begin(range); }
  [[nodiscard]] auto end() {
    const auto first = std::begin(range);
    const auto end = std::end(range);
    return !at(number) || first == end ? end : std::next(first);
  }
};
template <class Range>
First<Range> first_alone(unsigned number, Range&& range) {
  return {std::forward<Range>(range), number};
}
template <class Iterator>
Iterator after_first(Iterator first, Iterator last) {
  return first == last ? last : std::next(first);
}

/// An interval of its centre alone, or a ball without its radius.
template <class T>
T centre(T x) {
  if constexpr (requires { x.lower = x.upper; }) {
    x.lower = x.upper = (x.lower + x.upper) / 2;
  } else {
    arb_get_mid_arb(x.get(), x.get());
  }
  return x;
}

}  // namespace mutant
