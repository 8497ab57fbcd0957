#include "certify/claims/geodesics/crossing_search.h"

#include <cmath>
#include <gtest/gtest.h>

#include "certify/check.h"
#include "certify/claims/geodesics/chord_table.h"
#include "certify/claims/geodesics/completeness_check.h"
#include "tests/certify/lifted_reference.h"
#include "tests/support/scale.h"

/// The search for least sequences of edges (docs/proof.md, Lemmas 15.1 to 15.3), on lists that another program found
/// and the search around vertices verified: of a surface without symmetries; of the Bolza surface, on which up to 24
/// have one length and many pass through the vertices of the net; and of one with a cuff of length 1e-3.
namespace epsnet::certify {
namespace {

const std::vector<std::string> kLists{"octagon-5-to-6", "bolza-to-6.2", "one-cuff-of-1e-3-to-6.5"};

GeodesicsDocument load(const std::string& name) {
  return read_file<GeodesicsDocument>(std::string(EPSNET_TEST_DATA) + "/geodesics/" + name + ".json");
}

/// The list without geodesic i.
GeodesicsDocument without(GeodesicsDocument document, std::size_t i) {
  document.geodesics.erase(document.geodesics.begin() + static_cast<std::ptrdiff_t>(i));
  document.clusters.clear();
  double reach = 0;
  for (std::uint32_t k = 0; k < document.geodesics.size(); ++k) {
    const Interval length = document.geodesics[k].length;
    if (k == 0 || length.lower > reach) document.clusters.push_back({k, 0, true});
    reach = std::max(reach, length.upper);
    GeodesicsDocument::Cluster& last = document.clusters.back();
    if (++last.count > 1) last.equal = false;
  }
  return document;
}

/// The middles of the lengths of all elements reported that are not longer than the list's bound; nothing if the search
/// says that it is not complete.
std::optional<std::vector<double>> lengths_found(const GeodesicsDocument& document, slong precision,
                                                 std::uint64_t limit = 1'000'000) {
  const LiftedNet lifted(document.net, document.geodesics, precision);
  const MovedNet moved(lifted.plane());
  if (!moved.valid()) return std::nullopt;
  const CompletenessCheck completeness(document, lifted.evaluator(), {});
  const CrossingSearch search(moved, std::vector<bool>(3 * document.net.triangles.size()),
                              completeness.cosh_half_bound(lifted.plane()));
  std::vector<double> found;
  bool complete = true;
  for (std::size_t start = 0; start < search.starts(); ++start) {
    const OrbitOutcome outcome = search.run(start, limit, [&](const BallIsometry& element, const LabelProduct&) {
      const Interval length = translation_length(element, precision);
      found.push_back((length.lower + length.upper) / 2);
      return Search::go_on;
    });
    complete = complete && outcome.complete;
    EXPECT_FALSE(outcome.complete && outcome.limit_reached);
  }
  return complete ? std::optional(found) : std::nullopt;
}

TEST(CrossingSearch, VerifiesLists) {
  for (const std::string& name : kLists) {
    const GeodesicsDocument document = load(name);
    const Certificate certificate = check(document);
    EXPECT_EQ(certificate.verdict, Verdict::verified) << name << ": " << certificate.message;
    // Nearly every geodesic is met once: its least sequence has one beginning.
    EXPECT_GE(certificate.geodesics->candidates, document.geodesics.size()) << name;
    EXPECT_LE(certificate.geodesics->candidates, document.geodesics.size() * 3 / 2) << name;
  }
}

TEST(CrossingSearch, MissesWhicheverIsLeftOut) {
  const auto step = static_cast<std::size_t>(std::ceil(1 / test::multiplier()));  // With sanitizers, not all of them.
  for (const std::string& name : kLists) {
    const GeodesicsDocument document = load(name);
    for (std::size_t i = 0; i < document.geodesics.size(); i += step) {
      const Certificate certificate = check(without(document, i));
      EXPECT_EQ(certificate.verdict, Verdict::refuted) << name << ", geodesic " << i;
      EXPECT_EQ(certificate.rule, "complete") << name << ", geodesic " << i << ": " << certificate.message;
    }
  }
}

TEST(CrossingSearch, ReportsAnElementOfEveryLength) {
  const GeodesicsDocument document = load("bolza-to-6.2");
  const auto found = lengths_found(document, 128);
  ASSERT_TRUE(found);
  for (const GeodesicsDocument::Cluster& cluster : document.clusters) {
    const Interval length = document.geodesics[cluster.first].length;
    const auto count = std::count_if(found->begin(), found->end(),
                                     [&](double x) { return length.lower - 1e-9 < x && x < length.upper + 1e-9; });
    EXPECT_GE(count, cluster.count);
  }
}

TEST(CrossingSearch, OmitsNothingThatFewBitsDoNotTell) {
  const GeodesicsDocument document = load("octagon-5-to-6");
  int complete = 0;
  int incomplete = 0;
  for (const slong precision : {16, 24, 32, 36, 40, 44, 48, 56, 64, 80}) {
    const auto found = lengths_found(document, precision);
    ++(found ? complete : incomplete);
    if (!found) continue;
    for (const GeodesicsDocument::ClosedGeodesic& geodesic : document.geodesics) {
      EXPECT_TRUE(std::any_of(found->begin(), found->end(),
                              [&](double x) { return std::abs(x - geodesic.length.lower) < 1e-2; }))
          << precision << " bits";
    }
  }
  EXPECT_GE(complete, 3);
  EXPECT_GE(incomplete, 1);
}

TEST(CrossingSearch, EndsIncompleteWhereItsLimitOrTheReportEndsIt) {
  const GeodesicsDocument document = load("octagon-5-to-6");
  EXPECT_FALSE(lengths_found(document, 128, 10));
  const LiftedNet lifted(document.net, document.geodesics);
  const MovedNet moved(lifted.plane());
  ASSERT_TRUE(moved.valid());
  const CompletenessCheck completeness(document, lifted.evaluator(), {});
  const CrossingSearch search(moved, std::vector<bool>(3 * document.net.triangles.size()),
                              completeness.cosh_half_bound(lifted.plane()));
  int reports = 0;
  const auto stop = [&](const BallIsometry&, const LabelProduct&) {
    ++reports;
    return Search::stop;
  };
  const OrbitOutcome stopped = search.run(0, 1'000'000, stop);
  EXPECT_EQ(reports, 1);
  EXPECT_FALSE(stopped.complete);
  EXPECT_FALSE(stopped.limit_reached);
  const OrbitOutcome limited = search.run(0, 5, stop);
  EXPECT_TRUE(limited.limit_reached);
  EXPECT_FALSE(limited.complete);
  EXPECT_EQ(limited.visits, 6U);
}

/// The products of labels that are reported are the elements: exact numbers are made from them.
TEST(CrossingSearch, ProductsOfLabelsAreTheElements) {
  const GeodesicsDocument document = load("bolza-to-6.2");
  const LiftedNet lifted(document.net, document.geodesics);
  const Reference reference(lifted.net());
  const MovedNet moved(lifted.plane());
  ASSERT_TRUE(moved.valid());
  const CompletenessCheck completeness(document, lifted.evaluator(), {});
  const CrossingSearch search(moved, std::vector<bool>(3 * document.net.triangles.size()),
                              completeness.cosh_half_bound(lifted.plane()));
  int reports = 0;
  for (std::size_t start = 0; start < search.starts(); ++start) {
    (void)search.run(start, 1'000'000, [&](const BallIsometry& element, const LabelProduct& product) {
      EXPECT_EQ(key_of(reference.value(product())), key_of(middle(element)));
      ++reports;
      return Search::go_on;
    });
  }
  EXPECT_GE(reports, 48);
}

/// A net all of whose vertices are moved is still one of the same surface; across a dart lies what the labels say.
TEST(MovedNet, ThirdCornersAreThoseAcross) {
  for (const std::string& name : kLists) {
    const GeodesicsDocument document = load(name);
    const LiftedNet lifted(document.net);
    const MovedNet moved(lifted.plane());
    ASSERT_TRUE(moved.valid()) << name;
    const NetDocument& net = lifted.net();
    for (std::uint32_t dart = 0; dart < 3 * net.triangles.size(); ++dart) {
      // The distance of the third corner from the end of the dart, in both triangles.
      const std::uint32_t other = opposite(net, dart);
      const Ball expected = lorentz_product(moved.corner(previous_dart(other)), moved.corner(other), 128);
      BallVector third;
      const std::uint32_t corners[3] = {next_dart(dart), dart, previous_dart(dart)};
      for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
          arb_addmul(third[k].get(), moved.beyond(dart)[i].get(), moved.corner(corners[i])[k].get(), 128);
        }
      }
      const Ball product = lorentz_product(third, moved.corner(next_dart(dart)), 128);
      EXPECT_TRUE(arb_overlaps(product.get(), expected.get())) << name << ", dart " << dart;
      EXPECT_GT(arb_rel_accuracy_bits(product.get()), 30);
    }
  }
}

}  // namespace
}  // namespace epsnet::certify
