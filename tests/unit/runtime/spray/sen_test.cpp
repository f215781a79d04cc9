// The cases of tests/data/golden/cases_sen.json that speak of guns, speeds and lines; the angles
// and blocks of G97 are tested with their backend.
#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "runtime/spray/calibration.h"
#include "runtime/spray/gun.h"
#include "runtime/spray/lines.h"
#include "runtime/spray/overlap.h"

namespace arelem::spray {
namespace {

using Json = nlohmann::json;
constexpr double degree = std::numbers::pi / 180.0;

Calibration binks() {
  std::ifstream in(ARELEM_SOURCE_DIR "/stdlib/guns/binks.toml");
  std::ostringstream text;
  text << in.rdbuf();
  Result<Calibration> gun = readCalibration(text.str(), "binks");
  if (!gun) {
    ADD_FAILURE() << gun.failure().message;
    return {};
  }
  return *gun;
}

std::vector<Json> cases() {
  std::ifstream in(ARELEM_SOURCE_DIR "/tests/data/golden/cases_sen.json");
  std::vector<Json> list;
  for (Json& one : Json::parse(in).get<std::vector<Json>>()) {
    const std::string function = one.value("fn", "");
    const bool angles = function == "fn_sen.pqr" || function == "fn_sen.axis_from_pqr" ||
                        function == "fn_sen.block" || function == "fn_sen.gun_pos";
    if (one.at("status") != "not reproducible" && !angles) {
      list.push_back(std::move(one));
    }
  }
  return list;
}

/// Straight line through points of equal weight: slope and intercept.
std::pair<double, double> fitted(const std::vector<double>& x, const std::vector<double>& y) {
  double sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0;
  const auto n = static_cast<double>(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    sx += x[i];
    sy += y[i];
    sxx += x[i] * x[i];
    sxy += x[i] * y[i];
  }
  const double slope = (n * sxy - sx * sy) / (n * sxx - sx * sx);
  return {slope, (sy - slope * sx) / n};
}

class SenCase : public testing::TestWithParam<Json> {
 protected:
  double in(const char* key, double otherwise = NAN) const {
    return GetParam().at("inputs").value(key, otherwise);
  }
  void expectNumber(double actual, const char* key) const {
    const double wanted = GetParam().at("expected").at(key).get<double>();
    EXPECT_NEAR(actual, wanted, 1e-6 * std::max(1.0, std::abs(wanted))) << key;
    const Json published = GetParam().value("published", Json::object());
    if (published.contains(key) && published.at(key).is_number()) {
      const Json tolerance = GetParam().at("published_tol");
      const double allowed =
          tolerance.is_number() ? tolerance.get<double>() : tolerance.value(key, 0.0);
      const bool near = std::abs(actual - published.at(key).get<double>()) <= allowed;
      EXPECT_EQ(near, GetParam().at("status") == "verified") << key << ' ' << actual;
    }
  }
  void dialog() const;
  void lines() const;
};

double onLine(const std::vector<double>& x, const std::vector<double>& y, double at) {
  const auto [slope, intercept] = fitted(x, y);
  return slope * at + intercept;
}

/// A table by straight lines instead of interpolation: over the valve at each pressure ("lines"),
/// over the pressure at each valve position ("pressure-lines"), or over both.
double byLines(const Grid& grid, const std::string& model, double pressure, double valve) {
  if (model == "pressure-lines") {
    std::vector<double> values;
    for (const std::vector<double>& row : grid.values) {
      values.push_back(onLine(grid.pressures, row, pressure));
    }
    const auto above = std::lower_bound(grid.valves.begin() + 1, grid.valves.end() - 1, valve);
    const auto i = static_cast<std::size_t>(above - grid.valves.begin());
    const double share = (valve - grid.valves[i - 1]) / (grid.valves[i] - grid.valves[i - 1]);
    return values[i - 1] + share * (values[i] - values[i - 1]);
  }
  std::vector<double> slopes, intercepts;
  for (std::size_t i = 0; i < grid.pressures.size(); ++i) {
    std::vector<double> column;
    for (const std::vector<double>& row : grid.values) {
      column.push_back(row[i]);
    }
    const auto [slope, intercept] = fitted(grid.valves, column);
    if (model == "lines" && grid.pressures[i] == pressure) {
      return slope * valve + intercept;
    }
    slopes.push_back(slope);
    intercepts.push_back(intercept);
  }
  return onLine(grid.pressures, slopes, pressure) * valve +
         onLine(grid.pressures, intercepts, pressure);
}

/// What the source's dialog shows, from the tables: interpolated, as we do, or by straight lines.
/// None of them gives the printed numbers.
void SenCase::dialog() const {
  const Calibration gun = binks();
  const std::string model = GetParam().at("inputs").at("model");
  const double pressure = in("pressure");
  const double valve = in("valve");
  Setting setting = *settingOf(gun, pressure, valve);
  if (model != "table") {
    setting.flow = byLines(gun.flow, model, pressure, valve) * milliliterPerMinute;
    setting.halfAngle =
        std::atan(byLines(gun.diameter, model, pressure, valve) / 2.0 / gun.distance);
  }
  const double flow = setting.flow / milliliterPerMinute;
  const double radius = coneRadius(in("distance"), setting.halfAngle);
  const double speed =
      speedFor(setting.flow, in("ratio") / 100.0, in("thickness_um") / 1000.0, radius);
  const Json& printed = GetParam().at("published");
  bool allPrinted = true;
  for (const auto& [key, value] : {std::pair{"flow", flow},
                                   {"half_angle", setting.halfAngle / degree},
                                   {"radius", radius},
                                   {"v", speed}}) {
    EXPECT_NEAR(value, GetParam().at("expected").at(key).get<double>(), 1e-6 * value) << key;
    allPrinted = allPrinted && std::abs(value - printed.at(key).get<double>()) < 0.006;
  }
  EXPECT_EQ(allPrinted, GetParam().at("status") == "verified");
}

void SenCase::lines() const {
  const std::string kind = GetParam().at("inputs").at("kind");
  const double size = in("size");
  const double length = kind == "planar" ? size : std::numbers::pi * size;
  const LineCount count = lineCount(length, in("r"));
  expectNumber(count.intervals, "intervals");
  expectNumber(count.lines(), "lines");
  expectNumber(count.step, "step");
  if (GetParam().at("expected").contains("step_deg")) {
    expectNumber(180.0 / count.intervals, "step_deg");
  }
}

TEST_P(SenCase, GivesTheNumbers) {
  const std::string function = GetParam().at("fn");
  if (function == "fn_sen.thickness") {
    expectNumber(spotFilm(in("mu"), in("sigma"), in("t"), in("r")), "delta");
  } else if (function == "fn_sen.mean_ratio") {
    // Mean of a semi-ellipse: its density is 1/2 on average and 2/pi in the middle.
    expectNumber(0.5 / Profile::ellipse().density(0.0), "ratio");
  } else if (function == "fn_sen.velocity") {
    expectNumber(speedFor(in("flow_ml_min") * milliliterPerMinute, in("sigma"), in("delta_mm"),
                          in("r_mm") * in("step_over_r", 1.0)),
                 "v");
  } else if (function == "fn_sen.radius") {
    expectNumber(coneRadius(in("d"), in("half_angle_deg") * degree), "r");
  } else if (function == "fn_sen.from_published") {
    const double radius = coneRadius(in("distance"), in("half_angle_deg") * degree);
    expectNumber(radius, "radius");
    expectNumber(speedFor(in("flow") * milliliterPerMinute, in("ratio") / 100.0,
                          in("thickness_um") / 1000.0, radius),
                 "v");
  } else if (function == "fn_sen.dialog") {
    dialog();
  } else if (function == "fn_sen.per_pressure_fit") {
    const Calibration gun = binks();
    for (const auto& [key, grid] : {std::pair{"flow", &gun.flow}, {"diam", &gun.diameter}}) {
      for (std::size_t i = 0; i < grid->pressures.size(); ++i) {
        std::vector<double> column;
        for (const std::vector<double>& row : grid->values) {
          column.push_back(row[i]);
        }
        const auto [slope, intercept] = fitted(grid->valves, column);
        EXPECT_NEAR(slope, GetParam().at("expected").at(key)[i][0].get<double>(), 1e-9);
        EXPECT_NEAR(intercept, GetParam().at("expected").at(key)[i][1].get<double>(), 1e-9);
      }
    }
  } else if (function == "fn_sen.half_angle") {
    expectNumber(settingOf(binks(), 110.0, 0.0)->halfAngle / degree, "angle");
  } else if (function == "fn_sen.step_range") {
    const double length = in("L");
    const double low = GetParam().at("expected").at("r_min_incl").get<double>();
    const double high = GetParam().at("expected").at("r_max_excl").get<double>();
    expectNumber(lineCount(length, low).intervals, "intervals");
    expectNumber(lineCount(length, high - 1e-9).intervals, "intervals");
    EXPECT_EQ(lineCount(length, high).intervals, 16);
  } else if (function == "fn_sen.lines") {
    lines();
  } else {
    FAIL() << "no test for " << function;
  }
}

INSTANTIATE_TEST_SUITE_P(Golden, SenCase, testing::ValuesIn(cases()), [](const auto& one) {
  std::string name = one.param.at("id");
  for (char& c : name) {
    c = std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
  }
  return name;
});

TEST(Calibrated, OutsideOfWhatWasMeasuredIsAnError) {
  const Calibration gun = binks();
  EXPECT_TRUE(settingOf(gun, 152.0, 54.0).ok());
  for (const auto& [pressure, valve] :
       {std::pair{109.9, 0.0}, {152.1, 0.0}, {120.0, -7.0}, {120.0, 55.0}}) {
    const Result<Setting> setting = settingOf(gun, pressure, valve);
    ASSERT_FALSE(setting.ok());
    EXPECT_EQ(setting.failure().row->code, "E0354");
  }
}

TEST(Calibrated, FilesWithErrorsAreRefused) {
  const std::string flow = "[flow]\npressures=[1,2]\nvalves=[0,1]\nvalues=[[1,2],[3,4]]\n";
  const std::string diameter =
      "[diameter]\ndistance=200\npressures=[1,2]\nvalves=[0,1]\nvalues=[[1,2],[3,4]]\n";
  EXPECT_TRUE(readCalibration(flow + diameter, "x").ok());
  for (const std::string& text :
       {flow, diameter, flow + "[diameter]\n", std::string("[flow\n"),
        "[flow]\npressures=[2,1]\nvalves=[0,1]\nvalues=[[1,2],[3,4]]\n" + diameter,
        "[flow]\npressures=[1,2]\nvalves=[0,1]\nvalues=[[1,2]]\n" + diameter,
        "[flow]\npressures=[1,2]\nvalves=[0,1]\nvalues=[[1,2],[3,-4]]\n" + diameter,
        "[flow]\npressures=[1,'a']\nvalves=[0,1]\nvalues=[[1,2],[3,4]]\n" + diameter}) {
    const Result<Calibration> gun = readCalibration(text, "x");
    ASSERT_FALSE(gun.ok()) << text;
    EXPECT_EQ(gun.failure().row->code, "E0355");
  }
}

TEST(Profiles, AreasAndSharesAgree) {
  const std::vector<std::pair<double, double>> points = {{-3, 0}, {-1, 2}, {2, 5}, {3, 1}};
  const auto table = Profile::table(points);
  ASSERT_TRUE(table.ok());
  EXPECT_DOUBLE_EQ(table->halfWidth, 3.0);
  for (const Profile& profile : {Profile::ellipse(), Profile::flat(), table->profile}) {
    double sum = 0.0;
    constexpr int n = 20000;
    for (int i = 0; i < n; ++i) {
      const double u = -1.0 + (2.0 * i + 1.0) / n;
      sum += profile.density(u) * 2.0 / n;
      if (i % 1000 == 999) {
        EXPECT_NEAR(sum, profile.share(-1.0 + 2.0 * (i + 1) / n), 1e-5);
      }
    }
    EXPECT_NEAR(sum, 1.0, 1e-5);
  }
}

TEST(Overlaps, ATriangleIsEvenAtOneHalfAndAFlatFanAtNone) {
  const std::vector<std::pair<double, double>> triangle = {{-1, 0}, {0, 1}, {1, 0}};
  const Profile profile = Profile::table(triangle)->profile;
  EXPECT_NEAR(optimalOverlap(profile, Measure::average), 0.5, 1e-6);
  EXPECT_NEAR(uniformity(profile, 0.5).largest, 0.0, 1e-9);
  EXPECT_NEAR(optimalOverlap(Profile::flat(), Measure::rms), 0.0, 1e-6);
  // A triangle at overlap 0: h = 2 (1 - |2 t - 1| ...) between 0 and 2 about 1.
  const Uniformity apart = uniformity(profile, 0.0);
  EXPECT_NEAR(apart.average, 0.5, 1e-9);
  EXPECT_NEAR(apart.rms, std::sqrt(1.0 / 3.0), 1e-9);
  EXPECT_NEAR(apart.largest, 1.0, 1e-9);
}

/// Flat passes side by side leave an even film, seams and all; with beta = 1/4 a third of each
/// interval gets two passes, the rest one; 4/3 are the mean.
TEST(Uniformity, OfAFlatFan) {
  const Uniformity even = uniformity(Profile::flat(), 0.0);
  EXPECT_NEAR(even.average, 0.0, 1e-12);
  EXPECT_NEAR(even.largest, 0.0, 1e-12);
  const Uniformity quarter = uniformity(Profile::flat(), 0.25);
  EXPECT_NEAR(quarter.largest, 0.5, 1e-12);           // 2 passes where 4/3 are the mean
  EXPECT_NEAR(quarter.average, 1.0 / 3.0, 1e-12);     // 1/3 of 0.5, 2/3 of 0.25
  EXPECT_NEAR(quarter.rms, std::sqrt(0.125), 1e-12);  // (1/12 + 2/48)^1/2
}

}  // namespace
}  // namespace arelem::spray
