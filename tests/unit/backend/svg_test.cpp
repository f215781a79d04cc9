#include <cmath>
#include <numbers>
#include <regex>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "backend/svg/conic.h"
#include "backend/svg/path.h"
#include "backend/svg/view.h"
#include "tests/unit/backend/oracle_records.h"
#include "tests/unit/backend/writing.h"

namespace arelem::test {
namespace {

using namespace backend::svg;
using ::testing::HasSubstr;
using ::testing::Not;

cl::Record go(int isn, std::vector<double> coordinates) {
  cl::Motion m;
  m.coordinates = std::move(coordinates);
  return record(isn, m);
}

/// Tags are balanced and attributes quoted: what an XML reader refuses first.
bool isBalanced(const std::string& xml) {
  std::vector<std::string> open;
  for (std::size_t at = xml.find('<'); at != std::string::npos; at = xml.find('<', at + 1)) {
    const std::size_t end = xml.find('>', at);
    if (end == std::string::npos) {
      return false;
    }
    const std::string tag = xml.substr(at + 1, end - at - 1);
    if (tag.find('<') != std::string::npos || std::count(tag.begin(), tag.end(), '"') % 2 != 0) {
      return false;
    }
    if (tag.front() == '/') {
      if (open.empty() || open.back() != tag.substr(1)) {
        return false;
      }
      open.pop_back();
    } else if (tag.back() != '/') {
      open.push_back(tag.substr(0, tag.find(' ')));
    }
  }
  return open.empty();
}

TEST(Svg, EveryOldProgramGivesAPicture) {
  for (const OracleCase& c : readOracleCases()) {
    const std::string picture = written("svg", c.records);
    EXPECT_TRUE(isBalanced(picture)) << c.name;
    EXPECT_EQ(picture, written("svg", c.records)) << c.name;
    EXPECT_THAT(picture, Not(HasSubstr("nan"))) << c.name;
  }
}

TEST(Svg, AFlatPathHasOneViewAndASolidOneThree) {
  const std::string flat = written("svg", {go(1, {0, 0, 5}), go(2, {10, 4, 5})});
  EXPECT_THAT(flat, HasSubstr(">XY</text>"));
  EXPECT_THAT(flat, Not(HasSubstr(">XZ</text>")));
  const std::string upright = written("svg", {go(1, {0, 3, 5}), go(2, {10, 3, 7})});
  EXPECT_THAT(upright, HasSubstr(">XZ</text>"));
  EXPECT_THAT(upright, Not(HasSubstr(">XY</text>")));
  const std::string solid = written("svg", {go(1, {0, 0, 0}), go(2, {10, 4, 5})});
  EXPECT_THAT(solid, HasSubstr(">XY</text>"));
  EXPECT_THAT(solid, HasSubstr(">XZ</text>"));
  EXPECT_THAT(solid, HasSubstr(">YZ</text>"));
}

TEST(Svg, KindsOfMoves) {
  cl::Surface circle;
  circle.surface = {EntityType::circle, "C1", 0, {0, 0, 0, 0, 0, 1, 1}};
  const std::string picture =
      written("svg", {go(1, {0, 0, 0}), record(2, cl::Post{Word::RAPID, "", {}}), go(3, {10, 0, 0}),
                      go(4, {10, 5, 0}), record(5, circle), go(5, {9, 6, 0, 8, 5, 0})});
  EXPECT_THAT(picture, HasSubstr("rapid, 10 long"));
  EXPECT_THAT(picture, HasSubstr("feed, 5 long"));
  EXPECT_THAT(picture, HasSubstr("along a circle, 2.828 long"));
}

TEST(Svg, NothingAndOnePoint) {
  EXPECT_THAT(written("svg", {}), HasSubstr("no motion"));
  EXPECT_TRUE(isBalanced(written("svg", {go(1, {3, 4, 5})})));
  EXPECT_TRUE(isBalanced(written("svg", {go(1, {1e300, -1e300, 1e300}), go(2, {0, 0, 0})})));
  EXPECT_TRUE(isBalanced(written("svg", {go(1, {std::nan(""), 0, 0})})));
}

TEST(Svg, HostileNamesAreEscaped) {
  Entity entity;
  entity.name = "<script>\"&";
  entity.canon = {1, 1, 0};
  backend::Context context;
  context.entities.push_back(std::make_shared<const Entity>(entity));
  CollectingSink sink;
  const std::string picture =
      written("svg",
              {record(1, cl::Text{Word::PARTNO, "</title><script>alert('x')</script>\x1b\xff"}),
               go(2, {0, 0, 0, 2, 2, 0})},
              context, sink);
  EXPECT_THAT(picture, Not(HasSubstr("<script>")));
  EXPECT_THAT(picture, HasSubstr("<title>&lt;/title&gt;&lt;script&gt;alert(&#39;x&#39;)"));
  EXPECT_THAT(picture, HasSubstr("&lt;script&gt;&quot;&amp;</text>"));
  EXPECT_TRUE(isBalanced(picture));
}

TEST(Svg, GeometryWithoutAPictureIsNamed) {
  Entity quadric;
  quadric.type = EntityType::quadric;
  quadric.canon.assign(10, 1.0);
  backend::Context context;
  context.entities = {std::make_shared<const Entity>(quadric),
                      std::make_shared<const Entity>(quadric)};
  CollectingSink sink;
  EXPECT_THAT(written("svg", {go(1, {0, 0, 0, 1, 1, 0})}, context, sink),
              HasSubstr("not drawn: 2 QADRIC"));
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t times = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++times;
  }
  return times;
}

std::string pictureOf(EntityType type, const std::vector<double>& canon) {
  Entity entity;
  entity.type = type;
  entity.canon = canon;
  backend::Context context;
  context.entities = {std::make_shared<const Entity>(entity)};
  CollectingSink sink;
  return written("svg", {go(1, {-5, -5, 0, 5, 5, 0})}, context, sink);
}

/// Every x1 of the vertical lines of the geometry.
std::vector<double> verticals(const std::string& picture) {
  std::vector<double> found;
  std::smatch m;
  std::string rest = picture.substr(0, picture.find(">geometry<"));
  const std::regex line(
      "<line x1=\"([0-9.]+)\" y1=\"[0-9.]+\" x2=\"\\1\" y2=\"[0-9.]+\" class=\"geometry\"");
  while (std::regex_search(rest, m, line)) {
    found.push_back(std::stod(m[1]));
    rest = m.suffix();
  }
  return found;
}

TEST(Svg, ATiltedCylinderIsAsWideAsAnUprightOne) {
  const double half = std::sqrt(0.5);
  const auto tilted = verticals(pictureOf(EntityType::cylinder, {0, 0, 0, 0, half, half, 2}));
  const auto lying = verticals(pictureOf(EntityType::cylinder, {0, 0, 0, 0, 1, 0, 2}));
  ASSERT_EQ(tilted.size(), 2U);
  EXPECT_EQ(tilted, lying);
}

TEST(Svg, AConeHasItsOutlineUnlessSeenFromWithin) {
  // Axis 45 degrees out of the plan: the outline of a half angle of 60 degrees is not seen, that of
  // 30 leans by acos(sqrt(3/4 - 1/2) / sqrt(1/2)) = 45 degrees from the axis.
  const double half = std::sqrt(0.5);
  const std::string wide = pictureOf(EntityType::cone, {0, 0, 0, 0, half, half, 0.5});
  const std::string narrow = pictureOf(EntityType::cone, {0, 0, 0, 0, half, half, std::sqrt(0.75)});
  const std::size_t legendAndCross = 3;
  EXPECT_EQ(count(wide, "class=\"geometry\""), legendAndCross);
  EXPECT_EQ(count(narrow, "class=\"geometry\""), legendAndCross + 2);
}

TEST(Svg, ATorusIsDrawnFromEverySide) {
  EXPECT_EQ(count(pictureOf(EntityType::torus, {0, 0, 0, 0, 0, 1, 3, 1}), "<circle"),
            count(pictureOf(EntityType::sphere, {0, 0, 0, 3}), "<circle") + 1);
  EXPECT_THAT(pictureOf(EntityType::torus, {0, 0, 0, 0, 0.6, 0.8, 3, 1}),
              Not(HasSubstr("not drawn")));
}

TEST(Svg, APlaneThatFillsTheViewIsNamed) {
  EXPECT_THAT(pictureOf(EntityType::plane, {0, 0, 1, 3}), HasSubstr("not drawn: 1 PLANE"));
  EXPECT_THAT(pictureOf(EntityType::plane, {1, 0, 0, 3}), Not(HasSubstr("not drawn")));
}

TEST(Svg, RoundingIsNoCoordinate) {
  EXPECT_THAT(written("svg", {go(1, {0, 0, -4e-16}), go(2, {10, 4, 0})}), HasSubstr("Z 0 to 0"));
}

TEST(Svg, TheWaysBetweenThePlacesOfAnUnknownCycleAreRapid) {
  const std::string picture =
      written("svg", {go(1, {0, 0, 0}), record(2, cl::Post{Word::CYCLE, "", {Word::DRILL, 2.0}}),
                      go(3, {10, 0, 0}), go(4, {10, 5, 0}),
                      record(5, cl::Post{Word::CYCLE, "", {Word::OFF}}), go(6, {8, 5, 0})});
  EXPECT_THAT(picture, HasSubstr("rapid, 15 long"));
  EXPECT_THAT(picture, HasSubstr("feed, 2 long"));
}

// Up 1 to the clearance, over to the holes 10 and 5, 3 up at rapid and 3 down at feed in each; from
// there to the last place 2 across and 1 down.
TEST(Svg, TheHolesOfACycleAreDrilled) {
  const std::string picture = written(
      "svg", {go(1, {0, 0, 0}),
              record(2, cl::Post{Word::CYCLE, "", {Word::DRILL, 2.0, 40.0, Word::MMPM, 1.0}}),
              go(3, {10, 0, 0}), go(4, {10, 5, 0}),
              record(5, cl::Post{Word::CYCLE, "", {Word::OFF}}), go(6, {8, 5, 0})});
  EXPECT_THAT(picture, HasSubstr("rapid, 22 long"));
  EXPECT_THAT(picture, HasSubstr("feed, 8.236 long"));
}

TEST(SvgPath, AHugePathIsThinnedAndKeepsItsShape) {
  PathCollector path(1000);
  constexpr int turns = 40;
  constexpr int count = 400000;
  std::vector<Vec3> all;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * turns * i / count;
    all.emplace_back(100 * std::cos(angle), 100 * std::sin(angle), 50.0 * i / count);
    path.accept(go(1 + i, {all.back().x(), all.back().y(), all.back().z()}));
  }
  path.finish();
  path.thin(0.0);
  EXPECT_LE(path.vertices().size(), 1000U);
  EXPECT_EQ(path.locations(), static_cast<std::uint64_t>(count));
  EXPECT_LE(path.stops().size(), PathCollector::mostStops);
  EXPECT_NEAR(path.length(MoveKind::feed), turns * 200 * std::numbers::pi, 1.0);
  EXPECT_EQ(path.bounds().high.z(), 50.0 * (count - 1) / count);
  EXPECT_LT(path.deviation(), 8.0);
  for (int i = 0; i < count; i += 997) {
    double nearest = 1e9;
    const auto& v = path.vertices();
    for (std::size_t k = 1; k < v.size(); ++k) {
      const Vec3 along = v[k].place - v[k - 1].place;
      const double t =
          std::clamp((all[i] - v[k - 1].place).dot(along) / along.squaredNorm(), 0.0, 1.0);
      nearest = std::min(nearest, (all[i] - v[k - 1].place - t * along).norm());
    }
    EXPECT_LE(nearest, path.deviation() + 1e-9);
  }
}

TEST(SvgPath, MovesOfKindsInTurnsStayBounded) {
  PathCollector path(1000);
  for (int i = 0; i < 100000; ++i) {
    if (i % 2 == 0) {
      path.accept(record(i, cl::Post{Word::RAPID, "", {}}));
    }
    path.accept(go(i, {std::fmod(i * 0.618, 10.0), std::fmod(i * 0.377, 10.0), i % 2 * 1.0}));
  }
  path.thin(0.0);
  EXPECT_LE(path.vertices().size(), 1000U);
}

TEST(SvgView, LinesAreClippedToTheView) {
  View view{"XY", 0, 1, 2, {0, 0, 100, 50}, 10, 0, 0};  // x 0..10, y 0..5
  const auto diagonal = view.clip(1, -1, 0);            // x = y
  ASSERT_TRUE(diagonal.has_value());
  EXPECT_NEAR(((*diagonal)[0] - (*diagonal)[1]).norm(), 5 * std::sqrt(2.0), 1e-12);
  EXPECT_FALSE(view.clip(0, 1, 7).has_value());  // y = 7
  EXPECT_FALSE(view.clip(1, 1, 100).has_value());
  EXPECT_FALSE(view.clip(0, 0, 1).has_value());
  const auto upright = view.clip(2, 0, 8);  // x = 4
  ASSERT_TRUE(upright.has_value());
  EXPECT_EQ((*upright)[0].x(), 4.0);
  EXPECT_NEAR(std::abs((*upright)[0].y() - (*upright)[1].y()), 5.0, 1e-12);
}

TEST(SvgView, AConicIsDrawnWhereItLies) {
  View view{"XY", 0, 1, 2, {0, 0, 400, 400}, 40, -5, -5};
  // x²/16 + y²/4 = 1
  const auto segments = conicInView({1.0 / 16, 0.25, 0, -1, 0, 0, 0, 0, 0, 0}, view);
  ASSERT_GT(segments.size(), 100U);
  double length = 0.0;
  for (const Segment& s : segments) {
    const double x = (s.from.x / 40) - 5;
    const double y = 5 - (s.from.y / 40);
    EXPECT_NEAR(x * x / 16 + y * y / 4, 1.0, 0.01);
    length += std::hypot(s.to.x - s.from.x, s.to.y - s.from.y) / 40;
  }
  EXPECT_NEAR(length, 19.376896, 0.02);  // circumference of the ellipse with half axes 4 and 2
}

// One cubic over the chord (0,0)-(2,0) with a = 0, b = 1: y = t² - 2t, between straight extensions.
TEST(SvgView, ATabulatedCylinderIsSampledBetweenItsExtensions) {
  const std::vector<double> canon = {3, 32, 1, 0, 0, 0, 1, 0,    0, 0, 1, -1, 2, 0, 0, 1, 0,
                                     0, 0,  0, 0, 1, 2, 0, -0.5, 2, 0, 0, 0,  1, 0, 0, 3, 2};
  const auto curve = tabulatedCurve(canon, 2);
  ASSERT_EQ(curve.size(), 17U);
  EXPECT_EQ(curve.front(), Vec3(0, 0, 0));
  EXPECT_EQ(curve[8], Vec3(1, -1, 0));
  EXPECT_EQ(curve.back(), Vec3(2, 0, 0));
  EXPECT_TRUE(tabulatedCurve(canon, 0).empty());
  EXPECT_TRUE(tabulatedCurve({1, 2, 3}, 2).empty());
}

}  // namespace
}  // namespace arelem::test
