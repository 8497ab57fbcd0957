

#include "netgen/eigenvalues/eigenvalues.h"
#include "netgen/geodesics/geodesics.h"
#include "netgen/pictures/pictures.h"
#include "python/binding/documents.h"

namespace epsnet::python {
namespace {

using certify::GeodesicsDocument;
using SharedGeodesics = Shared<GeodesicsDocument>;

const char* name_of(GeodesicsDocument::Claim claim) {
  using Claim = GeodesicsDocument::Claim;
  if (claim == Claim::systole) return "systole";
  return claim == Claim::spectrum ? "spectrum" : "thick-thin";
}

/// What the function `find(surface, options)` finds, and its certificate.
template <class Find>
std::pair<SharedGeodesics, certify::Certificate> found(const Surface& surface, const std::string& epsilon,
                                                       unsigned threads, const py::object& callback, const Find& find) {
  const auto search = [surface, find, epsilon = Length(epsilon), threads](const Progress& progress) {
    return shared(find(surface, GeodesicsOptions{.epsilon = epsilon, .threads = threads, .progress = progress}));
  };
  return interruptible(search, callback);
}

}  // namespace

void bind_geodesics(py::module_& module) {
  py::class_<SharedGeodesics> bound(module, "Geodesics");
  bind_document<GeodesicsDocument>(bound);
  bound
      .def_static("systole",
                  [](const Surface& surface, const std::string& epsilon, unsigned threads, const py::object& progress) {
                    return found(surface, epsilon, threads, progress, systole);
                  })
      .def_static("spectrum",
                  [](const Surface& surface, const std::string& up_to, const std::string& epsilon, unsigned threads,
                     const py::object& progress) {
                    const Length length(up_to);
                    return found(
                        surface, epsilon, threads, progress,
                        [length](const Surface& s, const GeodesicsOptions& o) { return spectrum(s, length, o); });
                  })
      .def_static("thick_thin",
                  [](const Surface& surface, const std::string& epsilon, unsigned threads, const py::object& progress) {
                    return found(surface, epsilon, threads, progress, thick_thin);
                  })
      .def("svg", [](const SharedGeodesics& self,
                     std::uint32_t size) { return svg_of([self] { return picture_of(*self); }, size); })
      .def_property_readonly("claim", [](const SharedGeodesics& self) { return name_of(self->claim); })
      .def_property_readonly("up_to", [](const SharedGeodesics& self) { return self->up_to; })
      .def_property_readonly("net", [](const SharedGeodesics& self) { return SharedNet(self->net); })
      .def_property_readonly(
          "geodesics",
          [](const SharedGeodesics& self) {
            std::vector<std::tuple<std::uint32_t, std::uint32_t, std::vector<std::uint32_t>, certify::Interval, bool>>
                result;
            for (const GeodesicsDocument::ClosedGeodesic& g : self->geodesics) {
              result.emplace_back(g.vertex, self->net.charts[self->net.vertices[g.vertex].chart].tile, g.word, g.length,
                                  g.simple);
            }
            return result;
          })
      .def_property_readonly("clusters",
                             [](const SharedGeodesics& self) {
                               std::vector<std::tuple<std::uint32_t, std::uint32_t, bool>> result;
                               for (const GeodesicsDocument::Cluster& c : self->clusters) {
                                 result.emplace_back(c.first, c.count, c.equal);
                               }
                               return result;
                             })
      .def_property_readonly("pieces", [](const SharedGeodesics& self) {
        std::vector<std::pair<std::uint32_t, std::vector<std::pair<std::uint32_t, std::uint32_t>>>> result;
        for (const GeodesicsDocument::Piece& p : self->pieces) result.emplace_back(p.genus, p.boundaries);
        return result;
      });
  module.def("collar_half_width", &collar_half_width, py::arg("length"));
}

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
