#include "runtime/region/drawing_blocks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "ir/space/tolerance.h"

namespace arelem::region {

namespace {
/// Values of groups, each with what holds where it is missing.
template <std::size_t n>
Result<std::array<double, n>> valuesOf(const DrawingObject& object,
                                       const std::array<std::pair<int, double>, n>& codes,
                                       std::string_view name) {
  std::array<double, n> values{};
  for (std::size_t i = 0; i < n; ++i) {
    values[i] = codes[i].second;
    for (const Group& group : object.groups) {
      if (group.code == codes[i].first) {
        const Result<double> value = numberOf(group, name);
        if (!value) {
          return value.failure();
        }
        values[i] = *value;
        break;
      }
    }
  }
  return values;
}
}  // namespace

Placement Placement::of(const Placement& inner) const {
  return {plane * inner.plane, zScale * inner.zScale, height(inner.z), size * inner.size};
}

Result<DrawingBlocks> blocksOf(const std::vector<DrawingObject>& objects, std::string_view name) {
  DrawingBlocks blocks;
  DrawingBlock* open = nullptr;
  for (const DrawingObject& object : objects) {
    if (object.name == "BLOCK") {
      const auto base = valuesOf<3>(object, {{{10, 0.0}, {20, 0.0}, {30, 0.0}}}, name);
      if (!base) {
        return base.failure();
      }
      open = &blocks[std::string(object.text(2))];
      *open = {(*base)[0], (*base)[1], (*base)[2], {}};
    } else if (object.name == "ENDBLK") {
      open = nullptr;
    } else if (open != nullptr) {
      open->entities.push_back(object);
    }
  }
  return blocks;
}

Placement InsertedBlock::at(double i, double k) const {
  Placement result = first;
  result.plane.pretranslate(i * column + k * row);
  return result;
}

Result<InsertedBlock> insertedBlock(const DrawingObject& insert,
                                    const DrawingBlock& block,
                                    std::string_view name) {
  const auto values = valuesOf<12>(insert,
                                   {{{10, 0.0},
                                     {20, 0.0},
                                     {30, 0.0},
                                     {41, 1.0},
                                     {42, 1.0},
                                     {43, 1.0},
                                     {50, 0.0},
                                     {70, 1.0},
                                     {71, 1.0},
                                     {44, 0.0},
                                     {45, 0.0},
                                     {230, 1.0}}},
                                   name);
  if (!values) {
    return values.failure();
  }
  const auto& [x, y, z, sx, sy, sz, degrees, columns, rows, columnStep, rowStep, up] = *values;
  InsertedBlock result;
  result.level = std::abs(std::abs(up) - 1.0) <= tolerance::similarity && sx != 0.0 && sy != 0.0;
  // On the back of the plane x is turned round, and z.
  const Eigen::Vector2d side(up < 0.0 ? -1.0 : 1.0, 1.0);
  const Eigen::Rotation2Dd turn(degrees * std::numbers::pi / 180.0);
  result.first.plane = Eigen::Scaling(side) * Eigen::Translation2d(x, y) * turn *
                       Eigen::Scaling(sx, sy) * Eigen::Translation2d(-block.x, -block.y);
  result.first.zScale = side.x() * sz;
  result.first.z = side.x() * (z - sz * block.z);
  result.first.size = std::max(std::abs(sx), std::abs(sy));
  result.column = side.cwiseProduct(turn * Vec2(columnStep, 0.0));
  result.row = side.cwiseProduct(turn * Vec2(0.0, rowStep));
  result.columns = std::max(1.0, std::floor(columns));
  result.rows = std::max(1.0, std::floor(rows));
  return result;
}

}  // namespace arelem::region
