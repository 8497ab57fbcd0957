

#include "netgen/base/gmp.h"
#include "netgen/isometries/identify.h"
#include "netgen/isometries/isometries.h"
#include "netgen/pants/pants.h"
#include "netgen/pictures/pictures.h"
#include "python/binding/documents.h"

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
  using certify::ComparisonDocument;
  using SharedComparison = Shared<ComparisonDocument>;
  py::class_<SharedComparison> comparison(module, "Comparison");
  bind_document<ComparisonDocument>(comparison);
  comparison.def_property_readonly("net", [](const SharedComparison& self) { return SharedNet(self->net); })
      .def_property_readonly("other_net", [](const SharedComparison& self) { return SharedNet(self->other.net); })
      .def_property_readonly("isometric", [](const SharedComparison& self) {
        return self->relation == ComparisonDocument::Relation::isometric;
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
      .def("isometry", [plain](const IsometryGroup& self, std::uint32_t i) { return plain(self.isometry(i)); })
      .def("product", &IsometryGroup::product)
      .def("permutation", &IsometryGroup::permutation)
      .def("order", &IsometryGroup::order)
      .def("fixed_points", &IsometryGroup::fixed_points)
      .def_property_readonly("generators", &IsometryGroup::generators)
      .def_property_readonly("name", &IsometryGroup::name);
  module.def("isometric", [plain](const Surface& first, const Surface& second, unsigned threads,
                                  const py::object& callback) {
    IsometricAnswer answer = interruptible(
        [=](const Progress& progress) { return isometric(first, second, {.threads = threads, .progress = progress}); },
        callback);
    const bool decided = answer.kind != Kind::undecided;
    using Proof = std::pair<SharedComparison, certify::Certificate>;
    std::optional<Proof> file = answer.proof ? std::optional(shared(*std::move(answer.proof))) : std::nullopt;
    return std::tuple(decided, answer.isometry ? std::optional(plain(*answer.isometry)) : std::nullopt, answer.reason,
                      std::move(file));
  });
  module.def("identify", [](const Surface& surface, unsigned threads, const py::object& callback) {
    const std::vector<NamedAnswer> answers = interruptible(
        [=](const Progress& progress) { return identify(surface, {.threads = threads, .progress = progress}); },
        callback);
    std::vector<std::string> undecided;
    for (const auto& [names, compared, answer] : answers) {
      if (answer.kind == Kind::yes) return std::pair(names, std::vector<std::string>());
      if (answer.kind == Kind::undecided) undecided.push_back(names.front());
    }
    return std::pair(std::vector<std::string>(), std::move(undecided));
  });
}

void bind_pants(py::module_& module) {
  using certify::PantsDocument;
  using SharedPants = Shared<PantsDocument>;
  py::class_<SharedPants> bound(module, "PantsDecomposition");
  bind_document<PantsDocument>(bound);
  bound
      .def_static("find",
                  [](const Surface& surface, const std::vector<Word>& curves, bool find, unsigned threads,
                     const py::object& callback) {
                    return interruptible(
                        [=](const Progress& progress) {
                          PantsDecomposition found = pants_decomposition(
                              surface, {.curves = curves, .own = !find, .threads = threads, .progress = progress});
                          return std::tuple(SharedPants(std::move(found.document)), std::move(found.certificate),
                                            found.own);
                        },
                        callback);
                  })
      .def("svg", [](const SharedPants& self,
                     std::uint32_t size) { return svg_of([self] { return picture_of(*self); }, size); })
      .def_property_readonly("net", [](const SharedPants& self) { return SharedNet(self->net); })
      .def_property_readonly("pants", [](const SharedPants& self) { return self->pants; })
      .def_property_readonly("cuffs", [](const SharedPants& self) {
        std::vector<std::tuple<std::array<PantsDocument::End, 2>, certify::Interval, certify::Interval,
                               std::optional<Rational>, PantsDocument::Word>>
            result;
        for (const PantsDocument::Cuff& cuff : self->cuffs) {
          result.emplace_back(cuff.ends, cuff.length, cuff.twist,
                              cuff.exp_half_length == 0 ? std::nullopt : std::optional(from_gmp(cuff.exp_half_length)),
                              cuff.across);
        }
        return result;
      });
  module.def("concatenated_words", [](const Surface& surface, const Word& first, const Word& second) {
    return concatenated(surface, first, second);
  });
  module.def("dehn_twist", [](const Surface& surface, const Word& curve, std::int32_t power) {
    return interruptible([=] { return dehn_twisted(surface, curve, power); });
  });
  module.def("dehn_twist_words", [](const Surface& surface, const Word& curve, std::int32_t power) {
    return interruptible([=] { return std::vector<Word>(dehn_twist_words(surface, curve, power)); });
  });
  module.def("twist", [](const Surface& surface, const Word& curve, const Rational& by) {
    return interruptible([=] { return twisted(surface, curve, by); });
  });
}

}  // namespace epsnet::python
