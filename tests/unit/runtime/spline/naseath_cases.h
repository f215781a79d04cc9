#pragma once
// The cases of tests/data/golden/cases_naseath.json.
#include <fstream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "runtime/spline/fit.h"

namespace arelem::spline {

inline nlohmann::json naseathCase(const std::string& id) {
  std::ifstream file(ARELEM_SOURCE_DIR "/tests/data/golden/cases_naseath.json");
  for (const nlohmann::json& one : nlohmann::json::parse(file)) {
    if (one["id"] == id) {
      return one;
    }
  }
  throw std::runtime_error("no case " + id);
}

inline std::vector<Vec3> pointsOf(const nlohmann::json& list) {
  std::vector<Vec3> points;
  for (const auto& p : list) {
    points.emplace_back(p[0].get<double>(), p[1].get<double>(), 0.0);
  }
  return points;
}

/// Test case 5 (a line with two noisy points) or 6 (a square wave): the spline through its data.
inline CubicSpline naseathSpline(int which) {
  const nlohmann::json expected =
      naseathCase("NAS-c" + std::to_string(which) + "-spline")["expected"];
  return *interpolate(pointsOf(expected["data"]), false);
}

}  // namespace arelem::spline
