#include "tests/random/scene.h"

#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "tests/random/built.h"

namespace arelem::scenes {

namespace {
constexpr double degree = std::numbers::pi / 180.0;

/// The seven numbers of a cutter whose corner touches the bottom line at `alpha` degrees and the
/// side line at `beta`.
std::array<double, 7> cutterOf(double d, double r, double alpha, double beta, double h) {
  const double sa = std::sin(alpha * degree), ca = std::cos(alpha * degree);
  const double sb = std::sin(beta * degree), cb = std::cos(beta * degree);
  const double det = ca * cb - sa * sb;
  return {d, r, d / 2 + r * (sb - ca) / det, d / 2 * sa / ca + r * (cb - sa) / det, alpha, beta, h};
}

std::array<double, 7> drawCutter(Dice& dice) {
  const double d = dice.choice({0.25, 0.5, 0.75, 1.0, 1.5}), h = dice.choice({3.0, 4.0, 5.0});
  switch (dice.below(8)) {
    case 0:
    case 1:  // ball
      return {d, d / 2, 0, d / 2, 0, 0, h};
    case 2:  // flat
      return {d, 0, d / 2, 0, 0, 0, h};
    case 3:
    case 4:  // bull-nose
      return cutterOf(d, d * dice.among(0.05, 0.4), 0, 0, h);
    case 5:  // tapered, with a small corner
      return cutterOf(d, d * dice.among(0.05, 0.3), 0, dice.choice({3.0, 5.0, 10.0}), h);
    case 6:  // all of it
      return cutterOf(d, d * dice.among(0.05, 0.2), dice.choice({5.0, 15.0, 31.0}),
                      dice.choice({0.0, 3.0, 10.0}), h);
    default:  // a drill, or a needle without diameter
      return dice.chance(0.3) ? std::array<double, 7>{0, 0, 0, 0, 0, 0, h}
                              : cutterOf(d, 0, 31, 0, h);
  }
}

void drawAxis(Scene& scene, Dice& dice) {
  // The normal of a mesh jumps: few axes that follow it settle, and it takes long to tell.
  const bool faceted = std::holds_alternative<MeshShape>(scene.part) ||
                       std::holds_alternative<MeshShape>(scene.drive);
  if (!scene.multax || !dice.chance(faceted ? 0.02 : 0.3)) {
    return;
  }
  scene.axis = dice.choice({AxisWord::normalPart, AxisWord::normalPart, AxisWord::normalDrive,
                            AxisWord::angle, AxisWord::lead, AxisWord::fourAxis});
  scene.axisSurface = dice.chance(0.75) ? 1 : 2;
  // An axis near the normal of the drive surface lays the tool flat: from there it leans far.
  scene.alpha = scene.axisSurface == 1 ? dice.among(2, 20) : dice.among(60, 85);
  scene.beta = dice.among(-2, 2);
}

/// A cylinder along `along` that touches a surface near a place; a mesh there is nearly square to
/// `up`.
Shape touching(
    const Shape& shape, const Vec3& near, const Vec3& up, const Vec3& along, Dice& dice) {
  const surface::Foot foot =
      std::holds_alternative<MeshShape>(shape) ? surface::Foot{0.0, up} : footOf(shape, near);
  const Vec3 at = near - foot.distance * foot.normal;
  const double radius = dice.among(1.5, 6), side = dice.chance(0.5) ? 1.0 : -1.0;
  const Vec3 axis = (along - along.dot(foot.normal) * foot.normal).normalized();
  return CylinderShape{at + side * radius * foot.normal, axis, radius};
}

void drawExtra(Scene& scene, Dice& dice) {
  const double share = dice.among(0, 1);
  if (share < 0.1) {
    scene.extra = Extra::secondCheck;
    scene.second = checkSurface(dice);
    scene.secondStop = dice.choice({"TO", "ON", "PAST"});
  } else if (share < 0.18) {
    scene.extra = Extra::tangentDrive;
    scene.check =
        touching(scene.drive, Vec3{dice.among(2, 4.5), 0, 0.5}, Vec3::UnitY(), Vec3::UnitZ(), dice);
    scene.stop = dice.choice({"TANTO", "DSTAN"});
  } else if (share < 0.24) {
    scene.extra = Extra::tangentPart;
    scene.check =
        touching(scene.part, Vec3{dice.among(2, 4.5), 0, 0}, Vec3::UnitZ(), Vec3::UnitY(), dice);
    scene.stop = "PSTAN";
  } else if (share < 0.34) {
    scene.extra = Extra::implied;
    scene.turnsLeft = dice.chance(0.5);
    scene.second = PlaneShape{Vec3{dice.among(-0.3, 0.3), 1, 0},
                              (scene.turnsLeft ? 1 : -1) * dice.among(1.5, 2.5)};
  } else if (share < 0.4) {
    scene.extra = Extra::counted;
  }
}

void drawTolerances(Scene& scene, Dice& dice) {
  constexpr std::array<std::array<double, 2>, 7> bands{{{0, 0.002},
                                                        {0.002, 0},
                                                        {0.002, 0.002},
                                                        {0.001, 0.004},
                                                        {0.005, 0.005},
                                                        {0, 0.01},
                                                        {0.0005, 0.0005}}};
  const std::array<double, 2>& band = bands[dice.below(bands.size())];
  scene.inner = band[0];
  scene.outer = band[1];
  if (dice.chance(0.2)) {
    for (double& t : scene.thick) {
      t = dice.choice({0.0, 0.01, 0.05, -0.02});
    }
  }
  if (dice.chance(0.2)) {
    scene.longest = dice.choice({0.3, 1.0, 2.5});
  }
}

Similarity drawMove(bool inSpace, Dice& dice) {
  Similarity move;
  if (dice.chance(0.8)) {
    const Vec3 axis = inSpace && dice.chance(0.7) ? dice.direction() : Vec3(Vec3::UnitZ());
    move.turn = Eigen::AngleAxisd(dice.among(0, 360) * degree, axis).toRotationMatrix();
  }
  if (dice.chance(0.4)) {
    move.turn.col(1) *= -1.0;
  }
  if (dice.chance(0.4)) {
    move.scale = dice.choice({0.125, 0.5, 4.0, 25.4});
  }
  move.shift = Vec3{dice.among(-9, 9), dice.among(-9, 9), dice.among(-9, 9)};
  return move;
}

/// The lines of a program in cards of at most 72 columns.
void addCards(std::string& text, std::string_view line) {
  constexpr std::size_t longest = 70;
  while (line.size() > longest) {
    const std::size_t cut = line.rfind(',', longest - 3) + 1;
    text.append(line.substr(0, cut)).append("$\n");
    line.remove_prefix(cut);
  }
  text.append(line).append("\n");
}

std::string spell(Hand hand, bool mirrored) {
  if (hand == Hand::on) {
    return "TLON";
  }
  return (hand == Hand::left) != mirrored ? "TLLFT" : "TLRGT";
}

std::string axisStatement(const Scene& s, const Similarity& to) {
  switch (s.axis) {
    case AxisWord::normalPart:
      return "TLAXIS/NORMPS";
    case AxisWord::normalDrive:
      return "TLAXIS/NORMDS";
    case AxisWord::angle:
      return fmt::format("TLAXIS/ATANGL,{},{}", s.axisSurface, s.alpha);
    case AxisWord::lead:
      return fmt::format("TLAXIS/ATANGL,{},{},CUTANG,{}", s.axisSurface, s.alpha, s.beta);
    case AxisWord::fourAxis:
      return fmt::format("TLAXIS/ATANGL,{},{},(VECTOR/{})", s.axisSurface, s.alpha,
                         written(to.direction(Vec3::UnitX())));
    case AxisWord::fixed:
      break;
  }
  return "";
}

/// From the motion along the drive surface to the end.
std::vector<std::string> motionStatements(const Scene& s, const Similarity& to) {
  const std::string motion = spell(s.hand, to.mirrors()) + ",GOFWD/DS1";
  const auto up = [&](double length) {
    return "GODLTA/" + written(Vec3(to.length(length) * to.direction(Vec3::UnitZ())));
  };
  switch (s.extra) {
    case Extra::secondCheck:
      return {motion + "," + s.stop + ",CS1,L1," + s.secondStop + ",CS2,L2", "L1)" + up(1),
              "TRANTO/L3", "L2)" + up(2), "L3)" + up(4)};
    case Extra::implied:
      return {motion,
              (s.turnsLeft != to.mirrors() ? "GOLFT" : "GORGT") + std::string("/CS1,ON,CS2")};
    case Extra::counted:
      return {motion + "," + s.stop + ",2,INTOF,CS1"};
    default:
      return {motion + "," + s.stop + ",CS1"};
  }
}
}  // namespace

std::string spell(const SceneId& id) {
  return fmt::format("{}:{},{},{}", id.seed, kinds[id.part()], kinds[id.drive()], id.number);
}

std::string Scene::program(const Similarity& to) const {
  std::vector<std::string> lines{"PARTNO RANDOM SCENE " + spell(id)};
  if (multax) {
    lines.insert(lines.end(), {"MULTAX", "3DCALC"});
  }
  lines.push_back("INTOL/" + written(to.length(inner)));
  lines.push_back("OUTTOL/" + written(to.length(outer)));
  lines.push_back("MAXDP/" + written(to.length(longest)));
  if (thick != std::array<double, 3>{}) {
    lines.push_back("THICK/" + written(to.scale * Vec3(thick[0], thick[1], thick[2])));
  }
  std::string values;
  for (std::size_t i = 0; i < cutter.size(); ++i) {
    values += (i == 0 ? "" : ",") + written(i == 4 || i == 5 ? cutter[i] : to.length(cutter[i]));
  }
  lines.push_back("CUTTER/" + values);
  if (ring) {
    lines.push_back(fmt::format("CUTTER/OPTION,{},{},{}", (*ring)[0], to.length((*ring)[1]),
                                to.length((*ring)[2])));
  }
  lines.push_back("PS1=" + definition(part, to, "part.stl"));
  lines.push_back("DS1=" + definition(drive, to, "drive.stl"));
  lines.push_back("CS1=" + definition(check, to, ""));
  if (extra == Extra::secondCheck || extra == Extra::implied) {
    lines.push_back("CS2=" + definition(second, to, ""));
  }
  lines.push_back("X1=" + definition(PlaneShape{Vec3::UnitX(), -4.25}, to, ""));
  lines.push_back("FROM/" + written(to.point(Vec3(-7.15, 2.55, 6.25))) +
                  (multax ? "," + written(to.direction(Vec3::UnitZ())) : ""));
  if (axis != AxisWord::fixed) {
    lines.push_back(axisStatement(*this, to));
  }
  if (onPart) {
    lines.emplace_back("TLONPS");
  }
  const char* const start = hand == Hand::on ? "ON" : hand == Hand::left ? "TO" : "PAST";
  lines.push_back(fmt::format("GO/{},DS1,{},PS1,ON,X1", start, onPart ? "ON" : "TO"));
  lines.push_back("INDIRV/" + written(to.direction(Vec3::UnitX())));
  const std::vector<std::string> motions = motionStatements(*this, to);
  lines.insert(lines.end(), motions.begin(), motions.end());
  lines.emplace_back("FINI");
  std::string text;
  for (const std::string& line : lines) {
    addCards(text, line);
  }
  return text;
}

std::vector<std::pair<std::string, std::string>> Scene::files(const Similarity& to) const {
  std::vector<std::pair<std::string, std::string>> files;
  if (const auto* mesh = std::get_if<MeshShape>(&part)) {
    files.emplace_back("part.stl", stl(*mesh, to));
  }
  if (const auto* mesh = std::get_if<MeshShape>(&drive)) {
    files.emplace_back("drive.stl", stl(*mesh, to));
  }
  return files;
}

Scene drawScene(const SceneId& id) {
  Dice dice(id.seed, id.pair, id.number);
  Scene scene;
  scene.id = id;
  scene.part = partSurface(id.part(), dice);
  scene.drive = driveSurface(id.drive(), dice);
  scene.check = checkSurface(dice);
  scene.cutter = drawCutter(dice);
  drawTolerances(scene, dice);
  scene.hand = dice.choice({Hand::on, Hand::left, Hand::right});
  scene.onPart = dice.chance(0.1);
  scene.stop = dice.choice({"TO", "ON", "PAST"});
  scene.multax = dice.chance(0.85);
  drawAxis(scene, dice);
  drawExtra(scene, dice);
  if (dice.chance(0.04)) {
    scene.ring = {dice.chance(0.5) ? 1.0 : 2.0, dice.among(0.1, 0.5), dice.among(0, 0.5)};
  }
  scene.move = drawMove(scene.multax, dice);
  return scene;
}

}  // namespace arelem::scenes
