#pragma once
#include <map>
#include <string>

#include <Eigen/Geometry>

#include "runtime/region/drawing_curves.h"

namespace arelem::region {

/// Where the coordinates of a block lie in those of the drawing.
struct Placement {
  Eigen::Affine2d plane = Eigen::Affine2d::Identity();
  double zScale = 1.0, z = 0.0;
  double size = 1.0;  ///< the largest scale

  [[nodiscard]] double height(double inBlock) const { return zScale * inBlock + z; }
  /// That of a block whose own placement is in the coordinates of this.
  [[nodiscard]] Placement of(const Placement& inner) const;
};

/// A block: its base point and its entities.
struct DrawingBlock {
  double x = 0.0, y = 0.0, z = 0.0;
  std::vector<DrawingObject> entities;
};
using DrawingBlocks = std::map<std::string, DrawingBlock, std::less<>>;

/// The blocks among the objects of the section BLOCKS. Errors: E0367.
[[nodiscard]] Result<DrawingBlocks> blocksOf(const std::vector<DrawingObject>& objects,
                                             std::string_view name);

/// The rows and columns of an INSERT.
struct InsertedBlock {
  Placement first;             ///< of the block at the first row and column
  Vec2 column = Vec2::Zero();  ///< from one to the next
  Vec2 row = Vec2::Zero();
  double columns = 1.0, rows = 1.0;
  bool level = true;  ///< parallel to the xy plane, and of a scale that is not 0

  [[nodiscard]] Placement at(double i, double k) const;
};
/// Errors: E0367.
[[nodiscard]] Result<InsertedBlock> insertedBlock(const DrawingObject& insert,
                                                  const DrawingBlock& block,
                                                  std::string_view name);

}  // namespace arelem::region
