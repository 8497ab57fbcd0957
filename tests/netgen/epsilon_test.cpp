#include <cmath>
#include <gtest/gtest.h>
#include <initializer_list>
#include <limits>
#include <rapidcheck/gtest.h>
#include <stdexcept>
#include <string>

#include "netgen/base/options.h"
#include "tests/support/triangulations.h"

namespace epsnet::epsilon_test {
namespace {

/// Every text is rejected with an error that quotes it.
void expect_rejected(std::initializer_list<const char*> texts) {
  for (const char* text : texts) {
    try {
      const Length epsilon{std::string(text)};
      ADD_FAILURE() << '"' << text << "\" is accepted as " << epsilon.value();
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find('"' + std::string(text) + '"'), std::string::npos) << error.what();
    }
  }
}

TEST(Epsilon, NumbersOnly) {
  expect_rejected({"",     " ",    "nan",   "NaN", "inf",   "infinity", "-inf",  "abc", "0x1p-3", "0x10",
                   "0.1 ", " 0.1", "0.1\n", "0,1", "1_000", "0.1f",     "0.1.2", ".",   "e",      "é"});
}

TEST(Epsilon, PositiveOnly) {
  expect_rejected({"0", "0.0", "0e5", "0/1", "-0", "-1", "-0.1", "-1/2", "1/-2", "00", "0.000e-3"});
}

TEST(Epsilon, ByTheGrammarOnly) {
  expect_rejected({".5",  "5.", "1.e3", "+1",    "1e",    "1e+",   "1e-",   "e5",    "1e1.5", "1e99999", "1e-10000",
                   "1/0", "1/", "/2",   "1/2/3", "1/2.5", "0.5/2", "1e2/3", "1/2e3", "1//2",  "1 / 2"});
}

TEST(Epsilon, IsTheExactNumberAndItsText) {
  const auto expect_value = [](const char* text, const char* value) {
    const Length epsilon{std::string(text)};
    EXPECT_EQ(epsilon.value(), Rational(value)) << text;
    EXPECT_EQ(epsilon.text(), text);
  };
  expect_value("0.1", "1/10");
  expect_value("0.10", "1/10");
  expect_value("00.1", "1/10");
  expect_value("1", "1");
  expect_value("010", "10");
  expect_value("2.50", "5/2");
  expect_value("1e-3", "1/1000");
  expect_value("1E-3", "1/1000");
  expect_value("12.5e+1", "125");
  expect_value("0.002e3", "2");
  expect_value("1e0000", "1");
  expect_value("09.08e-0001", "227/250");
  expect_value("1/10", "1/10");
  expect_value("2/20", "1/10");
  expect_value("010/3", "10/3");
  expect_value("123456789012345678901234567890/7", "123456789012345678901234567890/7");
}

TEST(Epsilon, ExtremeExponentsAreNumbers) {
  EXPECT_GT(Length("1e9999").value(), Rational(1000000));
  EXPECT_GT(Length("1e-9999").value(), 0);
  EXPECT_LT(Length("1e-9999").value(), Rational(1, 1000000));
}

TEST(Epsilon, LongTextsAreNumbersUpToALimit) {
  EXPECT_EQ(Length("0.1" + std::string(5000, '0')).value(), Rational(1, 10));
  EXPECT_THROW(Length("0.1" + std::string(1'000'000, '0')), std::invalid_argument);
  try {
    const Length epsilon(std::string(1'000'000, 'x'));
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_LT(std::string(error.what()).size(), 200U) << "a message is one readable line";
  }
}

TEST(Epsilon, OfADoubleIsItsShortestDecimal) {
  EXPECT_EQ(Length(0.1).value(), Rational(1, 10));
  EXPECT_EQ(Length(0.1).text(), "0.1");
  EXPECT_EQ(Length(2.0).value(), Rational(2));
  EXPECT_EQ(Length(1e-5).value(), Rational(1, 100000));
  EXPECT_GT(Length(std::numeric_limits<double>::max()).value(), Rational(1));
  EXPECT_GT(Length(std::numeric_limits<double>::denorm_min()).value(), Rational(0));
  for (const double bad : {0.0, -0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity(),
                           -std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW(Length{bad}, std::invalid_argument) << bad;
  }
}

RC_GTEST_PROP(EpsilonProperty, DoublesRoundTrip, ()) {
  const double value = std::ldexp(1 + test::any_share(), static_cast<int>(test::any_index(200u)) - 150);
  RC_ASSERT(std::stod(Length(value).text()) == value);
}

RC_GTEST_PROP(EpsilonProperty, AnyTextIsANumberOrAnInvalidArgument, ()) {
  const std::string text = *rc::gen::container<std::string>(rc::gen::elementOf(std::string("0019.eE+-/ x")));
  try {
    RC_ASSERT(Length(text).value() > 0);
  } catch (const std::invalid_argument&) {
    RC_SUCCEED("rejected");
  }
}

}  // namespace
}  // namespace epsnet::epsilon_test
