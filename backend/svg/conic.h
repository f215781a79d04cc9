#pragma once
#include <vector>

#include "backend/svg/view.h"

/// Curves that are not lines or circles, as pieces to draw.
namespace arelem::backend::svg {

struct Segment {
  Pixel from, to;
};

/// The conic a x² + b y² + d + 2h xy + 2p x + 2q y = 0 (canonical numbers a b c d f g h p q r)
/// inside an XY view: where it crosses the cells of a grid of about four pixels.
[[nodiscard]] std::vector<Segment> conicInView(const std::vector<double>& canon, const View& view);

/// The curve of a TABCYL whose generatrix is the coordinate axis `depth`, without its straight
/// extensions; empty for another generatrix. Layout of the numbers: see ir/geometry/entity.h.
[[nodiscard]] std::vector<Vec3> tabulatedCurve(const std::vector<double>& canon, int depth);

}  // namespace arelem::backend::svg
