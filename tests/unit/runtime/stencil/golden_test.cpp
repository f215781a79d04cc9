#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <regex>
#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "runtime/stencil/cell.h"
#include "runtime/stencil/divide.h"
#include "runtime/stencil/message.h"
#include "runtime/stencil/plan.h"

/// Every case of Blank's thesis: the numbers it publishes, with its misprints corrected, and those
/// of its listing as compiled independently (tests/data/stencil).
namespace arelem::stencil {
namespace {

using nlohmann::json;
constexpr double tolerance = 1e-6;

std::string textOf(const std::string& path) {
  std::ifstream in(path);
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}

const Alphabet& roadway() {
  static const Alphabet alphabet = [] {
    auto read = readAlphabet(textOf(ARELEM_SOURCE_DIR "/stdlib/roadway.alphabet"), "roadway");
    EXPECT_TRUE(read.ok()) << (read.ok() ? "" : read.failure().message);
    return *read;
  }();
  return alphabet;
}

Vec2 point(const json& j) {
  return {j[0].get<double>(), j[1].get<double>()};
}

json caseOf(const std::string& id) {
  static const json all =
      json::parse(textOf(ARELEM_SOURCE_DIR "/tests/data/stencil/cases_blank.json"));
  for (const json& one : all) {
    if (one.at("id") == id) {
      return one;
    }
  }
  ADD_FAILURE() << "no case " << id;
  return {};
}

/// The ids that begin so.
std::vector<std::string> casesOf(const std::string& prefix) {
  static const json all =
      json::parse(textOf(ARELEM_SOURCE_DIR "/tests/data/stencil/cases_blank.json"));
  std::vector<std::string> ids;
  for (const json& one : all) {
    const std::string id = one.at("id");
    if (id.starts_with(prefix)) {
      ids.push_back(id);
    }
  }
  EXPECT_FALSE(ids.empty()) << prefix;
  return ids;
}

TEST(StencilGolden, CardinalSpline) {
  const json c = caseOf("BLANK-cardinal");
  SplinePiece spline;
  for (std::size_t i = 0; i < 4; ++i) {
    spline.control[i] = point(c["inputs"]["P"][i]);
  }
  for (const auto& [name, t] : {std::pair{"t0", 0.0}, {"half", 0.5}, {"t1", 1.0}}) {
    EXPECT_LT((pointOf(spline, t) - point(c["expected"][name])).norm(), tolerance) << name;
  }
}

TEST(StencilGolden, PosesOfALine) {
  for (const std::string& id : casesOf("BLANK-pose")) {
    const json c = caseOf(id);
    const Line line{point(c["inputs"]["p1"]), point(c["inputs"]["p2"])};
    const json& e = c["expected"];
    EXPECT_NEAR(yawOf(line), e["psi"], tolerance);
    EXPECT_LT((middleOf(line) - point(e["mid"])).norm(), tolerance);
    EXPECT_NEAR(widthOf(line), e["L"], tolerance);
    EXPECT_NEAR(heightFor(widthOf(line), c["inputs"]["alpha"]), e["Z"], tolerance);
    EXPECT_NEAR(1.0 / widthOf(line), e["V"], tolerance);  // K = 1
  }
}

TEST(StencilGolden, Trapezoids) {
  for (const std::string& id : casesOf("BLANK-trapezoid-")) {
    const json c = caseOf(id);
    const double share = trapezoidShare(c["inputs"]["b1"], c["inputs"]["b2"]);
    EXPECT_NEAR(share, c["expected"]["x1"], tolerance) << id;
    EXPECT_NEAR(1.0 - share, c["expected"]["x2"], tolerance) << id;
  }
}

TEST(StencilGolden, Quadrilaterals) {
  for (const std::string& id : {std::string("BLANK-quad"), std::string("BLANK-quad-trapezoid")}) {
    const json c = caseOf(id);
    // a-b is one side, c-d the other; the division runs from ad to bc.
    const Line from{point(c["inputs"]["b"]), point(c["inputs"]["c"])};
    const Line to{point(c["inputs"]["a"]), point(c["inputs"]["d"])};
    const double s = quadrilateralShare(from, to);
    EXPECT_NEAR(s, c["expected"]["s"], tolerance) << id;
    EXPECT_LT((from.first + s * (from.second - from.first) - point(c["expected"]["h"])).norm(),
              tolerance);
    EXPECT_LT((to.first + s * (to.second - to.first) - point(c["expected"]["g"])).norm(),
              tolerance);
    EXPECT_NEAR(areaShare(from, to, s), 50.0, tolerance);
  }
}

TEST(StencilGolden, TiltFollowsTheDivision) {
  for (const std::string id :
       {"BLANK-beta-0.5", "BLANK-beta-0.6", "BLANK-beta-0.4", "BLANK-beta-0.5827"}) {
    const json c = caseOf(id);
    const double xi = c["inputs"]["xi"];
    const double xj = c["inputs"]["xj"];
    const double tilt = tiltFor(xi / (xi + xj), c["inputs"]["gamma"]);
    EXPECT_NEAR(tilt, c["expected"]["beta"], tolerance) << id;
    EXPECT_NEAR(shareOf(tilt, c["inputs"]["gamma"]), xi / (xi + xj), tolerance) << id;
  }
}

TEST(StencilGolden, RepositioningKeepsTheEdges) {
  for (const std::string& id : casesOf("BLANK-retilt")) {
    const json c = caseOf(id);
    const json& in = c["inputs"];
    const json& e = c["expected"];
    const Tilted t = placeTilted(in["L"], in["alpha"], in["beta"]);
    const double psi = in["psi"].get<double>() * M_PI / 180.0;
    EXPECT_NEAR(t.shift, e["x0"], tolerance) << id;
    EXPECT_NEAR(t.height, e["Z"], tolerance) << id;
    EXPECT_NEAR(in["X"].get<double>() + t.shift * std::cos(psi), e["X"], tolerance) << id;
    EXPECT_NEAR(in["Y"].get<double>() + t.shift * std::sin(psi), e["Y"], tolerance) << id;
    EXPECT_NEAR(shareOf(in["beta"], in["alpha"]) * in["L"].get<double>(), e["xi"], tolerance) << id;
    // By rays: both borders of the tilted fan hit the ends of the line.
    for (const double side : {-1.0, 1.0}) {
      const double ray =
          (side * in["alpha"].get<double>() / 2 - in["beta"].get<double>()) * M_PI / 180.0;
      EXPECT_NEAR(t.shift + t.height * std::tan(ray), side * in["L"].get<double>() / 2, 1e-12)
          << id;
    }
  }
}

std::vector<Line> primitiveOne() {
  const Stroke& bowl = roadway().find("B")->strokes[1];
  EXPECT_EQ(bowl.primitive, 1);
  return linesOf(bowl, 4.0, 25.0, 20, Division::asSource);
}

TEST(StencilGolden, PaintOfPrimitiveOne) {
  const json none = caseOf("BLANK-ratio-no-tilt")["expected"];
  const json trapezoid = caseOf("BLANK-ratio-trapezoid")["expected"];
  const json trapezoidMost = caseOf("BLANK-ratio-trapezoid-max");
  const json fifteen = caseOf("BLANK-beta-15");
  const json quad = caseOf("BLANK-ratio-quad")["expected"];
  const std::vector<Line> lines = primitiveOne();
  std::vector<double> shares;
  double outerMost = 0, outerLeast = 100, least = 100, most = 0, fraction = 0;
  double sLeast = 1, sMost = 0, sSum = 0, betaLeast = 90, betaMost = -90;
  for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
    const double outer = 100.0 - areaShare(lines[i], lines[i + 1]);
    outerMost = std::max(outerMost, outer);
    outerLeast = std::min(outerLeast, outer);
    const double share = trapezoidShare((lines[i + 1].first - lines[i].first).norm(),
                                        (lines[i + 1].second - lines[i].second).norm());
    fraction += share / 20.0;
    shares.push_back(share);
    const double s = quadrilateralShare(lines[i], lines[i + 1]);
    sLeast = std::min(sLeast, s);
    sMost = std::max(sMost, s);
    sSum += s / 20.0;
    betaLeast = std::min(betaLeast, tiltFor(s, 63.5));
    betaMost = std::max(betaMost, tiltFor(s, 63.5));
    EXPECT_NEAR(areaShare(lines[i], lines[i + 1], s), 50.0, 1e-9);
  }
  // A line takes the mean of the shares of the cells beside it.
  const auto at = [&](std::size_t i) {
    const double share = 0.5 * (shares[i == 0 ? 0 : i - 1] + shares[std::min<std::size_t>(i, 19)]);
    return Vec2(lines[i].first + share * (lines[i].second - lines[i].first));
  };
  for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
    const double inner = areaOf({lines[i].first, at(i)}, {lines[i + 1].first, at(i + 1)});
    const double half = 100.0 * inner / areaOf(lines[i], lines[i + 1]);
    least = std::min({least, half, 100 - half});
    most = std::max({most, half, 100 - half});
    if (i == 0) {
      EXPECT_NEAR(100 - half, trapezoid["ends"], tolerance);
    }
  }
  EXPECT_NEAR(100.0 - areaShare(lines[0], lines[1]), none["outer_ends"], tolerance);
  EXPECT_NEAR(outerMost, none["outer_max"], tolerance);
  EXPECT_NEAR(outerLeast, none["outer_min"], tolerance);
  EXPECT_NEAR(fraction, trapezoid["mean_fraction"], tolerance);
  EXPECT_NEAR(least, trapezoid["min"], tolerance);
  EXPECT_NEAR(most, trapezoid["max"], tolerance);
  // The two halves of a cell sum to 100, so that the published 52 does not fit the published 47.
  EXPECT_NEAR(most, trapezoidMost["expected"]["max"], tolerance);
  EXPECT_NEAR(most + least, 100.0, tolerance);
  EXPECT_GT(most - trapezoidMost["published"]["max"].get<double>(), trapezoidMost["published_tol"]);
  EXPECT_NEAR(tiltFor(fraction, 63.5), trapezoid["beta"], tolerance);
  // The letter P of section 2.7.2.
  EXPECT_NEAR(tiltFor(fraction, 63.5), fifteen["expected"]["beta"], tolerance);
  EXPECT_NEAR(tiltFor(fraction, 63.5), fifteen["published"]["beta"], fifteen["published_tol"]);
  EXPECT_NEAR(sLeast, quad["s_min"], tolerance);
  EXPECT_NEAR(sMost, quad["s_max"], tolerance);
  EXPECT_NEAR(sSum, quad["s_mean"], tolerance);
  EXPECT_NEAR(betaLeast, quad["beta_min"], tolerance);
  EXPECT_NEAR(betaMost, quad["beta_max"], tolerance);
}

std::vector<Pose> letter(const std::string& text,
                         double height,
                         const Vec2& origin,
                         const FanGun& gun) {
  Writing writing;
  writing.division = Division::asSource;
  auto runs = runsOf(text, roadway(), {origin, height, 0.0, std::nullopt}, writing, {});
  EXPECT_TRUE(runs.ok());
  Job job;
  job.gun = gun;
  job.speedTimesWidth = 600.0 * 1.8 / 0.025;
  job.asSource = true;
  std::vector<Pose> poses;
  for (const Run& run : *runs) {
    auto track = planRun(run, job);
    EXPECT_TRUE(track.ok());
    poses.insert(poses.end(), track->poses.begin(), track->poses.end());
  }
  return poses;
}

void expectPoses(const std::vector<Pose>& poses, const json& expected) {
  ASSERT_EQ(poses.size(), expected.size());
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const json& e = expected[i];
    EXPECT_NEAR(poses[i].place.x(), e[0], tolerance) << i;
    EXPECT_NEAR(poses[i].place.y(), e[1], tolerance) << i;
    EXPECT_NEAR(poses[i].height, e[2], tolerance) << i;
    EXPECT_NEAR(std::remainder(poses[i].yaw - e[3].get<double>(), 360.0), 0.0, tolerance) << i;
    EXPECT_NEAR(poses[i].speed, e[4], tolerance) << i;
  }
}

FanGun gunOfS() {
  return {63.5, 509.3, 0.878715, 0.0, 0.0, 0.0};
}
FanGun gunOfB() {
  return {63.5, 528.145 - 20.828, 0.5 / std::tan(31.75 * M_PI / 180.0), 0.0, 0.0, 0.0};
}

TEST(StencilGolden, LetterS) {
  expectPoses(letter("S", 1800.0, {400.0, -900.0}, gunOfS()),
              caseOf("BLANK-S-mm")["expected"]["points"]);
}

TEST(StencilGolden, LetterB) {
  expectPoses(letter("B", 1900.0, {400.0, -950.0}, gunOfB()),
              caseOf("BLANK-B-mm")["expected"]["points"]);
}

TEST(StencilGolden, LettersOnTheGrid) {
  for (const std::string name : {"S", "B"}) {
    const json points = caseOf("BLANK-" + name + "-grid")["expected"]["points"];
    const std::vector<Pose> poses = letter(name, 25.0, Vec2::Zero(), {});
    ASSERT_EQ(poses.size(), points.size());
    for (std::size_t i = 0; i < poses.size(); ++i) {
      EXPECT_LT((middleOf(poses[i].line) - point(points[i])).norm(), tolerance) << name << i;
      EXPECT_NEAR(std::remainder(poses[i].yaw - points[i][2].get<double>(), 360.0), 0.0, tolerance)
          << name << i;
      EXPECT_NEAR(widthOf(poses[i].line), points[i][3], tolerance) << name << i;
    }
  }
}

/// The published table of points, letter by letter.
TEST(StencilGolden, LetterPoints) {
  std::istringstream in(textOf(ARELEM_SOURCE_DIR "/tests/data/stencil/letter_points.csv"));
  std::string row;
  std::getline(in, row);
  std::map<std::string, std::vector<Pose>> poses = {
      {"S", letter("S", 1800.0, {400.0, -900.0}, gunOfS())},
      {"B", letter("B", 1900.0, {400.0, -950.0}, gunOfB())}};
  std::size_t rows = 0;
  while (std::getline(in, row)) {
    std::replace(row.begin(), row.end(), ',', ' ');
    std::istringstream fields(row);
    std::string name;
    std::size_t i = 0;
    double gx, gy, yaw, length, x, y, height, speed;
    ASSERT_TRUE(fields >> name >> i >> gx >> gy >> yaw >> length >> x >> y >> height >> speed);
    ASSERT_LT(i, poses[name].size());
    const Pose& pose = poses[name][i];
    EXPECT_NEAR(pose.place.x(), x, tolerance) << row;
    EXPECT_NEAR(pose.place.y(), y, tolerance) << row;
    EXPECT_NEAR(std::remainder(pose.yaw - yaw, 360.0), 0.0, tolerance) << row;
    EXPECT_NEAR(pose.height, height, tolerance) << row;
    EXPECT_NEAR(pose.speed, speed, tolerance) << row;
    ++rows;
  }
  EXPECT_EQ(rows, 225U);
}

/// Fails for a row that no test names: by its id, or by the beginning of ids that a test goes
/// through.
TEST(StencilGolden, EveryRowHasATest) {
  std::vector<std::string> named;
  for (const char* file :
       {"/tests/unit/runtime/stencil/golden_test.cpp", "/tests/unit/backend/joints/joints_test.cpp",
        "/tests/unit/backend/robot/robot_test.cpp"}) {
    const std::string text = textOf(ARELEM_SOURCE_DIR + std::string(file));
    ASSERT_FALSE(text.empty()) << file;
    const std::regex quoted("(casesOf\\(|starts_with\\()?\"(BLANK-[^\" ]*)\"");
    for (std::sregex_iterator i(text.begin(), text.end(), quoted), end; i != end; ++i) {
      named.push_back((*i)[2].str() + ((*i)[1].matched ? "*" : ""));
    }
  }
  const auto isNamed = [&](const std::string& id) {
    return std::any_of(named.begin(), named.end(), [&](const std::string& name) {
      return name.back() == '*' ? id.starts_with(name.substr(0, name.size() - 1)) : id == name;
    });
  };
  for (const std::string name : {"S", "B"}) {  // put together by the tests
    named.push_back("BLANK-" + name + "-grid");
    named.push_back("BLANK-" + name + "-vplus");  // tests/end_to_end/test_robots.py
  }
  // What nothing of ours computes: the deflection of the pantograph's links under their load, and
  // curves that are published without numbers.
  named.insert(named.end(), {"BLANK-chap3", "BLANK-figs"});
  const std::string all = "BLANK";
  for (const std::string& id : casesOf(all)) {
    EXPECT_TRUE(isNamed(id)) << id << " is not checked by any test";
  }
  EXPECT_FALSE(isNamed(all + "-new"));
}

}  // namespace
}  // namespace arelem::stencil
