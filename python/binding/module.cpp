#include <stdexcept>
#include <string>

#include "certify/base/error.h"
#include "certify/file/file.h"
#include "netgen/curves/curves.h"
#include "netgen/exchange/exchange.h"
#include "netgen/lifts/lifts.h"
#include "netgen/nets/certified_net.h"
#include "netgen/pants/pants.h"
#include "netgen/prove/certified.h"
#include "netgen/surfaces/fenchel_nielsen.h"
#include "python/binding/binding.h"
#include "triangulation/surface/surface.h"

namespace epsnet::python {
namespace {

using Parts = certify::ErrorParts;

/// Raises the class of this name of epsnet.errors, which `make` makes an exception of.
template <class Make>
void raise_made(const char* name, const Make& make) {
  try {
    const py::object type = py::module_::import("epsnet.errors").attr(name);
    const py::object error = make(type);
    PyErr_SetObject(type.ptr(), error.ptr());
  } catch (py::error_already_set& problem) {
    problem.restore();
  }
}

void raise(const char* name, const std::string& text, const Parts& parts) {
  const auto given = [](const std::string& part) { return part.empty() ? py::object(py::none()) : py::str(part); };
  raise_made(name, [&](const py::object& type) {
    return type(parts.reason(), py::arg("file") = given(parts.file), py::arg("place") = given(parts.place),
                py::arg("expected") = given(parts.expected), py::arg("text") = text);
  });
}

void raise(const char* name, const certify::LocatedError& error) { raise(name, error.what(), error.parts()); }

/// Of an argument of this name.
void raise(const char* name, const std::string& problem, const std::string& place) {
  raise(name, place + ": " + problem, Parts{.place = place, .problem = problem});
}

void raise(const char* name, const std::exception& error) { raise(name, error.what(), Parts{.problem = error.what()}); }

void raise(const NotCertifiedError& error) {
  raise_made("NotVerifiedError", [&](const py::object& type) {
    const py::object certificate = py::module_::import("epsnet.certificates").attr("Certificate");
    return type(error.what(), certificate(error.certificate()));
  });
}

}  // namespace

void bind_errors(py::module_&) {
  py::register_local_exception_translator([](std::exception_ptr thrown) {
    try {
      std::rethrow_exception(std::move(thrown));
    } catch (const CoordinateError& error) {
      raise("SurfaceError", error.what(), error.member());
    } catch (const FenchelNielsenRequestError& error) {
      raise("SurfaceError", error);
    } catch (const SurfaceError& error) {
      raise("SurfaceError", error);
    } catch (const PantsGraphError& error) {
      raise("SurfaceError", error.what(), "graph");
    } catch (const CurveError& error) {
      raise("ArgumentError", error);
    } catch (const MappingClassError& error) {
      raise("ArgumentError", error);
    } catch (const NotCertifiedError& error) {
      raise(error);
    } catch (const NetError& error) {
      raise("NetError", error);
    } catch (const LimitError& error) {
      raise("LimitError", error);
    } catch (const NetGeometryError& error) {
      raise("NetError", error);
    } catch (const ExchangeError& error) {
      raise("FormatError", error);
    } catch (const WriteError& error) {
      raise("FileError", error);
    } catch (const certify::FileError& error) {
      raise("FileError", error);
    } catch (const certify::MalformedError& error) {
      raise("FormatError", error);
    } catch (const certify::Fault& fault) {
      raise("EpsnetError", fault);
    } catch (const Error& error) {
      raise("EpsnetError", error);
    } catch (const std::invalid_argument& error) {
      raise("ArgumentError", error);
    }
  });
}

}  // namespace epsnet::python

PYBIND11_MODULE(_epsnet, module) {
  module.doc() = "The C++ library behind the package epsnet, under names of its own: use the package.";
  module.attr("__version__") = EPSNET_VERSION;
  epsnet::python::bind_errors(module);
  epsnet::python::bind_numbers(module);
  epsnet::python::bind_surfaces(module);
  epsnet::python::bind_certificates(module);
  epsnet::python::bind_nets(module);
  epsnet::python::bind_geodesics(module);
  epsnet::python::bind_isometries(module);
  epsnet::python::bind_pants(module);
  epsnet::python::bind_curves(module);
  epsnet::python::bind_distances(module);
  epsnet::python::bind_eigenvalues(module);
  epsnet::python::bind_files(module);
}
