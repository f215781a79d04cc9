#include "ir/cl/feed.h"

#include <gtest/gtest.h>

namespace arelem::cl {
namespace {

using Per = Feed::Per;

Feed feed(std::vector<Value> parameters, double millimeters) {
  const FeedReading reading = readFeed({Word::FEDRAT, "", std::move(parameters)}, millimeters);
  EXPECT_TRUE(reading.feed) << reading.why;
  return reading.feed.value_or(Feed{});
}

std::string why(std::vector<Value> parameters) {
  const FeedReading reading = readFeed({Word::FEDRAT, "", std::move(parameters)}, 1.0);
  EXPECT_FALSE(reading.feed);
  return reading.why.substr(0, reading.why.find(':'));
}

TEST(Feed, CountsInTheUnitThatStandsWithIt) {
  const double inch = 25.4;
  EXPECT_EQ(feed({10.0}, inch).value, 254.0);
  EXPECT_EQ(feed({10.0, Word::IPM}, 1.0).value, 254.0);
  EXPECT_EQ(feed({Word::MMPM, 10.0}, inch).value, 10.0);
  EXPECT_EQ(feed({10.0, Word::MMPS}, inch).value, 600.0);
  EXPECT_EQ(feed({10.0, std::string("PERMIN")}, inch).value, 254.0);
  EXPECT_EQ(feed({0.5, std::string("PERREV")}, inch).value, 12.7);
  EXPECT_EQ(feed({0.5, std::string("PERREV")}, inch).per, Per::turn);
  EXPECT_EQ(feed({0.5, Word::IPR}, 1.0).value, 12.7);
  EXPECT_EQ(feed({4.0, Word::INVERS}, inch).value, 4.0);
  EXPECT_EQ(feed({4.0, Word::INVERS}, inch).per, Per::move);
}

TEST(Feed, IsAMinuteAlongTheMove) {
  EXPECT_EQ((Feed{100.0, Per::minute}.perMinute(5.0, 900.0)), 100.0);
  EXPECT_EQ((Feed{0.25, Per::turn}.perMinute(5.0, 900.0)), 225.0);
  EXPECT_EQ((Feed{4.0, Per::move}.perMinute(5.0, 900.0)), 20.0);
}

TEST(Feed, OtherParametersAreNoFeed) {
  EXPECT_EQ(why({}), "no number");
  EXPECT_EQ(why({Word::MMPM}), "no number");
  EXPECT_EQ(why({1.0, 2.0}), "several numbers");
  EXPECT_EQ(why({1.0, Word::IPM, Word::IPR}), "several units");
  EXPECT_EQ(why({1.0, Word::LOCK}), "`LOCK`");
}

TEST(Feed, SpindleTurnsAsItsLastNumberSays) {
  const auto behind = [](std::vector<Value> parameters) {
    return turnsBehind({Word::SPINDL, "", std::move(parameters)}, 600.0);
  };
  EXPECT_EQ(behind({-900.0}), 900.0);
  EXPECT_EQ(behind({Word::CLW}), 600.0);
  EXPECT_EQ(behind({Word::OFF}), 0.0);
  EXPECT_EQ(behind({200.0, std::string("SFM")}), 0.0);
}

}  // namespace
}  // namespace arelem::cl
