#include "certify/claims/geodesics/orbit_search.h"

#include <gtest/gtest.h>
#include <map>

#include "tests/certify/lifted_reference.h"

/// The reverse search of docs/proof.md, Lemma 15, against all lifted triangles of a region, found without pruning.
namespace epsnet::certify {
namespace {

NetDocument net_of(const std::string& name) {
  return read_file<NetDocument>(std::string(EPSNET_TEST_DATA) + "/certify/verified/" + name);
}

struct Found {
  OrbitOutcome outcome;
  std::map<Key, int> elements;
  bool products_fit = true;
};

Found search(const LiftedNet& lifted, const Reference& reference, std::uint32_t dart, Real distance_bound,
             std::uint64_t limit = 1'000'000) {
  Ball distance, cosh, sinh;
  arb_set_d(distance.get(), static_cast<double>(distance_bound));
  arb_sinh_cosh(sinh.get(), cosh.get(), distance.get(), lifted.plane().precision());
  Found found;
  found.outcome = search_orbit(lifted.plane(), dart, cosh, sinh, limit,
                               [&](const BallIsometry& element, const LabelProduct& product) {
                                 ++found.elements[key_of(middle(element))];
                                 const auto labels = product();
                                 if (key_of(reference.value(labels)) != key_of(middle(element)))
                                   found.products_fit = false;
                                 return Search::go_on;
                               });
  return found;
}

struct Instance {
  const char* name;
  double distance;
};

TEST(OrbitSearch, VisitsExactlyTheTrianglesWithinTheBound) {
  for (const auto& [name, distance] : std::vector<Instance>{{"regular-2-10-vertices.json", 0.1},
                                                            {"regular-2-10-vertices.json", 3.3},
                                                            {"regular-2-4-rotated-vertices.json", 2.1},
                                                            {"octagon-9-vertices.json", 2.1}}) {
    const NetDocument net = net_of(name);
    const Reference reference(net);
    const LiftedNet lifted(net);
    // Every corner of a triangle is once the vertex.
    for (std::uint32_t dart = 0; dart < 3 * net.triangles.size(); dart += 4) {
      const Wanted all = wanted(reference, dart, distance);
      ASSERT_GT(all.gap, 1e-9) << "too near to be told in long double";
      const Found found = search(lifted, reference, dart, distance);
      EXPECT_TRUE(found.outcome.complete);
      EXPECT_FALSE(found.outcome.limit_reached);
      EXPECT_EQ(found.outcome.visits, all.triangles) << name << " dart " << dart;
      EXPECT_TRUE(found.products_fit) << name << " dart " << dart;
      ASSERT_EQ(found.elements.size(), all.elements.size()) << name << " dart " << dart;
      for (const auto& [key, count] : found.elements) {
        EXPECT_EQ(count, 1);
        EXPECT_TRUE(all.elements.contains(key)) << name << " dart " << dart;
      }
    }
  }
}

TEST(OrbitSearch, EndsIncompleteWhereItsLimitOrTheReportEndsIt) {
  const NetDocument net = net_of("regular-2-10-vertices.json");
  const Reference reference(net);
  const LiftedNet lifted(net);
  const std::uint64_t visits = search(lifted, reference, 0, 3.3).outcome.visits;
  ASSERT_GT(visits, 100U);
  const OrbitOutcome enough = search(lifted, reference, 0, 3.3, visits).outcome;
  EXPECT_TRUE(enough.complete);
  EXPECT_FALSE(enough.limit_reached);
  for (const std::uint64_t limit : {visits - 1, std::uint64_t{1}, std::uint64_t{0}}) {
    const OrbitOutcome outcome = search(lifted, reference, 0, 3.3, limit).outcome;
    EXPECT_FALSE(outcome.complete);
    EXPECT_TRUE(outcome.limit_reached);
    EXPECT_EQ(outcome.visits, limit + 1);
  }
  // The first report is 1, at the root; the next ends the search.
  Ball cosh, sinh;
  arb_set_d(cosh.get(), std::cosh(3.3));
  arb_set_d(sinh.get(), std::sinh(3.3));
  for (const int last : {1, 2}) {
    int reports = 0;
    const OrbitOutcome outcome = search_orbit(
        lifted.plane(), 0, cosh, sinh, visits,
        [&](const BallIsometry&, const LabelProduct&) { return ++reports == last ? Search::stop : Search::go_on; });
    EXPECT_EQ(reports, last);
    EXPECT_FALSE(outcome.complete);
    EXPECT_FALSE(outcome.limit_reached);
    EXPECT_LT(outcome.visits, visits);
  }
}

TEST(OrbitSearch, VisitsWhatIsPerhapsWithinABoundThatIsNotKnown) {
  const NetDocument net = net_of("regular-2-10-vertices.json");
  const Reference reference(net);
  const LiftedNet lifted(net);
  for (const double distance : {1.6, 2.7}) {
    // Any distance from 0 to 2D: what D wants is perhaps wanted.
    Ball cosh, sinh;
    arb_set_d(cosh.get(), std::cosh(distance));
    mag_set_d(arb_radref(cosh.get()), std::cosh(distance) - 1);
    arb_set_d(sinh.get(), std::sinh(distance));
    const OrbitOutcome outcome = search_orbit(lifted.plane(), 0, cosh, sinh, 1'000'000,
                                              [&](const BallIsometry&, const LabelProduct&) { return Search::go_on; });
    EXPECT_TRUE(outcome.complete);
    EXPECT_GE(outcome.visits, wanted(reference, 0, distance).triangles);
  }
}

/// Nets in which the point q of a dart lies, to binary64, on the line of an edge of a lifted triangle: a vertex is
/// moved until the line passes q, and is left on both sides of it.
std::vector<NetDocument> nets_with_q_on_a_line(const NetDocument& net, std::uint32_t dart, Real radius) {
  const Reference reference(net);
  const Complex q = point_near(reference, dart);
  const auto& root = net.triangles[dart / 3].vertex;
  std::vector<NetDocument> found;
  for (const Lift& lift : reference.lifts(dart / 3, q, radius)) {
    const Vector x = vector_of(image(lift.to_chart, q));
    for (std::uint32_t edge = 3 * lift.triangle; edge < 3 * lift.triangle + 3; ++edge) {
      for (const std::uint32_t end : {edge, next_dart(edge)}) {
        const std::uint32_t w = start(net, end);
        if (std::find(root.begin(), root.end(), w) != root.end()) continue;
        NetDocument moved = net;
        const auto is_left = [&](double shift) {
          moved.vertices[w].x = net.vertices[w].x + shift;
          const NetDocument::Vertex& vertex = moved.vertices[w];
          const auto place = [&](std::uint32_t d) {
            if (start(net, d) != w) return vector_of(reference.corner(d));
            return vector_of(image(reference.label(corner_label(net, d)), Complex(vertex.x, vertex.y)));
          };
          return determinant(place(edge), place(next_dart(edge)), x) > 0;
        };
        double low = -0.03;
        double high = 0.03;
        const bool before = is_left(low);
        if (before == is_left(high)) continue;
        for (double middle = 0; middle != low && middle != high; middle = (low + high) / 2) {
          (is_left(middle) == before ? low : high) = middle;
        }
        for (const double shift : {low, high}) {
          (void)is_left(shift);
          found.push_back(moved);
        }
      }
    }
  }
  return found;
}

TEST(OrbitSearch, OmitsNothingWhereBallsDoNotTellOnWhichSideOfAnEdgeQLies) {
  // There it visits a triangle that is perhaps a child.
  const NetDocument net = net_of("regular-2-10-vertices.json");
  std::uint64_t complete = 0;
  std::uint64_t twice = 0;
  for (const std::uint32_t dart : {0U, 13U, 31U}) {
    for (const NetDocument& moved : nets_with_q_on_a_line(net, dart, 2)) {
      const Reference reference(moved);
      const Wanted all = wanted(reference, dart, 1.6);
      const OrbitOutcome outcome = search(LiftedNet(moved, 50), reference, dart, 1.6).outcome;
      if (!outcome.complete) continue;
      ++complete;
      EXPECT_GE(outcome.visits, all.triangles) << "dart " << dart;
      if (outcome.visits > all.triangles) ++twice;
    }
  }
  EXPECT_GT(complete, 20U);
  EXPECT_GT(twice, 2U);
}

/// Whether balls may be those of an element given in long double.
bool may_be(const BallIsometry& f, const Move& g) {
  const auto near = [](arb_srcptr x, Real y) {
    return std::abs(middle(x) - y) <= mag_get_d(arb_radref(x)) + 1e-9L * (1 + std::abs(y));
  };
  return near(f.a.re(), g.first.real()) && near(f.a.im(), g.first.imag()) && near(f.b.re(), g.second.real()) &&
         near(f.b.im(), g.second.imag());
}

TEST(OrbitSearch, OmitsNothingThatFewBitsDoNotTell) {
  const NetDocument net = net_of("regular-2-10-vertices.json");
  const Reference reference(net);
  int complete = 0;
  for (const std::uint32_t dart : {0U, 7U, 23U}) {
    const Wanted all = wanted(reference, dart, 1.6);
    for (slong precision = 16; precision < 64; ++precision) {
      const LiftedNet lifted(net, precision);
      Ball distance, cosh, sinh;
      arb_set_d(distance.get(), 1.6);
      arb_sinh_cosh(sinh.get(), cosh.get(), distance.get(), precision);
      std::vector<BallIsometry> found;
      const OrbitOutcome outcome =
          search_orbit(lifted.plane(), dart, cosh, sinh, 10'000, [&](const BallIsometry& element, const LabelProduct&) {
            found.push_back(element);
            return Search::go_on;
          });
      if (!outcome.complete) continue;
      ++complete;
      EXPECT_GE(outcome.visits, all.triangles) << "dart " << dart << ", " << precision << " bits";
      for (const auto& entry : all.elements) {
        const Move& element = entry.second;
        EXPECT_TRUE(std::any_of(found.begin(), found.end(),
                                [&](const BallIsometry& f) {
                                  return may_be(f, element) || may_be(f, {-element.first, -element.second});
                                }))
            << "dart " << dart << ", " << precision << " bits";
      }
    }
  }
  EXPECT_GT(complete, 30);
}

}  // namespace
}  // namespace epsnet::certify
