#include "backend/svg/solid.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "backend/svg/path_drawer.h"

namespace arelem::backend::svg {

namespace {
constexpr double frame = 0.08;     // of the box, free on each side
constexpr double axisLength = 24;  // pixels of a unit vector square to the view
constexpr double axisCorner = 34;  // pixels from the lower left corner of the box

/// Rows: to the right, up, and towards the eye at (1, -1, 1).
Eigen::Matrix3d isometric() {
  Eigen::Matrix3d m;
  m << 1, 1, 0, -1, 1, 2, 1, -1, 1;
  return m.rowwise().normalized();
}

void drawAxes(Canvas& canvas, const Box& box, const Eigen::Matrix3d& turn) {
  const Pixel origin{box.left + axisCorner, box.top + box.height - axisCorner};
  constexpr std::array<std::string_view, 3> names = {"X", "Y", "Z"};
  for (int k = 0; k < 3; ++k) {
    const Vec3 seen = turn.col(k);
    const Pixel tip{origin.x + axisLength * seen.x(), origin.y - axisLength * seen.y()};
    canvas.line(origin, tip, "class=\"scale\"");
    canvas.text(
        {origin.x + 1.35 * (tip.x - origin.x) - 3.5, origin.y + 1.35 * (tip.y - origin.y) + 4},
        names[static_cast<std::size_t>(k)], "class=\"soft\"");
  }
}
}  // namespace

void drawSolid(Canvas& canvas, const Box& box, const std::vector<Vertex>& path, int clipId) {
  const Eigen::Matrix3d turn = isometric();
  std::vector<Vertex> turned = path;
  Bounds bounds;
  for (Vertex& v : turned) {
    v.place = turn * v.place;
    v.about = -1;  // circles are seen as ellipses
    bounds.add(v.place);
  }
  canvas.text({box.left, box.top - 7}, "isometric, not to scale", "class=\"soft\"");
  canvas.rectangle(box, "class=\"frame\"");
  const Vec3 size = bounds.size();
  View view{"isometric", 0, 1, 2, box, 1, 0, 0};
  const double most = std::max(size.x() / box.width, size.y() / box.height);
  view.scale = most > 0.0 ? (1.0 - 2.0 * frame) / most : 1.0;
  const Vec3 middle = 0.5 * (bounds.low + bounds.high);
  view.left = middle.x() - 0.5 * box.width / view.scale;
  view.bottom = middle.y() - 0.5 * box.height / view.scale;
  canvas.beginClip(box, clipId);
  PathDrawer(canvas, view, turned).draw();
  drawAxes(canvas, box, turn);
  canvas.endGroup();
  if (!turned.empty()) {
    canvas.circle(view(turned.back().place), 5.5, "class=\"finish\"");
    canvas.circle(view(turned.front().place), 3.8, "class=\"begin\"");
  }
}

}  // namespace arelem::backend::svg
