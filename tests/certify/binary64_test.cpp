#include <cfenv>
#include <filesystem>
#include <functional>
#include <gtest/gtest.h>
#include <optional>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "certify/base/interval.h"
#ifdef __SSE2__
#include <xmmintrin.h>
#endif

#include "certify/check.h"
#include "certify/file/file.h"
#include "certify/net/filter.h"

/// However the caller's floating-point environment is set, files are read and checked as in the default one.
namespace epsnet::certify::binary64_test {
namespace {

/// A floating-point environment that is not the default one, until the end.
class Environment {
 public:
  Environment(const char* name, const std::function<void()>& set) : name_(name), set_(set) {}
  [[nodiscard]] const char* name() const { return name_; }
  /// body() in this environment, on this thread.
  template <class Body>
  auto run(const Body& body) const {
    struct Restored {
      Restored() { std::fegetenv(&before); }
      ~Restored() { std::fesetenv(&before); }
      std::fenv_t before{};
    } restored;
    set_();
    return body();
  }

 private:
  const char* name_;
  std::function<void()> set_;
};

std::vector<Environment> environments() {
  std::vector<Environment> result{{"upward", [] { std::fesetround(FE_UPWARD); }},
                                  {"downward", [] { std::fesetround(FE_DOWNWARD); }},
                                  {"toward zero", [] { std::fesetround(FE_TOWARDZERO); }}};
#ifdef __SSE2__
  // std::fegetround does not notice any of these.
  result.emplace_back("upward by SSE alone", [] { _MM_SET_ROUNDING_MODE(_MM_ROUND_UP); });
  result.emplace_back("results flushed to zero", [] { _mm_setcsr(_mm_getcsr() | 0x8000U); });
  result.emplace_back("operands taken for zero", [] { _mm_setcsr(_mm_getcsr() | 0x0040U); });
#endif
  return result;
}

TEST(Binary64, WhetherItIsRoundedToNearestIsAskedOfTheArithmetic) {
  EXPECT_TRUE(rounds_to_nearest());
  for (const Environment& environment : environments()) {
    EXPECT_FALSE(environment.run([] { return rounds_to_nearest(); })) << environment.name();
    EXPECT_TRUE(rounds_to_nearest());
  }
}

TEST(Binary64, ItIsRoundedToNearestForAWhileInAllThreadsThatStart) {
  for (const Environment& environment : environments()) {
    environment.run([&] {
      {
        const RoundingToNearest rounding;
        EXPECT_TRUE(rounds_to_nearest()) << environment.name();
        bool in_thread = false;
        std::thread([&] { in_thread = rounds_to_nearest(); }).join();
        EXPECT_TRUE(in_thread) << environment.name();
      }
      EXPECT_FALSE(rounds_to_nearest()) << environment.name();
    });
  }
}

std::vector<std::filesystem::path> files() {
  std::vector<std::filesystem::path> result;
  for (const char* folder : {"certify/verified", "certify/refuted", "certify/undecided", "bounds", "distances"}) {
    for (const auto& entry : std::filesystem::directory_iterator(std::string(EPSNET_TEST_DATA) + "/" + folder)) {
      result.push_back(entry.path());
    }
  }
  return result;
}

TEST(Binary64, NumbersAreReadAsTheNearestOnes) {
  for (const Environment& environment : environments()) {
    for (const auto& path : files()) {
      const ClaimDocument expected = read_file<ClaimDocument>(path);
      EXPECT_EQ(environment.run([&] { return read_file<ClaimDocument>(path); }), expected)
          << environment.name() << " " << path;
    }
  }
}

/// All that a certificate says.
std::string text(const Certificate& certificate) {
  std::ostringstream out;
  out << name(certificate.verdict) << "\n" << certificate.claim << "\n" << certificate.message << "\n";
  for (const RuleReport& report : certificate.rules) out << to_string(report) << "\n";
  out << certificate.counts.work << " " << certificate.counts.max_precision_used << " "
      << certificate.counts.triangles_beyond_64_bits << " " << certificate.ties.size() << "\n";
  const auto add = [&](const std::optional<Interval>& x) {
    out << std::hexfloat << (x ? x->lower : -1) << " " << (x ? x->upper : -1) << "\n";
  };
  if (const auto& all = certificate.enclosures) {
    for (const Interval& x : {all->epsilon, all->area, all->largest_circumradius, all->longest_edge}) add(x);
    for (const auto& x : {all->shortest_edge, all->shortest_loop, all->shortest_core}) add(x);
  }
  return out.str();
}

TEST(SlowBinary64, CertificatesAreTheSameHoweverTheCallerRounds) {
  for (const auto& path : files()) {
    const ClaimDocument document = read_file<ClaimDocument>(path);
    const std::string expected = text(check(document, {.threads = 1}));
    for (const Environment& environment : environments()) {
      for (const unsigned threads : {1U, 3U}) {
        const auto certificate = environment.run([&] { return check(document, {.threads = threads}); });
        EXPECT_EQ(text(certificate), expected) << environment.name() << " " << path;
      }
    }
  }
}

TEST(Binary64, WithoutRoundingToNearestTheFilterSettlesNothing) {
  const NetDocument document =
      read_file<NetDocument>(std::string(EPSNET_TEST_DATA) + "/certify/verified/octagon-33-vertices.json");
  const CollarMembers collars(document);
  const auto settled = [&] {
    const Filter filter(document, collars, {}, LabelTable({}, {}, document.labels.size()), {1e9, 1e9}, {1e-9, 1e-9});
    std::size_t result = 0;
    constexpr Questions kAll = 255;
    for (std::uint32_t t = 0; t < document.triangles.size(); ++t) {
      Filter::Answer answer;
      filter.answer({&t, 1}, {&kAll, 1}, {&answer, 1});
      result += answer.settled != 0 ? 1 : 0;
    }
    return result;
  };
  EXPECT_GT(settled(), 10U);
  for (const Environment& environment : environments()) EXPECT_EQ(environment.run(settled), 0U) << environment.name();
}

}  // namespace
}  // namespace epsnet::certify::binary64_test
