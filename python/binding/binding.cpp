#include "python/binding/binding.h"

#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <gmp.h>
#include <unistd.h>
#include <variant>

#include "certify/base/interval.h"
#include "certify/check.h"
#include "certify/file/file.h"
#include "certify/numbers/ball.h"
#include "certify/verdict/report.h"
#include "netgen/base/atomic_file.h"
#include "netgen/base/gmp.h"
#include "netgen/base/options.h"

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

namespace epsnet::python {

// Jobs.

namespace {

constexpr std::chrono::milliseconds kInterval(50);
constexpr std::chrono::milliseconds kPatience(500);

/// Thrown in a computation that nobody waits for.
struct Abandoned {};

/// Computations that nobody waits for, and that have not ended.
std::atomic<int> abandoned_jobs = 0;

/// Such a computation would go on in a process whose static objects are being destroyed.
void leave_at_once(int status, void*) {
  if (abandoned_jobs.load() == 0) return;
  remove_temporary_files();
  std::fflush(nullptr);
  _exit(status);
}

}  // namespace

Progress JobState::progress(const std::shared_ptr<JobState>& state) {
  return [state](std::string_view what, double share) {
    const std::lock_guard lock(state->mutex_);
    if (state->abandoned_) throw Abandoned();
    state->what_ = what;
    state->share_ = share;
    state->told_ = true;
  };
}

void JobState::run(const std::function<void()>& computation) {
  std::exception_ptr error;
  try {
    computation();
  } catch (...) {
    error = std::current_exception();
  }
  const std::lock_guard lock(mutex_);
  error_ = error;
  ended_ = true;
  if (abandoned_) --abandoned_jobs;
  ended_signal_.notify_all();
}

void JobState::wait(const py::object& callback) {
  const auto ended = [this] { return ended_; };
  for (bool first = true;; first = false) {
    {
      const py::gil_scoped_release released;
      std::unique_lock lock(mutex_);
      // The first look is early, so that a callback hears of short computations, too.
      if (ended_signal_.wait_for(lock, first ? kInterval / 10 : kInterval, ended)) break;
    }
    try {
      look(callback);
    } catch (...) {
      abandon();
      throw;
    }
  }
  if (told_ && !callback.is_none() && !error_) callback(what_, share_);
  if (error_) std::rethrow_exception(error_);
}

void JobState::look(const py::object& callback) {
  if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  py::module_::import("epsnet._progress").attr("poll")();
  if (callback.is_none()) return;
  std::string what;
  double share = 0;
  {
    const std::lock_guard lock(mutex_);
    if (!told_) return;
    told_ = false;
    what = what_;
    share = share_;
  }
  callback(what, share);
}

void JobState::abandon() {
  static std::once_flag once;
  std::call_once(once, [] { on_exit(leave_at_once, nullptr); });
  const py::gil_scoped_release released;
  std::unique_lock lock(mutex_);
  if (ended_) return;
  abandoned_ = true;
  ++abandoned_jobs;
  ended_signal_.wait_for(lock, kPatience, [this] { return ended_; });
}

std::string svg_of(const std::function<PolygonPicture()>& make, std::uint32_t size) {
  const auto [svg, left_out] = interruptible([make, size] {
    PolygonPicture picture = make();
    return std::pair(draw_svg(picture, size), std::move(picture.left_out));
  });
  warn_of(left_out);
  return svg;
}

void warn_of(const std::vector<std::string>& left_out) {
  for (const std::string& what : left_out) {
    if (PyErr_WarnEx(PyExc_UserWarning, ("left out: " + what).c_str(), 1) != 0) throw py::error_already_set();
  }
}

void save(const std::filesystem::path& path, const std::function<void(std::ostream&)>& write) {
  interruptible([path, write](const Progress& progress) {
    write_files_atomically({{path, write}}, [&] { progress("writing", 1); });
  });
}

// Certificates, and files of any claim.

namespace {

using certify::Certificate;

py::dict counts_of(const Certificate& certificate) {
  const certify::Counts& counts = certificate.counts;
  py::dict result;
  result["vertices"] = counts.vertices;
  result["edges"] = counts.edges;
  result["triangles"] = counts.triangles;
  result["genus"] = counts.genus;
  result["tiles"] = counts.tiles;
  result["charts"] = counts.charts;
  result["labels"] = counts.labels;
  result["label_identities"] = counts.label_identities;
  result["exact_ties"] = counts.exact_ties;
  result["triangles_beyond_64_bits"] = counts.triangles_beyond_64_bits;
  result["max_precision_used"] = counts.max_precision_used;
  result["work"] = counts.work;
  if (counts.collars) result["collars"] = *counts.collars;
  if (const auto& geodesics = certificate.geodesics) {
    result["geodesics"] = geodesics->geodesics;
    result["lifted_triangles"] = geodesics->lifted_triangles;
    result["candidates"] = geodesics->candidates;
    result["deep_vertices"] = geodesics->deep_vertices;
  }
  return result;
}

py::dict enclosures_of(const Certificate& certificate) {
  py::dict result;
  if (!certificate.enclosures) return result;
  const certify::Enclosures& enclosures = *certificate.enclosures;
  result["epsilon"] = enclosures.epsilon;
  result["area"] = enclosures.area;
  result["largest_circumradius"] = enclosures.largest_circumradius;
  result["longest_edge"] = enclosures.longest_edge;
  if (enclosures.shortest_edge) result["shortest_edge"] = *enclosures.shortest_edge;
  if (enclosures.shortest_loop) result["shortest_loop"] = *enclosures.shortest_loop;
  if (enclosures.shortest_core) result["shortest_core"] = *enclosures.shortest_core;
  return result;
}

}  // namespace

void bind_certificates(py::module_& module) {
  py::class_<Certificate>(module, "Certificate")
      .def_property_readonly("verdict", [](const Certificate& c) { return certify::name(c.verdict); })
      .def_readonly("claim", &Certificate::claim)
      .def_readonly("rule", &Certificate::rule)
      .def_readonly("message", &Certificate::message)
      .def_property_readonly("rules",
                             [](const Certificate& c) {
                               std::vector<std::tuple<std::string, std::string, std::string>> rules;
                               for (const certify::RuleReport& report : c.rules) {
                                 rules.emplace_back(report.rule, certify::name(report.verdict), report.text);
                               }
                               return rules;
                             })
      .def_readonly("ties", &Certificate::ties)
      .def_property_readonly("counts", &counts_of)
      .def_property_readonly("enclosures", &enclosures_of)
      .def_property_readonly("line", [](const Certificate& c) { return certify::verdict_line(c); });
  module.def("decimal_below", py::overload_cast<double>(&certify::decimal_below));
  module.def("decimal_above", py::overload_cast<double>(&certify::decimal_above));
}

namespace {

/// The contents of a file that can be checked, as the class of its kind.
py::object claim_of(certify::ClaimDocument claim) {
  return std::visit([]<class Document>(Document& document) { return py::cast(Shared<Document>(std::move(document))); },
                    claim);
}

}  // namespace

void bind_files(py::module_& module) {
  module.def("display_name", &certify::display_name, py::arg("path"));
  module.def(
      "read",
      [](const std::filesystem::path& path) {
        return py::bytes(interruptible([path] { return certify::load(path); }));
      },
      py::arg("path"));
  module.def(
      "parse_claim",
      [](const std::string& text, const std::string& name) {
        return claim_of(interruptible([=] { return certify::parse_file<certify::ClaimDocument>(text, name); }));
      },
      py::arg("text"), py::arg("name"));
  module.def(
      "length_text", [](double length) { return Length(length).text(); }, py::arg("length"));
  module.def(
      "length_text", [](const std::string& length) { return Length(length).text(); }, py::arg("length"));
  module.def(
      "write_text",
      [](const std::string& text, const std::filesystem::path& path) {
        save(path, [text](std::ostream& out) { out << text; });
      },
      py::arg("text"), py::arg("path"));
}

}  // namespace epsnet::python
