#pragma once
#include "backend/svg/canvas.h"
#include "backend/svg/path.h"

namespace arelem::backend::svg {

/// Draws the path as it is seen from the front, right and above (isometric), as large as the box
/// allows, with the directions of the axes.
void drawSolid(Canvas& canvas, const Box& box, const std::vector<Vertex>& path, int clipId);

}  // namespace arelem::backend::svg
