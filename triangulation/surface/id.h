#pragma once

#include <cassert>
#include <compare>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

/// Numbers of tiles, sides, charts, vertices and triangles as distinct types, so that none can stand for another.
namespace epsnet {

/// The number of one of the things that are of this kind, counted from 0. Converted from and to integers explicitly.
template <class Kind>
class Id {
 public:
  Id() = default;
  /// The id with a number. Requires: 0 ≤ number < 2^32.
  constexpr explicit Id(std::integral auto number) : number_(static_cast<std::uint32_t>(number)) {
    assert(std::in_range<std::uint32_t>(number));
  }

  /// The number.
  [[nodiscard]] constexpr std::uint32_t number() const { return number_; }
  constexpr Id& operator++() {
    ++number_;
    return *this;
  }
  friend constexpr auto operator<=>(Id, Id) = default;

 private:
  std::uint32_t number_;
};

/// The number, for messages.
template <class Kind>
[[nodiscard]] std::string to_string(Id<Kind> id) {
  return std::to_string(id.number());
}

/// The number of a tile of a surface.
using TileId = Id<struct TileKind>;
/// The number of a side of a tile, through all tiles of a surface; also that of the corner where the side starts.
using SideId = Id<struct SideKind>;
/// The number of a chart in an atlas.
using ChartId = Id<struct ChartKind>;
/// The number of a vertex in a triangulation.
using VertexId = Id<struct VertexKind>;
/// The number of a triangle in a triangulation.
using TriangleId = Id<struct TriangleKind>;

/// Successive numbers, in order: what a range-based for loop needs.
template <class I>
class Ids {
 public:
  /// Points to an id.
  class Iterator {
   public:
    /// Points to this id.
    constexpr explicit Iterator(I id) : id_(id) {}
    [[nodiscard]] constexpr I operator*() const { return id_; }
    constexpr Iterator& operator++() {
      ++id_;
      return *this;
    }
    friend constexpr bool operator==(Iterator, Iterator) = default;

   private:
    I id_;
  };

  /// The numbers less than `count`.
  constexpr explicit Ids(std::uint32_t count) : Ids(I(0), count) {}
  /// `count` numbers, from this one on.
  constexpr Ids(I first, std::uint32_t count) : first_(first), count_(count) {}
  /// The first number.
  [[nodiscard]] constexpr Iterator begin() const { return Iterator(first_); }
  /// Behind the last number.
  [[nodiscard]] constexpr Iterator end() const { return Iterator(I(first_.number() + count_)); }

 private:
  I first_;
  std::uint32_t count_;
};

/// A vector whose elements are those of these numbers.
template <class I, class T>
class ById : public std::vector<T> {
 public:
  using std::vector<T>::vector;
  [[nodiscard]] decltype(auto) operator[](I id) { return std::vector<T>::operator[](id.number()); }
  [[nodiscard]] decltype(auto) operator[](I id) const { return std::vector<T>::operator[](id.number()); }
  /// All numbers of elements.
  [[nodiscard]] Ids<I> ids() const { return Ids<I>(static_cast<std::uint32_t>(this->size())); }
  /// The number of the next element that is added.
  [[nodiscard]] I end_id() const { return I(this->size()); }
};

}  // namespace epsnet

/// \cond Doxygen does not know the namespace std.
/// The hash of the number.
template <class Kind>
struct std::hash<epsnet::Id<Kind>> {
  [[nodiscard]] std::size_t operator()(epsnet::Id<Kind> id) const noexcept {
    return std::hash<std::uint32_t>{}(id.number());
  }
};
/// \endcond
