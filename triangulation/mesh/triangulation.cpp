#include "triangulation/mesh/triangulation.h"

#include <algorithm>

namespace epsnet {

void Triangulation::reserve(std::size_t vertices) {
  mesh_.points.reserve(vertices);
  mesh_.charts.reserve(vertices);
  mesh_.triangles.reserve(2 * vertices);
}

std::vector<Dart> Triangulation::star(Dart d) const {
  std::vector<Dart> darts;
  Dart e = d;
  do {
    darts.push_back(e);
    e = next_dart(opposite(e));
  } while (e != d);
  return darts;
}

LiftedPoint Triangulation::lifted_point(const BasePoint& point, TriangleId t) {
  const ChartId chart = atlas_.add_chart({point.tile, point.z});
  const ChartId there = chart_of(t);
  return {chart,
          {0, 0},
          atlas_.label(chart, there, path_between_tiles(surface(), point.tile, atlas_.charts()[there].tile))};
}

LabelId Triangulation::label_along(Dart d) {
  return atlas_.product(atlas_.inverse(corner(d).label), corner(next_dart(d)).label);
}

LabelId Triangulation::transition(Dart d) {
  const Triangle& t = triangle(triangle_of(d));
  const Dart e = t.opposite[corner_of(d)];
  const Triangle& other = triangle(triangle_of(e));
  if (t.all_identity() && other.all_identity()) {
    return kIdentity;
  }
  return lift_across(t.label(corner_of(d)), t.label(next(corner_of(d))), e);
}

template <class T, std::size_t N, class Stage>
StageSign Triangulation::multiprecision_stage(const std::array<Corner, N>& corners, const Stage& stage) {
  std::array<Complex<T>, N> points;
  for (std::size_t i = 0; i < N; ++i) {
    points[i] = atlas_.lift<T>(corners[i].label, mesh_.points[corners[i].vertex]);
  }
  return stage(points, Atlas::lift_error<T>());
}

template <std::size_t N, class Stage>
int Triangulation::staged(const std::array<Corner, N>& corners, const Stage& stage) {
  std::array<Complex<double>, N> points;
  double error = 0;
  for (std::size_t i = 0; i < N; ++i) {
    const Lift l = lift(corners[i]);
    points[i] = l.z;
    error = std::max(error, l.error);
  }
  StageSign result = stage(points, error);
  if (!result.certain) {
    ++multiprecision_;
    result = multiprecision_stage<Mp256>(corners, stage);
  }
  if (!result.certain) {
    result = multiprecision_stage<Mp1024>(corners, stage);
  }
  if (!result.certain) {
    result = multiprecision_stage<Mp4096>(corners, stage);
  }
  return result.sign;
}

int Triangulation::in_circle(Corner a, Corner b, Corner c, Corner d) {
  return staged(std::array{a, b, c, d}, []<class T>(const std::array<Complex<T>, 4>& p, const T& error) {
    return in_circle_stage<T>(p[0], p[1], p[2], p[3], error);
  });
}

int Triangulation::orientation(Corner a, Corner b, Corner c) {
  return staged(std::array{a, b, c}, []<class T>(const std::array<Complex<T>, 3>& p, const T& error) {
    return orientation_stage<T>(p[0], p[1], p[2], error);
  });
}

int Triangulation::compare_circumradius_staged(TriangleId t, const Threshold& s) {
  return staged(std::array{corner(t, 0), corner(t, 1), corner(t, 2)},
                [&s]<class T>(const std::array<Complex<T>, 3>& p, const T& error) {
                  const auto& [low, high] = s.at<T>();
                  return circumradius_stage<T>(p[0], p[1], p[2], low, high, error);
                });
}

int Triangulation::compare_distance_staged(Corner a, Corner b, const Threshold& s) {
  return staged(std::array{a, b}, [&s]<class T>(const std::array<Complex<T>, 2>& p, const T& error) {
    const auto& [low, high] = s.at<T>();
    return distance_stage<T>(p[0], p[1], low, high, error);
  });
}

bool Triangulation::is_delaunay(Dart d) {
  const TriangleId t = triangle_of(d);
  const Dart e = opposite(d);
  const LabelId across = transition(d);
  return in_circle(corner(t, 0), corner(t, 1), corner(t, 2),
                   moved(across, corner(triangle_of(e), previous(corner_of(e))))) <= 0;
}

}  // namespace epsnet
