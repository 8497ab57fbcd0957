#include "netgen/surfaces/surfaces.h"

#include "certify/file/file.h"
#include "netgen/eigenvalues/eigenvalues.h"
#include "netgen/exchange/exchange.h"
#include "netgen/lifts/info.h"
#include "netgen/nets/dirichlet_polygon.h"
#include "netgen/pictures/pictures.h"
#include "netgen/surfaces/fenchel_nielsen.h"
#include "netgen/surfaces/group.h"
#include "python/binding/binding.h"
#include "triangulation/surface/surface.h"

namespace epsnet::python {
namespace {

using Ends = std::pair<Rational, Rational>;

Ends ends(const EnclosedNumber& x) { return {x.lower, x.upper}; }

Surface surface_of(std::vector<Tile> tiles, const std::vector<std::array<std::uint32_t, 4>>& gluing) {
  std::vector<Gluing> pairs;
  for (const auto& [tile, side, other_tile, other_side] : gluing) {
    pairs.push_back({tile, side, other_tile, other_side});
  }
  return Surface(std::move(tiles), std::move(pairs));
}

std::vector<std::array<std::uint32_t, 4>> gluing_of(const Surface& surface) {
  std::vector<std::array<std::uint32_t, 4>> result;
  for (const Gluing& g : surface.gluing()) result.push_back({g.tile, g.side, g.other_tile, g.other_side});
  return result;
}

/// The coordinates that a request means: the edges of the graph, lengths, twists.
struct Coordinates {
  FenchelNielsen coordinates;

  [[nodiscard]] std::vector<std::pair<std::uint32_t, std::uint32_t>> edges() const {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> result;
    for (const PantsGraph::Edge& edge : coordinates.graph.edges()) {
      result.emplace_back(edge[0].pants, edge[1].pants);
    }
    return result;
  }
};

using SurfaceClass = py::class_<Surface>;

/// The surfaces that can be made.
void bind_kinds(SurfaceClass& bound) {
  bound
      .def(py::init([](const std::vector<Tile>& tiles, const std::vector<std::array<std::uint32_t, 4>>& gluing) {
             return interruptible([=] { return surface_of(tiles, gluing); });
           }),
           py::arg("tiles"), py::arg("gluing"))
      .def_static("octagon", &random_octagon, py::arg("seed"))
      .def_static("symmetric", &symmetric_octagon, py::arg("half"))
      .def_static(
          "regular", [](std::uint32_t genus) { return interruptible([=] { return Surface::regular(genus); }); },
          py::arg("genus"))
      .def(
          "cover",
          [](const Surface& base, const std::vector<Permutation>& permutations) {
            return interruptible([=] { return cover(base, permutations); });
          },
          py::arg("permutations"))
      .def(
          "random_sheets",
          [](const Surface& base, std::uint32_t degree, std::uint64_t seed) {
            return interruptible([=] { return random_sheets(base, degree, seed); });
          },
          py::arg("degree"), py::arg("seed"))
      .def_static(
          "named",
          [](const std::string& name, std::optional<std::uint32_t> genus) {
            return interruptible([=] { return named_surface(name, genus); });
          },
          py::arg("name"), py::arg("genus"))
      .def_static("names",
                  [] {
                    std::vector<std::pair<std::string, std::string>> result;
                    for (const NamedSurface& surface : named_surfaces()) {
                      result.emplace_back(surface.name, surface.description);
                    }
                    for (const RegularMap& map : regular_maps()) result.emplace_back(map.name, description(map));
                    return result;
                  })
      .def_static(
          "map",
          [](const Permutation& rotation, const Permutation& edges) {
            return interruptible([=] { return surface_of_map({rotation, edges}); });
          },
          py::arg("rotation"), py::arg("edges"))
      .def_static(
          "from_matrices",
          [](const std::string& text) {
            return interruptible([=] { return surface_of_matrices(parse_matrices(text)).surface; });
          },
          py::arg("text"))
      .def_static(
          "fenchel_nielsen",
          [](const Coordinates& request) {
            return interruptible([=] { return fenchel_nielsen_surface(request.coordinates); });
          },
          py::arg("coordinates"))
      .def_static(
          "symmetry_remarks",
          [](const Coordinates& request) {
            return interruptible([=] { return symmetry_remarks(request.coordinates); });
          },
          py::arg("coordinates"));
}

/// Texts, files and pictures.
void bind_surface_files(SurfaceClass& bound) {
  bound
      .def_static(
          "parse",
          [](const std::string& text, const std::string& name) {
            return interruptible([=] { return parse_surface_file(text, name); });
          },
          py::arg("text"), py::arg("name"))
      .def_static(
          "parse_exchange",
          [](const std::string& text, const std::string& name) {
            return interruptible([=] { return import_surface(text, name); });
          },
          py::arg("text"), py::arg("name"))
      .def(
          "save",
          [](const Surface& surface, const std::filesystem::path& path) {
            save(path, [surface](std::ostream& out) { certify::write_file(to_document(surface), out); });
          },
          py::arg("path"))
      .def("text",
           [](const Surface& surface) {
             return py::bytes(interruptible(
                 [=] { return written([&](std::ostream& out) { certify::write_file(to_document(surface), out); }); }));
           })
      .def("svg", [](const Surface& surface,
                     std::uint32_t size) { return svg_of([surface] { return picture_of(surface); }, size); })
      .def("domain_text", [](const Surface& surface) { return interruptible([=] { return write_domain(surface); }); })
      .def(
          "graph_text",
          [](const Surface& surface, const std::string& format) {
            return interruptible([=] {
              return written([&](std::ostream& out) {
                if (format == "edges") return write_edges(surface, out);
                const GraphNodes nodes = format == "adjacency" ? GraphNodes::vertices : GraphNodes::faces;
                write_matrix_market(lattice_matrix(surface, nodes), out);
              });
            });
          },
          py::arg("format"))
      .def("triangulation_text",
           [](const Surface& surface) {
             return interruptible(
                 [=] { return written([&](std::ostream& out) { write_triangulation(surface, out); }); });
           })
      .def(
          "matrices",
          [](const Surface& surface, bool in_disk) {
            return interruptible(
                [=] { return write_matrices(surface, in_disk ? MatrixModel::su11 : MatrixModel::sl2r); });
          },
          py::arg("in_disk"));
}

/// What a surface consists of.
void bind_surface_facts(SurfaceClass& bound) {
  bound.def_property("about", &Surface::about, &Surface::set_about)
      .def_property_readonly("is_regular", &Surface::is_regular)
      .def_property_readonly("is_rational", &Surface::is_rational)
      .def_property_readonly("is_regular_polygon", &Surface::is_regular_polygon)
      .def_property_readonly("regular_tile",
                             [](const Surface& surface) {
                               const auto& tile = surface.regular_tile();
                               return tile ? std::optional(std::pair(tile->p, tile->q)) : std::nullopt;
                             })
      .def_property_readonly("genus", &Surface::genus)
      .def_property_readonly("tiles", &Surface::tiles)
      .def_property_readonly("gluing", &gluing_of)
      .def_property_readonly("side_count", &Surface::side_count)
      .def_property_readonly("vertex_classes",
                             [](const Surface& surface) {
                               std::vector<std::uint32_t> classes;
                               for (const SideId side : surface.side_ids())
                                 classes.push_back(surface.vertex_class(side));
                               return classes;
                             })
      .def_property_readonly("vertex_count", &Surface::vertex_class_count)
      .def("info",
           [](const Surface& surface) { return interruptible([=] { return surface_info(surface).json.dump(); }); })
      .def("__eq__", [](const Surface& a, const Surface& b) {
        return interruptible([=] {
          certify::SurfaceDocument x = to_document(a);
          certify::SurfaceDocument y = to_document(b);
          x.about = y.about = "";
          return x == y;
        });
      });
}

/// Sides, and the paths across them.
void bind_paths(SurfaceClass& bound) {
  bound
      .def("partner",
           [](const Surface& surface, std::uint32_t side) {
             if (side >= surface.side_count()) throw py::index_error("no such side");
             return surface.partner(SideId(side));
           })
      .def("centre_of_tile",
           [](const Surface& surface, std::uint32_t tile) {
             if (tile >= surface.tiles().size()) {
               throw SurfaceError("there is no tile " + std::to_string(tile) + ", the surface has " +
                                  std::to_string(surface.tiles().size()));
             }
             return centre_of_tile(surface, TileId(tile));
           })
      .def(
          "exact_isometry",
          [](const Surface& surface, const Word& word) {
            return interruptible([=] { return exact_isometry(surface, word); });
          },
          py::arg("word"))
      .def(
          "enclosed_isometry",
          [](const Surface& surface, const Word& word, unsigned bits) {
            const EnclosedIsometry f = interruptible([=] { return enclosed_isometry(surface, word, bits); });
            return std::pair(std::pair(ends(f.a_re), ends(f.a_im)), std::pair(ends(f.b_re), ends(f.b_im)));
          },
          py::arg("word"), py::arg("bits"));
}

void bind_surface(py::module_& module) {
  SurfaceClass surface(module, "Surface");
  bind_kinds(surface);
  bind_surface_files(surface);
  bind_surface_facts(surface);
  bind_paths(surface);
}

void bind_polygons(py::module_& module) {
  using Side = FundamentalPolygon::Side;
  py::class_<FundamentalPolygon>(module, "FundamentalPolygon")
      .def(py::init([](const Surface& surface) { return interruptible([=] { return fundamental_polygon(surface); }); }))
      .def_readonly("vertices", &FundamentalPolygon::vertices)
      .def_readonly("relations", &FundamentalPolygon::relations)
      .def_property_readonly("sides", [](const FundamentalPolygon& polygon) {
        std::vector<std::tuple<Word, std::uint32_t, SideId>> sides;
        for (const Side& side : polygon.sides) sides.emplace_back(side.word, side.partner, side.side);
        return sides;
      });

  py::class_<DirichletPolygon>(module, "DirichletPolygon")
      .def(py::init([](const Surface& surface, const std::optional<BasePoint>& base) {
        return interruptible([=] { return dirichlet_polygon(surface, base); });
      }))
      .def_property_readonly("vertices",
                             [](const DirichletPolygon& polygon) {
                               std::vector<std::complex<double>> vertices;
                               for (const Complex<double>& z : polygon.vertices) vertices.emplace_back(z.x, z.y);
                               return vertices;
                             })
      .def_readonly("ties", &DirichletPolygon::ties)
      .def_property_readonly("sides",
                             [](const DirichletPolygon& polygon) {
                               std::vector<std::tuple<Word, std::uint32_t, double>> sides;
                               for (const DirichletPolygon::Side& side : polygon.sides) {
                                 sides.emplace_back(side.word, side.partner, side.distance);
                               }
                               return sides;
                             })
      .def("svg", [](const DirichletPolygon& polygon,
                     std::uint32_t size) { return svg_of([polygon] { return picture_of(polygon); }, size); })
      .def("text", [](const DirichletPolygon& polygon) { return py::bytes(dirichlet_json(polygon)); })
      .def("info", [](const DirichletPolygon& polygon) { return dirichlet_info(polygon).json.dump(); });
}

}  // namespace

void bind_surfaces(py::module_& module) {
  py::class_<Coordinates>(module, "Coordinates")
      .def(py::init([](const std::string& graph, std::optional<std::uint32_t> genus, std::optional<std::uint64_t> seed,
                       const std::vector<std::string>& lengths, const std::vector<std::string>& twists) {
        return interruptible([=] { return Coordinates{resolve({graph, genus, seed, lengths, twists})}; });
      }))
      .def_property_readonly("edges", &Coordinates::edges)
      .def_property_readonly("lengths", [](const Coordinates& c) { return c.coordinates.lengths; })
      .def_property_readonly("twists", [](const Coordinates& c) { return c.coordinates.twists; });
  bind_surface(module);
  bind_polygons(module);
}

}  // namespace epsnet::python
