#pragma once

#include <ostream>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>
#include <sstream>
#include <string>
#include <utility>

#include "certify/base/interval.h"
#include "certify/net/document.h"
#include "kernel/numbers.h"
#include "kernel/plane.h"
#include "triangulation/surface/id.h"
#include "triangulation/surface/surface.h"

/// The extension module `_epsnet`: classes and functions of the public headers, under names of their own. The package
/// of Python files around it makes of them what people use, and its .pyi says what is here.
namespace pybind11::detail {

/// Rational numbers are fractions.Fraction; an int or whatever has `numerator` and `denominator` is taken, too.
template <>
struct type_caster<epsnet::Rational> {
  PYBIND11_TYPE_CASTER(epsnet::Rational, const_name("fractions.Fraction"));
  bool load(handle source, bool);
  static handle cast(const epsnet::Rational& value, return_value_policy, handle);
};

/// Points of the disk with rational coordinates are pairs.
template <>
struct type_caster<epsnet::Complex<epsnet::Rational>> {
  PYBIND11_TYPE_CASTER(epsnet::Complex<epsnet::Rational>, const_name("tuple[fractions.Fraction, fractions.Fraction]"));
  bool load(handle source, bool convert) {
    make_caster<std::pair<epsnet::Rational, epsnet::Rational>> pair;
    if (!pair.load(source, convert)) return false;
    auto [x, y] = cast_op<std::pair<epsnet::Rational, epsnet::Rational>>(std::move(pair));
    value = {std::move(x), std::move(y)};
    return true;
  }
  static handle cast(const epsnet::Complex<epsnet::Rational>& z, return_value_policy policy, handle parent) {
    return make_caster<std::pair<epsnet::Rational, epsnet::Rational>>::cast(std::pair(z.x, z.y), policy, parent);
  }
};

/// Numbers of something are ints.
template <class Kind>
struct type_caster<epsnet::Id<Kind>> {
  PYBIND11_TYPE_CASTER(epsnet::Id<Kind>, const_name("int"));
  bool load(handle source, bool convert) {
    make_caster<std::uint32_t> number;
    if (!number.load(source, convert)) return false;
    value = epsnet::Id<Kind>(cast_op<std::uint32_t>(number));
    return true;
  }
  static handle cast(epsnet::Id<Kind> id, return_value_policy policy, handle parent) {
    return make_caster<std::uint32_t>::cast(id.number(), policy, parent);
  }
};

/// Points of surfaces: (tile, (x, y)).
template <>
struct type_caster<epsnet::BasePoint> {
  PYBIND11_TYPE_CASTER(epsnet::BasePoint, const_name("tuple[int, tuple[fractions.Fraction, fractions.Fraction]]"));
  using Pair = std::pair<epsnet::TileId, epsnet::Complex<epsnet::Rational>>;
  bool load(handle source, bool convert) {
    make_caster<Pair> pair;
    if (!pair.load(source, convert)) return false;
    auto [tile, z] = cast_op<Pair>(std::move(pair));
    value = {tile, std::move(z)};
    return true;
  }
  static handle cast(const epsnet::BasePoint& point, return_value_policy policy, handle parent) {
    return make_caster<Pair>::cast(Pair(point.tile, point.z), policy, parent);
  }
};

/// Intervals are pairs of floats.
template <>
struct type_caster<epsnet::certify::Interval> {
  PYBIND11_TYPE_CASTER(epsnet::certify::Interval, const_name("tuple[float, float]"));
  bool load(handle source, bool convert) {
    make_caster<std::pair<double, double>> pair;
    if (!pair.load(source, convert)) return false;
    const auto [lower, upper] = cast_op<std::pair<double, double>>(std::move(pair));
    value = {lower, upper};
    return true;
  }
  static handle cast(epsnet::certify::Interval x, return_value_policy policy, handle parent) {
    return make_caster<std::pair<double, double>>::cast(std::pair(x.lower, x.upper), policy, parent);
  }
};

/// Isometries are (a, b), each a pair of exact numbers.
template <>
struct type_caster<epsnet::Isometry<epsnet::Rational>> {
  PYBIND11_TYPE_CASTER(epsnet::Isometry<epsnet::Rational>, const_name("tuple"));
  static bool load(handle, bool) { return false; }
  static handle cast(const epsnet::Isometry<epsnet::Rational>& f, return_value_policy policy, handle parent) {
    using Pair = std::pair<epsnet::Complex<epsnet::Rational>, epsnet::Complex<epsnet::Rational>>;
    return make_caster<Pair>::cast(Pair(f.a, f.b), policy, parent);
  }
};

}  // namespace pybind11::detail

namespace epsnet::python {

namespace py = pybind11;

/// The text that `write(stream)` writes, as bytes of UTF-8.
template <class Write>
std::string written(const Write& write) {
  std::ostringstream out;
  write(out);
  return std::move(out).str();
}

/// A read-only array of NumPy of the memory of `owner`, which it keeps alive.
template <class T>
py::array view(const py::object& owner, const void* data, std::vector<py::ssize_t> shape,
               std::vector<py::ssize_t> strides) {
  py::array array(py::dtype::of<T>(), std::move(shape), std::move(strides), data, owner);
  py::detail::array_proxy(array.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
  return array;
}

void bind_certificates(py::module_& module);
void bind_distances(py::module_& module);
void bind_eigenvalues(py::module_& module);
void bind_errors(py::module_& module);
void bind_files(py::module_& module);
void bind_geodesics(py::module_& module);
void bind_isometries(py::module_& module);
void bind_nets(py::module_& module);
void bind_numbers(py::module_& module);
void bind_pants(py::module_& module);
void bind_surfaces(py::module_& module);

}  // namespace epsnet::python
