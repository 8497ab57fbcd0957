#include "netgen/isometries/isometries.h"

#include "python/binding/binding.h"
#include "python/binding/job.h"

namespace epsnet::python {

void bind_isometries(py::module_& module) {
  using Kind = IsometricAnswer::Kind;
  using Plain = std::pair<bool, std::vector<Word>>;
  const auto plain = [](const SurfaceIsometry& f) { return Plain(f.preserves_orientation, f.images); };
  py::class_<IsometryGroup>(module, "IsometryGroup")
      .def(py::init([](const Surface& surface, unsigned threads, const py::object& callback) {
        return interruptible(
            [=](const Progress& progress) { return isometries(surface, {.threads = threads, .progress = progress}); },
            callback);
      }))
      .def("__len__", &IsometryGroup::size)
      .def("isometry", [plain](const IsometryGroup& self, std::uint32_t i) { return plain(self.isometries().at(i)); })
      .def("product", &IsometryGroup::product)
      .def("permutation", &IsometryGroup::permutation)
      .def("order", &IsometryGroup::order)
      .def("fixed_points", &IsometryGroup::fixed_points)
      .def_property_readonly("generators", &IsometryGroup::generators)
      .def_property_readonly("name", &IsometryGroup::name);
  module.def("isometric", [plain](const Surface& first, const Surface& second, unsigned threads,
                                  const py::object& callback) {
    const IsometricAnswer answer = interruptible(
        [=](const Progress& progress) { return isometric(first, second, {.threads = threads, .progress = progress}); },
        callback);
    const bool decided = answer.kind != Kind::undecided;
    return std::tuple(decided, answer.isometry ? std::optional(plain(*answer.isometry)) : std::nullopt, answer.reason);
  });
}

}  // namespace epsnet::python
