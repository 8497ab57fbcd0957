#include <array>
#include <functional>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <numeric>

#include "certify/base/error.h"
#include "certify/base/text.h"
#include "certify/claims/geodesics/sequences.h"
#include "certify/file/file.h"
#include "certify/lifted/lifted_plane.h"
#include "certify/net/lifted_triangle.h"
#include "certify/net/numbering.h"
#include "certify/net/rules.h"

/// What is not there cannot be looked up: each lookup answers what is there, and anything else is a fault of this
/// program.
namespace epsnet::certify::lookup_test {
namespace {

using testing::HasSubstr;

constexpr std::uint32_t kHuge = ~std::uint32_t{0};

/// A net with labels, and a pseudo net.
NetDocument load(const std::string& name) { return read_file<NetDocument>(std::string(EPSNET_TEST_DATA) + "/" + name); }

struct Setting {
  explicit Setting(const NetDocument& net)
      : document(net),
        parts(label_parts(check_surface(net.surface).crossings, net.charts, {})),
        evaluator(document, parts) {}
  NetDocument document;
  LabelParts parts;
  LabelEvaluator evaluator;
};

template <class Call>
void expect_fault(const Call& call, const std::string& what = "") {
  try {
    call();
    ADD_FAILURE() << "no fault: " << what;
  } catch (const Fault& fault) {
    EXPECT_THAT(fault.what(), HasSubstr("a fault of this program: " + what));
  }
}

TEST(Lookup, OfWhatIsNotThereIsAFault) {
  const std::vector<int> x{7, 8};
  EXPECT_EQ(looked_up(x, 1, "no place"), 8);
  expect_fault([&] { (void)looked_up(x, 2, "no place"); }, "no place 2");
  EXPECT_EQ(value_of(std::optional(3), "nothing"), 3);
  expect_fault([&] { (void)value_of(std::optional<int>(), "nothing"); }, "nothing");
  expect_fault([] { ensure(false, "broken"); }, "broken");
  ensure(true, "broken");
  const std::vector<std::uint32_t> increasing{2, 5, 9};
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(place_of(increasing[i], increasing), i);
  for (const std::uint32_t other : {0U, 3U, 8U, 10U, kHuge}) {
    expect_fault([&] { (void)place_of(other, increasing); }, "not in the list: number " + std::to_string(other));
  }
  EXPECT_EQ(decimal("0.1"), mpq_class(1, 10));
  expect_fault([] { (void)decimal("one"); });
}

TEST(Lookup, IncreasingNumbersAreEachThereOnce) {
  const std::vector<std::vector<std::uint32_t>> some{{9, 2}, {}, {2, 5, 5}, {9}};
  const auto all = [](const std::vector<std::uint32_t>& numbers, std::vector<std::uint32_t>& result) {
    result.insert(result.end(), numbers.begin(), numbers.end());
  };
  EXPECT_THAT(increasing(some, all), testing::ElementsAre(2U, 5U, 9U));
}

TEST(Lookup, OfADartThatIsNotThereIsAFault) {
  const NetDocument document = load("certify/verified/octagon-9-vertices.json");
  const auto darts = static_cast<std::uint32_t>(3 * document.triangles.size());
  EXPECT_EQ(opposite(document, darts - 1), document.triangles.back().opposite[2]);
  for (const std::uint32_t dart : {darts, darts + 1, darts + 2, kHuge}) {
    expect_fault([&] { (void)opposite(document, dart); }, "there is no triangle");
    expect_fault([&] { (void)start(document, dart); }, "there is no triangle");
    expect_fault([&] { (void)corner_label(document, dart); }, "there is no triangle");
  }
  expect_fault([&] { (void)chart_of_triangle(document, darts / 3); }, "there is no triangle");
}

/// A label that was not evaluated was another one in version 0.2.
TEST(Lookup, OfALabelThatWasNotEvaluatedIsAFault) {
  const Setting setting(load("certify/verified/octagon-9-vertices.json"));
  const std::size_t count = setting.document.labels.size();
  ASSERT_GT(count, 3U);
  const std::vector<std::uint32_t> numbers{2, static_cast<std::uint32_t>(count)};
  const LabelTable table(numbers, setting.evaluator.evaluate(numbers, 64, 64, 1), count);
  for (const std::uint32_t number : numbers) {
    const auto value = setting.evaluator.evaluate(std::array{number}, 64, 64, 1).front();
    EXPECT_TRUE(acb_equal(table[number].a.get(), value.a.get()) && acb_equal(table[number].b.get(), value.b.get()));
  }
  for (std::uint32_t number = 0; number < count + 3; ++number) {
    if (number == numbers[0] || number == numbers[1]) continue;
    expect_fault([&] { (void)table[number]; }, "a label was not evaluated");
  }
  expect_fault([&] { (void)table[kHuge]; });
  expect_fault([&] { LabelTable({1, 2}, std::vector<BallIsometry>(1), count); });
  expect_fault([&] { LabelTable({0}, std::vector<BallIsometry>(1), count); });
  expect_fault([&] { LabelTable({static_cast<std::uint32_t>(count) + 1}, std::vector<BallIsometry>(1), count); });
}

TEST(Lookup, OfALabelThatIsNotThereIsAFault) {
  const Setting setting(load("forgeries/collars.json"));
  const LabelEvaluator& evaluator = setting.evaluator;
  const std::size_t collars = setting.document.collars->size();
  ASSERT_GT(collars, 0U);
  // Cores have the numbers after those of labels.
  const auto last = static_cast<std::uint32_t>(setting.document.labels.size() + collars);
  EXPECT_EQ(evaluator.core_number(collars - 1), last);
  EXPECT_EQ(evaluator.evaluate(std::array{last}, 64, 64, 1).size(), 1U);
  EXPECT_GT(evaluator.exact_bits(last), 0U);
  expect_fault([&] { (void)evaluator.core_number(collars); }, "there is no collar");
  for (const std::uint32_t number : {last + 1, kHuge}) {
    expect_fault([&] { (void)evaluator.word(number); }, "there is no label");
    expect_fault([&] { (void)evaluator.exact_bits(number); }, "there is no label");
    expect_fault([&] { (void)evaluator.evaluate(std::array{number}, 64, 64, 1); }, "there is no label");
    expect_fault(
        [&] {
          std::visit([&](const auto& kind) { (void)evaluator.evaluate_exactly(kind, number); }, evaluator.crossings());
        },
        "there is no label");
  }
  expect_fault([&] { (void)evaluator.evaluate(std::array{0U}, 64, 64, 1); }, "there is no label");
}

TEST(Lookup, OfLabelsOfAnotherDocumentIsAFault) {
  Setting setting(load("certify/verified/octagon-9-vertices.json"));
  NetDocument other = setting.document;
  other.charts.push_back(other.charts[0]);
  expect_fault([&] { LabelEvaluator(other, setting.parts); }, "frames and charts");
  const NetDocument regular = load("certify/verified/regular-3-centre.json");
  setting.parts.frames.resize(regular.charts.size());
  expect_fault([&] { LabelEvaluator(regular, setting.parts); }, "crossings and sides");
}

TEST(Lookup, OfATriangleThatWasNotLoadedIsAFault) {
  const Setting setting(load("certify/verified/octagon-9-vertices.json"));
  std::vector<std::uint32_t> numbers(setting.document.labels.size());
  std::iota(numbers.begin(), numbers.end(), 1U);
  const LabelTable labels(numbers, setting.evaluator.evaluate(numbers, 64, 256, 1), numbers.size());
  Ball one;
  arb_one(one.get());
  LiftedTriangle lifted;
  const std::vector<std::function<void(std::uint32_t)>> measures{
      [&](std::uint32_t i) { (void)lifted.gap(i); },
      [&](std::uint32_t i) { (void)lifted.squared_difference(i); },
      [&](std::uint32_t i) { lifted.measure_edge(one.get(), i, 64); },
      [&](std::uint32_t i) { lifted.measure_cross_ratio(setting.document, labels, i, 64); },
  };
  for (const auto& measure : measures) expect_fault([&] { measure(0); }, "a triangle");
  expect_fault([&] { lifted.measure_orientation(64); }, "a triangle");
  expect_fault([&] { lifted.measure_circumradius(one.get(), 64); }, "a triangle");
  expect_fault(
      [&] { lifted.load(setting.document, labels, static_cast<std::uint32_t>(setting.document.triangles.size()), 64); },
      "there is no triangle");
  lifted.load(setting.document, labels, 0, 64);
  for (const auto& measure : measures) {
    measure(2);
    expect_fault([&] { measure(3); }, "a triangle");
  }
}

TEST(Lookup, OfWhatIsNotInALiftedPlaneIsAFault) {
  const Setting setting(load("certify/verified/octagon-9-vertices.json"));
  const LiftedPlane plane(setting.document, setting.evaluator, setting.parts, 64, 64, 1);
  const auto triangles = static_cast<std::uint32_t>(setting.document.triangles.size());
  const auto labels = static_cast<std::uint32_t>(setting.document.labels.size());
  (void)plane.label(labels);
  expect_fault([&] { (void)plane.label(labels + 1); }, "there is no value of label number");
  (void)plane.corner(3 * triangles - 1);
  expect_fault([&] { (void)plane.corner(3 * triangles); }, "there is no dart");
  expect_fault([&] { (void)plane.transition(3 * triangles); }, "there is no dart");
  const auto charts = static_cast<std::uint32_t>(setting.document.charts.size());
  expect_fault([&] { (void)plane.same(charts, identity_isometry(), identity_isometry()); }, "there is no chart");
  // A list of no geodesics.
  const SequenceTable table({});
  expect_fault([&] { (void)table.find_other(0); }, "there is no geodesic");
}

TEST(Lookup, OfAnIntervalWithItsEndsExchangedIsAFault) {
  IntervalIndex index;
  index.insert({1, 2}, 0);
  expect_fault([&] { index.insert({2, 1}, 1); }, "an interval");
  expect_fault([&] { (void)index.near({2, 1}); }, "an interval");
  EXPECT_THAT(index.near({1.5, 1.5}), testing::ElementsAre(0U));
}

}  // namespace
}  // namespace epsnet::certify::lookup_test
