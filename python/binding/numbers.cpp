#include <gmp.h>

#include "certify/numbers/ball.h"
#include "netgen/base/gmp.h"
#include "python/binding/binding.h"

/// Integers of Python and of GMP, by way of hexadecimal digits, which takes linear time on both sides.
namespace epsnet::python {
namespace {

py::object to_int(mpz_srcptr value) {
  std::string digits(mpz_sizeinbase(value, 16) + 2, '\0');
  mpz_get_str(digits.data(), 16, value);
  return py::reinterpret_steal<py::object>(PyLong_FromString(digits.c_str(), nullptr, 16));
}

/// False for what is no int.
bool set_integer(mpz_ptr result, const py::handle& value) {
  const auto integer = py::reinterpret_steal<py::object>(PyNumber_Index(value.ptr()));
  if (!integer) {
    PyErr_Clear();
    return false;
  }
  const auto text = py::reinterpret_steal<py::object>(PyNumber_ToBase(integer.ptr(), 16));
  return text && mpz_set_str(result, py::cast<std::string>(text).c_str(), 0) == 0;
}

/// An interval around arcosh x = 2 arsinh √((x − 1)/2), x at least 1; around 0 for less.
certify::Interval arcosh(const Rational& x) {
  if (x <= 1) return {0, 0};
  const certify::Precision precision(128);
  const certify::Ball half_of_excess = certify::Ball::rounded(mpq_class(to_gmp(Rational((x - 1) / 2))));
  return certify::outer_interval(certify::twice(certify::asinh(certify::sqrt(half_of_excess))));
}

}  // namespace

void bind_numbers(py::module_& module) {
  module.def("arcosh", [](const Rational& lower, const Rational& upper) {
    return certify::Interval{arcosh(lower).lower, arcosh(upper).upper};
  });
}

}  // namespace epsnet::python

namespace pybind11::detail {

bool type_caster<epsnet::Rational>::load(handle source, bool) {
  if (PyFloat_Check(source.ptr()) || !hasattr(source, "numerator") || !hasattr(source, "denominator")) return false;
  mpq_t number;
  mpq_init(number);
  const bool fits = epsnet::python::set_integer(mpq_numref(number), source.attr("numerator")) &&
                    epsnet::python::set_integer(mpq_denref(number), source.attr("denominator")) &&
                    mpz_sgn(mpq_denref(number)) > 0;
  if (fits) {
    mpq_canonicalize(number);
    value = epsnet::Rational(number);
  }
  mpq_clear(number);
  return fits;
}

handle type_caster<epsnet::Rational>::cast(const epsnet::Rational& value, return_value_policy, handle) {
  mpq_srcptr number = value.backend().data();
  const object fraction = module_::import("fractions").attr("Fraction");
  return fraction(epsnet::python::to_int(mpq_numref(number)), epsnet::python::to_int(mpq_denref(number))).release();
}

}  // namespace pybind11::detail
