#include "backend/text/number.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <random>
#include <string>

#include <gtest/gtest.h>

namespace arelem::backend {
namespace {

std::string fixed(double value, int decimals = shortest) {
  char text[numberRoom];
  return {text, writeFixed(text, value, decimals)};
}

std::string parameter(double value, int decimals = shortest) {
  char text[numberRoom];
  return {text, writeParameter(text, value, decimals)};
}

TEST(Number, ShortestFixedNotation) {
  EXPECT_EQ(fixed(0.0), "0.0");
  EXPECT_EQ(fixed(-0.0), "0.0");
  EXPECT_EQ(fixed(10.0), "10.0");
  EXPECT_EQ(fixed(-2.5), "-2.5");
  EXPECT_EQ(fixed(0.1 + 0.2), "0.30000000000000004");
  EXPECT_EQ(fixed(1e-7), "0.0000001");
  EXPECT_EQ(fixed(999999.9995), "999999.9995");
  EXPECT_EQ(fixed(1e15), "1000000000000000.0");
}

TEST(Number, ResiduesOfRoundingAreZero) {
  EXPECT_EQ(fixed(1e-16), "0.0");
  EXPECT_EQ(fixed(-4.9e-324), "0.0");
  EXPECT_EQ(parameter(-1e-300), "0");
}

TEST(Number, FixedDecimals) {
  EXPECT_EQ(fixed(999999.9995, 3), "1000000.000");
  EXPECT_EQ(fixed(0.0004, 3), "0.000");
  EXPECT_EQ(fixed(-0.0004, 3), "0.000");
  EXPECT_EQ(fixed(-0.0006, 3), "-0.001");
  EXPECT_EQ(fixed(-1.5, 6), "-1.500000");
  EXPECT_EQ(fixed(123456789012.25, 6), "123456789012.250000");
  EXPECT_EQ(fixed(0.05, 1), "0.1");    // 0.05 is a little more than 5/100 as a double
  EXPECT_EQ(fixed(0.125, 2), "0.12");  // a tie goes to the even digit
}

TEST(Number, ParametersOfPostWordsHaveNoPointWhenWhole) {
  EXPECT_EQ(parameter(1000.0), "1000");
  EXPECT_EQ(parameter(12.75), "12.75");
  EXPECT_EQ(parameter(-3.0), "-3");
  EXPECT_EQ(parameter(2.0, 6), "2");
  EXPECT_EQ(parameter(2.5, 6), "2.500000");
}

TEST(Number, EveryNumberReadsBack) {
  std::mt19937_64 random(20240607);
  std::uniform_real_distribution<double> mantissa(-1.0, 1.0);
  std::uniform_int_distribution<int> exponent(-30, 49);
  for (int i = 0; i < 200000; ++i) {
    const double value = std::ldexp(mantissa(random), exponent(random));
    const std::string text = fixed(value);
    EXPECT_EQ(std::strtod(text.c_str(), nullptr), value) << text;
    EXPECT_EQ(text.find_first_of("eE+"), std::string::npos) << text;
  }
}

TEST(Number, FixedDecimalsAgreeWithTheCLibrary) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> mantissa(-1.0, 1.0);
  std::uniform_int_distribution<int> exponent(-20, 40);
  std::uniform_int_distribution<int> decimals(1, 12);
  for (int i = 0; i < 200000; ++i) {
    const double value = std::ldexp(mantissa(random), exponent(random));
    const int digits = decimals(random);
    char expected[400];
    std::snprintf(expected, sizeof expected, "%.*f", digits, value);
    const bool negativeZero = expected[0] == '-' && std::strtod(expected, nullptr) == 0.0;
    EXPECT_EQ(fixed(value, digits), expected + (negativeZero ? 1 : 0)) << digits;
  }
}

TEST(Number, WhatTextCannotHold) {
  EXPECT_FALSE(isWritable(std::numeric_limits<double>::infinity()));
  EXPECT_FALSE(isWritable(std::numeric_limits<double>::quiet_NaN()));
  EXPECT_FALSE(isWritable(1e300));
  EXPECT_TRUE(isWritable(-1e15));
}

TEST(Number, JsonNumbers) {
  std::string text;
  for (const double value : {4.0, -0.0, 1e-5, 1e22, 0.1, std::numeric_limits<double>::infinity()}) {
    appendJsonNumber(text, value);
    text += ' ';
  }
  EXPECT_EQ(text, "4.0 0.0 1e-05 1e+22 0.1 null ");
}

}  // namespace
}  // namespace arelem::backend
