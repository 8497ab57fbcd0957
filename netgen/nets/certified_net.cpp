#include "netgen/nets/certified_net.h"

#include <chrono>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "certify/check.h"
#include "netgen/nets/collars.h"
#include "netgen/nets/refine.h"
#include "netgen/nets/triangulations.h"
#include "netgen/prove/certified.h"

namespace epsnet {
namespace {

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

TriangulatedNet triangulated_net(const Surface& surface, const Length& epsilon, const NetOptions& options,
                                 const Variant& variant) {
  if (options.pseudo && !allows_pseudo_nets(epsilon)) {
    throw std::invalid_argument("epsilon = " + epsilon.text() +
                                " is too large for a pseudo net, the limit is ln sqrt(2) = 0.3465...");
  }
  if (options.pseudo && options.sparse) {
    throw std::invalid_argument(
        "a pseudo net cannot be sparse: its pairs of vertices beside short geodesics do not move");
  }
  if (options.pseudo && !options.points.empty()) throw std::invalid_argument("a pseudo net cannot have given points");
  if (options.sparse && !options.points.empty()) {
    throw std::invalid_argument("a sparse net cannot have given points, as its vertices move");
  }
  const auto start_time = std::chrono::steady_clock::now();
  std::vector<BasePoint> points = options.points;
  if (options.base) points.insert(points.begin(), *options.base);
  DelaunayStart start = points.empty() ? delaunay_start(surface, std::nullopt)
                                       : delaunay_start_of_points(surface, points, Threshold(epsilon.value() / 2));
  const double start_seconds = seconds_since(start_time);
  const auto refinement_time = std::chrono::steady_clock::now();
  TriangulatedNet net{std::move(start.triangulation), {}, std::nullopt};
  if (options.pseudo) {
    Collars collars(net.triangulation, epsilon);
    net.statistics = refine(net.triangulation, epsilon, options, variant, &collars);
    net.collars = collars.documents();
    net.statistics.collars = collars.count();
  } else if (options.sparse) {
    net.statistics = refine_sparsely(net.triangulation, epsilon, options, variant);
  } else {
    net.statistics = refine(net.triangulation, epsilon, options, variant);
  }
  net.statistics.initial_flips = start.flips;
  net.statistics.removed += start.removed;
  net.statistics.multiprecision = net.triangulation.multiprecision_count();
  net.statistics.start_seconds = start_seconds;
  net.statistics.refine_seconds = seconds_since(refinement_time);
  return net;
}

VariantNet compute_variant(const Surface& surface, const Length& epsilon, const Variant& variant,
                           const NetOptions& options) {
  TriangulatedNet net = triangulated_net(surface, epsilon, options, variant);
  VariantNet result{net_document(net.triangulation, epsilon), net.statistics};
  result.document.collars = std::move(net.collars);
  result.statistics.charts = result.document.charts.size();
  result.statistics.labels = result.document.labels.size();
  return result;
}

UncertifiedNet compute_net(const Surface& surface, const Length& epsilon, const NetOptions& options) {
  VariantNet net = compute_variant(surface, epsilon, {}, options);
  const NetStatistics& statistics = net.statistics;
  return {std::move(net.document), statistics};
}

CertifiedNet certified_net(const Surface& surface, const Length& epsilon, const NetOptions& options) {
  UncertifiedNet net = compute_net(surface, epsilon, options);
  certify::Certificate certificate = proof_of(net.document, options.check);
  return {{std::move(net.document), std::move(certificate)}, net.statistics};
}

CertifiedNet certified_net(const Surface& surface, double epsilon, const NetOptions& options) {
  return certified_net(surface, Length(epsilon), options);
}

}  // namespace epsnet
