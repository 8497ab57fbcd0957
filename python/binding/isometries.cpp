#include "netgen/isometries/isometries.h"

#include "python/binding/documents.h"
#include "python/binding/nets.h"

namespace epsnet::python {

void bind_isometries(py::module_& module) {
  using certify::IsometriesDocument;
  using SharedProof = Shared<IsometriesDocument>;
  py::class_<SharedProof> proof(module, "IsometryProof");
  bind_document<IsometriesDocument>(proof);
  proof.def_property_readonly("net", [](const SharedProof& self) { return SharedNet(self->net); })
      .def_property_readonly("up_to", [](const SharedProof& self) { return self->up_to; })
      .def_property_readonly("order", [](const SharedProof& self) { return self->order; })
      .def_property_readonly("preserving", [](const SharedProof& self) {
        std::vector<bool> result;
        for (const auto& isometry : self->isometries) result.push_back(isometry.preserves_orientation);
        return result;
      });
  using Kind = IsometricAnswer::Kind;
  using Plain = std::pair<bool, std::vector<Word>>;
  const auto plain = [](const SurfaceIsometry& f) { return Plain(f.preserves_orientation, f.images); };
  py::class_<IsometryGroup>(module, "IsometryGroup")
      .def(py::init([](const Surface& surface, unsigned threads, const py::object& callback) {
        return interruptible(
            [=](const Progress& progress) { return isometries(surface, {.threads = threads, .progress = progress}); },
            callback);
      }))
      .def("proof",
           [](const IsometryGroup& self, const Surface& surface, unsigned threads, const py::object& callback) {
             return interruptible(
                 [=](const Progress& progress) {
                   return shared(certified_isometries(surface, self, {.threads = threads, .progress = progress}));
                 },
                 callback);
           })
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
