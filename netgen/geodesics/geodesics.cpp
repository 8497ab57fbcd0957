#include "netgen/geodesics/geodesics.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "certify/numbers/parallel.h"
#include "netgen/geodesics/axis_catalogue.h"
#include "netgen/geodesics/cutting_search.h"
#include "netgen/nets/certified_net.h"
#include "netgen/nets/refine.h"
#include "netgen/nets/triangulations.h"
#include "netgen/surfaces/exact_isometries.h"

namespace epsnet {
namespace {

/// Returns the options of the net for a search. (It is a function because g++ 12 warns that a temporary may be used
/// uninitialized.)
NetOptions net_options(const GeodesicsOptions& options) {
  NetOptions result;
  result.progress = options.progress;
  return result;
}

/// A net, and the search for the closed geodesics of its surface.
///
/// A loop edge whose core is short names a collar. What crosses edges inside of one collar alone is its core
/// (docs/geodesics.md), so the search begins at other edges, and the cores are found by their loops.
class Search {
 public:
  Search(const Surface& surface, const GeodesicsOptions& options)
      : options_(options),
        triangulation_(triangulated_net(surface, options.epsilon, net_options(options)).triangulation) {
    AxisCatalogue<Mp1024> exact(triangulation_);
    std::vector<bool> inner(4 * std::size_t{triangulation_.triangle_count()});
    for (const TriangleId t : triangulation_.triangles()) {
      for (std::uint32_t i = 0; i < 3; ++i) {
        const Dart d = make_dart(t, i);
        if (is_loop(d) && d < triangulation_.opposite(d)) examine_loop(exact, {d, {}, next_dart(d)}, inner);
      }
    }
    ways_.emplace(triangulation_, inner);
  }

  /// Paths to all closed geodesics of length at most `length`, each at least once; those that are not certain perhaps
  /// more than once, and powers of some.
  [[nodiscard]] std::vector<CuttingPath> paths(double length) const {
    require_feasible(length);
    std::vector<std::vector<CuttingPath>> found(ways_->starts());
    certify::for_each_parallel(found.size(), threads(), [&](unsigned worker, std::size_t i) {
      const auto tick = [&] { report("searching", static_cast<double>(i) / static_cast<double>(found.size())); };
      found[i] = ways_->paths(i, length, kMostCrossings, worker == 0 ? tick : std::function<void()>());
      if (worker == 0) tick();
    });
    std::vector<CuttingPath> all;
    for (auto& some : found)
      all.insert(all.end(), std::make_move_iterator(some.begin()), std::make_move_iterator(some.end()));
    return all;
  }

  void report(std::string_view what, double share) const {
    if (options_.progress) options_.progress(what, share);
  }

  [[nodiscard]] unsigned threads() const { return certify::thread_count(options_.threads); }
  [[nodiscard]] Triangulation& triangulation() { return triangulation_; }
  /// The loop edges that name collars.
  [[nodiscard]] const std::vector<ReturnPath>& loops() const { return loops_; }
  /// The length of the shortest core of a loop edge; infinity if there is no loop edge.
  [[nodiscard]] double shortest_core() const { return shortest_core_; }

 private:
  [[nodiscard]] bool is_loop(Dart d) const {
    const TriangleId t = triangle_of(d);
    return triangulation_.corner(t, corner_of(d)).vertex == triangulation_.corner(t, next(corner_of(d))).vertex;
  }

  /// There are about e^L/2L geodesics of lengths L from 1 on, and some 40 edges are crossed for each.
  void require_feasible(double length) const {
    const double crossings = 20 * std::exp(length) / std::max(length, 1.0);
    if (crossings <= static_cast<double>(kMostCrossings)) return;
    std::ostringstream message;
    message << "to find all closed geodesics up to length " << length << " takes a search across about " << crossings
            << " edges, more than the limit, " << static_cast<double>(kMostCrossings);
    throw NetError(message.str());
  }

  void examine_loop(AxisCatalogue<Mp1024>& exact, ReturnPath loop, std::vector<bool>& inner) {
    const Isometry<Mp1024> g = exact.element(loop);
    const double core = static_cast<double>(displacement_length(g));
    shortest_core_ = std::min(shortest_core_, core);
    // The bounds are a little less than 2 arsinh 1 and the collar's half-width, so that rounding does not matter.
    if (!(core > 0 && core < 2 * std::asinh(1.0) - kMargin)) return;
    const double width = std::asinh(1 / std::sinh(core / 2)) - kMargin;
    if (!(static_cast<double>(exact.distance_from_axis(loop.start, g)) < width)) return;
    // The edges at the vertex that end in this lift of the collar, too.
    Isometry<Mp1024> carried = g;
    for (const Dart d : triangulation_.star(loop.start)) {
      if (static_cast<double>(exact.distance_from_axis(next_dart(d), carried)) < width) {
        inner[static_cast<std::uint32_t>(d)] = true;
        inner[static_cast<std::uint32_t>(triangulation_.opposite(d))] = true;
      }
      carried = exact.element_beyond(d, carried);
    }
    loops_.push_back(std::move(loop));
  }

  static constexpr double kMargin = 1e-6;
  static constexpr std::uint64_t kMostCrossings = 10'000'000'000;

  const GeodesicsOptions& options_;
  Triangulation triangulation_;
  std::optional<CuttingSearch> ways_;
  std::vector<ReturnPath> loops_;
  double shortest_core_ = std::numeric_limits<double>::infinity();
};

/// Closed geodesics, by length. Those that the search tells from all others by their paths alone are not looked up in
/// a catalogue.
template <class T>
struct Found {
  T length;
  ReturnPath path;
  bool simple;
};

/// The elements of paths, from labels that are evaluated once: threads may share them.
template <class T>
class PathElements {
 public:
  explicit PathElements(Triangulation& triangulation)
      : at_corner_(4 * std::size_t{triangulation.triangle_count()}), across_(at_corner_.size()) {
    std::unordered_map<LabelId, std::uint32_t> numbers{{kIdentity, 0}};
    const auto number_of = [&](LabelId label) {
      const auto [entry, is_new] = numbers.try_emplace(label, static_cast<std::uint32_t>(values_.size()));
      if (is_new) values_.push_back(triangulation.isometry_in<T>(label));
      return entry->second;
    };
    for (const TriangleId t : triangulation.triangles()) {
      for (std::uint32_t i = 0; i < 3; ++i) {
        const Dart d = make_dart(t, i);
        at_corner_[index(d)] = number_of(triangulation.corner(t, i).label);
        across_[index(d)] = number_of(triangulation.transition(d));
      }
    }
  }

  /// As AxisCatalogue::element.
  [[nodiscard]] Isometry<T> operator()(const ReturnPath& path) const {
    Isometry<T> result = values_[at_corner_[index(path.end)]];
    for (std::size_t i = path.darts.size(); i-- > 0;) {
      const std::uint32_t number = across_[index(path.darts[i])];
      if (number != 0) result = values_[number] * result;
    }
    result = result * inverse(values_[at_corner_[index(path.start)]]);
    return result.a.x < 0 ? Isometry<T>{-result.a, -result.b} : result;
  }

 private:
  [[nodiscard]] static std::uint32_t index(Dart d) { return static_cast<std::uint32_t>(d); }

  std::vector<Isometry<T>> values_{{}};   ///< Number 0 is the identity.
  std::vector<std::uint32_t> at_corner_;  ///< By dart: the number of the label of the corner that it leaves,
  std::vector<std::uint32_t> across_;     ///< and of that which leads across it.
};

template <class T>
struct Candidate {
  ReturnPath path;
  T length;
  std::optional<bool> simple;  ///< Of a geodesic with only one path.
};

/// The candidates of length at most `up_to`, by length.
template <class T>
std::vector<Candidate<T>> candidates(Search& search, const T& up_to) {
  // The cores of collars may be found by loops, too.
  constexpr double kShort = 1.8;
  // Equal is not longer: two numbers so close are equal.
  const T most = up_to * (1 + boost::multiprecision::ldexp(T(1), -100));
  std::vector<Candidate<T>> result;
  for (const ReturnPath& loop : search.loops()) result.push_back({loop, 0, std::nullopt});
  for (CuttingPath& path : search.paths(static_cast<double>(up_to))) {
    const Dart first = path.darts.front();
    result.push_back({{first, std::move(path.darts), first}, 0, path.certain ? path.simple : std::nullopt});
  }
  const PathElements<T> element(search.triangulation());
  certify::for_each_parallel(result.size(), search.threads(), [&](unsigned, std::size_t i) {
    Candidate<T>& candidate = result[i];
    candidate.length = displacement_length(element(candidate.path));
    if (candidate.length < kShort) candidate.simple.reset();
  });
  std::erase_if(result, [&](const Candidate<T>& candidate) { return candidate.length > most; });
  std::stable_sort(result.begin(), result.end(),
                   [](const Candidate<T>& a, const Candidate<T>& b) { return a.length < b.length; });
  return result;
}

/// All closed geodesics of length at most `up_to`, by length. The catalogue gets all that are shorter than 1.8.
template <class T>
std::vector<Found<T>> find_all(Search& search, AxisCatalogue<T>& catalogue, const T& up_to) {
  std::vector<Candidate<T>> wanted = candidates(search, up_to);
  std::vector<Found<T>> result;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    Candidate<T>& candidate = wanted[i];
    if (!candidate.simple) {
      const std::size_t known = catalogue.geodesics().size();
      (void)catalogue.find_or_add(candidate.path, catalogue.element(candidate.path));
      if (catalogue.geodesics().size() == known) continue;
      candidate.simple = catalogue.geodesics().back().simple;
    }
    result.push_back({std::move(candidate.length), std::move(candidate.path), *candidate.simple});
    search.report("telling geodesics apart", static_cast<double>(i) / static_cast<double>(wanted.size()));
  }
  return result;
}

/// Returns the word of a path from a vertex to itself, directed from the vertex to its lift at the end.
Word word_of(Triangulation& triangulation, const ReturnPath& path) {
  Word word;
  const auto append = [&](LabelId label) {
    if (label == kIdentity) return;
    word = concatenated(triangulation.surface(), std::move(word), triangulation.atlas().labels()[label].word);
  };
  // The value of a word changes coordinates along the path, from those here to those beyond each dart.
  append(triangulation.corner(path.start).label);
  for (const Dart d : path.darts) append(triangulation.inverse(triangulation.transition(d)));
  append(triangulation.inverse(triangulation.corner(path.end).label));
  return word;
}

template <class T>
certify::GeodesicsDocument::ClosedGeodesic to_document(Triangulation& triangulation, const Found<T>& geodesic) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const double length = static_cast<double>(geodesic.length);
  const Dart start = geodesic.path.start;
  return {.vertex = triangulation.corner(triangle_of(start), corner_of(start)).vertex.number(),
          .word = letters_of(word_of(triangulation, geodesic.path)),
          .length = {std::nextafter(length, 0.0), std::nextafter(length, kInfinity)},
          .simple = geodesic.simple};
}

/// Whether the geodesics of a cluster have exactly equal lengths; true where tiles are not rational, whose coordinates
/// nobody has rounded.
bool is_equal_exactly(const Surface& surface, const certify::GeodesicsDocument::Cluster& cluster,
                      const std::vector<certify::GeodesicsDocument::ClosedGeodesic>& documents) {
  if (!surface.is_rational()) return true;
  const auto trace = [&](std::uint32_t i) { return squared_trace(surface, word_of_letters(documents[i].word)); };
  const mpq_class first = trace(cluster.first);
  for (std::uint32_t i = cluster.first + 1; i < cluster.first + cluster.count; ++i) {
    if (trace(i) != first) return false;
  }
  return true;
}

/// Returns the runs of overlapping enclosures. Lengths that agree to seven tenths of their bits are claimed to be
/// equal, if they are: coordinates of surfaces are often rounded, to many digits.
template <class T>
std::vector<certify::GeodesicsDocument::Cluster> clusters(
    const Surface& surface, const std::vector<Found<T>>& geodesics,
    const std::vector<certify::GeodesicsDocument::ClosedGeodesic>& documents) {
  constexpr int kBits = std::numeric_limits<T>::digits * 7 / 10;
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
    last.equal = last.equal && difference <= boost::multiprecision::ldexp(geodesics[i].length, -kBits);
  }
  for (certify::GeodesicsDocument::Cluster& cluster : result) {
    cluster.equal = cluster.equal && (cluster.count == 1 || is_equal_exactly(surface, cluster, documents));
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
  AxisCatalogue<T> catalogue(search.triangulation());
  const std::vector<Found<T>> found = find_all<T>(search, catalogue, up_to);
  certify::GeodesicsDocument result;
  result.claim = claim;
  for (const Found<T>& geodesic : found) result.geodesics.push_back(to_document<T>(search.triangulation(), geodesic));
  result.clusters = clusters<T>(search.triangulation().surface(), found, result.geodesics);
  if (claim == certify::GeodesicsDocument::Claim::thick_thin)
    result.pieces = pieces<T>(search.triangulation(), catalogue.geodesics());
  result.net = net_document(search.triangulation(), options.epsilon);
  return result;
}

/// Returns a shortest closed geodesic: raises a bound until it finds geodesics below it, and takes the shortest.
template <class T>
certify::GeodesicsDocument shortest_geodesic(Search& search, const GeodesicsOptions& options) {
  const std::uint32_t genus = search.triangulation().surface().genus();
  // The systole is at most 2 ln(4g − 2) (Buser, Lemma 5.2.1).
  const double most = std::min(search.shortest_core(), 2 * std::log(4.0 * genus - 2)) * (1 + 1e-9);
  constexpr double kStep = 0.5;
  for (double bound = std::min(most, kStep);; bound = std::min(most, bound + kStep)) {
    AxisCatalogue<T> catalogue(search.triangulation());
    const std::vector<Found<T>> found = find_all<T>(search, catalogue, T(bound));
    if (found.empty() && bound < most) continue;
    if (found.empty()) throw NetError("no closed geodesic was found up to the bound of the systole");
    certify::GeodesicsDocument result;
    result.claim = certify::GeodesicsDocument::Claim::systole;
    result.geodesics.push_back(to_document<T>(search.triangulation(), found.front()));
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

certify::GeodesicsDocument unproved::systole(const Surface& surface, const GeodesicsOptions& options) {
  return with_search(surface, options,
                     [&]<class T>(Search& search, const T&) { return shortest_geodesic<T>(search, options); });
}

certify::GeodesicsDocument unproved::spectrum(const Surface& surface, const Length& up_to,
                                              const GeodesicsOptions& options) {
  return with_search(surface, options, [&]<class T>(Search& search, const T&) {
    certify::GeodesicsDocument result =
        all_geodesics<T>(search, options, certify::GeodesicsDocument::Claim::spectrum, static_cast<T>(up_to.value()));
    result.up_to = up_to.text();
    return result;
  });
}

certify::GeodesicsDocument unproved::thick_thin(const Surface& surface, const GeodesicsOptions& options) {
  return with_search(surface, options, [&]<class T>(Search& search, const T&) {
    return all_geodesics<T>(search, options, certify::GeodesicsDocument::Claim::thick_thin,
                            T(2 * boost::multiprecision::asinh(T(1))));
  });
}

Certified<certify::GeodesicsDocument> systole(const Surface& surface, const GeodesicsOptions& options) {
  return proved(unproved::systole(surface, options), options.threads, options.progress);
}

Certified<certify::GeodesicsDocument> spectrum(const Surface& surface, const Length& up_to,
                                               const GeodesicsOptions& options) {
  return proved(unproved::spectrum(surface, up_to, options), options.threads, options.progress);
}

Certified<certify::GeodesicsDocument> thick_thin(const Surface& surface, const GeodesicsOptions& options) {
  return proved(unproved::thick_thin(surface, options), options.threads, options.progress);
}

certify::Interval collar_half_width(certify::Interval length) {
  const auto half_width = [](double l) {
    return static_cast<double>(boost::multiprecision::asinh(Mp256(1 / boost::multiprecision::sinh(Mp256(l) / 2))));
  };
  return {std::nextafter(half_width(length.upper), 0.0),
          std::nextafter(half_width(length.lower), std::numeric_limits<double>::infinity())};
}

}  // namespace epsnet
