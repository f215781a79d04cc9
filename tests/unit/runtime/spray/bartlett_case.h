#pragma once
#include <cmath>
#include <fstream>
#include <numbers>
#include <optional>
#include <set>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "runtime/spray/inset.h"
#include "runtime/spray/search.h"

/// One row of tests/data/golden/cases_bartlett.json as a test.
namespace arelem::spray {

using Json = nlohmann::json;

inline std::vector<Json> cases() {
  std::ifstream in(ARELEM_SOURCE_DIR "/tests/data/golden/cases_bartlett.json");
  return Json::parse(in).get<std::vector<Json>>();
}

inline double num(const Json& j, const char* key) {
  return j.at(key).get<double>();
}

inline Loop loopOf(const Json& poly) {
  Loop loop;
  for (const Json& p : poly) {
    loop.emplace_back(p[0].get<double>(), p[1].get<double>());
  }
  return loop;
}

/// A regular hexagon with a flat top.
inline Json hexagon(double flats) {
  Json poly = Json::array();
  for (int i = 0; i < 6; ++i) {
    const double angle = i * std::numbers::pi / 3.0;
    poly.push_back(
        {flats / std::sqrt(3.0) * std::cos(angle), flats / std::sqrt(3.0) * std::sin(angle)});
  }
  return poly;
}

inline Task taskOf(const Json& in) {
  Task task;
  task.outline.loops = {loopOf(in.at("poly"))};
  task.aspect = num(in, "ar");
  task.overlap = num(in, "beta");
  task.insetRatio = num(in, "inset");
  task.stop = in.at("stop") == "prog" ? StopRule::program : StopRule::strict;
  task.sharpest = HUGE_VAL;  // the source knows no limit
  if (in.contains("costs")) {
    const Json& c = in.at("costs");
    task.film = num(c, "h");
    task.limits = {num(c, "vmax"), num(c, "qmax") * literPerMinute, num(c, "eta")};
    task.prices = {num(c, "k1"), num(c, "k2"), num(c, "k3"), num(c, "k4")};
  } else {
    task.film = 0.051;
    task.limits = {1000.0, literPerMinute, 0.65};
  }
  return task;
}

/// The expected values of a row, which keep a list of what a test looked at.
class Expected {
 public:
  Expected(const Json& json, std::set<std::string>& seen) : json_(json), seen_(seen) {}
  const Json& at(const char* key) const {
    seen_.insert(key);
    return json_.at(key);
  }

 private:
  const Json& json_;
  std::set<std::string>& seen_;
};
inline double num(const Expected& expected, const char* key) {
  return expected.at(key).get<double>();
}

class BartlettCase : public testing::TestWithParam<Json> {
 protected:
  const Json& in() const { return GetParam().at("inputs"); }
  Expected expected() const { return {GetParam().at("expected"), seen_}; }
  /// Every expected value of the row was compared with something.
  void TearDown() override {
    for (const auto& [key, value] : GetParam().at("expected").items()) {
      EXPECT_TRUE(seen_.count(key) == 1) << "nothing was compared with " << key;
    }
  }
  /// How far a value may be off the published one.
  double allowed(const char* key) const {
    const Json given = GetParam().value("published_tol", Json(0.0));
    return given.is_number() ? given.get<double>() : given.value(key, given.value("default", 0.0));
  }
  void expectNumber(double actual, const char* key, double allowance = 1e-6) const {
    const double wanted = num(expected(), key);
    EXPECT_NEAR(actual, wanted, allowance * std::max(1.0, std::abs(wanted))) << key;
    const Json published = GetParam().value("published", Json::object());
    if (!published.contains(key) || !published.at(key).is_number()) {
      return;
    }
    const bool near = std::abs(actual - num(published, key)) <= allowed(key);
    EXPECT_EQ(near, GetParam().at("status") == "verified")
        << key << ": " << actual << ", published " << num(published, key);
  }
  void expectList(const std::vector<double>& actual, const char* key) const {
    ASSERT_EQ(actual.size(), expected().at(key).size()) << key;
    for (std::size_t i = 0; i < actual.size(); ++i) {
      EXPECT_NEAR(actual[i], expected().at(key)[i].get<double>(), 1e-6) << key << ' ' << i;
    }
    const Json published = GetParam().value("published", Json::object());
    if (GetParam().at("status") == "verified" && published.contains(key) &&
        published.at(key).is_array()) {
      for (std::size_t i = 0; i < actual.size(); ++i) {
        EXPECT_NEAR(actual[i], published.at(key)[i].get<double>(), allowed(key)) << key << ' ' << i;
      }
    }
  }
  void path(const Json& given) const;
  void search(const Json& given, const Range& sizes, const std::vector<double>& angles) const;
  void rejected(const Json& given) const;
  void compare(const Trial& best) const;
  void expectPlace(const Vec2& actual, const char* key) const {
    expectList({actual.x(), actual.y()}, key);
  }

 private:
  mutable std::set<std::string> seen_;
};

}  // namespace arelem::spray
