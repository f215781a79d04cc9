#include "runtime/stencil/edge.h"

#include <algorithm>

#include "runtime/geometry/angle.h"

namespace arelem::stencil {

namespace {
struct At {
  double t;

  Vec2 operator()(const LinePiece& line) const { return line.from + t * (line.to - line.from); }
  Vec2 operator()(const SplinePiece& spline) const {
    const auto& p = spline.control;
    const double t2 = t * t;
    const double t3 = t2 * t;
    return (-t3 + 2.0 * t2 - t) * p[0] + (t3 - 2.0 * t2 + 1.0) * p[1] + (-t3 + t2 + t) * p[2] +
           (t3 - t2) * p[3];
  }
  Vec2 operator()(const ArcPiece& arc) const {
    const auto [s, c] = geometry::sinCosDegrees(arc.start + t * (arc.end - arc.start));
    return arc.center + Vec2(arc.radii.x() * c, arc.radii.y() * s);
  }
};
}  // namespace

Vec2 pointOf(const Piece& piece, double t) {
  return std::visit(At{t}, piece);
}

Vec2 firstPoint(const Edge& edge) {
  return pointOf(edge.pieces.front(), 0.0);
}

Vec2 lastPoint(const Edge& edge) {
  return pointOf(edge.pieces.back(), 1.0);
}

Measured::Measured(const Edge& edge) : pieces_(edge.pieces) {
  samples_.emplace_back();
  length_.push_back(0.0);
  for (std::size_t k = 0; k < pieces_.size(); ++k) {
    const bool line = std::holds_alternative<LinePiece>(pieces_[k]);
    const int count = line ? 1 : samplesOfACurve;
    for (int i = 0; i < count; ++i) {
      const double from = static_cast<double>(i) / count;
      const double to = static_cast<double>(i + 1) / count;
      const Vec2 a = pointOf(pieces_[k], from);
      const Vec2 m = pointOf(pieces_[k], 0.5 * (from + to));
      const Vec2 b = pointOf(pieces_[k], to);
      // One step of Richardson: the length between two points to the fifth order of their distance.
      const double arc = (4.0 * ((m - a).norm() + (b - m).norm()) - (b - a).norm()) / 3.0;
      length_.push_back(length_.back() + arc);
      samples_.push_back({k, from, to});
    }
  }
}

Vec2 Measured::at(double share) const {
  const double wanted = std::clamp(share, 0.0, 1.0) * length();
  const auto next = std::lower_bound(length_.begin() + 1, length_.end() - 1, wanted);
  const auto i = static_cast<std::size_t>(next - length_.begin());
  const double step = length_[i] - length_[i - 1];
  const double t = step > 0.0 ? (wanted - length_[i - 1]) / step : 0.0;
  const Sample& sample = samples_[i];
  return pointOf(pieces_[sample.piece], sample.from + t * (sample.to - sample.from));
}

}  // namespace arelem::stencil
