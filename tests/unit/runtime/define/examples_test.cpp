// Curves of the old system's examples (belonging to others, read in place where ARELEM_SHARED names
// their folder).
#include <cmath>
#include <cstdlib>
#include <fstream>

#include <nlohmann/json.hpp>

#include "runtime/geometry/tabulated_cylinder.h"
#include "tests/unit/runtime/define/forms.h"

namespace arelem::define::test {
namespace {

using Json = nlohmann::json;

std::optional<Json> resultsOf(const std::string& program) {
  const char* shared = std::getenv("ARELEM_SHARED");
  std::ifstream file(std::string(shared != nullptr ? shared : ARELEM_SOURCE_DIR "/../shared") +
                     "/oracle/examples/" + program + ".json");
  return file ? std::optional<Json>(Json::parse(file)) : std::nullopt;
}

#define ARELEM_NEEDS_EXAMPLE(results)                                         \
  if (!(results)) {                                                           \
    GTEST_SKIP() << "needs the examples of other authors: set ARELEM_SHARED"; \
  }

std::vector<double> valuesOf(const Json& results, const std::string& name, int subscript = 0) {
  for (const Json& print : results["prints"]) {
    if (print["name"] == name && print["subscript"] == subscript) {
      return print["values"].get<std::vector<double>>();
    }
  }
  ADD_FAILURE() << name;
  return {};
}

/// The cutter's center stays at `radius` from the curve, within the band [0, outer] of the motion
/// and `slack` more.
void expectAlong(
    const Json& results, int isn, const Entity& curve, double radius, double outer, double slack) {
  const auto surface = geometry::TabulatedCylinder::of(curve.canon);
  int count = 0;
  for (const Json& record : results["cl"]) {
    if (record.value("isn", 0) != isn || !record.contains("points")) {
      continue;
    }
    for (const Json& p : record["points"]) {
      const double off =
          geometry::nearestOn(surface, {p[0].get<double>(), p[1].get<double>()}).distance - radius;
      EXPECT_GE(off, -slack);
      EXPECT_LE(off, outer + slack);
      ++count;
    }
  }
  EXPECT_GT(count, 50);
}

TEST(Examples, SplineOfSample2TakesThePrintedPlaces) {
  const auto results = resultsOf("sample2");
  ARELEM_NEEDS_EXAMPLE(results);
  P data{W::NOZ, W::SPLINE};
  for (int i = 1; i <= 28; ++i) {
    data.emplace_back(make(T::point, valuesOf(*results, "TP", i)));
    if (i == 1) {
      data.insert(data.end(), {W::SLOPE, 1000000.0});
    }
  }
  data.insert(data.end(), {W::SLOPE, 0.0});
  const EntityPtr curve = definedPtr(T::tabulatedCylinder, data);
  int compared = 0;
  for (const Json& print : results->at("prints")) {
    const auto v = print["values"].get<std::vector<double>>();
    if (print["name"] != "P4" || print["type"] != "POINT" || v[0] < 79.0) {
      continue;
    }
    const EntityPtr upright = definedPtr(T::line, {v[0], 0.0, v[0], 1.0});
    const Entity place = defined(T::point, {W::INTOF, upright, curve, point(v[0], v[1])});
    // Between the points the old fit, which stops its iteration early, is up to 3.2e-5 off.
    EXPECT_NEAR(place.canon[1], v[1], 4e-5) << "at x " << v[0];
    ++compared;
  }
  EXPECT_GE(compared, 10);
}

TEST(Examples, ConicOfSample2HasThePrintedCoefficients) {
  const auto results = resultsOf("sample2");
  ARELEM_NEEDS_EXAMPLE(results);
  const auto p = [&](int i) { return make(T::point, valuesOf(*results, "PNT", i)); };
  const Entity conic = defined(T::lconic, {W::W_3PT2SL, p(1), 0.0699268, p(2), 0.0, p(3)});
  expectCanon(conic.canon, valuesOf(*results, "ZDCL", 1), 1e-9);
}

TEST(Examples, LineMeetsTheSplineOfTest2) {
  const auto results = resultsOf("test2");
  ARELEM_NEEDS_EXAMPLE(results);
  const auto p = [&](const std::string& name) { return make(T::point, valuesOf(*results, name)); };
  const EntityPtr curve =
      definedPtr(T::tabulatedCylinder, {W::NOZ, W::SPLINE, p("P1"), W::SLOPE, 0.0, p("P4"), p("P3"),
                                        p("P5"), p("P2"), W::SLOPE, 100000.0});
  const Entity place =
      defined(T::point, {W::INTOF, make(T::line, valuesOf(*results, "L1")), curve, p("P4")});
  expectCanon(place.canon, valuesOf(*results, "PTEST"), 1e-5);
}

TEST(Examples, CutterFollowsTheSineCurve) {
  const auto results = resultsOf("sine");
  ARELEM_NEEDS_EXAMPLE(results);
  P data{W::NOZ, W::SPLINE};
  for (int a = 1; a <= 137; ++a) {
    data.insert(data.end(), {a / 10.0, 4.0 * std::sin(4.0 * a * std::acos(-1.0) / 180.0)});
  }
  expectAlong(*results, 68, defined(T::tabulatedCylinder, data), 0.125, 0.0005, 1e-5);
}

TEST(Examples, CutterFollowsTheFreeFormCurve) {
  const auto results = resultsOf("tabcyl");
  ARELEM_NEEDS_EXAMPLE(results);
  const Entity curve = defined(T::tabulatedCylinder,
                               {W::NOZ, W::SPLINE, 5.0, 0.0,  W::SLOPE, 0.0, 6.0,  0.2, 7.0,  0.85,
                                7.32,   1.5,       7.3, 2.3,  6.9,      3.0, 6.1,  3.5, 4.5,  4.1,
                                2.7,    4.5,       1.2, 4.85, 0.5,      5.0, -0.2, 5.3, -0.8, 5.7});
  // The old fit stops its iteration early: its curve is up to 3e-5 off the curvature-continuous
  // one.
  expectAlong(*results, 42, curve, 0.05, 0.0005, 3e-5);
}

}  // namespace
}  // namespace arelem::define::test
