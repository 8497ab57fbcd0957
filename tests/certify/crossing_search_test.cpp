#include "certify/claims/geodesics/crossing_search.h"

#include <cmath>
#include <gtest/gtest.h>

#include "certify/base/text.h"
#include "certify/check.h"
#include "certify/claims/geodesics/axis_crossings.h"
#include "certify/claims/geodesics/sequences.h"
#include "tests/certify/claim_files.h"
#include "tests/certify/lifted_reference.h"
#include "tests/support/scale.h"

/// The search for least sequences of edges (docs/proof.md, Lemmas 12 to 15), on lists that another program found and an
/// older search, around vertices, verified: of a surface without symmetries; of the Bolza surface, on which up to 24
/// have one length and many pass through the vertices of the net, or along its edges; of one with a cuff of length
/// 1e-3; and of Klein's quartic, whose 21 systoles have one length, and the 28 geodesics after them another one.
namespace epsnet::certify::crossing_search_test {
namespace {

const std::vector<std::string> kLists{"octagon-5-to-6", "bolza-to-6.2", "one-cuff-of-1e-3-to-6.5", "klein-to-5.5"};

GeodesicsDocument load(const std::string& name) {
  return read_file<GeodesicsDocument>(std::string(EPSNET_TEST_DATA) + "/geodesics/" + name + ".json");
}

/// The list without geodesic i.
GeodesicsDocument without(GeodesicsDocument document, std::size_t i) {
  document.geodesics.erase(document.geodesics.begin() + static_cast<std::ptrdiff_t>(i));
  return in_order(std::move(document));
}

/// The list with geodesic i run through once more, `times` times.
GeodesicsDocument with_power(GeodesicsDocument document, std::size_t i, int times) {
  GeodesicsDocument::ClosedGeodesic power = document.geodesics[i];
  for (int k = 1; k < times; ++k) {
    power.word.insert(power.word.end(), document.geodesics[i].word.begin(), document.geodesics[i].word.end());
  }
  power.length = {times * power.length.lower, times * power.length.upper};
  document.geodesics.push_back(power);
  return in_order(std::move(document));
}

/// A list with all that its search needs.
struct SearchOfList {
  explicit SearchOfList(const GeodesicsDocument& document, slong precision = 128)
      : lifted(document.net, document.geodesics, precision), moved(lifted.plane()) {
    if (!moved.valid()) return;
    const Precision scope(precision);
    order.emplace(moved, std::vector<bool>(3 * document.net.triangles.size()));
    search.emplace(moved, *order, cosh(half(Ball::rounded(decimal(document.up_to)))));
  }

  [[nodiscard]] std::vector<std::uint32_t> darts(const std::vector<std::uint32_t>& codes) const {
    std::vector<std::uint32_t> result;
    for (const std::uint32_t code : codes) result.push_back(order->dart(code));
    return result;
  }

  LiftedNet lifted;
  MovedNet moved;
  std::optional<DartOrder> order;
  std::optional<CrossingSearch> search;
};

/// The middles of the lengths of all elements reported; nothing if the search says that it is not complete.
std::optional<std::vector<double>> lengths_found(const GeodesicsDocument& document, slong precision,
                                                 std::uint64_t limit = 1'000'000) {
  const Precision scope(precision);
  const SearchOfList list(document, precision);
  if (!list.search) return std::nullopt;
  std::vector<double> found;
  bool complete = true;
  for (std::size_t part = 0; part < list.search->size(); ++part) {
    const SearchOutcome outcome = list.search->run(part, limit, [&](const std::vector<std::uint32_t>& codes) {
      const Interval length = translation_length(element_across(list.lifted.plane(), list.darts(codes)), precision);
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

/// The same of all lists is deep.
TEST(CrossingSearch, MissesWhicheverIsLeftOutOfARandomOctagon) {
  const GeodesicsDocument document = load("octagon-5-to-6");
  const auto step = static_cast<std::size_t>(std::ceil(0.3 / test::multiplier()));
  for (std::size_t i = 0; i < document.geodesics.size(); i += step) {
    const Certificate certificate = check(without(document, i));
    EXPECT_EQ(certificate.verdict, Verdict::refuted) << "geodesic " << i;
    EXPECT_EQ(certificate.rule, "complete") << "geodesic " << i << ": " << certificate.message;
  }
}

TEST(DeepCrossingSearch, MissesWhicheverIsLeftOut) {
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

/// Of equal lengths none is shorter; whichever of the longer ones is said to be a systole, a shorter one is found.
TEST(CrossingSearch, TellsSystolesFromLongerGeodesics) {
  for (const std::string& name : kLists) {
    const GeodesicsDocument all = load(name);
    GeodesicsDocument systole = all;
    systole.claim = GeodesicsDocument::Claim::systole;
    systole.clusters.clear();
    systole.up_to.clear();
    const std::size_t shortest = all.clusters[0].count;
    for (std::size_t i = 0; i < std::min(2 * shortest, all.geodesics.size()); i += i < 4 ? 1 : 5) {
      systole.geodesics = {all.geodesics[i]};
      const Certificate certificate = check(systole);
      EXPECT_EQ(certificate.verdict, i < shortest ? Verdict::verified : Verdict::refuted) << name << ", geodesic " << i;
      if (i < shortest) continue;
      EXPECT_EQ(certificate.rule, "complete");
      EXPECT_NE(certificate.message.find(" is shorter"), std::string::npos) << certificate.message;
    }
  }
}

/// Deep in a collar more bits are needed.
TEST(SlowCrossingSearch, VerifiesAListWithAVeryShortCuff) {
  const GeodesicsDocument document = load("one-cuff-of-1e-8-to-6.5");
  const Certificate certificate = check(document);
  EXPECT_EQ(certificate.verdict, Verdict::verified) << certificate.message;
  EXPECT_GE(certificate.geodesics->candidates, document.geodesics.size());
  EXPECT_GE(certificate.geodesics->deep_vertices, 1U);
  const auto step = static_cast<std::size_t>(std::ceil(6 / test::multiplier()));
  for (std::size_t i = 0; i < document.geodesics.size(); i += step) {
    const Certificate lacking = check(without(document, i));
    EXPECT_EQ(lacking.verdict, Verdict::refuted) << "geodesic " << i;
    EXPECT_EQ(lacking.rule, "complete") << "geodesic " << i << ": " << lacking.message;
  }
}

TEST(CrossingSearch, FindsWhatOccursTwice) {
  for (const std::string& name : kLists) {
    const GeodesicsDocument document = load(name);
    for (std::size_t i = 0; i < document.geodesics.size(); i += 17) {
      const Certificate certificate = check(with_power(document, i, 1), {.threads = 2});
      EXPECT_EQ(certificate.verdict, Verdict::refuted) << name << ", geodesic " << i;
      EXPECT_EQ(certificate.rule, "distinct") << name << ", geodesic " << i;
    }
  }
  const GeodesicsDocument bolza = load("bolza-to-6.2");
  for (std::size_t i = 0; i < 12; ++i) {
    const Certificate certificate = check(with_power(bolza, i, 2));
    EXPECT_EQ(certificate.verdict, Verdict::refuted);
    EXPECT_EQ(certificate.rule, "distinct");
    EXPECT_NE(certificate.message.find(" is geodesic " + std::to_string(i) + ", run through 2 times, up to orient"),
              std::string::npos)
        << certificate.message;
    // A power alone is not what the list lacks.
    GeodesicsDocument alone = with_power(bolza, i, 2);
    alone.geodesics.erase(alone.geodesics.begin() + static_cast<std::ptrdiff_t>(i));
    const Certificate without_root = check(in_order(alone));
    EXPECT_EQ(without_root.verdict, Verdict::refuted);
    EXPECT_EQ(without_root.rule, "complete") << without_root.message;
  }
}

TEST(CrossingSearch, TellsWhatIsSimple) {
  for (const std::string& name : kLists) {
    const GeodesicsDocument document = load(name);
    for (std::size_t i = 0; i < document.geodesics.size(); i += 7) {
      GeodesicsDocument wrong = document;
      wrong.geodesics[i].simple = !wrong.geodesics[i].simple;
      const Certificate certificate = check(wrong);
      EXPECT_EQ(certificate.verdict, Verdict::refuted) << name << ", geodesic " << i;
      EXPECT_EQ(certificate.message,
                "geodesic " + std::to_string(i) + (document.geodesics[i].simple ? " is simple" : " is not simple"));
    }
  }
}

TEST(CrossingSearch, DoesTheSameWithTwoThreads) {
  for (const std::string& name : kLists) {
    const GeodesicsDocument document = load(name);
    const Certificate one = check(document, {.threads = 1});
    const Certificate two = check(document, {.threads = 2});
    EXPECT_EQ(one.geodesics->lifted_triangles, two.geodesics->lifted_triangles);
    EXPECT_EQ(one.geodesics->candidates, two.geodesics->candidates);
    EXPECT_EQ(one.counts.work, two.counts.work);
  }
}

TEST(CrossingSearch, ReportsAnElementOfEveryLength) {
  const GeodesicsDocument document = load("bolza-to-6.2");
  // With numbers of twice the length of binary64, and with balls.
  for (const slong precision : {128, 192}) {
    const auto found = lengths_found(document, precision);
    ASSERT_TRUE(found);
    for (const GeodesicsDocument::Cluster& cluster : document.clusters) {
      const Interval length = document.geodesics[cluster.first].length;
      const auto count = std::count_if(found->begin(), found->end(),
                                       [&](double x) { return length.lower - 1e-9 < x && x < length.upper + 1e-9; });
      EXPECT_GE(count, cluster.count) << precision << " bits";
    }
  }
}

/// What is reported is a least rotation, and each sequence once, in whichever part: parts share the work.
TEST(CrossingSearch, ReportsEverySequenceOnce) {
  for (const std::string& name : kLists) {
    const SearchOfList list(load(name));
    ASSERT_TRUE(list.search);
    std::vector<std::vector<std::uint32_t>> found;
    for (std::size_t part = 0; part < list.search->size(); ++part) {
      (void)list.search->run(part, 1'000'000, [&](const std::vector<std::uint32_t>& codes) {
        EXPECT_EQ(period_of(codes), codes.size());
        for (std::size_t i = 1; i < codes.size(); ++i) {
          std::vector<std::uint32_t> rotation = codes;
          std::rotate(rotation.begin(), rotation.begin() + static_cast<std::ptrdiff_t>(i), rotation.end());
          EXPECT_LT(codes, rotation);
        }
        found.push_back(codes);
        return Search::go_on;
      });
    }
    std::sort(found.begin(), found.end());
    EXPECT_EQ(std::adjacent_find(found.begin(), found.end()), found.end()) << name;
  }
}

/// The sequence of every geodesic of a list is among those reported, and is that of no other.
TEST(CrossingSearch, ReportsTheSequencesOfTheList) {
  for (const std::string& name : kLists) {
    const GeodesicsDocument document = load(name);
    const SearchOfList list(document);
    ASSERT_TRUE(list.search);
    std::vector<std::vector<std::uint32_t>> found;
    for (std::size_t part = 0; part < list.search->size(); ++part) {
      (void)list.search->run(part, 1'000'000, [&](const std::vector<std::uint32_t>& codes) {
        found.push_back(least_sequence(codes).root);
        return Search::go_on;
      });
    }
    std::sort(found.begin(), found.end());
    std::vector<LeastSequence> sequences;
    const auto firsts = first_darts(document.net);
    for (std::uint32_t i = 0; i < document.geodesics.size(); ++i) {
      const BallIsometry element = list.lifted.element(i);
      const auto crossings = axis_crossings(list.moved, firsts[document.geodesics[i].vertex], element);
      ASSERT_TRUE(crossings) << name << ", geodesic " << i;
      const BallIsometry across = element_across(list.lifted.plane(), crossings->darts);
      EXPECT_EQ(crosses(list.moved, across, crossings->darts), Tri::yes);
      EXPECT_TRUE(arb_overlaps(cosh_half_length(across).get(), cosh_half_length(element).get()));
      EXPECT_EQ(find_meetings(list.lifted.plane(), {&*crossings, 1})[0].itself,
                document.geodesics[i].simple ? Tri::no : Tri::yes);
      std::vector<std::uint32_t> codes;
      for (const std::uint32_t dart : crossings->darts) codes.push_back(list.order->code(dart));
      sequences.push_back(least_sequence(codes));
      EXPECT_EQ(sequences.back().exponent, 1U);
      // With no edges inside a collar, ways around its core are given up for their number.
      if (document.geodesics[i].length.upper < 1) continue;
      EXPECT_TRUE(std::binary_search(found.begin(), found.end(), sequences.back().root)) << name << ", geodesic " << i;
    }
    const SequenceTable table(sequences);
    for (std::uint32_t i = 0; i < sequences.size(); ++i) {
      EXPECT_TRUE(table.contains(sequences[i].root));
      EXPECT_FALSE(table.find_other(i));
    }
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
  EXPECT_FALSE(lengths_found(document, 192, 10));
  const SearchOfList list(document);
  ASSERT_TRUE(list.search);
  int reports = 0;
  const auto stop = [&](const std::vector<std::uint32_t>&) {
    ++reports;
    return Search::stop;
  };
  std::size_t part = 0;
  SearchOutcome stopped;
  for (; reports == 0 && part < list.search->size(); ++part) stopped = list.search->run(part, 1'000'000, stop);
  EXPECT_EQ(reports, 1);
  EXPECT_FALSE(stopped.complete);
  EXPECT_FALSE(stopped.limit_reached);
  const SearchOutcome limited = list.search->run(part - 1, 5, stop);
  EXPECT_TRUE(limited.limit_reached);
  EXPECT_FALSE(limited.complete);
  EXPECT_EQ(limited.visits, 6U);
}

/// Those of which the ends are moved by the loop's element by less than a point on the border of its collar: of that
/// the distance w from the axis has cosh w = coth(l/2), and sinh(d/2) = sinh(l/2) cosh w.
TEST(EdgesInCollars, HaveBothEndsInTheCollarOfTheLoop) {
  int in = 0;
  int out = 0;
  for (const char* name : {"three-cuffs", "three-cuffs-and-one-vertex", "two-cuffs-that-differ-by-1e-14",
                           "one-cuff-of-1e-3-to-6.5", "systole-far-from-the-only-vertex", "octagon-5-to-6"}) {
    const GeodesicsDocument document = load(name);
    const LiftedNet lifted(document.net);
    const MovedNet moved(lifted.plane());
    ASSERT_TRUE(moved.valid()) << name;
    const NetDocument& net = lifted.net();
    const Reference reference(net);
    for (std::uint32_t loop = 0; loop < 3 * net.triangles.size(); ++loop) {
      if (start(net, loop) != start(net, next_dart(loop))) continue;
      const Move element = with_sign(reference.element(loop));
      const Real cosh_half = element.first.real();
      const auto edges = edges_in_collar(moved, loop);
      ASSERT_TRUE(edges) << name;
      std::uint32_t dart = loop;
      do {
        const Move& to_triangle = reference.label(corner_label(net, dart));
        const Move here = to_triangle * element * inverted(to_triangle);
        Real most = 0;
        for (const std::uint32_t end : {dart, next_dart(dart)}) {
          const Complex z = point_of(middle(moved.corner(end)));
          most = std::max(most, squared_half_sinh(z, image(here, z)) / (cosh_half * cosh_half));
        }
        const bool is_in = std::find(edges->begin(), edges->end(), dart) != edges->end();
        if (cosh_half * cosh_half >= 2 || most > 1 + 1e-6L) {
          EXPECT_FALSE(is_in) << name << ", loop " << loop << ", dart " << dart;
          ++out;
        } else if (most < 1 - 1e-6L) {
          EXPECT_TRUE(is_in) << name << ", loop " << loop << ", dart " << dart;
          ++in;
        }
        dart = next_dart(opposite(net, dart));
      } while (dart != loop);
    }
  }
  EXPECT_GT(in, 20);
  EXPECT_GT(out, 20);
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
}  // namespace epsnet::certify::crossing_search_test
