#include <chrono>

#include "python/binding/binding.h"

namespace epsnet::python {

Progress progress_of(const py::object& callback) {
  static constexpr std::chrono::milliseconds kInterval(50);
  // The handle, not the object: copies of a function are made and destroyed without the GIL. The first call counts.
  return [callback = py::handle(callback), last = std::chrono::steady_clock::now() - kInterval](std::string_view what,
                                                                                                double share) mutable {
    const auto now = std::chrono::steady_clock::now();
    if (now - last < kInterval) return;
    last = now;
    const py::gil_scoped_acquire acquired;
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    if (!callback.is_none()) callback(py::str(what.data(), what.size()), share);
  };
}

}  // namespace epsnet::python
