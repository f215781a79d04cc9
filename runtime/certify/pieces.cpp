#include "runtime/certify/body_search.h"

namespace arelem::certify {

double Piece::least(double x, double y, double from, double to) const {
  const tool::ProfilePoint p = at(from);
  const tool::ProfilePoint q = at(to);
  const double ends = std::min(x * p.rho + y * p.z, x * q.rho + y * q.z);
  if (radius == 0.0) {
    return ends;
  }
  // radius (x sin t - y cos t) is least where (sin t, -cos t) points against (x, y).
  const double lowest = std::atan2(-x, y);
  const double start = low + from * (high - low);
  const double stop = low + to * (high - low);
  const bool inside = lowest >= start && lowest <= stop;
  return inside ? x * a.rho + y * a.z - radius * std::hypot(x, y) : ends;
}

double leastOfTurn(double first, double second, const Turn& half) {
  // first - (first cos x - second sin x): least where the turn in brackets points along it, if that
  // is within, else at an end.
  const double size = std::hypot(first, second);
  if (first >= size * half.cosine) {
    return first > 0.0 ? -second * second / (first + size) : first - size;
  }
  const double sine = half.sine;
  const double bulge = sine * sine / (1.0 + half.cosine);
  return first * bulge - std::abs(second) * sine;
}

std::vector<Piece> piecesOf(const tool::Profile& cutter) {
  std::vector<Piece> pieces;
  const tool::ProfilePoint corner{cutter.e, cutter.f};
  if (cutter.ring) {
    pieces.push_back({corner, corner});
    return pieces;
  }
  const auto addLine = [&](tool::ProfilePoint a, tool::ProfilePoint b) {
    if (std::hypot(b.rho - a.rho, b.z - a.z) > 0.0) {
      pieces.push_back({a, b});
    }
  };
  // The whole ball of the corner lies within the cutter, unless it reaches the top: the face there
  // does not cut.
  if (cutter.r > 0.0 && cutter.h <= cutter.f + cutter.r) {
    Piece arc{corner, corner};
    arc.radius = cutter.r;
    arc.low = cutter.alpha;
    arc.high = std::atan2(cutter.cosBeta, cutter.sinBeta);
    pieces.push_back(arc);
  } else {
    pieces.push_back({corner, corner, cutter.r});
  }
  addLine({0.0, 0.0}, cutter.bottomEnd);
  addLine(cutter.sideStart, cutter.sideEnd);
  return pieces;
}

}  // namespace arelem::certify
