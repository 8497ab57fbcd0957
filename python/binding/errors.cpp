#include <stdexcept>
#include <string>

#include "certify/base/fault.h"
#include "certify/file/reader.h"
#include "netgen/exchange/exchange.h"
#include "netgen/lifts/lifts.h"
#include "netgen/nets/certified_net.h"
#include "netgen/pants/pants.h"
#include "netgen/surfaces/fenchel_nielsen.h"
#include "python/binding/binding.h"
#include "triangulation/surface/error.h"
#include "triangulation/surface/surface.h"

namespace epsnet::python {
namespace {

/// Raises the class of epsnet.errors; a part of the input that the C++ exception blames is its `place`.
void raise(const char* name, const std::string& text, const std::string& place = {}) {
  try {
    const py::object type = py::module_::import("epsnet.errors").attr(name);
    const py::object error = place.empty() ? type(text) : type(text, py::arg("place") = place);
    PyErr_SetObject(type.ptr(), error.ptr());
  } catch (py::error_already_set& problem) {
    problem.restore();
  }
}

}  // namespace

void bind_errors(py::module_&) {
  py::register_local_exception_translator([](std::exception_ptr thrown) {
    try {
      std::rethrow_exception(std::move(thrown));
    } catch (const CoordinateError& error) {
      raise("SurfaceError", error.what(), error.member());
    } catch (const FenchelNielsenRequestError& error) {
      raise("SurfaceError", error.problem(), error.member());
    } catch (const SurfaceError& error) {
      raise("SurfaceError", error.what());
    } catch (const PantsGraphError& error) {
      raise("SurfaceError", error.what(), "graph");
    } catch (const CurveError& error) {
      raise("ArgumentError", error.problem(), "curve " + std::to_string(error.number()));
    } catch (const NetError& error) {
      raise("NetError", error.what());
    } catch (const LimitError& error) {
      raise("LimitError", error.what());
    } catch (const NetGeometryError& error) {
      raise("NetError", error.what());
    } catch (const ExchangeError& error) {
      raise("FormatError", error.what());
    } catch (const WriteError& error) {
      raise("FileError", error.what());
    } catch (const certify::FileError& error) {
      raise("FileError", error.what());
    } catch (const certify::MalformedError& error) {
      raise("FormatError", error.what());
    } catch (const certify::Fault& fault) {
      raise("EpsnetError", fault.what());
    } catch (const Error& error) {
      raise("EpsnetError", error.what());
    } catch (const std::invalid_argument& error) {
      raise("ArgumentError", error.what());
    }
  });
}

}  // namespace epsnet::python
