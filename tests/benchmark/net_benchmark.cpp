// Speed and memory of the generator and of the certifier, compared with CGAL's Euclidean Delaunay triangulation of as
// many random points. All are timed in the same run, as ratios vary less between machines than times.

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <benchmark/benchmark.h>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <map>
#include <random>
#include <sys/resource.h>
#include <vector>

#include "certify/check.h"
#include "netgen/nets/certified_net.h"
#include "netgen/nets/refine.h"
#include "netgen/surfaces/surfaces.h"
#include "triangulation/mesh/operations.h"

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::int32_t kSeed = 123;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// ε as a benchmark's integer argument: thousandths.
epsnet::Length epsilon_of(std::int64_t thousandths) { return epsnet::Length(std::to_string(thousandths) + "/1000"); }

/// The best rates seen, in points per second, by number of points: for the ratio at the end.
std::map<std::size_t, double> best_net_rate;

/// Inserted points per second, from the octagon to the finished triangulation; nothing written, nothing certified.
void generate(benchmark::State& state, epsnet::Insertion insertion) {
  const epsnet::Surface surface = epsnet::random_octagon(kSeed);
  const epsnet::Length epsilon = epsilon_of(state.range(0));
  std::size_t points = 0;
  for (auto _ : state) {
    const auto start = Clock::now();
    epsnet::Triangulation triangulation(surface);
    (void)epsnet::make_delaunay(triangulation);
    (void)epsnet::refine(triangulation, epsilon, {}, {.insertion = insertion});
    const double seconds = seconds_since(start);
    state.SetIterationTime(seconds);
    points = triangulation.vertex_count();
    if (insertion == epsnet::Insertion::cavity) {
      double& best = best_net_rate[points];
      best = std::max(best, static_cast<double>(points) / seconds);
    }
  }
  state.counters["points"] = static_cast<double>(points);
  state.counters["points/s"] =
      benchmark::Counter(static_cast<double>(points), benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK_CAPTURE(generate, cavity, epsnet::Insertion::cavity)
    ->Arg(100)
    ->Arg(10)
    ->Arg(5)
    ->Arg(2)
    ->MinTime(3)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(generate, flips, epsnet::Insertion::flips)->Arg(10)->UseManualTime()->Unit(benchmark::kMillisecond);

/// Triangles per second of the certifier on one core.
void certify(benchmark::State& state) {
  const epsnet::UncertifiedNet net = epsnet::compute_net(epsnet::random_octagon(kSeed), epsilon_of(state.range(0)));
  epsnet::certify::CheckOptions options;
  options.threads = 1;
  for (auto _ : state) {
    const auto certificate = epsnet::certify::check(net.document, options);
    if (certificate.verdict != epsnet::certify::Verdict::verified) {
      state.SkipWithError("not verified");
    }
  }
  state.counters["triangles/s"] = benchmark::Counter(static_cast<double>(net.document.triangles.size()),
                                                     benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK(certify)->Arg(100)->Arg(10)->Unit(benchmark::kMillisecond);

/// CGAL's Euclidean Delaunay triangulation of random points, spatially sorted by CGAL; and the ratio of our points per
/// second to its.
void cgal_delaunay(benchmark::State& state) {
  using Triangulation = CGAL::Delaunay_triangulation_2<CGAL::Exact_predicates_inexact_constructions_kernel>;
  const auto count = static_cast<std::size_t>(state.range(0));
  std::mt19937_64 random(kSeed);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  std::vector<Triangulation::Point> points;
  while (points.size() < count) {
    points.emplace_back(coordinate(random), coordinate(random));
  }
  double best = 0;
  for (auto _ : state) {
    const auto start = Clock::now();
    Triangulation triangulation(points.begin(), points.end());
    const double seconds = seconds_since(start);
    state.SetIterationTime(seconds);
    best = std::max(best, static_cast<double>(count) / seconds);
    benchmark::DoNotOptimize(triangulation);
  }
  state.counters["points/s"] =
      benchmark::Counter(static_cast<double>(count), benchmark::Counter::kIsIterationInvariantRate);
  const auto nearest = best_net_rate.lower_bound(count);
  if (nearest != best_net_rate.end()) {
    state.counters["epsnet/CGAL"] = nearest->second / best;
  }
}
BENCHMARK(cgal_delaunay)
    ->Arg(86'000)
    ->Arg(345'000)
    ->Arg(2'150'000)
    ->MinTime(3)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

/// Bytes per vertex that generation adds to the memory of the process, at its peak.
void report_memory() {
  const auto peak_kilobytes = [] {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss;
  };
  const epsnet::Surface surface = epsnet::random_octagon(kSeed);
  const long before = peak_kilobytes();
  epsnet::Triangulation triangulation(surface);
  (void)epsnet::make_delaunay(triangulation);
  (void)epsnet::refine(triangulation, epsilon_of(2), {});
  const double bytes = 1024.0 * static_cast<double>(peak_kilobytes() - before);
  std::printf("memory: %.1f bytes per vertex at the peak of generation (%u vertices)\n",
              bytes / triangulation.vertex_count(), triangulation.vertex_count());
}

}  // namespace

int main(int argc, char** argv) {
  report_memory();  // First, while the peak is this one's.
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) {
    return 1;
  }
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
