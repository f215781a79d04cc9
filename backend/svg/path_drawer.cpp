#include "backend/svg/path_drawer.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace arelem::backend::svg {

namespace {
constexpr std::size_t mostArrows = 12;
constexpr double arrowSegment = 36.0;  // pixels a segment needs for an arrow
constexpr double arrowGap = 28.0;      // pixels between two arrows
/// Where more pixels of path than this stand on a pixel of the view, lines are drawn thin.
constexpr double dense = 0.08;
constexpr double mostSweep = 0.75 * std::numbers::pi;  // of one arc element
constexpr double roundness = 0.3;      // pixels by which locations may lie beside their arc
constexpr double largestRadius = 2e4;  // pixels; beyond, a chord shows the same
constexpr double fullTurn = 2.0 * std::numbers::pi;

std::string_view nameOf(MoveKind kind) {
  switch (kind) {
    case MoveKind::rapid:
      return "rapid";
    case MoveKind::gun:
      return "gun";
    case MoveKind::arc:
      return "arc";
    default:
      return "feed";
  }
}

double distance(const Pixel& a, const Pixel& b) {
  return std::hypot(b.x - a.x, b.y - a.y);
}
}  // namespace

bool PathDrawer::isDense() const {
  double length = 0.0;
  for (std::size_t i = 1; i < path_.size(); ++i) {
    length += path_[i].kind == MoveKind::start
                  ? 0.0
                  : distance(view_(path_[i - 1].place), view_(path_[i].place));
  }
  return length > dense * view_.box.width * view_.box.height;
}

void PathDrawer::draw() {
  const bool thin = isDense();
  for (const MoveKind kind : {MoveKind::rapid, MoveKind::feed, MoveKind::arc, MoveKind::gun}) {
    drawKind(kind, fmt::format("class=\"{}{}\"", nameOf(kind), thin ? " thin" : ""));
  }
  drawArrows();
}

void PathDrawer::drawKind(MoveKind kind, std::string_view attributes) {
  for (std::size_t i = 1; i < path_.size();) {
    if (path_[i].kind != kind) {
      ++i;
      continue;
    }
    std::vector<PathPiece> pieces = {{view_(path_[i - 1].place), 0.0, false}};
    std::size_t end = i;
    while (end < path_.size() && path_[end].kind == kind) {
      ++end;
    }
    while (i < end) {
      const std::size_t run = roundRun(i, end);
      if (run > i && addArc(i, run, pieces)) {
        i = run;
        continue;
      }
      for (const std::size_t stop = std::max(run, i + 1); i < stop; ++i) {
        const Pixel p = view_(path_[i].place);
        if (p.x != pieces.back().to.x || p.y != pieces.back().to.y) {
          pieces.push_back({p, 0.0, false});
        }
      }
    }
    if (pieces.size() > 1) {
      canvas_.curve(pieces, attributes);
    }
  }
}

std::size_t PathDrawer::roundRun(std::size_t i, std::size_t end) const {
  std::size_t run = i;
  while (run < end && path_[run].about == view_.depth && path_[run].center == path_[i].center) {
    ++run;
  }
  return run;
}

bool PathDrawer::addArc(std::size_t i, std::size_t end, std::vector<PathPiece>& pieces) const {
  const Pixel center = view_(path_[i].center);
  const auto radiusOf = [&](const Vertex& v) { return distance(view_(v.place), center); };
  const double radius = radiusOf(path_[end - 1]);
  if (!(radius > 1.0) || radius > largestRadius) {
    return false;
  }
  // A startup comes to the circle from elsewhere: its own way there is straight.
  const bool comes = std::abs(radiusOf(path_[i - 1]) - radius) > roundness;
  const std::size_t first = comes ? i : i - 1;
  double sweep = 0.0;
  double most = 0.0;
  for (std::size_t k = first + 1; k < end; ++k) {
    const Pixel a = view_(path_[k - 1].place);
    const Pixel b = view_(path_[k].place);
    const double turn = std::remainder(
        std::atan2(b.y - center.y, b.x - center.x) - std::atan2(a.y - center.y, a.x - center.x),
        fullTurn);
    if (std::abs(radiusOf(path_[k]) - radius) > roundness || turn * sweep < -1e-9) {
      return false;
    }
    sweep += turn;
    most = std::max(most, std::abs(turn));
  }
  if (most > mostSweep || sweep == 0.0) {  // coarse chords do not tell which way round they go
    return false;
  }
  const Pixel start = view_(path_[first].place);
  if (comes) {
    pieces.push_back({start, 0.0, false});
  }
  const double from = std::atan2(start.y - center.y, start.x - center.x);
  const int count = static_cast<int>(std::ceil(std::abs(sweep) / mostSweep));
  for (int k = 1; k < count; ++k) {
    const double angle = from + sweep * k / count;
    pieces.push_back({{center.x + radius * std::cos(angle), center.y + radius * std::sin(angle)},
                      radius,
                      sweep > 0.0});
  }
  pieces.push_back({view_(path_[end - 1].place), radius, sweep > 0.0});
  return true;
}

/// On the longest moves, in their middle, where no other arrow is near.
void PathDrawer::drawArrows() {
  std::vector<std::pair<double, std::size_t>> longest;
  for (std::size_t i = 1; i < path_.size(); ++i) {
    const double length = distance(view_(path_[i - 1].place), view_(path_[i].place));
    const bool cuts = path_[i].kind == MoveKind::feed || path_[i].kind == MoveKind::gun;
    if (cuts && length >= arrowSegment) {
      longest.emplace_back(-length, i);
    }
  }
  std::sort(longest.begin(), longest.end());
  std::vector<Pixel> taken;
  for (const auto& [length, i] : longest) {
    const Pixel a = view_(path_[i - 1].place);
    const Pixel b = view_(path_[i].place);
    const Pixel middle{0.5 * (a.x + b.x), 0.5 * (a.y + b.y)};
    const bool near = std::any_of(taken.begin(), taken.end(),
                                  [&](const Pixel& p) { return distance(p, middle) < arrowGap; });
    if (near || taken.size() >= mostArrows) {
      continue;
    }
    taken.push_back(middle);
    const Eigen::Vector2d along = Eigen::Vector2d(b.x - a.x, b.y - a.y) / -length;
    const Eigen::Vector2d side(-along.y(), along.x());
    const Eigen::Vector2d tip = Eigen::Vector2d(middle.x, middle.y) + 5.0 * along;
    const Eigen::Vector2d left = tip - 9.0 * along + 3.5 * side;
    const Eigen::Vector2d right = tip - 9.0 * along - 3.5 * side;
    canvas_.polyline({{tip.x(), tip.y()}, {left.x(), left.y()}, {right.x(), right.y()}},
                     path_[i].kind == MoveKind::gun ? "class=\"arrow on\"" : "class=\"arrow\"");
  }
}

void PathDrawer::reserve(Labels& labels) const {
  constexpr double dot = 6.0;  // about the radius of the marks of start and end
  for (const Vertex* v :
       {path_.empty() ? nullptr : &path_.front(), path_.empty() ? nullptr : &path_.back()}) {
    if (v != nullptr) {
      const Pixel p = view_(v->place);
      for (const double y : {-dot, -0.5 * dot, 0.0, 0.5 * dot, dot}) {
        labels.avoid({p.x - dot, p.y + y}, {p.x + dot, p.y + y}, Labels::Line::path);
      }
    }
  }
  for (std::size_t i = 1; i < path_.size(); ++i) {
    if (path_[i].kind != MoveKind::start) {
      labels.avoid(view_(path_[i - 1].place), view_(path_[i].place), Labels::Line::path);
    }
  }
}

}  // namespace arelem::backend::svg
