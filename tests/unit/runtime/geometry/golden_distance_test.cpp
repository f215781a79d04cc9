// Directed distances and normals: the cases of tests/data/golden/cases_galbiati.json.
#include <fstream>
#include <functional>
#include <map>
#include <numbers>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "runtime/define/tabcyl_fit.h"
#include "runtime/geometry/directed_distance.h"

namespace arelem::geometry {
namespace {

using Json = nlohmann::json;

Vec3 vec(const Json& v) {
  return {v[0].get<double>(), v[1].get<double>(), v[2].get<double>()};
}

Crossing crossingOf(const Json& in) {
  const int fiop = in.value("FIOP", 0);
  return fiop == 0 ? Crossing::nearest : fiop == 1 ? Crossing::ahead : Crossing::aheadElseNearest;
}

Cone coneOf(const Json& in) {
  return {vec(in["V"]), vec(in["T"]),
          std::cos(in["alpha_deg"].get<double>() * std::numbers::pi / 180.0)};
}

/// Coefficients a h g p b f q c r d.
Quadric quadricOf(const Json& coef) {
  const auto at = [&](int i) { return coef[static_cast<std::size_t>(i)].get<double>(); };
  return Quadric::of(
      std::vector<double>{at(0), at(4), at(7), at(9), at(5), at(2), at(1), at(3), at(6), at(8)});
}

/// The cubic over the chord of the two middle points, alone.
TabulatedCylinder middleSegment(const Json& points) {
  std::vector<define::CurveNode> nodes;
  for (const Json& p : points) {
    nodes.push_back({{p[0].get<double>(), p[1].get<double>()}, {}});
  }
  std::optional<Failure> remark;
  TabulatedCylinder surface = *define::fitCurve(nodes, define::FitMethod::fourPoint, remark);
  surface.intervals = {surface.intervals[2]};
  return surface;
}

void expectDistance(const std::optional<double>& actual, const Json& expected, double allowance) {
  ASSERT_EQ(actual.has_value(), !expected.is_null());
  if (actual) {
    EXPECT_NEAR(*actual, expected.get<double>(), allowance);
  }
}

void expectNormal(const std::optional<Vec3>& actual, const Json& expected, double allowance) {
  ASSERT_EQ(actual.has_value(), !expected.is_null());
  if (actual) {
    EXPECT_NEAR((*actual - vec(expected)).norm(), 0.0, allowance);
  }
}

using Check = std::function<void(const Json& in, const Json& out, double allowance)>;

template <class Shape>
Check distanceTo(Shape (*read)(const Json&)) {
  return [read](const Json& in, const Json& out, double allowance) {
    expectDistance(directedDistance(read(in), vec(in["P"]), vec(in["dS"]), crossingOf(in)),
                   out["dist"], allowance);
  };
}

const std::map<std::string, Check>& checks() {
  static const std::map<std::string, Check> table = {
      {"QUAD",
       [](const Json& in, const Json& out, double allowance) {
         CrossingChoice choice(crossingOf(in));
         considerQuadratic(in["A"].get<double>(), in["B"].get<double>(), in["C"].get<double>(),
                           choice);
         expectDistance(choice.result(), out["root"], allowance);
       }},
      {"DDPLAN", distanceTo<Plane>([](const Json& in) {
         return Plane{vec(in["SN"]), vec(in["SN"]).dot(vec(in["SP"]))};
       })},
      {"DDSPHR", distanceTo<Sphere>([](const Json& in) {
         return Sphere{vec(in["C"]), in["R"].get<double>()};
       })},
      {"DDCYLN", distanceTo<Cylinder>([](const Json& in) {
         return Cylinder{vec(in["V"]), vec(in["T"]), in["r0"].get<double>()};
       })},
      {"DDCON", distanceTo<Cone>(coneOf)},
      {"DDQUAD", distanceTo<Quadric>([](const Json& in) { return quadricOf(in["coef"]); })},
      {"DDTABC_SEG",
       [](const Json& in, const Json& out, double allowance) {
         const auto s = directedDistance(middleSegment(in["pts"]), vec(in["P"]), vec(in["dS"]),
                                         crossingOf(in));
         expectDistance(s, out["S"], allowance);
       }},
      {"CUBIC",
       [](const Json& in, const Json& out, double allowance) {
         const auto interval = middleSegment(in["pts"]).intervals.front();
         EXPECT_NEAR(interval.a, out["abc"][0].get<double>(), allowance);
         EXPECT_NEAR(interval.b, out["abc"][1].get<double>(), allowance);
         EXPECT_NEAR(interval.c(), out["abc"][2].get<double>(), allowance);
       }},
      {"UNPLAN",
       [](const Json& in, const Json& out, double allowance) {
         expectNormal(unitNormal(Plane{vec(in["N"]), 0.0}, Vec3::Zero()), out["n"], allowance);
       }},
      {"UNSPHR",
       [](const Json& in, const Json& out, double allowance) {
         expectNormal(unitNormal(Sphere{vec(in["C"]), 1.0}, vec(in["SP"])), out["n"], allowance);
       }},
      {"UNCYLN",
       [](const Json& in, const Json& out, double allowance) {
         expectNormal(unitNormal(Cylinder{vec(in["V"]), vec(in["T"]), 1.0}, vec(in["SP"])),
                      out["n"], allowance);
       }},
      {"UNCON",
       [](const Json& in, const Json& out, double allowance) {
         expectNormal(unitNormal(coneOf(in), vec(in["SP"])), out["n"], allowance);
       }},
      {"UNQUAD",
       [](const Json& in, const Json& out, double allowance) {
         expectNormal(unitNormal(quadricOf(in["coef"]), vec(in["SP"])), out["n"], allowance);
       }},
  };
  return table;
}

TEST(GoldenDistance, AgreesWithTheReport) {
  std::ifstream file(std::string(ARELEM_SOURCE_DIR) + "/tests/data/golden/cases_galbiati.json");
  ASSERT_TRUE(file);
  int checked = 0;
  for (const Json& row : Json::parse(file)) {
    const auto function = row["fn"].get<std::string>().substr(std::string("fn_galbiati.").size());
    const auto check = checks().find(function);
    if (check == checks().end()) {
      continue;
    }
    SCOPED_TRACE(row["id"].get<std::string>());
    check->second(row["inputs"], row["expected"], 1e-9);
    ++checked;
  }
  EXPECT_EQ(checked, 59);
}

}  // namespace
}  // namespace arelem::geometry
