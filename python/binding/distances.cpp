#include "netgen/distances/distances.h"

#include <algorithm>
#include <iterator>
#include <stdexcept>

#include "netgen/nets/dirichlet_polygon.h"
#include "python/binding/documents.h"

namespace epsnet::python {
namespace {

using certify::BoundDocument;
using certify::DistanceDocument;
using SharedDistance = Shared<DistanceDocument>;
using SharedBound = Shared<BoundDocument>;

BasePoint point_of(const certify::RationalPoint& z, std::uint32_t tile) {
  return {TileId(tile), {Rational(z.x.get_mpq_t()), Rational(z.y.get_mpq_t())}};
}

/// The claims, by the names that files give them.
struct NamedBound {
  BoundDocument::Claim claim;
  const char* name;
  Certified<BoundDocument> (*make)(const Surface&, const BoundOptions&);
};
constexpr NamedBound kBounds[] = {{BoundDocument::Claim::diameter, "diameter", &diameter},
                                  {BoundDocument::Claim::radius, "radius", &radius},
                                  {BoundDocument::Claim::embedded_disk, "embedded-disk", &largest_embedded_disk}};

std::pair<SharedBound, certify::Certificate> enclose(const Surface& surface, const std::string& claim, double width,
                                                     unsigned threads, const py::object& callback) {
  const auto* const found =
      std::find_if(std::begin(kBounds), std::end(kBounds), [&](const NamedBound& c) { return claim == c.name; });
  if (found == std::end(kBounds)) throw std::invalid_argument("there is no claim " + claim);
  const auto search = [surface, width, threads, make = found->make](const Progress& progress) {
    BoundOptions options;
    options.width = width;
    options.threads = threads;
    options.progress = progress;
    return shared(make(surface, options));
  };
  return interruptible(search, callback);
}

const char* name_of(BoundDocument::Claim claim) {
  return std::find_if(std::begin(kBounds), std::end(kBounds), [&](const NamedBound& c) { return claim == c.claim; })
      ->name;
}

std::uint64_t cells_of(const BoundDocument& document) {
  std::uint64_t cells = 0;
  for (const auto& row : document.cells) {
    for (const std::uint32_t entry : row) cells += entry >= 3 ? 1 : 0;
  }
  return cells;
}

}  // namespace

void bind_distances(py::module_& module) {
  py::class_<SharedDistance> distances(module, "Distance");
  bind_document<DistanceDocument>(distances);
  distances
      .def_static("measure",
                  [](const Surface& surface, const BasePoint& p, const BasePoint& q, double width) {
                    return interruptible([=] { return shared(distance(surface, p, q, {.width = width})); });
                  })
      .def("svg", [](const SharedDistance& self,
                     std::uint32_t size) { return svg_of([self] { return picture_of(*self); }, size); })
      .def_property_readonly("net", [](const SharedDistance& self) { return SharedNet(self->net); })
      .def_property_readonly("value", [](const SharedDistance& self) { return self->distance; })
      .def_property_readonly("equal", [](const SharedDistance& self) { return self->equal; })
      .def_property_readonly("paths", [](const SharedDistance& self) { return self->paths; })
      .def_property_readonly("point",
                             [](const SharedDistance& self) { return point_of(self->point.z, self->point.tile); });

  py::class_<SharedBound> bounds(module, "Cover");
  bind_document<BoundDocument>(bounds);
  bounds.def_static("enclose", &enclose)
      .def("svg", [](const SharedBound& self,
                     std::uint32_t size) { return svg_of([self] { return picture_of(*self); }, size); })
      .def_property_readonly("net", [](const SharedBound& self) { return SharedNet(self->net); })
      .def_property_readonly("claim", [](const SharedBound& self) { return name_of(self->claim); })
      .def_property_readonly("value", [](const SharedBound& self) { return self->value; })
      .def_property_readonly("cells", [](const SharedBound& self) { return cells_of(*self); })
      .def_property_readonly("triangulations", [](const SharedBound& self) { return self->triangulations.size() + 1; });

  module.def("eccentricity_net", [](const Surface& surface, const BasePoint& point) {
    return interruptible([=] { return shared(eccentricity_net(surface, point)); });
  });
  module.def("farthest_points", [](const Surface& surface, const BasePoint& point) {
    return interruptible([=] { return farthest_points(surface, dirichlet_polygon(surface, point)); });
  });
  module.def("loops_at", [](const Surface& surface, const BasePoint& point, double up_to) {
    std::vector<std::pair<Word, double>> result;
    for (PointLoop& loop : interruptible([=] { return loops_at(surface, point, up_to); }))
      result.emplace_back(std::move(loop.word), loop.length);
    return result;
  });
  module.def("point_along", [](const Surface& surface, const BasePoint& from, double direction, double length) {
    return interruptible([=] { return point_along(surface, from, direction, length); });
  });
  module.def("fixed_points",
             [](const Surface& surface, const std::vector<Word>& words, const std::vector<Word>& images) {
               return interruptible([=] { return fixed_points(surface, words, images); });
             });
  module.attr("least_bound_width") = kLeastBoundWidth;
  module.def("reversed_word", [](const Surface& surface, const Word& word) { return reversed(surface, word); });
}

}  // namespace epsnet::python
