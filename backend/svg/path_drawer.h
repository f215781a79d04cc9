#pragma once
#include <string_view>

#include "backend/svg/canvas.h"
#include "backend/svg/labels.h"
#include "backend/svg/path.h"

namespace arelem::backend::svg {

/// Draws a path in one view: each kind of move in its color, circles seen along their axis as true
/// arcs, arrows on long moves.
class PathDrawer {
 public:
  PathDrawer(Canvas& canvas, const View& view, const std::vector<Vertex>& path)
      : canvas_(canvas), view_(view), path_(path) {}

  void draw();
  /// Keeps names off the path.
  void reserve(Labels& labels) const;

 private:
  [[nodiscard]] bool isDense() const;
  void drawKind(MoveKind kind, std::string_view attributes);
  void drawArrows();
  /// The end of the run of locations from `i` on that lie on one circle seen along its axis.
  [[nodiscard]] std::size_t roundRun(std::size_t i, std::size_t end) const;
  /// Adds locations i to end - 1 as arcs; false when they do not go round evenly.
  bool addArc(std::size_t i, std::size_t end, std::vector<PathPiece>& pieces) const;

  Canvas& canvas_;
  const View& view_;
  const std::vector<Vertex>& path_;
};

}  // namespace arelem::backend::svg
