#include "netgen/eigenvalues/eigenvalues.h"

#include "netgen/pictures/pictures.h"
#include "python/binding/documents.h"
#include "python/binding/nets.h"

namespace epsnet::python {

void bind_eigenvalues(py::module_& module) {
  using certify::EigenvaluesDocument;
  using SharedEigenvalues = Shared<EigenvaluesDocument>;
  py::class_<SharedEigenvalues> bound(module, "Eigenvalues");
  bind_document<EigenvaluesDocument>(bound);
  bound
      .def_static("find",
                  [](const Surface& surface, std::optional<std::uint32_t> count, std::optional<double> below,
                     std::optional<int> digits, const std::optional<std::string>& epsilon, unsigned threads,
                     const py::object& callback) {
                    EigenvaluesOptions options{.below = below, .digits = digits, .threads = threads};
                    if (count) options.count = *count;
                    if (epsilon) options.epsilon = Length(*epsilon);
                    const auto search = [surface, options](const Progress& progress) {
                      EigenvaluesOptions with_progress = options;
                      with_progress.progress = progress;
                      return shared(eigenvalues(surface, with_progress));
                    };
                    return interruptible(search, callback);
                  })
      .def("svg",
           [](const SharedEigenvalues& self, std::uint32_t size) {
             return interruptible([self, size] { return draw_svg(picture_of(*self), size); });
           })
      .def_property_readonly("net", [](const SharedEigenvalues& self) { return SharedNet(self->net); })
      .def("eigenfunction",
           [](const SharedEigenvalues& self, std::size_t index) {
             const certify::Interval in = self->eigenfunctions[eigenfunction_place(*self, index).row].in;
             return std::tuple(in.lower, in.upper, eigenfunction_at_vertices(*self, index));
           })
      .def("eigenfunction_svg",
           [](const SharedEigenvalues& self, std::size_t index, std::uint32_t centre, bool breadth_first,
              std::uint32_t size) {
             const EigenfunctionPictureOptions options{
                 .order = breadth_first ? DrawOrder::breadth_first : DrawOrder::weight, .centre = centre, .size = size};
             return interruptible([=] { return eigenfunction_svg(*self, index, options); });
           })
      .def("count_below",
           [](const SharedEigenvalues& self, double x) {
             const EigenvalueCount count = eigenvalues_below(*self, x);
             return std::pair(count.least, count.most);
           })
      .def_property_readonly("next", [](const SharedEigenvalues& self) { return self->next; })
      .def_property_readonly("enclosures", [](const SharedEigenvalues& self) {
        std::vector<std::pair<certify::Interval, std::uint32_t>> result;
        for (const auto& [in, count] : self->eigenvalues) result.emplace_back(in, count);
        return result;
      });
}

}  // namespace epsnet::python
