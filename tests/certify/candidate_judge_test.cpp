#include "certify/claims/geodesics/candidate_judge.h"

#include <gtest/gtest.h>

#include "certify/claims/geodesics/completeness_check.h"
#include "certify/net/surface_sides.h"
#include "tests/certify/lifted_reference.h"

/// What is said of single elements, however well they are known: what is true of them, or nothing.
namespace epsnet::certify {
namespace {

using Claim = GeodesicsDocument::Claim;

GeodesicsDocument load(const std::string& name) {
  return read_file<GeodesicsDocument>(std::string(EPSNET_TEST_DATA) + "/geodesics/" + name);
}

/// Two curves of lengths that agree to 14 digits, and a third one.
GeodesicsDocument cuffs() { return load("two-cuffs-that-differ-by-1e-14.json"); }

/// A list of the geodesics with these numbers, of which all are known as further words.
class Judged {
 public:
  Judged(GeodesicsDocument document, const std::vector<std::size_t>& listed, Claim claim, const std::string& up_to = "",
         slong precision = 128)
      : all_(document.geodesics),
        document_(list(std::move(document), listed, claim, up_to)),
        lifted_(document_.net, words(listed), precision) {
    const auto firsts = first_darts(lifted_.net());
    std::vector<ChordTable::Member> members;
    for (std::size_t i = 0; i < listed.size(); ++i) {
      members.push_back({firsts[all_[listed[i]].vertex], lifted_.element(i)});
    }
    table_.emplace(lifted_.plane(), std::move(members), 1);
    const CompletenessCheck check(document_, lifted_.evaluator(), {});
    cosh_half_ = check.cosh_half_bound(lifted_.plane());
    judge_.emplace(document_, lifted_.evaluator(), lifted_.plane(), *table_, cosh_half_);
  }
  Judged(const Judged&) = delete;
  Judged& operator=(const Judged&) = delete;

  [[nodiscard]] const LiftedNet& lifted() const { return lifted_; }

  /// Of geodesic i of all, or of another element that is said to be its word.
  [[nodiscard]] Tri operator()(std::size_t i, const BallIsometry& element) const {
    return judge_->judge(all_[i].vertex, element, product(i), nullptr).in_order;
  }
  /// The element of geodesic i of all.
  [[nodiscard]] BallIsometry element(std::size_t i) const { return lifted_.element(place_[i]); }

 private:
  static GeodesicsDocument list(GeodesicsDocument document, const std::vector<std::size_t>& listed, Claim claim,
                                const std::string& up_to) {
    const auto all = document.geodesics;
    document.geodesics.clear();
    for (const std::size_t i : listed) document.geodesics.push_back(all[i]);
    document.claim = claim;
    document.up_to = up_to;
    return document;
  }

  /// Those of the list come first.
  std::vector<GeodesicsDocument::ClosedGeodesic> words(const std::vector<std::size_t>& listed) {
    std::vector<std::size_t> order = listed;
    for (std::size_t i = 0; i < all_.size(); ++i) {
      if (std::find(listed.begin(), listed.end(), i) == listed.end()) order.push_back(i);
    }
    std::vector<GeodesicsDocument::ClosedGeodesic> result;
    place_.resize(all_.size());
    for (const std::size_t i : order) {
      place_[i] = result.size();
      result.push_back(all_[i]);
    }
    return result;
  }

  [[nodiscard]] LabelProduct product(std::size_t i) const {
    return [number = lifted_.element_number(place_[i])] { return std::vector<SignedLabel>{{number, true}}; };
  }

  std::vector<GeodesicsDocument::ClosedGeodesic> all_;
  std::vector<std::size_t> place_;
  GeodesicsDocument document_;
  LiftedNet lifted_;
  std::optional<ChordTable> table_;
  Ball cosh_half_;
  std::optional<CandidateJudge> judge_;
};

/// The bits with which every question of these tests is decided.
constexpr int kEnough = 40;

/// Requires: `expected` is true of the element. It is judged so with `kEnough` bits or more. With fewer bits, and
/// wherever it is in its ball, it is judged so or left open; with balls of radius 16, which contain 0, it is left open.
void expect_judged(const Judged& judged, std::size_t i, const BallIsometry& element, Tri expected,
                   const std::string& what) {
  std::mt19937 random(1);
  for (int trial = 0; trial < 200; ++trial) {
    const Tri found = judged(i, blurred_somehow(element, trial % 64, random));
    EXPECT_TRUE(found == expected || found == Tri::unknown) << what << ", trial " << trial;
  }
  EXPECT_EQ(judged(i, blurred(element, -4)), Tri::unknown) << what;
  for (int bits = 0; bits < kEnough; ++bits) {
    const Tri found = judged(i, blurred(element, bits));
    EXPECT_TRUE(found == expected || found == Tri::unknown) << what << ", " << bits << " bits";
  }
  for (int bits = kEnough; bits < 64; ++bits) {
    EXPECT_EQ(judged(i, blurred(element, bits)), expected) << what << ", " << bits << " bits";
  }
}

TEST(CandidateJudge, MissesNoGeodesicOfASpectrumHoweverWellItIsKnown) {
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string name = "geodesic " + std::to_string(i);
    const std::vector<std::size_t> others{(i + 1) % 3, (i + 2) % 3};
    for (const auto& [claim, up_to] : {std::pair{Claim::spectrum, "1.7"}, {Claim::thick_thin, ""}}) {
      const Judged whole(cuffs(), {0, 1, 2}, claim, up_to);
      const Judged lacking(cuffs(), others, claim, up_to);
      expect_judged(whole, i, whole.element(i), Tri::yes, name + ", listed");
      expect_judged(lacking, i, lacking.element(i), Tri::no, name + ", missing");
    }
  }
}

TEST(CandidateJudge, TellsWhatIsNoGeodesicOfTheListFromWhatIsHoweverWellItIsKnown) {
  const Judged judged(cuffs(), {0, 1}, Claim::spectrum, "1.2");
  const BallIsometry one = identity_isometry();
  expect_judged(judged, 0, one, Tri::yes, "the identity");
  BallIsometry lengthy = judged.element(0);
  for (int i = 0; i < 3; ++i) lengthy = compose(lengthy, lengthy, 128);
  choose_sign(lengthy);
  expect_judged(judged, 0, lengthy, Tri::yes, "an eighth power");
}

TEST(CandidateJudge, ComparesWithASystoleExactly) {
  const Judged right(cuffs(), {0}, Claim::systole);
  const Judged wrong(cuffs(), {1}, Claim::systole);
  // A tie, which balls never tell; a longer one; and one that is shorter by 1e-14.
  expect_judged(right, 0, right.element(0), Tri::yes, "the systole itself");
  expect_judged(right, 1, right.element(1), Tri::yes, "the next one");
  expect_judged(wrong, 0, wrong.element(0), Tri::no, "a shorter one");
  expect_judged(right, 0, identity_isometry(), Tri::yes, "the identity");
  // With 34 bits balls tell nothing, and exact numbers are asked; with 20 they are not.
  EXPECT_EQ(wrong(0, blurred(wrong.element(0), 34)), Tri::no);
  EXPECT_EQ(right(1, blurred(right.element(1), 34)), Tri::yes);
  EXPECT_EQ(wrong(0, blurred(wrong.element(0), 20)), Tri::unknown);
  EXPECT_EQ(right(1, blurred(right.element(1), 20)), Tri::unknown);
}

TEST(CandidateJudge, ComparesWith2Arsinh1Exactly) {
  const GeodesicsDocument exactly = load("one-curve-of-2-arsinh-1.json");
  const Judged listed(exactly, {0}, Claim::thick_thin);
  const Judged missing(exactly, {}, Claim::thick_thin);
  expect_judged(listed, 0, listed.element(0), Tri::yes, "listed");
  expect_judged(missing, 0, missing.element(0), Tri::no, "missing");
  EXPECT_EQ(missing(0, blurred(missing.element(0), 34)), Tri::no);
  EXPECT_EQ(missing(0, blurred(missing.element(0), 20)), Tri::unknown);
  for (int bits = 0; bits < 60; ++bits) {
    // Of a known length, somewhere.
    BallIsometry f = listed.element(0);
    for (arb_ptr x : {f.a.im(), f.b.re(), f.b.im()}) arb_add_error_2exp_si(x, -bits);
    EXPECT_NE(listed(0, f), Tri::no) << bits;
  }
  GeodesicsDocument more = load("no-curve-of-2-arsinh-1-and-1e-20-more.json");
  more.geodesics = exactly.geodesics;
  const Judged longer(more, {}, Claim::thick_thin);
  expect_judged(longer, 0, longer.element(0), Tri::yes, "longer by 1e-20");
  EXPECT_EQ(longer(0, blurred(longer.element(0), 34)), Tri::yes) << "exactly";
  // Of a spectrum balls alone are asked: no length is an `up_to`.
  const Judged spectrum(exactly, {}, Claim::spectrum, "1.76274717403908605");
  EXPECT_EQ(spectrum(0, blurred(spectrum.element(0), 34)), Tri::unknown);
}

TEST(CandidateJudge, LeavesOpenWhatIsTooLongForExactNumbers) {
  // Around another curve many times, and back at the end: of the same length, too long a word for exact numbers.
  const auto lengthened = [](GeodesicsDocument document, std::uint32_t side) {
    const std::uint32_t back = SurfaceSides(document.net.surface).partner[side];
    std::vector<std::uint32_t>& word = document.geodesics[0].word;
    word.insert(word.begin(), 100'000, side);
    word.insert(word.end(), 100'000, back);
    return document;
  };
  GeodesicsDocument more = load("no-curve-of-2-arsinh-1-and-1e-20-more.json");
  more.geodesics = load("one-curve-of-2-arsinh-1.json").geodesics;
  const Judged exact(more, {}, Claim::thick_thin);
  const Judged lengthy(lengthened(more, 1), {}, Claim::thick_thin);
  const BallIsometry known_little = blurred(exact.element(0), 34);
  ASSERT_EQ(exact(0, known_little), Tri::yes);
  EXPECT_EQ(lengthy(0, known_little), Tri::unknown);

  const Judged systole(cuffs(), {1}, Claim::systole);
  const Judged asked_of_a_long_word(lengthened(cuffs(), 2), {1}, Claim::systole);
  const BallIsometry element = blurred(systole.element(0), 34);
  ASSERT_EQ(systole(0, element), Tri::no);
  EXPECT_EQ(asked_of_a_long_word(0, element), Tri::unknown);
}

TEST(CandidateJudge, LeavesOutOneOfTwoInverseElementsForCertain) {
  const Judged judged(cuffs(), {0, 1, 2}, Claim::thick_thin);
  int left_out = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const BallIsometry f = judged.element(i);
    const BallIsometry g = inverse(f);
    EXPECT_NE(CandidateJudge::inverse_will_do(f), CandidateJudge::inverse_will_do(g));
    left_out += CandidateJudge::inverse_will_do(f) ? 1 : 0;
    left_out += CandidateJudge::inverse_will_do(g) ? 1 : 0;
    for (BallIsometry x : {f, g}) {
      // Where the sign of a is open, so is which of the two it is.
      mag_set_d(arb_radref(x.a.re()), 100);
      EXPECT_FALSE(CandidateJudge::inverse_will_do(x));
    }
    for (BallIsometry x : {f, g}) {
      mag_set_d(arb_radref(x.b.im()), 100);
      EXPECT_FALSE(CandidateJudge::inverse_will_do(x));
    }
  }
  EXPECT_EQ(left_out, 3);
}

}  // namespace
}  // namespace epsnet::certify
