#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>

#include "certify/base/interval.h"
#include "certify/base/tile.h"

/// What files consist of (docs/format.md), said once for the reader and the writer. The types of one claim are in the
/// `fields.h` of its folder.
///
/// `Fields<T>` says how a T stands in a file: as an array of these `elements`, as an object of these `members`, in the
/// order in which they are written, or as one of these `kNames`. Elements and members are references into a T, and what
/// they are in a file follows from their type:
///
/// | type | in a file |
/// | --- | --- |
/// | std::uint32_t | an index |
/// | double | a binary64 |
/// | mpq_class | a rational |
/// | std::vector<mpz_class> | a number of a field, or its polynomial: integers, on one line |
/// | std::string | a string |
/// | bool | true or false |
/// | std::vector<std::uint32_t> | a word, of which the length is limited |
/// | std::uint64_t, std::int64_t | an integer |
/// | std::vector<double> | numbers, on one line |
/// | std::vector<std::int64_t> | such integers, on one line |
/// | std::vector<T> | an array of T; each has a line, unless it is part of another one |
/// | Format, Version, List | see below |
namespace epsnet::certify {

template <class T>
struct Fields;

template <class T>
concept Array = requires(T& value) {
  Fields<T>::elements(value);
};
template <class T>
concept Object = requires(T& value) {
  Fields<T>::members(value);
};
template <class T>
concept Enumeration = std::is_enum_v<T>;

/// A member that is `optional` is written unless it is empty.
enum class Presence { required, optional, forbidden };

/// A member of an object. `Value` is a reference, or List, Format, Version.
template <class Value>
struct Member {
  std::string_view name;
  Value value;
  Presence presence = Presence::required;
  const char* condition = "";         ///< Words for what decides whether a member that is not optional is there.
  const char* expected = "a string";  ///< Words for what a string says.
  std::size_t rows = 0;               ///< A guess of how many elements an array has.

  [[nodiscard]] Member optional() && {
    presence = Presence::optional;
    return *this;
  }
  [[nodiscard]] Member only_if(bool wanted, const char* words) && {
    presence = wanted ? Presence::required : Presence::forbidden;
    condition = words;
    return *this;
  }
  [[nodiscard]] Member expecting(const char* words) && {
    expected = words;
    return *this;
  }
  [[nodiscard]] Member of_about(std::size_t guess) && {
    rows = guess;
    return *this;
  }
};

template <class Value>
Member<Value> member(std::string_view name, Value&& value) {
  return {name, std::forward<Value>(value)};
}

/// Indices that are no word and have no limits of their own. As an element: all elements that follow.
template <class Indices>
struct List {
  Indices& indices;
};
template <class Indices>
List(Indices&) -> List<Indices>;

/// The member `format` of the files of one kind.
struct Format {
  std::string_view name;
};
/// The member `version` of all files.
struct Version {
  std::uint32_t number = 1;
};

inline auto format_and_version(std::string_view format) {
  return std::tuple(member("format", Format{format}), member("version", Version()));
}

template <>
struct Fields<RationalPoint> {
  static constexpr const char* kExpected = "[x, y], two rationals";
  static auto elements(auto& point) { return std::tie(point.x, point.y); }
};

template <>
struct Fields<std::array<std::uint32_t, 2>> {
  static constexpr const char* kExpected = "two indices";
  static auto elements(auto& pair) { return std::tie(pair[0], pair[1]); }
};

template <>
struct Fields<std::array<double, 2>> {
  static constexpr const char* kExpected = "two numbers";
  static auto elements(auto& pair) { return std::tie(pair[0], pair[1]); }
};

template <>
struct Fields<Interval> {
  static constexpr const char* kExpected = "[lo, hi], two numbers";
  static auto elements(auto& interval) { return std::tie(interval.lower, interval.upper); }
};

/// One kind of claim: what a message or a test needs to know of its files. Fields of its document has it as `kKind`.
struct ClaimKind {
  std::string_view name;      ///< A file of this kind is a NAME file, and has a section with this title in format.md.
  std::string_view format;    ///< The member `format` of its files.
  std::string_view contents;  ///< What is in a file: "closed geodesics".
  std::string_view says;  ///< What such a file claims, one sentence of a few lines of 80 columns for `certify --help`.
  int section;            ///< The section of docs/proof.md with its theorem or its rules.

  /// Returns "a NAME file", or "an NAME file".
  [[nodiscard]] std::string file() const {
    const bool vowel = std::string_view("aeio").find(name.front()) != std::string_view::npos;
    return (vowel ? "an " : "a ") + std::string(name) + " file";
  }
};

}  // namespace epsnet::certify
