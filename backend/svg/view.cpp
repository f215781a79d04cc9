#include "backend/svg/view.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ir/space/picture_tolerance.h"

namespace arelem::backend::svg {

namespace {
constexpr double pageWidth = 800.0;
constexpr double margin = 24.0;
constexpr double titleHeight = 68.0;
constexpr double gap = 40.0;           // between views; holds their captions
constexpr double legendHeight = 92.0;  // in three columns of four rows
constexpr double narrowest = 210.0;    // of the corner that shows the path at an angle
constexpr double lowest = 170.0;
constexpr double tallestDrawing = 900.0;
constexpr double smallestCell = 60.0;

View xy() {
  return {"XY", 0, 1, 2, {}, 1, 0, 0};
}
View xz() {
  return {"XZ", 0, 2, 1, {}, 1, 0, 0};
}
View yz() {
  return {"YZ", 1, 2, 0, {}, 1, 0, 0};
}

/// The only view of a flat path, or nothing.
std::optional<View> planeOf(const Bounds& path) {
  const Vec3 size = path.size();
  const double thin = tolerance::flatPath * size.maxCoeff();
  if (size.z() <= thin) {
    return xy();
  }
  if (size.y() <= thin) {
    return xz();
  }
  return size.x() <= thin ? std::optional(yz()) : std::nullopt;
}

std::optional<View> asked(PictureViews views) {
  switch (views) {
    case PictureViews::plan:
      return xy();
    case PictureViews::front:
      return xz();
    case PictureViews::side:
      return yz();
    default:
      return std::nullopt;
  }
}

/// Centers what is to be seen in the view's box.
void center(View& view, const Bounds& bounds, double scale) {
  view.scale = scale;
  const double a = 0.5 * (bounds.low[view.across] + bounds.high[view.across]);
  const double u = 0.5 * (bounds.low[view.up] + bounds.high[view.up]);
  view.left = a - 0.5 * view.box.width / scale;
  view.bottom = u - 0.5 * view.box.height / scale;
}

Layout single(View view, const Bounds& bounds) {
  Layout page;
  const Vec3 size = bounds.size();
  const double width = pageWidth - 2 * margin;
  const double tall = tallestDrawing - legendHeight;
  const double scale = std::min(width / size[view.across], tall / size[view.up]);
  const double height = std::max(size[view.up] * scale, 2 * smallestCell);
  view.box = {margin, titleHeight + margin, width, height};
  center(view, bounds, scale);
  page.legend = {margin, view.box.top + height + 0.4 * gap, width, legendHeight};
  page.height = page.legend.top + legendHeight;
  page.views = {view};
  return page;
}

Layout three(const Bounds& bounds) {
  Layout page;
  const Vec3 size = bounds.size();
  const double width = pageWidth - 2 * margin - gap;
  // Both columns and both rows must fit.
  double scale = std::min(width / (size.x() + size.y()), tallestDrawing / (size.y() + size.z()));
  if (size.y() * scale < narrowest) {
    scale = std::min(scale, (width - narrowest) / size.x());
  }
  const double left = std::min(std::max(size.x() * scale, smallestCell), width - narrowest);
  const double right = width - left;
  const double upper = std::max(size.y() * scale, lowest);
  const double lower = std::max(size.z() * scale, smallestCell);
  const double top = titleHeight + margin;
  page.views = {xy(), xz(), yz()};
  page.views[0].box = {margin, top, left, upper};
  page.views[1].box = {margin, top + upper + gap, left, lower};
  page.views[2].box = {margin + left + gap, top + upper + gap, right, lower};
  for (View& view : page.views) {
    center(view, bounds, scale);
  }
  page.solid = Box{margin + left + gap, top, right, upper};
  page.legend = {margin, top + upper + gap + lower + 0.4 * gap, width + gap, legendHeight};
  page.height = page.legend.top + legendHeight;
  return page;
}
}  // namespace

std::optional<std::array<Eigen::Vector2d, 2>> View::clip(double a, double b, double d) const {
  const double square = a * a + b * b;
  if (!(square > 0.0) || !std::isfinite(square) || !std::isfinite(d)) {
    return std::nullopt;
  }
  const Eigen::Vector2d foot(a * d / square, b * d / square);
  const Eigen::Vector2d along(-b, a);
  const Eigen::Vector2d low(left, bottom);
  const Eigen::Vector2d high(right(), top());
  double from = -std::numeric_limits<double>::infinity();
  double to = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 2; ++i) {
    if (along[i] == 0.0) {
      if (foot[i] < low[i] || foot[i] > high[i]) {
        return std::nullopt;
      }
      continue;
    }
    const double t1 = (low[i] - foot[i]) / along[i];
    const double t2 = (high[i] - foot[i]) / along[i];
    from = std::max(from, std::min(t1, t2));
    to = std::min(to, std::max(t1, t2));
  }
  if (!(from < to)) {
    return std::nullopt;
  }
  return std::array{Eigen::Vector2d(foot + from * along), Eigen::Vector2d(foot + to * along)};
}

Layout arrange(const Bounds& path, const Bounds& bounds, PictureViews views) {
  // A box without size still gets a picture: one unit wide.
  Bounds seen = bounds;
  const double least =
      std::max(1e-3 * bounds.size().maxCoeff(), bounds.size().maxCoeff() > 0.0 ? 0.0 : 1.0);
  for (int i = 0; i < 3; ++i) {
    const double missing = 0.5 * std::max(0.0, least - (seen.high[i] - seen.low[i]));
    seen.low[i] -= missing;
    seen.high[i] += missing;
  }
  const auto plane = views == PictureViews::automatic ? planeOf(path) : asked(views);
  return plane ? single(*plane, seen) : three(seen);
}

}  // namespace arelem::backend::svg
