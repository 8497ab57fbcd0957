#include <algorithm>
#include <complex>
#include <iterator>
#include <pybind11/complex.h>
#include <stdexcept>

#include "netgen/base/gmp.h"
#include "netgen/curves/curves.h"
#include "netgen/distances/distances.h"
#include "netgen/eigenvalues/eigenvalues.h"
#include "netgen/geodesics/geodesics.h"
#include "netgen/isometries/isometries.h"
#include "netgen/nets/dirichlet_polygon.h"
#include "netgen/pants/pants.h"
#include "netgen/pictures/pictures.h"
#include "netgen/surfaces/group.h"
#include "python/binding/binding.h"

/// What is proved of a surface: distances and bounds, geodesics, eigenvalues, isometries, pants, closed curves.
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

namespace {

using certify::GeodesicsDocument;
using SharedGeodesics = Shared<GeodesicsDocument>;

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
      .def_static("local_maximum",
                  [](const Surface& surface, const std::string& epsilon, unsigned threads, const py::object& progress) {
                    return found(surface, epsilon, threads, progress, local_maximum);
                  })
      .def("svg", [](const SharedGeodesics& self,
                     std::uint32_t size) { return svg_of([self] { return picture_of(*self); }, size); })
      .def_property_readonly("claim", [](const SharedGeodesics& self) { return self->claim_name(); })
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
                     std::optional<int> digits, const std::optional<std::string>& epsilon, const TorusPoint& phases,
                     const std::optional<Rational>& box, unsigned threads, const py::object& callback) {
                    EigenvaluesOptions options{
                        .below = below, .digits = digits, .phases = phases, .box = box, .threads = threads};
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
      .def_property_readonly("phases", [](const SharedEigenvalues& self) { return self->phases; })
      .def_property_readonly(
          "box",
          [](const SharedEigenvalues& self) { return self->box ? std::optional(self->box->radius) : std::nullopt; })
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
  module.def("bands", [](const Surface& surface, const std::vector<TorusPoint>& points, std::uint32_t count,
                         std::optional<int> digits, const std::optional<std::string>& epsilon, unsigned threads,
                         const py::object& callback) {
    BandsOptions options{.count = count, .digits = digits, .threads = threads};
    if (epsilon) options.epsilon = Length(*epsilon);
    const auto search = [surface, points, options](const Progress& progress) {
      BandsOptions with_progress = options;
      with_progress.progress = progress;
      return bands(surface, points, with_progress);
    };
    return interruptible(search, callback);
  });
  module.def("gap_outside",
             [](const Surface& surface, const Rational& radius, double at_least, std::size_t most,
                const std::optional<std::string>& epsilon, unsigned threads, const py::object& callback) {
               GapOptions options{.most = most, .threads = threads};
               if (epsilon) options.epsilon = Length(*epsilon);
               const auto search = [surface, radius, at_least, options](const Progress& progress) {
                 GapOptions with_progress = options;
                 with_progress.progress = progress;
                 return gap_outside(surface, radius, at_least, with_progress);
               };
               return interruptible(search, callback);
             });
  module.def("lattice_matrix", [](const Surface& surface, bool faces, const TorusPoint& turns) {
    return interruptible(
        [=] { return lattice_matrix(surface, faces ? GraphNodes::faces : GraphNodes::vertices, turns); });
  });
  py::class_<HermitianMatrix>(module, "HermitianMatrix")
      .def_readonly("size", &HermitianMatrix::size)
      .def_property_readonly("entries",
                             [](const HermitianMatrix& self) {
                               std::vector<std::tuple<std::uint32_t, std::uint32_t, std::complex<double>>> result;
                               for (const auto& [row, column, value] : self.entries)
                                 result.emplace_back(row, column, value);
                               return result;
                             })
      .def_property_readonly("text",
                             [](const HermitianMatrix& self) {
                               std::ostringstream out;
                               write_matrix_market(self, out);
                               return out.str();
                             })
      .def("eigenvalues", [](const HermitianMatrix& self) { return interruptible([=] { return eigenvalues(self); }); });
  module.def("torus_path", &torus_path);
  module.def("character_sides", [](const Surface& surface) {
    std::vector<std::uint32_t> result;
    for (const SideId side : character_sides(surface)) result.push_back(side.number());
    return result;
  });
  module.def("phases_of_sides", [](const Surface& surface, const TorusPoint& turns) {
    const ById<SideId, Rational> phases = phases_of_sides(surface, turns);
    return std::vector<Rational>(phases.begin(), phases.end());
  });
  module.def("bands_svg", [](std::vector<std::vector<certify::Interval>> rows, std::uint32_t size) {
    return draw_svg(BandsPicture{std::move(rows), {}}, size);
  });
}

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
      .def_static("marked",
                  [](const Surface& surface, const SharedPants& marking, unsigned threads, const py::object& callback) {
                    return interruptible(
                        [=](const Progress& progress) {
                          PantsDecomposition found =
                              marked_pants(surface, *marking, {.threads = threads, .progress = progress});
                          return std::pair(SharedPants(std::move(found.document)), std::move(found.certificate));
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

namespace {

void bind_curve_topology(py::module_& module) {
  py::class_<ClosedCurve>(module, "ClosedCurve")
      .def_readonly("root", &ClosedCurve::root)
      .def_readonly("power", &ClosedCurve::power)
      .def_readonly("self_intersections", &ClosedCurve::self_intersections)
      .def_readonly("homology", &ClosedCurve::homology)
      .def_readonly("genus_on_the_left", &ClosedCurve::genus_on_the_left);
  py::class_<CurveTopology>(module, "CurveTopology")
      .def(py::init([](const Surface& surface) { return interruptible([=] { return CurveTopology(surface); }); }))
      .def_property_readonly("homology_basis", &CurveTopology::homology_basis)
      .def("curve",
           [](const CurveTopology& self, const Word& word) { return interruptible([=] { return self.curve(word); }); })
      .def("root_word",
           [](const CurveTopology& self, ClosedCurve curve) {
             curve.power = 1;
             return self.word(curve);
           })
      .def("intersections",
           [](const CurveTopology& self, const ClosedCurve& first, const ClosedCurve& second) {
             const auto [geometric, algebraic] = interruptible([=] { return self.intersections(first, second); });
             return std::pair(geometric, algebraic);
           })
      .def("angles",
           [](const CurveTopology& self, const ClosedCurve& first, const ClosedCurve& second) {
             std::vector<certify::Interval> result;
             for (const auto& [angle] : interruptible([=] { return self.crossings(first, second); })) {
               result.push_back(angle);
             }
             return result;
           })
      .def("twist_derivative",
           [](const CurveTopology& self, const ClosedCurve& curve, const ClosedCurve& along) {
             return interruptible([=] { return self.twist_derivative(curve, along); });
           })
      .def("fill", [](const CurveTopology& self, const std::vector<ClosedCurve>& curves) {
        return interruptible([=] { return self.fill(curves); });
      });
}

void bind_derivatives(py::module_& module) {
  module.def("length_derivatives", [](const Surface& surface, const Word& word, bool second, unsigned threads) {
    const LengthDerivatives result = interruptible([=] {
      PantsOptions options;
      options.threads = threads;
      return length_derivatives(surface, pants_decomposition(surface, options), word, second, threads);
    });
    return py::make_tuple(result.length, result.gradient, result.second);
  });
#ifndef __EMSCRIPTEN__
  module.def(
      "maximize_systole", [](const Surface& start, std::uint32_t steps, unsigned threads, const py::object& callback) {
        const SystoleMaximum found = interruptible(
            [=](const Progress& progress) {
              return maximize_systole(start, {.steps = steps, .threads = threads, .progress = progress});
            },
            callback);
        using Proof = std::pair<double, double>;
        return std::tuple(found.surface, found.systole, found.systoles,
                          found.proof ? std::optional(Proof(found.proof->distance, found.proof->slope)) : std::nullopt);
      });
#endif
}

/// Products of Dehn twists are lists of pairs: a word and a power.
void bind_mapping_classes(py::module_& module) {
  using Twists = std::vector<std::pair<Word, std::int32_t>>;
  const auto from_twists = [](const Twists& twists) {
    MappingClass result;
    for (const auto& [curve, power] : twists) result.push_back({curve, power});
    return result;
  };
  py::class_<MappingClassGroup>(module, "MappingClassGroup")
      .def(py::init([](const Surface& surface) { return interruptible([=] { return MappingClassGroup(surface); }); }))
      .def_property_readonly("generators",
                             [](const MappingClassGroup& self) {
                               std::vector<std::pair<std::string, Word>> result;
                               for (const auto& [name, curve] : self.generators()) result.emplace_back(name, curve);
                               return result;
                             })
      .def("parse",
           [](const MappingClassGroup& self, const std::string& text) {
             Twists result;
             for (const auto& [curve, power] : self.parse(text)) result.emplace_back(curve, power);
             return result;
           })
      .def("image",
           [from_twists](const MappingClassGroup& self, const Twists& twists, const ClosedCurve& curve) {
             return interruptible([=] { return self.topology().word(self.image(from_twists(twists), curve)); });
           })
      .def(
          "homology",
          [from_twists](const MappingClassGroup& self, const Twists& twists) {
            std::vector<std::vector<py::int_>> result;
            for (const auto& row : self.homology(from_twists(twists))) {
              auto& entries = result.emplace_back();
              for (const mpz_class& x : row) {
                entries.push_back(py::reinterpret_steal<py::int_>(PyLong_FromString(x.get_str().c_str(), nullptr, 10)));
              }
            }
            return result;
          })
      .def("is_identity",
           [from_twists](const MappingClassGroup& self, const Twists& twists) {
             return interruptible([=] { return self.is_identity(from_twists(twists)); });
           })
      .def("order",
           [from_twists](const MappingClassGroup& self, const Twists& twists) {
             return interruptible([=] { return self.order(from_twists(twists)); });
           })
      .def("is_isometry", [from_twists](const MappingClassGroup& self, const Twists& twists, bool preserves_orientation,
                                        const std::vector<Word>& images) {
        return interruptible([=] { return self.is_isometry(from_twists(twists), {preserves_orientation, images}); });
      });
  module.def("with_marking", [from_twists](const Surface& surface, const Twists& twists) {
    return interruptible([=] { return with_marking(surface, from_twists(twists)); });
  });
}

}  // namespace

void bind_curves(py::module_& module) {
  bind_curve_topology(module);
  bind_mapping_classes(module);
  bind_derivatives(module);
  using certify::CurvesDocument;
  using SharedCurves = Shared<CurvesDocument>;
  py::class_<SharedCurves> bound(module, "Curves");
  bind_document<CurvesDocument>(bound);
  bound
      .def_static(
          "find",
          [](const Surface& surface, const std::vector<Word>& words, unsigned threads, const py::object& callback) {
            return interruptible(
                [=](const Progress& progress) {
                  return shared(curves(surface, words, {.threads = threads, .progress = progress}));
                },
                callback);
          })
      .def_property_readonly("net", [](const SharedCurves& self) { return SharedNet(self->net); })
      .def_property_readonly("basis", [](const SharedCurves& self) { return self->basis; })
      .def_property_readonly("filling", [](const SharedCurves& self) { return self->filling; })
      .def_property_readonly("curves",
                             [](const SharedCurves& self) {
                               std::vector<std::tuple<std::uint32_t, std::vector<std::uint32_t>, certify::Interval,
                                                      std::uint32_t, std::uint64_t, std::vector<std::int64_t>>>
                                   result;
                               for (const CurvesDocument::Curve& c : self->curves) {
                                 result.emplace_back(c.vertex, c.word, c.length, c.power, c.self_intersections,
                                                     c.homology);
                               }
                               return result;
                             })
      .def_property_readonly("pairs", [](const SharedCurves& self) {
        std::vector<std::pair<std::uint64_t, std::int64_t>> result;
        for (const CurvesDocument::Pair& pair : self->pairs) result.emplace_back(pair.intersections, pair.algebraic);
        return result;
      });
}

}  // namespace epsnet::python
