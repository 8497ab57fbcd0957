#include "netgen/eigenvalues/eigenvalues.h"

#include "certify/check.h"
#include "certify/file/reader.h"
#include "certify/file/writer.h"
#include "netgen/pictures/pictures.h"
#include "python/binding/documents.h"
#include "python/binding/nets.h"

namespace epsnet::python {

void bind_eigenvalues(py::module_& module) {
  using certify::EigenvaluesDocument;
  using SharedEigenvalues = Shared<EigenvaluesDocument>;
  py::class_<SharedEigenvalues> bound(module, "Eigenvalues");
  bind_document<EigenvaluesDocument>(
      bound,
      [](const EigenvaluesDocument& document, const certify::CheckOptions& options) {
        return certify::check(document, options);
      },
      [](const EigenvaluesDocument& document, std::ostream& out) { certify::write_file(document, out); },
      [](const std::string& text, const std::string& name) {
        return certify::parse_file<EigenvaluesDocument>(text, name);
      });
  bound
      .def_static(
          "find",
          [](const Surface& surface, const std::optional<std::string>& up_to, std::uint32_t count,
             std::optional<double> width, std::optional<double> seconds, bool fast, unsigned threads,
             const py::object& callback) {
            EigenvaluesOptions options{
                .count = count, .width = width, .seconds = seconds, .eigenfunctions = !fast, .threads = threads};
            if (up_to) options.up_to = Length(*up_to);
            const auto search = [surface, options](const Progress& progress) {
              EigenvaluesOptions with_progress = options;
              with_progress.progress = progress;
              return SharedEigenvalues(eigenvalues(surface, with_progress));
            };
            return interruptible(search, callback);
          })
      .def("svg",
           [](const SharedEigenvalues& self, std::uint32_t size) {
             return interruptible([self, size] { return draw_svg(picture_of(*self), size); });
           })
      .def_property_readonly("net", [](const SharedEigenvalues& self) { return SharedNet(self->net); })
      .def_property_readonly("up_to", [](const SharedEigenvalues& self) { return self->up_to; })
      .def_property_readonly("eigenvalues_up_to", [](const SharedEigenvalues& self) { return self->eigenvalues_up_to; })
      .def_property_readonly("windows", [](const SharedEigenvalues& self) {
        std::vector<std::tuple<certify::Interval, std::uint32_t, std::uint32_t, certify::Interval, certify::Interval>>
            result;
        for (const EigenvaluesDocument::Window& w : self->windows) {
          result.emplace_back(w.in, w.least, w.most, w.smallest, w.greatest);
        }
        return result;
      });
}

}  // namespace epsnet::python
