// Measures CGAL with as many points in the Euclidean plane, for comparison with the numbers of tests/benchmark/run:
//
//   cgal_benchmark delaunay COUNT   the Delaunay triangulation of COUNT random points of a square, all given at once
//   cgal_benchmark mesh COUNT       the refinement of a square to about COUNT vertices, angles of 20.7 degrees and more
//
// prints the number of vertices, the elapsed seconds and the processor seconds, without those for drawing the points.

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Delaunay_mesh_size_criteria_2.h>
#include <CGAL/Delaunay_mesher_2.h>
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <random>
#include <vector>

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

double seconds(clockid_t clock) {
  timespec time{};
  clock_gettime(clock, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// The time since the object was made.
struct Stopwatch {
  double start_elapsed = seconds(CLOCK_MONOTONIC);
  double start_processor = seconds(CLOCK_PROCESS_CPUTIME_ID);

  void print(std::size_t vertices) const {
    std::printf("%zu %.6f %.6f\n", vertices, seconds(CLOCK_MONOTONIC) - start_elapsed,
                seconds(CLOCK_PROCESS_CPUTIME_ID) - start_processor);
  }
};

/// CGAL sorts the points along a space-filling curve.
void delaunay(std::size_t count) {
  std::mt19937_64 random(123);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  std::vector<Kernel::Point_2> points;
  points.reserve(count);
  while (points.size() < count) points.emplace_back(coordinate(random), coordinate(random));
  const Stopwatch stopwatch;
  const CGAL::Delaunay_triangulation_2<Kernel> triangulation(points.begin(), points.end());
  stopwatch.print(triangulation.number_of_vertices());
}

void mesh(std::size_t count) {
  using Faces = CGAL::Delaunay_mesh_face_base_2<Kernel>;
  using Structure = CGAL::Triangulation_data_structure_2<CGAL::Triangulation_vertex_base_2<Kernel>, Faces>;
  using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure>;
  constexpr double kLeastSine2 = 0.125;      // CGAL's default; it proves that the refinement ends.
  constexpr double kVerticesPerSize2 = 2.5;  // About: vertices times the square of the greatest edge, found by trial.
  const Stopwatch stopwatch;
  Triangulation triangulation;
  const Kernel::Point_2 corners[] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  for (std::size_t i = 0; i < 4; ++i) triangulation.insert_constraint(corners[i], corners[(i + 1) % 4]);
  const double size = std::sqrt(kVerticesPerSize2 / static_cast<double>(count));
  CGAL::refine_Delaunay_mesh_2(triangulation, CGAL::Delaunay_mesh_size_criteria_2<Triangulation>(kLeastSine2, size));
  stopwatch.print(triangulation.number_of_vertices());
}

}  // namespace

int main(int argc, char** argv) {
  std::size_t count = 0;
  const bool meshing = argc == 3 && std::strcmp(argv[1], "mesh") == 0;
  if (argc != 3 || (!meshing && std::strcmp(argv[1], "delaunay") != 0) ||
      std::from_chars(argv[2], argv[2] + std::strlen(argv[2]), count).ec != std::errc() || count == 0) {
    std::fputs("Usage: cgal_benchmark delaunay|mesh COUNT\n", stderr);
    return 64;
  }
  meshing ? mesh(count) : delaunay(count);
  return 0;
}
