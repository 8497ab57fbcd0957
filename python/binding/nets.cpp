#include <complex>
#include <cstddef>
#include <memory>
#include <mutex>
#include <stdexcept>

#include "certify/file/file.h"
#include "netgen/distances/distances.h"
#include "netgen/exchange/exchange.h"
#include "netgen/lifts/info.h"
#include "netgen/lifts/lifts.h"
#include "netgen/nets/certified_net.h"
#include "netgen/pictures/pictures.h"
#include "netgen/surfaces/surfaces.h"
#include "python/binding/binding.h"

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

std::string page(const NetDocument& net, const std::string& title, const std::optional<certify::Certificate>& verdict,
                 const std::vector<Layer>& more) {
  ViewerOptions options{.title = title, .certificate = verdict, .layers = standard_layers(net)};
  try {
    options.distances = distances_for_page(net, verdict);
  } catch (const Error&) {  // The page does without.
  }
  options.layers.insert(options.layers.end(), more.begin(), more.end());
  return viewer_page(net, options);
}

std::string exported(const NetDocument& net, const std::string& format, std::optional<std::uint32_t> distance_from) {
  return written([&](std::ostream& out) {
    if (format == "off") return write_off(net, out);
    if (format == "vtu" && distance_from) {
      return write_vtu_with({"distance", rounded_distances_from(net, *distance_from)}, net, out);
    }
    if (format == "vtu") return write_vtu(net, out);
    if (format == "gmsh") return write_gmsh(net, out);
    if (format == "gmsh-glued") return write_gmsh_glued(net, out);
    if (format == "medit") return write_medit(net, out);
    if (format == "mfem") return write_mfem(net, out);
    if (format == "edges") return write_edges(net, out);
    if (format == "adjacency") return write_adjacency(net, GraphNodes::vertices, out);
    if (format == "face-adjacency") return write_adjacency(net, GraphNodes::faces, out);
    if (format == "json") return write_mesh_json(net, out);
    if (format == "triangulation") return write_triangulation(net, out);
    throw std::invalid_argument("there is no format " + format);
  });
}

py::dict statistics_of(const NetStatistics& s) {
  py::dict result;
  result["insertions"] = s.insertions;
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

NetOptions net_options(const std::optional<BasePoint>& base, const std::vector<BasePoint>& points, bool pseudo,
                       bool sparse, unsigned threads) {
  NetOptions options;
  options.base = base;
  options.points = points;
  options.pseudo = pseudo;
  options.sparse = sparse;
  options.threads = threads;
  return options;
}

/// The document, its certificate, and what was counted; the certificate says VERIFIED.
py::tuple compute(const Surface& surface, const std::string& epsilon, const NetOptions& given,
                  const py::object& callback) {
  const auto make = [surface, length = Length(epsilon), options = given](const Progress& progress) mutable {
    options.progress = progress;
    auto [net, statistics] = compute_net(surface, length, options);
    return std::pair(shared(proved(std::move(net), options.threads, progress)), statistics);
  };
  auto [found, statistics] = interruptible(make, callback);
  return py::make_tuple(std::move(found.first), std::move(found.second), statistics_of(statistics));
}

/// Finds points, one at a time.
class SharedLocator {
 public:
  explicit SharedLocator(const SharedNet& net) : net_(net), locator_(*net) {}

  [[nodiscard]] py::tuple locate(const BasePoint& point) {
    const PointLocation found = [&] {
      const py::gil_scoped_release released;  // Microseconds; but another thread may have the mutex.
      const std::lock_guard lock(mutex_);
      return locator_.locate(point);
    }();
    const char* const place = found.place == PointLocation::Place::inside ? "inside"
                              : found.place == PointLocation::Place::side ? "side"
                                                                          : "corner";
    return py::make_tuple(place, found.triangle, found.number, py::tuple(py::cast(found.word)),
                          py::tuple(py::cast(found.weights)), py::tuple(py::cast(found.distances)),
                          net_->triangles[found.triangle].vertex[found.nearest_corner()]);
  }

 private:
  SharedNet net_;
  Locator locator_;
  std::mutex mutex_;
};

/// The bounds of the distances, an array of the shape (rows, columns, 2).
py::array distances(const SharedNet& net, const std::vector<std::uint32_t>& from, const std::vector<std::uint32_t>& to,
                    unsigned threads, const py::object& callback) {
  static_assert(sizeof(certify::Interval) == 2 * sizeof(double), "intervals are read as pairs of floats");
  const auto search = [=](const Progress& progress) {
    return vertex_distances(*net, from, to, {.threads = threads, .progress = progress});
  };
  std::vector<certify::Interval> enclosures = interruptible(search, callback).enclosures;
  auto* const kept = new std::vector<certify::Interval>(std::move(enclosures));
  const py::capsule owner(kept, [](void* data) { delete static_cast<std::vector<certify::Interval>*>(data); });
  const py::ssize_t columns = size_of(to);
  constexpr py::ssize_t kSize = sizeof(double);
  return view<double>(owner, kept->data(), {size_of(from), columns, 2}, {2 * kSize * columns, 2 * kSize, kSize});
}

/// What a picture is asked for.
struct PictureOptions {
  DrawOptions draw;
  bool tiles = false;
  bool distances = false;  ///< Colours by the distance from the centre.
};

PictureOptions picture_options(std::uint32_t centre, bool triangles, bool vertices, bool dirichlet,
                               bool combinatorial_dirichlet, bool tiles, bool disks, bool half_disks,
                               const std::string& colour, bool legend, bool breadth_first, std::uint32_t size) {
  DrawOptions draw{.order = breadth_first ? DrawOrder::breadth_first : DrawOrder::weight,
                   .centre = centre,
                   .triangles = triangles,
                   .vertices = vertices,
                   .dirichlet = dirichlet,
                   .combinatorial_dirichlet = combinatorial_dirichlet,
                   .covering_disks = disks,
                   .packing_disks = half_disks,
                   .legend = legend,
                   .size = size};
  if (colour == "circumradius") draw.colouring = Colouring::circumradius;
  if (colour == "chart") draw.colouring = Colouring::chart;
  if (colour == "distance") draw.colouring = Colouring::values;
  return {draw, tiles, colour == "distance"};
}

/// A picture of the net, and what is left out of it.
std::pair<std::string, std::vector<std::string>> picture(const NetDocument& net, const PictureOptions& asked,
                                                         const std::vector<Layer>& layers) {
  DrawOptions options = asked.draw;
  options.layers = collar_layers(net);
  if (asked.tiles) options.layers.push_back(tile_layer(net));
  options.layers.insert(options.layers.end(), layers.begin(), layers.end());
  if (asked.distances) {
    options.values = rounded_distances_from(net, options.centre);
    options.values_name = "distance";
  }
  std::vector<std::string> left_out;
  std::string svg = draw_svg(net, options, &left_out);
  return {std::move(svg), std::move(left_out)};
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

using NetClass = py::class_<SharedNet>;

/// What makes nets.
void bind_computation(NetClass& bound) {
  bound.def_static("compute", &compute, py::arg("surface"), py::arg("epsilon"), py::arg("options"), py::arg("progress"))
      .def_static("of_tiles", [](const Surface& surface, const std::string& epsilon) {
        return interruptible([=] { return SharedNet(net_of_tiles(surface, Length(epsilon))); });
      });
}

/// The members of the document: arrays of its memory, and lists.
void bind_net_arrays(NetClass& bound) {
  bound.def_property_readonly("epsilon", [](const SharedNet& self) { return self->epsilon; })
      .def_property_readonly(
          "surface", [](const SharedNet& self) { return interruptible([=] { return from_document(self->surface); }); })
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
                  {TileId(chart.tile), {Rational(chart.centre.x.get_mpq_t()), Rational(chart.centre.y.get_mpq_t())}});
            }
            return charts;
          })
      .def_property_readonly("labels",
                             [](const SharedNet& self) {
                               std::vector<std::tuple<std::uint32_t, std::uint32_t, std::vector<std::uint32_t>>> labels;
                               for (const NetDocument::Label& label : self->labels) {
                                 labels.emplace_back(label.from, label.to, label.word);
                               }
                               return labels;
                             })
      .def_property_readonly("collars", [](const SharedNet& self) {
        using Row = std::tuple<std::vector<std::uint32_t>, certify::Interval, std::array<std::uint32_t, 2>,
                               std::array<std::uint32_t, 2>>;
        std::optional<std::vector<Row>> collars;
        if (!self->collars) return collars;
        collars.emplace();
        for (const NetDocument::Collar& c : *self->collars) {
          collars->emplace_back(c.core, certify::Interval{c.length[0], c.length[1]}, c.vertices, c.triangles);
        }
        return collars;
      });
}

/// Numbers that are rounded, or found from the members, and points.
void bind_net_geometry(NetClass& bound) {
  bound
      .def("geometry",
           [](const SharedNet& self) { return arrays_of(interruptible([=] { return geometry_of(*self); })); })
      .def("distances", &distances, py::arg("rows"), py::arg("columns"), py::arg("threads"), py::arg("progress"))
      .def(
          "lifts",
          [](const SharedNet& self, bool breadth_first, std::uint32_t centre) {
            return interruptible([=] {
              return lift_triangles(NetGeometry(*self), breadth_first ? DrawOrder::breadth_first : DrawOrder::weight,
                                    centre);
            });
          },
          py::arg("breadth_first"), py::arg("centre"))
      .def("point_of_vertex",
           [](const SharedNet& self, const Surface& surface, std::uint32_t vertex) {
             return interruptible([=] { return point_of_vertex(surface, *self, vertex); });
           })
      .def("point_of_triangle",
           [](const SharedNet& self, const Surface& surface, std::uint32_t triangle,
              const std::array<Rational, 3>& weights) {
             return interruptible([=] { return point_of_triangle(surface, *self, triangle, weights); });
           })
      .def("info", [](const SharedNet& self) { return interruptible([=] { return net_info(*self).json.dump(); }); });
}

/// Pictures, the page, and what they show.
void bind_net_pictures(NetClass& bound) {
  bound
      .def(
          "svg",
          [](const SharedNet& self, const PictureOptions& options, const std::vector<Layer>& layers) {
            const auto [svg, left_out] = interruptible([=] { return picture(*self, options, layers); });
            warn_of(left_out);
            return svg;
          },
          py::arg("options"), py::arg("layers"))
      .def(
          "page",
          [](const SharedNet& self, const std::string& title, const std::optional<certify::Certificate>& certificate,
             const std::vector<Layer>& layers) {
            return interruptible([=] { return page(*self, title, certificate, layers); });
          },
          py::arg("title"), py::arg("certificate"), py::arg("layers"))
      .def("eccentricity_svg",
           [](const SharedNet& self, std::uint32_t size) {
             return svg_of([self] { return picture_of_eccentricity(*self); }, size);
           })
      .def("distance_layer",
           [](const SharedNet& self, const Shared<certify::DistanceDocument>& distance) {
             return interruptible([=] { return distance_layer(*self, *distance); });
           })
      .def("geodesic_layer",
           [](const SharedNet& self, const Shared<certify::GeodesicsDocument>& geodesics, std::size_t number) {
             return interruptible([=] { return geodesic_layer(*self, *geodesics, number); });
           })
      .def("geodesics_layers", [](const SharedNet& self, const Shared<certify::GeodesicsDocument>& geodesics) {
        return interruptible([=] { return geodesics_layers(*self, *geodesics); });
      });
}

/// The files that not all documents have.
void bind_net_files(NetClass& bound) {
  bound
      .def(
          "save_compact",
          [](const SharedNet& self, const std::filesystem::path& path) {
            save(path, [self](std::ostream& out) { certify::write_compact_net(*self, out); });
          },
          py::arg("path"))
      .def("exported",
           [](const SharedNet& self, const std::string& format, std::optional<std::uint32_t> distance_from) {
             return py::bytes(interruptible([=] { return exported(*self, format, distance_from); }));
           });
}

void bind_net_options(py::module_& module) {
  py::class_<NetOptions>(module, "NetOptions")
      .def(py::init(&net_options), py::arg("base"), py::arg("points"), py::arg("pseudo"), py::arg("sparse"),
           py::arg("threads"));
  py::class_<PictureOptions>(module, "DrawOptions")
      .def(py::init(&picture_options), py::arg("centre"), py::arg("triangles"), py::arg("vertices"),
           py::arg("dirichlet"), py::arg("combinatorial_dirichlet"), py::arg("tiles"), py::arg("disks"),
           py::arg("half_disks"), py::arg("colour"), py::arg("legend"), py::arg("breadth_first"), py::arg("size"));
}

void bind_net(py::module_& module) {
  NetClass net(module, "Net");
  bind_document<NetDocument>(net);
  bind_computation(net);
  bind_net_arrays(net);
  bind_net_geometry(net);
  bind_net_pictures(net);
  bind_net_files(net);
}

void bind_locator(py::module_& module) {
  py::class_<SharedLocator>(module, "Locator")
      .def(py::init([](const SharedNet& document) {
             return interruptible([document] { return std::make_unique<SharedLocator>(document); });
           }),
           py::arg("net"))
      .def("locate", &SharedLocator::locate, py::arg("point"));
}

}  // namespace

void bind_nets(py::module_& module) {
  py::class_<Layer>(module, "Layer").def_readonly("name", &Layer::name).def_readwrite("on", &Layer::on);
  bind_lifts(module);
  bind_net_options(module);
  bind_net(module);
  bind_locator(module);
}

}  // namespace epsnet::python
