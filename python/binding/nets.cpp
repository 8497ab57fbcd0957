#include "python/binding/nets.h"

#include <complex>
#include <cstddef>
#include <stdexcept>

#include "certify/claims/net/check.h"
#include "certify/file/reader.h"
#include "certify/file/writer.h"
#include "netgen/distances/distance.h"
#include "netgen/exchange/exchange.h"
#include "netgen/lifts/lifts.h"
#include "netgen/lifts/net_geometry.h"
#include "netgen/nets/certified_net.h"
#include "netgen/pictures/draw.h"
#include "netgen/pictures/viewer.h"
#include "netgen/surfaces/surface_file.h"

namespace epsnet::python {
namespace {

using certify::NetDocument;
using Vertex = NetDocument::Vertex;
using Triangle = NetDocument::Triangle;
static_assert(offsetof(Vertex, y) == offsetof(Vertex, x) + sizeof(double), "a vertex is read as a complex number");
static_assert(sizeof(Complex<double>) == sizeof(std::complex<double>) && offsetof(Complex<double>, y) == sizeof(double),
              "points are read as complex numbers");

/// An array of the member of the rows of a vector of `self`.
template <class T, class Row>
py::array rows(const py::object& self, const std::vector<Row>& from, std::size_t offset, py::ssize_t columns = 0) {
  std::vector<py::ssize_t> shape{static_cast<py::ssize_t>(from.size())};
  std::vector<py::ssize_t> strides{sizeof(Row)};
  if (columns > 0) {
    shape.push_back(columns);
    strides.push_back(sizeof(T));
  }
  return view<T>(self, reinterpret_cast<const std::byte*>(from.data()) + offset, shape, strides);
}

/// An array that owns a vector.
template <class T>
py::array owned(std::vector<T> values, std::vector<py::ssize_t> shape) {
  auto* const kept = new std::vector<T>(std::move(values));
  const py::capsule owner(kept, [](void* data) { delete static_cast<std::vector<T>*>(data); });
  std::vector<py::ssize_t> strides(shape.size(), sizeof(T));
  for (std::size_t i = shape.size() - 1; i-- > 0;) strides[i] = strides[i + 1] * shape[i + 1];
  return view<T>(owner, kept->data(), std::move(shape), std::move(strides));
}

py::ssize_t size_of(const auto& container) { return static_cast<py::ssize_t>(container.size()); }

/// One dart of each edge, the smaller one.
py::array edge_darts(const SharedNet& net) {
  std::vector<std::uint32_t> darts;
  const std::vector<Triangle>& triangles = net->triangles;
  for (std::uint32_t dart = 0; dart < 3 * triangles.size(); ++dart) {
    if (triangles[dart / 3].opposite[dart % 3] > dart) darts.push_back(dart);
  }
  const py::ssize_t count = size_of(darts);
  return owned(std::move(darts), {count});
}

/// The numbers of a net that are rounded to binary64.
struct Geometry {
  std::vector<std::complex<double>> corners;
  std::vector<std::complex<double>> centred;
  std::vector<double> circumradii;
  std::vector<double> lengths;  ///< By dart.
};

Geometry geometry_of(const NetDocument& net) {
  const NetGeometry geometry(net);
  Geometry result;
  for (std::uint32_t t = 0; t < net.triangles.size(); ++t) {
    for (const Complex<double>& z : geometry.corners(t)) result.corners.emplace_back(z.x, z.y);
    for (const Complex<double>& z : geometry.centred_corners(t)) result.centred.emplace_back(z.x, z.y);
    result.circumradii.push_back(geometry.circumradius(t));
    for (std::uint32_t i = 0; i < 3; ++i) result.lengths.push_back(geometry.edge_length(3 * t + i));
  }
  return result;
}

py::tuple arrays_of(Geometry geometry) {
  const py::ssize_t count = size_of(geometry.circumradii);
  return py::make_tuple(owned(std::move(geometry.corners), {count, 3}), owned(std::move(geometry.circumradii), {count}),
                        owned(std::move(geometry.lengths), {count, 3}), owned(std::move(geometry.centred), {count, 3}));
}

/// One closed geodesic alone.
Layer geodesic_layer(const NetDocument& net, const certify::GeodesicsDocument& geodesics, std::size_t number) {
  Layer layer = geodesics_layers(net, geodesics).front();
  if (!layer.left_out.empty()) return layer;
  const std::size_t first = layer.parts.at(number).first_arc;
  const std::size_t last = number + 1 < layer.parts.size() ? layer.parts[number + 1].first_arc : layer.arcs.size();
  layer.arcs = {layer.arcs.begin() + static_cast<std::ptrdiff_t>(first),
                layer.arcs.begin() + static_cast<std::ptrdiff_t>(last)};
  layer.parts = {layer.parts[number]};
  layer.parts.front().first_arc = 0;
  return layer;
}

std::string page(const NetDocument& net, const std::string& title, const std::optional<certify::Certificate>& verdict,
                 const std::vector<Layer>& more) {
  ViewerOptions options{.title = title, .certificate = verdict, .layers = standard_layers(net)};
  options.layers.insert(options.layers.end(), more.begin(), more.end());
  return viewer_page(net, options);
}

std::string exported(const NetDocument& net, const std::string& format) {
  return written([&](std::ostream& out) {
    if (format == "off") return write_off(net, out);
    if (format == "vtu") return write_vtu(net, out);
    if (format == "gmsh") return write_gmsh(net, out);
    if (format == "edges") return write_edges(net, out);
    if (format == "json") return write_mesh_json(net, out);
    if (format == "triangulation") return write_triangulation(net, out);
    throw std::invalid_argument("expected the format gmsh, vtu, off, edges, json or triangulation, not \"" + format +
                                '"');
  });
}

py::dict statistics_of(const NetStatistics& s) {
  py::dict result;
  result["insertions"] = s.insertions;
  result["flips"] = s.flips;
  result["initial_flips"] = s.initial_flips;
  result["removed"] = s.removed;
  result["multiprecision"] = s.multiprecision;
  result["collars"] = s.collars;
  result["undone"] = s.undone;
  result["charts"] = s.charts;
  result["labels"] = s.labels;
  result["start_seconds"] = s.start_seconds;
  result["refine_seconds"] = s.refine_seconds;
  return result;
}

/// The document, its certificate, and what was counted; the certificate says VERIFIED.
py::tuple compute(const Surface& surface, const std::string& epsilon, const std::optional<BasePoint>& base, bool pseudo,
                  unsigned threads, const py::object& progress) {
  const Length length(epsilon);
  NetOptions options;
  options.base = base;
  options.pseudo = pseudo;
  options.threads = threads;
  options.progress = progress_of(progress);
  options.check = check_options(threads, true, progress);
  CertifiedNet net = without_gil([&] { return certified_net(surface, length, options); });
  return py::make_tuple(SharedNet(std::move(net.net)), std::move(net.certificate), statistics_of(net.statistics));
}

void bind_lifts(py::module_& module) {
  using Lifted = Lifts::LiftedTriangle;
  py::class_<Lifts>(module, "Lifts")
      .def_property_readonly("triangles",
                             [](const py::object& self) {
                               const auto& lifted = self.cast<const Lifts&>().lifted;
                               return rows<std::uint32_t>(self, lifted, offsetof(Lifted, triangle));
                             })
      .def_property_readonly("corners",
                             [](const py::object& self) {
                               const auto& lifted = self.cast<const Lifts&>().lifted;
                               return rows<std::complex<double>>(self, lifted, offsetof(Lifted, corner), 3);
                             })
      .def_property_readonly("places", [](const py::object& self) {
        return rows<std::uint32_t>(self, self.cast<const Lifts&>().place, 0);
      });
}

}  // namespace

void bind_nets(py::module_& module) {
  py::class_<Layer>(module, "Layer").def_readonly("name", &Layer::name).def_readwrite("on", &Layer::on);
  bind_lifts(module);
  py::class_<SharedNet> net(module, "Net");
  bind_document<NetDocument>(
      net, [](const NetDocument& document, const certify::CheckOptions& options) { return check(document, options); },
      [](const NetDocument& document, std::ostream& out) { certify::write_net(document, out); },
      [](const std::string& text, const std::string& name) { return certify::parse_net(text, name); });
  net.def_static("compute", &compute, py::arg("surface"), py::arg("epsilon"), py::arg("base"), py::arg("pseudo"),
                 py::arg("threads"), py::arg("progress"))
      .def_static("of_tiles",
                  [](const Surface& surface, const std::string& epsilon) {
                    return SharedNet(net_of_tiles(surface, Length(epsilon)));
                  })
      .def_property_readonly("epsilon", [](const SharedNet& self) { return self->epsilon; })
      .def_property_readonly(
          "surface", [](const SharedNet& self) { return without_gil([&] { return from_document(self->surface); }); })
      .def_property_readonly("vertices",
                             [](const py::object& self) {
                               return rows<std::complex<double>>(self, self.cast<const SharedNet&>()->vertices, 0);
                             })
      .def_property_readonly("vertex_charts",
                             [](const py::object& self) {
                               return rows<std::uint32_t>(self, self.cast<const SharedNet&>()->vertices,
                                                          offsetof(Vertex, chart));
                             })
      .def_property_readonly("triangles",
                             [](const py::object& self) {
                               return rows<std::uint32_t>(self, self.cast<const SharedNet&>()->triangles,
                                                          offsetof(Triangle, vertex), 3);
                             })
      .def_property_readonly("opposite",
                             [](const py::object& self) {
                               return rows<std::uint32_t>(self, self.cast<const SharedNet&>()->triangles,
                                                          offsetof(Triangle, opposite), 3);
                             })
      .def_property_readonly("corner_labels",
                             [](const py::object& self) {
                               return rows<std::uint32_t>(self, self.cast<const SharedNet&>()->triangles,
                                                          offsetof(Triangle, label), 2);
                             })
      .def("edge_darts", &edge_darts)
      .def_property_readonly(
          "charts",
          [](const SharedNet& self) {
            std::vector<BasePoint> charts;
            for (const NetDocument::Chart& chart : self->charts) {
              charts.push_back(
                  {chart.tile, {Rational(chart.centre.x.get_mpq_t()), Rational(chart.centre.y.get_mpq_t())}});
            }
            return charts;
          })
      .def_property_readonly("labels",
                             [](const SharedNet& self) {
                               std::vector<std::tuple<std::uint32_t, std::uint32_t, Word>> labels;
                               for (const NetDocument::Label& label : self->labels) {
                                 labels.emplace_back(label.from, label.to, label.word);
                               }
                               return labels;
                             })
      .def_property_readonly(
          "collars",
          [](const SharedNet& self) {
            using Row = std::tuple<Word, certify::Interval, std::array<std::uint32_t, 2>, std::array<std::uint32_t, 2>>;
            std::optional<std::vector<Row>> collars;
            if (!self->collars) return collars;
            collars.emplace();
            for (const NetDocument::Collar& c : *self->collars) {
              collars->emplace_back(c.core, certify::Interval{c.length[0], c.length[1]}, c.vertices, c.triangles);
            }
            return collars;
          })
      .def("geometry", [](const SharedNet& self) { return arrays_of(without_gil([&] { return geometry_of(*self); })); })
      .def(
          "lifts",
          [](const SharedNet& self, bool breadth_first, std::uint32_t centre) {
            return without_gil([&] {
              return lift_triangles(NetGeometry(*self), breadth_first ? DrawOrder::breadth_first : DrawOrder::weight,
                                    centre);
            });
          },
          py::arg("breadth_first"), py::arg("centre"))
      .def("point_of_vertex", [](const SharedNet& self, const Surface& surface,
                                 std::uint32_t vertex) { return point_of_vertex(surface, *self, vertex); })
      .def(
          "svg",
          [](const SharedNet& self, std::uint32_t centre, bool triangles, bool vertices, bool dirichlet, bool tiles,
             const std::string& colouring, bool legend, std::uint32_t size, const std::vector<Layer>& layers) {
            DrawOptions options{.centre = centre,
                                .triangles = triangles,
                                .vertices = vertices,
                                .dirichlet = dirichlet,
                                .legend = legend,
                                .size = size};
            if (colouring == "circumradius") options.colouring = Colouring::circumradius;
            if (colouring == "chart") options.colouring = Colouring::chart;
            std::vector<std::string> left_out;
            std::string svg = without_gil([&] {
              options.layers = collar_layers(*self);
              if (tiles) options.layers.push_back(tile_layer(*self));
              options.layers.insert(options.layers.end(), layers.begin(), layers.end());
              return draw_svg(*self, options, &left_out);
            });
            for (const std::string& what : left_out) {
              if (PyErr_WarnEx(PyExc_UserWarning, ("left out: " + what).c_str(), 1) != 0) throw py::error_already_set();
            }
            return svg;
          },
          py::arg("centre"), py::arg("triangles"), py::arg("vertices"), py::arg("dirichlet"), py::arg("tiles"),
          py::arg("colouring"), py::arg("legend"), py::arg("size"), py::arg("layers"))
      .def(
          "page",
          [](const SharedNet& self, const std::string& title, const std::optional<certify::Certificate>& certificate,
             const std::vector<Layer>& layers) {
            return without_gil([&] { return page(*self, title, certificate, layers); });
          },
          py::arg("title"), py::arg("certificate"), py::arg("layers"))
      .def("exported",
           [](const SharedNet& self, const std::string& format) {
             return py::bytes(without_gil([&] { return exported(*self, format); }));
           })
      .def("distance_layer",
           [](const SharedNet& self, const Shared<certify::DistanceDocument>& distance) {
             return without_gil([&] { return distance_layer(*self, *distance); });
           })
      .def("geodesic_layer",
           [](const SharedNet& self, const Shared<certify::GeodesicsDocument>& geodesics, std::size_t number) {
             return without_gil([&] { return geodesic_layer(*self, *geodesics, number); });
           })
      .def("geodesics_layers", [](const SharedNet& self, const Shared<certify::GeodesicsDocument>& geodesics) {
        return without_gil([&] { return geodesics_layers(*self, *geodesics); });
      });
}

}  // namespace epsnet::python
