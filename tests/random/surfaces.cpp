#include "tests/random/surfaces.h"

#include <cmath>
#include <numbers>

namespace arelem::scenes {

// Numbers are drawn in braces: the calls of an argument list have no order of their own.
namespace {
/// The form of a x2 + b y2 + c z2 + h xy + p x + q y + r z + d.
QuadricShape quadric(const std::array<double, 8>& numbers) {
  const auto [a, b, c, h, p, q, r, d] = numbers;
  Eigen::Matrix4d m = Eigen::Matrix4d::Zero();
  m.diagonal() << a, b, c, d;
  m(0, 1) = m(1, 0) = h / 2;
  m(0, 3) = m(3, 0) = p / 2;
  m(1, 3) = m(3, 1) = q / 2;
  m(2, 3) = m(3, 2) = r / 2;
  return {m};
}

/// A curve of seven points over [-10, 10] whose heights go along `up`.
TabulatedShape wave(Dice& dice, const Vec3& up, const Vec3& direction) {
  TabulatedShape s;
  s.direction = direction;
  for (const double x : {-10.0, -6.0, -3.0, 0.0, 3.0, 6.0, 10.0}) {
    s.points.push_back(Vec3(x, 0, 0) + dice.among(-0.5, 0.5) * up);
  }
  return s;
}

/// A mesh of 9 x 7 places whose heights go along `up`; `across` is the other way.
MeshShape hills(Dice& dice, const Vec3& up, const Vec3& across) {
  std::array<std::array<Vec3, 7>, 9> at;
  for (std::size_t x = 0; x < at.size(); ++x) {
    for (std::size_t y = 0; y < at[x].size(); ++y) {
      at[x][y] = Vec3(2.5 * static_cast<double>(x) - 10, 0, 0) +
                 (2.0 * static_cast<double>(y) - 6) * across + dice.among(-0.4, 0.4) * up;
    }
  }
  MeshShape mesh;
  for (std::size_t x = 0; x + 1 < at.size(); ++x) {
    for (std::size_t y = 0; y + 1 < at[x].size(); ++y) {
      mesh.triangles.push_back({at[x][y], at[x + 1][y], at[x + 1][y + 1]});
      mesh.triangles.push_back({at[x][y], at[x + 1][y + 1], at[x][y + 1]});
    }
  }
  return mesh;
}

/// Arcs to both sides of the third direction, whose radius, height, side and shoulder change along
/// the first.
PolyconicShape arch(Dice& dice, const std::array<Vec3, 3>& frame, const Vec3& origin) {
  const double r = dice.among(7, 20), half = dice.among(0.5, 0.9), grows = dice.among(-0.15, 0.15);
  const double sine = std::sin(half), cosine = std::cos(half);
  const double fall = r * sine * sine / cosine, share = cosine / (1 + cosine);
  const double height = dice.among(-1, 1), bow = dice.among(-1, 1), side = dice.among(-1, 1);
  return {frame,
          origin,
          dice.among(-0.2, 0.2),
          -10,
          20,
          {{{-r * sine, -grows * r * sine},
            {fall, grows * fall},
            {-r * sine, -grows * r * sine},
            {-fall, -grows * fall},
            {r * sine, grows * r * sine + height, bow},
            {r * cosine - r, side},
            {0.5 * (1 + share), dice.among(-0.04, 0.04)}}}};
}

/// Two arcs over x whose heights go along `up`, joined along `across`; `middle` is between them.
RuledShape ruled(Dice& dice, const Vec3& up, const Vec3& across, const Vec3& middle) {
  RuledShape s;
  for (std::size_t i = 0; i < 2; ++i) {
    const double radius = dice.among(5, 8);
    const Vec3 foot = middle + (i == 0 ? -4.0 : 4.0) * across;
    s.carriers[i] = {foot - radius * up, across, radius};
    s.points[i] = {Vec3(foot - 2 * up - Vec3(4.5, 0, 0)), Vec3(foot - 2 * up + Vec3(4.5, 0, 0)),
                   Vec3(foot + 2 * up)};
  }
  return s;
}

constexpr double level = 0.5;  ///< surfaces lie by up to this off the axes

Shape roundPart(std::string_view kind, double z, Dice& dice) {
  const auto u = [&](double low, double high) { return dice.among(low, high); };
  const bool hollow = dice.chance(0.3);
  if (kind == "sphere") {
    const double radius = hollow ? u(9, 20) : u(7, 20);
    return SphereShape{Vec3{u(-1, 1), u(-1, 1), hollow ? z + radius : z - radius}, radius};
  }
  if (kind == "cylinder") {
    const double radius = hollow ? u(8, 16) : u(6, 12), turn = u(0, std::numbers::pi);
    return CylinderShape{Vec3(0, 0, hollow ? z + radius : z - radius),
                         Vec3(std::cos(turn), std::sin(turn), u(-0.1, 0.1)), radius};
  }
  if (kind == "cone") {
    return ConeShape{Vec3{u(-25, -15), u(-0.5, 0.5), z - 2}, Vec3::UnitX(), u(8, 20)};
  }
  return TorusShape{Vec3{u(-1, 1), u(-9, -7), z - 3}, Vec3{0, u(-0.1, 0.1), 1}, u(7, 9), 3.0};
}

Shape quadricPart(double z, Dice& dice) {
  const auto u = [&](double low, double high) { return dice.among(low, high); };
  switch (dice.below(4)) {
    case 0:  // ellipsoid
      return quadric({u(0.01, 0.03), u(0.03, 0.1), u(0.1, 0.4), 0, 0, 0, 0, -1});
    case 1:  // saddle
      return quadric({u(0.01, 0.04), u(-0.04, -0.01), 0, 0, 0, 0, 1, z});
    case 2:  // bowl
      return quadric({u(0.01, 0.05), u(0.01, 0.05), 0, u(-0.01, 0.01), u(-0.1, 0.1), 0, -1, z});
    default:  // elliptic cylinder along y
      return quadric({u(0.005, 0.02), 0, u(0.1, 0.4), 0, 0, 0, 0, -1});
  }
}

Shape roundDrive(std::string_view kind, double y, Dice& dice) {
  const auto u = [&](double low, double high) { return dice.among(low, high); };
  if (kind == "sphere") {
    const double radius = u(10, 20);
    return SphereShape{Vec3{u(-1, 1), y - radius, u(-1, 1)}, radius};
  }
  if (kind == "cylinder") {
    const double radius = u(8, 20), side = dice.chance(0.3) ? 1 : -1;
    const double lean = dice.chance(0.3) ? 0.0 : 0.1;
    return CylinderShape{Vec3{u(-1, 1), y + side * radius, 0},
                         Vec3{u(-lean, lean), u(-lean, lean), 1}, radius};
  }
  if (kind == "cone") {
    return ConeShape{Vec3{u(-1, 1), y - 14, 40}, -Vec3::UnitZ(), u(15, 20)};
  }
  return TorusShape{Vec3{u(-1, 1), y - 12, u(-1, 1)}, Vec3{u(-0.1, 0.1), u(-0.1, 0.1), 1}, u(9, 10),
                    2.5};
}

Shape quadricDrive(Dice& dice) {
  const auto u = [&](double low, double high) { return dice.among(low, high); };
  switch (dice.below(3)) {
    case 0:
      return quadric({u(0.005, 0.01), 1, u(0.001, 0.01), 0, 0, u(3, 6), 0, u(-1, 1)});
    case 1: {  // elliptic cylinder along z, as ELLIPS makes
      const double a = u(8, 14), b = u(4, 8), y = u(-level, level) - b;
      return quadric({1 / (a * a), 1 / (b * b), 0, 0, 0, -2 * y / (b * b), 0, y * y / (b * b) - 1});
    }
    default: {  // hyperbolic cylinder along z, as HYPERB makes
      const double a = u(2, 4), b = u(5, 9), y = u(-level, level) + a;
      return quadric(
          {-1 / (b * b), 1 / (a * a), 0, 0, 0, -2 * y / (a * a), 0, y * y / (a * a) - 1});
    }
  }
}
}  // namespace

Shape partSurface(std::size_t index, Dice& dice) {
  const std::string_view kind = kinds[index];
  const double z = dice.among(-level, level);
  if (kind == "plane") {
    return PlaneShape{Vec3{dice.among(-0.3, 0.3), dice.among(-0.3, 0.3), 1}, z};
  }
  if (kind == "quadric") {
    return quadricPart(z, dice);
  }
  if (kind == "tabcyl") {
    const double lean = dice.chance(0.5) ? 0.3 : 0.0;
    return wave(dice, Vec3::UnitZ(), Vec3{dice.among(-lean, lean), 1, dice.among(-lean, lean)});
  }
  if (kind == "ruled") {
    return ruled(dice, Vec3::UnitZ(), Vec3::UnitY(), Vec3(0, 0, z));
  }
  if (kind == "polyconic") {
    return arch(dice, {Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()}, Vec3(0, 0, z));
  }
  if (kind == "mesh") {
    return hills(dice, Vec3::UnitZ(), Vec3::UnitY());
  }
  return roundPart(kind, z, dice);
}

Shape driveSurface(std::size_t index, Dice& dice) {
  const std::string_view kind = kinds[index];
  const double y = dice.among(-level, level);
  if (kind == "plane") {
    const double lean = dice.chance(0.3) ? 0.0 : 0.2;
    return PlaneShape{Vec3{dice.among(-0.3, 0.3), 1, dice.among(-lean, lean)}, y};
  }
  if (kind == "quadric") {
    return quadricDrive(dice);
  }
  if (kind == "tabcyl") {
    const double lean = dice.chance(0.5) ? 0.2 : 0.0;
    return wave(dice, Vec3::UnitY(), Vec3{dice.among(-lean, lean), dice.among(-lean, lean), 1});
  }
  if (kind == "ruled") {
    return ruled(dice, Vec3::UnitY(), Vec3::UnitZ(), Vec3(0, y, 0));
  }
  if (kind == "polyconic") {
    return arch(dice, {Vec3::UnitZ(), Vec3::UnitX(), Vec3::UnitY()}, Vec3(0, y, 0));
  }
  if (kind == "mesh") {
    return hills(dice, Vec3::UnitY(), Vec3::UnitZ());
  }
  return roundDrive(kind, y, dice);
}

Shape checkSurface(Dice& dice) {
  const auto u = [&](double low, double high) { return dice.among(low, high); };
  switch (dice.below(5)) {
    case 0:
    case 1:
      return PlaneShape{Vec3{1, u(-0.2, 0.2), u(-0.2, 0.2)}, u(3.5, 5)};
    case 2:
      return SphereShape{Vec3{u(5, 7), u(-0.5, 0.5), u(-0.5, 1)}, u(1.5, 2.5)};
    case 3:
      return CylinderShape{Vec3{u(5, 7), u(-0.5, 0.5), 0}, Vec3{u(-0.2, 0.2), u(-0.2, 0.2), 1},
                           u(1.5, 2.5)};
    default:
      return ConeShape{Vec3{u(6, 7), u(-0.5, 0.5), 10}, Vec3{u(-0.1, 0.1), u(-0.1, 0.1), -1},
                       u(8, 14)};
  }
}

}  // namespace arelem::scenes
