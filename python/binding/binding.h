#pragma once

#include <condition_variable>
#include <exception>
#include <filesystem>
#include <functional>
#include <iosfwd>
#include <memory>
#include <mutex>
#include <optional>
#include <ostream>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>
#include <sstream>
#include <string>
#include <thread>
#include <type_traits>
#include <utility>
#include <variant>

#include "certify/base/interval.h"
#include "certify/check.h"
#include "certify/file/file.h"
#include "certify/net/document.h"
#include "certify/verdict/report.h"
#include "kernel/numbers.h"
#include "kernel/plane.h"
#include "netgen/base/options.h"
#include "netgen/pictures/pictures.h"
#include "netgen/prove/certified.h"
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

// Computations that Python waits for, and that it can stop waiting for.

/// What a computation and the thread that waits for it share.
class JobState {
 public:
  /// For the computation: tells its progress, and throws once nobody waits for it.
  [[nodiscard]] static Progress progress(const std::shared_ptr<JobState>& state);
  /// Runs the computation, and tells that it has ended.
  void run(const std::function<void()>& computation);
  /// Waits until the computation has ended, without the GIL, and throws what it threw. Some twenty times a second it
  /// looks for a signal (Ctrl-C is KeyboardInterrupt), calls epsnet._progress.poll, and `callback(what, share)` unless
  /// that is None. If one of these raises, tells the computation to end, and throws that within half a second.
  void wait(const py::object& callback);

 private:
  void look(const py::object& callback);
  void abandon();

  std::mutex mutex_;
  std::condition_variable ended_signal_;
  bool ended_ = false;
  bool abandoned_ = false;
  bool told_ = false;  ///< Whether there is progress that `callback` was not called with.
  std::string what_;
  double share_ = 0;
  std::exception_ptr error_;
};

/// Returns `function(progress)`, or `function()`, computed in a thread of its own while other Python threads run.
///
/// Ctrl-C ends the wait within a second, wherever the computation is: one that does not look at its progress goes on
/// alone, and its result is thrown away. So `function` owns what it needs (it is copied), and touches no Python object.
template <class Function>
auto interruptible(Function function, const py::object& callback = py::none()) {
  static constexpr bool kTells = std::is_invocable_v<Function&, const Progress&>;
  using Result = typename std::conditional_t<kTells, std::invoke_result<Function&, const Progress&>,
                                             std::invoke_result<Function&>>::type;
  static constexpr bool kReturns = !std::is_void_v<Result>;
  struct Job : JobState {
    Function function;
    std::conditional_t<kReturns, std::optional<Result>, std::monostate> result;
    explicit Job(Function f) : function(std::move(f)) {}
  };
  const auto job = std::make_shared<Job>(std::move(function));
  std::thread([job] {
    job->run([&] {
      const auto compute = [&] {
        if constexpr (kTells) {
          return job->function(JobState::progress(job));
        } else {
          return job->function();
        }
      };
      if constexpr (kReturns) {
        job->result.emplace(compute());
      } else {
        compute();
      }
    });
  }).detach();
  job->wait(callback);
  if constexpr (kReturns) return std::move(*job->result);
}

/// Warns in Python of what a picture leaves out.
void warn_of(const std::vector<std::string>& left_out);

/// Returns the picture that `make()` returns as SVG, computed as in `interruptible`. Warns of what is left out.
std::string svg_of(const std::function<PolygonPicture()>& make, std::uint32_t size);

/// Writes a file, completely or not at all; nothing if the wait is ended. `write` owns what it needs.
void save(const std::filesystem::path& path, const std::function<void(std::ostream&)>& write);

// Documents.

/// The contents of a file as Python holds them: never changed, so that arrays and pictures may refer to them.
template <class Document>
struct Shared {
  std::shared_ptr<const Document> document;

  explicit Shared(Document contents) : document(std::make_shared<const Document>(std::move(contents))) {}
  const Document& operator*() const { return *document; }
  const Document* operator->() const { return document.get(); }
};

/// A proved document as Python holds it, with its certificate.
template <class Document>
[[nodiscard]] std::pair<Shared<Document>, certify::Certificate> shared(Certified<Document> found) {
  return {Shared<Document>(std::move(found.document)), std::move(found.certificate)};
}

/// What all documents have: their check, as of a file that somebody else made, their text, the file.
template <class Document, class Class>
void bind_document(Class& bound) {
  bound
      .def(
          "check",
          [](const Shared<Document>& self, unsigned threads, const py::object& callback) {
            const auto checked = [self, threads](const Progress& progress) {
              return certify::check(*self, {.threads = threads, .progress = progress});
            };
            return interruptible(checked, callback);
          },
          py::arg("threads") = 0, py::arg("progress") = py::none())
      .def(
          "save",
          [](const Shared<Document>& self, const std::filesystem::path& path) {
            save(path, [self](std::ostream& out) { certify::write_file(*self, out); });
          },
          py::arg("path"))
      .def("text",
           [](const Shared<Document>& self) {
             return py::bytes(interruptible(
                 [self] { return written([&](std::ostream& out) { certify::write_file(*self, out); }); }));
           })
      .def_static(
          "parse",
          [](const std::string& text, const std::string& name) {
            return interruptible([=] { return Shared<Document>(certify::parse_file<Document>(text, name)); });
          },
          py::arg("text"), py::arg("name"))
      .def("__eq__", [](const Shared<Document>& a, const Shared<Document>& b) {
        return interruptible([=] { return *a == *b; });
      });
}

using SharedNet = Shared<certify::NetDocument>;

// Each adds a part of the module.

void bind_certificates(py::module_& module);
void bind_curves(py::module_& module);
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
