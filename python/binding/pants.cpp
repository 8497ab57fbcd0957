#include "netgen/pants/pants.h"

#include "python/binding/binding.h"
#include "python/binding/job.h"

namespace epsnet::python {

void bind_pants(py::module_& module) {
  module.def("pants", [](const Surface& surface, const std::vector<Word>& curves, bool find, unsigned threads,
                         const py::object& callback) {
    const PantsDecomposition pants = interruptible(
        [=](const Progress& progress) {
          return pants_decomposition(surface,
                                     {.curves = curves, .own = !find, .threads = threads, .progress = progress});
        },
        callback);
    std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
    for (const PantsGraph::Edge& edge : pants.graph.edges()) edges.emplace_back(edge[0].pants, edge[1].pants);
    std::vector<std::tuple<Word, certify::Interval, certify::Interval, std::optional<Rational>, Word>> cuffs;
    for (const PantsDecomposition::Cuff& cuff : pants.cuffs) {
      cuffs.emplace_back(cuff.curve, cuff.length, cuff.twist, cuff.exact_root, cuff.across);
    }
    return std::tuple(edges, cuffs, pants.pants, pants.own);
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
