#include "netgen/geodesics/geodesics.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <sstream>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include "certify/numbers/parallel.h"
#include "netgen/geodesics/axis_catalogue.h"
#include "netgen/geodesics/cut_surface.h"
#include "netgen/geodesics/unfolding.h"
#include "netgen/nets/certified_net.h"

namespace epsnet {
namespace {

/// Returns the options of the net for a search. (It is a function because g++ 12 warns that a temporary may be used
/// uninitialized.)
NetOptions net_options(const GeodesicsOptions& options) {
  NetOptions result;
  result.progress = options.progress;
  return result;
}

/// A net, and which of its vertices are deep: so far inside a collar that only its core and powers pass near them.
///
/// Every other closed geodesic has a point outside of all collars (docs/geodesics.md). This point is within ε of a
/// vertex v, and the geodesic's element at v moves v by a distance d with sinh(d/2) ≤ sinh(L/2) cosh ε. If the collar
/// of the core of a loop at v contains the disk of radius ε around v, no search has to start from v.
class Search {
 public:
  Search(const Surface& surface, const GeodesicsOptions& options)
      : options_(options),
        epsilon_(static_cast<double>(options.epsilon.value())),
        triangulation_(triangulated_net(surface, options.epsilon, net_options(options)).triangulation),
        unfolding_(triangulation_, epsilon_),
        deep_(triangulation_.vertex_count()) {
    AxisCatalogue<Mp1024> exact(triangulation_);
    for (const TriangleId t : triangulation_.triangles()) {
      for (std::uint32_t i = 0; i < 3; ++i) {
        const Dart d = make_dart(t, i);
        if (is_loop(d) && d < triangulation_.opposite(d)) examine_loop(exact, {d, {}, next_dart(d)});
      }
    }
  }

  /// Returns paths to all closed geodesics of length at most `length`, each at least once, or a power of it.
  [[nodiscard]] std::vector<ReturnPath> paths(double length) const {
    std::vector<VertexId> vertices;
    for (const VertexId v : deep_.ids()) {
      if (!deep_[v]) vertices.push_back(v);
    }
    const double displacement = 2 * std::asinh(std::sinh(length / 2) * std::cosh(epsilon_));
    require_feasible(length, displacement, vertices.size());
    const unsigned threads =
        options_.threads != 0 ? options_.threads : std::max(std::thread::hardware_concurrency(), 1U);
    std::vector<std::vector<ReturnPath>> found(vertices.size());
    certify::for_each_parallel(vertices.size(), threads, [&](unsigned worker, std::size_t i) {
      const auto tick = [&] { report("searching", static_cast<double>(i) / static_cast<double>(vertices.size())); };
      found[i] = unfolding_.returns(vertices[i], {displacement, length}, worker == 0 ? tick : std::function<void()>());
      if (worker == 0) tick();
    });
    std::vector<ReturnPath> all = deep_loops_;
    for (auto& some : found)
      all.insert(all.end(), std::make_move_iterator(some.begin()), std::make_move_iterator(some.end()));
    return all;
  }

  void report(std::string_view what, double share) const {
    if (options_.progress) options_.progress(what, share);
  }

  [[nodiscard]] Triangulation& triangulation() { return triangulation_; }
  /// Returns the length of the shortest core of a loop; infinity if there is no loop.
  [[nodiscard]] double shortest_core() const { return shortest_core_; }

 private:
  [[nodiscard]] bool is_loop(Dart d) const {
    const TriangleId t = triangle_of(d);
    return triangulation_.corner(t, corner_of(d)).vertex == triangulation_.corner(t, next(corner_of(d))).vertex;
  }

  /// Disks of radius r = D + 2ε and area 2π(cosh r − 1) are searched, on a surface of area 4π(g − 1).
  void require_feasible(double length, double displacement, std::size_t searches) const {
    constexpr double kMost = 1e11;
    const double copies = (std::cosh(displacement + 2 * epsilon_) - 1) / (2 * (triangulation_.surface().genus() - 1.0));
    const double triangles = copies * static_cast<double>(searches) * triangulation_.triangle_count();
    if (triangles <= kMost) return;
    std::ostringstream message;
    message << "to find all closed geodesics up to length " << length
            << " from a net with epsilon = " << options_.epsilon.text() << " takes a search through about " << triangles
            << " triangles, more than the limit, " << kMost;
    throw NetError(message.str());
  }

  void examine_loop(AxisCatalogue<Mp1024>& exact, ReturnPath loop) {
    const Isometry<Mp1024> g = exact.element(loop);
    const double core = static_cast<double>(displacement_length(g));
    shortest_core_ = std::min(shortest_core_, core);
    // The bounds are a little less than 2 arsinh 1 and the collar's half-width, so that rounding does not matter.
    if (!(core > 0 && core < 2 * std::asinh(1.0) - kMargin)) return;
    const double distance = static_cast<double>(exact.distance_from_axis(loop.start, g));
    if (distance + epsilon_ >= std::asinh(1 / std::sinh(core / 2)) - kMargin) return;
    deep_[triangulation_.corner(triangle_of(loop.start), corner_of(loop.start)).vertex] = true;
    deep_loops_.push_back(std::move(loop));
  }

  static constexpr double kMargin = 1e-6;

  const GeodesicsOptions& options_;
  double epsilon_;
  Triangulation triangulation_;
  Unfolding unfolding_;
  ById<VertexId, bool> deep_;
  std::vector<ReturnPath> deep_loops_;
  double shortest_core_ = std::numeric_limits<double>::infinity();
};

/// Returns all closed geodesics of length at most `up_to`, by length.
template <class T>
AxisCatalogue<T> find_all(Search& search, const T& up_to) {
  struct Candidate {
    ReturnPath path;
    Isometry<T> element;
    T length;
  };
  // A length this close to `up_to` counts as equal, and so as not longer.
  const T most = up_to * (1 + boost::multiprecision::ldexp(T(1), -100));
  AxisCatalogue<T> catalogue(search.triangulation());
  std::vector<Candidate> candidates;
  for (ReturnPath& path : search.paths(static_cast<double>(up_to))) {
    const Isometry<T> element = catalogue.element(path);
    const T length = displacement_length(element);
    if (length <= most) candidates.push_back({std::move(path), element, length});
  }
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& a, const Candidate& b) { return a.length < b.length; });
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    (void)catalogue.find_or_add(candidates[i].path, candidates[i].element);
    search.report("telling geodesics apart", static_cast<double>(i) / static_cast<double>(candidates.size()));
  }
  return catalogue;
}

/// Returns the word of a path from a vertex to itself, directed from the vertex to its lift at the end.
Word word_of(Triangulation& triangulation, const ReturnPath& path) {
  const auto label = [&](Dart d) { return triangulation.corner(triangle_of(d), corner_of(d)).label; };
  LabelId result = label(path.end);
  for (std::size_t i = path.darts.size(); i-- > 0;) {
    result = triangulation.product(triangulation.transition(path.darts[i]), result);
  }
  result = triangulation.product(triangulation.inverse(label(path.start)), result);
  // The value of a word changes coordinates along the path, so it moves points in the other direction.
  return triangulation.atlas().labels()[triangulation.inverse(result)].word;
}

template <class T>
certify::GeodesicsDocument::ClosedGeodesic to_document(Triangulation& triangulation,
                                                       const typename AxisCatalogue<T>::Geodesic& geodesic) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const double length = static_cast<double>(geodesic.length);
  const Dart start = geodesic.path.start;
  return {.vertex = triangulation.corner(triangle_of(start), corner_of(start)).vertex.number(),
          .word = word_of(triangulation, geodesic.path),
          .length = {std::nextafter(length, 0.0), std::nextafter(length, kInfinity)},
          .simple = geodesic.simple};
}

/// Returns the runs of overlapping enclosures. Lengths that agree to a hundred bits are claimed to be equal; certify
/// decides.
template <class T>
std::vector<certify::GeodesicsDocument::Cluster> clusters(
    const std::vector<typename AxisCatalogue<T>::Geodesic>& geodesics,
    const std::vector<certify::GeodesicsDocument::ClosedGeodesic>& documents) {
  std::vector<certify::GeodesicsDocument::Cluster> result;
  double reach = 0;
  for (std::uint32_t i = 0; i < documents.size(); ++i) {
    if (result.empty() || documents[i].length.lower > reach) {
      result.push_back({i, 0, true});
    }
    reach = std::max(reach, documents[i].length.upper);
    certify::GeodesicsDocument::Cluster& last = result.back();
    ++last.count;
    const T difference = geodesics[i].length - geodesics[last.first].length;
    last.equal = last.equal && difference <= boost::multiprecision::ldexp(geodesics[i].length, -100);
  }
  return result;
}

template <class T>
std::vector<certify::GeodesicsDocument::Piece> pieces(
    const Triangulation& triangulation, const std::vector<typename AxisCatalogue<T>::Geodesic>& geodesics) {
  struct Ranked {
    const typename AxisCatalogue<T>::Step* step;
    CornerArc* arc;
  };
  std::vector<std::vector<CornerArc>> curves;
  std::vector<std::vector<Ranked>> at_corner(std::size_t{3} * triangulation.triangle_count());
  for (const auto& geodesic : geodesics) {
    auto& arcs = curves.emplace_back();
    for (const auto& step : geodesic.steps) arcs.push_back({step.triangle, step.cut, step.cut_is_left, 0});
  }
  for (std::size_t c = 0; c < curves.size(); ++c) {
    for (std::size_t i = 0; i < curves[c].size(); ++i) {
      const auto& step = geodesics[c].steps[i];
      at_corner[std::size_t{3} * step.triangle.number() + step.cut].push_back({&step, &curves[c][i]});
    }
  }
  for (auto& arcs : at_corner) {
    std::sort(arcs.begin(), arcs.end(),
              [](const Ranked& a, const Ranked& b) { return a.step->position < b.step->position; });
    for (std::uint32_t rank = 0; rank < arcs.size(); ++rank) arcs[rank].arc->rank = rank;
  }
  return cut_surface(triangulation, curves);
}

/// Returns the document of all geodesics of length at most `up_to`.
template <class T>
certify::GeodesicsDocument all_geodesics(Search& search, const GeodesicsOptions& options,
                                         certify::GeodesicsDocument::Claim claim, const T& up_to) {
  const AxisCatalogue<T> catalogue = find_all<T>(search, up_to);
  certify::GeodesicsDocument result;
  result.claim = claim;
  for (const auto& geodesic : catalogue.geodesics()) {
    result.geodesics.push_back(to_document<T>(search.triangulation(), geodesic));
  }
  result.clusters = clusters<T>(catalogue.geodesics(), result.geodesics);
  if (claim == certify::GeodesicsDocument::Claim::thick_thin)
    result.pieces = pieces<T>(search.triangulation(), catalogue.geodesics());
  result.net = net_document(search.triangulation(), options.epsilon);
  return result;
}

/// Returns a shortest closed geodesic: raises a bound until it finds geodesics below it, and takes the shortest.
template <class T>
certify::GeodesicsDocument shortest_geodesic(Search& search, const GeodesicsOptions& options) {
  const std::uint32_t genus = search.triangulation().surface().genus();
  // The systole is at most 2 ln(4g − 2) (Buser, Theorem 5.2.1).
  const double most = std::min(search.shortest_core(), 2 * std::log(4.0 * genus - 2)) * (1 + 1e-9);
  constexpr double kStep = 0.5;
  for (double bound = std::min(most, kStep);; bound = std::min(most, bound + kStep)) {
    const AxisCatalogue<T> catalogue = find_all<T>(search, T(bound));
    if (catalogue.geodesics().empty() && bound < most) continue;
    if (catalogue.geodesics().empty()) throw NetError("no closed geodesic was found up to the bound of the systole");
    certify::GeodesicsDocument result;
    result.claim = certify::GeodesicsDocument::Claim::systole;
    result.geodesics.push_back(to_document<T>(search.triangulation(), catalogue.geodesics().front()));
    result.net = net_document(search.triangulation(), options.epsilon);
    return result;
  }
}

/// Calls `job` with the precision that the shortest geodesics of the surface require.
template <class Job>
certify::GeodesicsDocument with_search(const Surface& surface, const GeodesicsOptions& options, const Job& job) {
  Search search(surface, options);
  constexpr double kShort = 1e-6;
  return search.shortest_core() < kShort ? job(search, Mp1024()) : job(search, Mp256());
}

}  // namespace

certify::GeodesicsDocument systole(const Surface& surface, const GeodesicsOptions& options) {
  return with_search(surface, options,
                     [&]<class T>(Search& search, const T&) { return shortest_geodesic<T>(search, options); });
}

certify::GeodesicsDocument spectrum(const Surface& surface, const Length& up_to, const GeodesicsOptions& options) {
  return with_search(surface, options, [&]<class T>(Search& search, const T&) {
    certify::GeodesicsDocument result =
        all_geodesics<T>(search, options, certify::GeodesicsDocument::Claim::spectrum, static_cast<T>(up_to.value()));
    result.up_to = up_to.text();
    return result;
  });
}

certify::GeodesicsDocument thick_thin(const Surface& surface, const GeodesicsOptions& options) {
  return with_search(surface, options, [&]<class T>(Search& search, const T&) {
    return all_geodesics<T>(search, options, certify::GeodesicsDocument::Claim::thick_thin,
                            T(2 * boost::multiprecision::asinh(T(1))));
  });
}

certify::Interval collar_half_width(certify::Interval length) {
  const auto half_width = [](double l) {
    return static_cast<double>(boost::multiprecision::asinh(Mp256(1 / boost::multiprecision::sinh(Mp256(l) / 2))));
  };
  return {std::nextafter(half_width(length.upper), 0.0),
          std::nextafter(half_width(length.lower), std::numeric_limits<double>::infinity())};
}

}  // namespace epsnet
