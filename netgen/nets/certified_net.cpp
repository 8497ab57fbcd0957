#include "netgen/nets/certified_net.h"

#include <chrono>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "certify/check.h"
#include "netgen/base/gmp.h"
#include "netgen/nets/collars.h"
#include "netgen/nets/refine.h"
#include "netgen/nets/start.h"
#include "netgen/surfaces/surface_file.h"

namespace epsnet {
namespace {

/// Numbers the members of a large set that are used, in the order of their first use.
class Renumbering {
 public:
  explicit Renumbering(std::size_t size) : number_(size, kUnused) {}
  [[nodiscard]] std::uint32_t operator()(std::uint32_t i) {
    if (number_[i] == kUnused) {
      number_[i] = static_cast<std::uint32_t>(used_.size());
      used_.push_back(i);
    }
    return number_[i];
  }
  [[nodiscard]] const std::vector<std::uint32_t>& used() const { return used_; }

 private:
  static constexpr std::uint32_t kUnused = ~std::uint32_t{0};
  std::vector<std::uint32_t> number_;
  std::vector<std::uint32_t> used_;
};

}  // namespace

certify::NetDocument net_document(const Triangulation& triangulation, const Length& epsilon) {
  const Atlas& atlas = triangulation.atlas();
  certify::NetDocument net;
  net.surface = to_document(triangulation.surface());
  net.epsilon = epsilon.text();
  Renumbering chart_number(atlas.chart_count());
  Renumbering label_number(atlas.label_count());
  (void)label_number(kIdentity);
  net.vertices.reserve(triangulation.vertex_count());
  for (std::uint32_t v = 0; v < triangulation.vertex_count(); ++v) {
    const Vertex& vertex = triangulation.vertex(v);
    net.vertices.push_back({vertex.z.x, vertex.z.y, chart_number(vertex.chart)});
  }
  net.triangles.reserve(triangulation.triangle_count());
  for (std::uint32_t t = 0; t < triangulation.triangle_count(); ++t) {
    const Triangle& triangle = triangulation.triangle(t);
    net.triangles.push_back({triangle.vertex,
                             {document_dart(triangle.opposite[0]), document_dart(triangle.opposite[1]),
                              document_dart(triangle.opposite[2])},
                             {label_number(triangle.label(1)), label_number(triangle.label(2))}});
  }
  for (const std::uint32_t c : chart_number.used()) {
    net.charts.push_back({atlas.chart(c).tile, to_gmp(atlas.chart(c).centre)});
  }
  for (const LabelId l : label_number.used()) {
    if (l != kIdentity) {
      net.labels.push_back({chart_number(atlas.from(l)), chart_number(atlas.to(l)), atlas.word(l)});
    }
  }
  return net;
}

namespace {

struct Refined {
  Triangulation triangulation;
  std::optional<std::vector<certify::NetDocument::Collar>> collars;  ///< Of a pseudo net.
};

Refined refined(const Surface& surface, const Length& epsilon, const NetOptions& options,
                NetStatistics& statistics) try {
  if (options.pseudo && !epsilon.allows_pseudo_nets()) {
    throw std::invalid_argument("epsilon = " + epsilon.text() +
                                " is too large for a pseudo net, the limit is ln sqrt(2) = 0.3465...");
  }
  using Clock = std::chrono::steady_clock;
  const auto seconds_since = [](Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
  };
  const auto start = Clock::now();
  Refined result{delaunay_start(surface, options.base, &statistics.initial_flips), std::nullopt};
  Triangulation& triangulation = result.triangulation;
  if (options.base) {
    statistics.removed = reduce_to_vertex_0(triangulation);
  }
  statistics.start_seconds = seconds_since(start);
  const auto refinement = Clock::now();
  if (options.pseudo) {
    Collars collars(triangulation, epsilon);
    refine(triangulation, epsilon, options, statistics, &collars);
    result.collars = collars.documents();
    statistics.collars = collars.count();
  } else {
    refine(triangulation, epsilon, options, statistics);
  }
  statistics.refine_seconds = seconds_since(refinement);
  statistics.multiprecision = triangulation.multiprecision_count();
  return result;
} catch (const LimitError& error) {
  throw NetError(error.what());
}

}  // namespace

Triangulation net_triangulation(const Surface& surface, const Length& epsilon, const NetOptions& options,
                                NetStatistics& statistics) {
  return refined(surface, epsilon, options, statistics).triangulation;
}

UncertifiedNet compute_net(const Surface& surface, const Length& epsilon, const NetOptions& options) {
  UncertifiedNet result;
  Refined net = refined(surface, epsilon, options, result.statistics);
  result.net = net_document(net.triangulation, epsilon);
  result.net.collars = std::move(net.collars);
  result.statistics.charts = result.net.charts.size();
  result.statistics.labels = result.net.labels.size();
  return result;
}

CertifiedNet certified_net(const Surface& surface, const Length& epsilon, const NetOptions& options) {
  UncertifiedNet net = compute_net(surface, epsilon, options);
  certify::Certificate certificate = certify::check(net.net, options.check);
  if (certificate.verdict != certify::Verdict::verified) {
    throw NetError("the net was not verified: " + certify::verdict_line(certificate));
  }
  return {std::move(net.net), std::move(certificate), net.statistics};
}

CertifiedNet certified_net(const Surface& surface, double epsilon, const NetOptions& options) {
  return certified_net(surface, Length(epsilon), options);
}

}  // namespace epsnet
