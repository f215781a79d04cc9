#include "runtime/tool/profile.h"

#include <cmath>
#include <numbers>

#include "ir/diag/motion.h"
#include "runtime/tool/profile_check.h"
#include "runtime/tool/rounded.h"

namespace arelem::tool {

namespace {
constexpr double degree = std::numbers::pi / 180.0;
/// The old system's least height of a cutter given by one or two values. Part unit.
constexpr double defaultHeight = 5.0;

/// Lengths of the size of a tool need no std::hypot, which takes longer than all else here.
double lengthOf(double x, double z) {
  return std::sqrt(x * x + z * z);
}

double apart(ProfilePoint a, ProfilePoint b) {
  return lengthOf(a.rho - b.rho, a.z - b.z);
}

/// True where the direction (dx, dz) from the corner center points out of the arc, not of a line.
bool insideArc(const Profile& p, double dx, double dz, double length) {
  return dx >= p.sinAlpha * length && -dz >= p.sinBeta * length && -dz <= p.cosAlpha * length;
}

/// Keeps the nearest candidate.
struct Nearest {
  ProfilePoint from;
  double distance;
  ProfilePoint point;

  void consider(ProfilePoint q) {
    const double d = apart(from, q);
    if (d < distance) {
      distance = d;
      point = q;
    }
  }
  void considerLine(ProfilePoint a, ProfilePoint b) {
    consider(a);
    consider(b);
    const double span = apart(a, b);
    if (span <= 0.0) {
      return;
    }
    const double s =
        ((from.rho - a.rho) * (b.rho - a.rho) + (from.z - a.z) * (b.z - a.z)) / (span * span);
    if (s > 0.0 && s < 1.0) {
      consider({a.rho + s * (b.rho - a.rho), a.z + s * (b.z - a.z)});
    }
  }
};
}  // namespace

void completeProfile(Profile& p) {
  p.sinAlpha = std::sin(p.alpha);
  p.cosAlpha = std::cos(p.alpha);
  p.sinBeta = std::sin(p.beta);
  p.cosBeta = std::cos(p.beta);
  p.bottomEnd = {p.e + p.r * p.sinAlpha, p.f - p.r * p.cosAlpha};
  p.sideStart = {p.e + p.r * p.cosBeta, p.f - p.r * p.sinBeta};
  p.sideEnd = {p.d / 2 + std::tan(p.beta) * (p.h - p.d / 2 * std::tan(p.alpha)), p.h};
}

Result<Profile> makeProfile(std::span<const double> values) {
  Profile p;
  p.d = values[0];
  p.r = values.size() > 1 ? values[1] : 0.0;
  if (values.size() == 7) {
    p.e = values[2];
    p.f = values[3];
    p.alpha = values[4] * degree;
    p.beta = values[5] * degree;
    p.h = values[6];
  }
  const bool noCorner = p.e == 0.0 && p.f == 0.0;
  if (values.size() < 7 || (noCorner && p.alpha == 0.0 && p.beta == 0.0)) {
    p.e = p.d / 2 - p.r;
    p.f = p.r;
  } else if (noCorner) {
    const ProfilePoint center = cornerCenter(p);
    p.e = center.rho;
    p.f = center.z;
  }
  if (auto bad = rangeFault(p)) {
    return *std::move(bad);
  }
  p.e = std::max(p.e, 0.0);
  // CUTTER/0 is a point; with a height it is a line.
  const bool isPoint = p.isPoint() && values.size() < 7;
  if (p.h == 0.0 && !isPoint) {
    p.h = std::max(defaultHeight, p.r);
  }
  completeProfile(p);
  return p;
}

Profile makeRing(double radius, double height) {
  Profile p;
  p.d = 2 * radius;
  p.e = radius;
  p.f = height;
  p.h = height;
  p.ring = true;
  completeProfile(p);
  p.sideEnd = p.sideStart;
  return p;
}

ProfilePoint reachPoint(const Profile& p, double nz) {
  if (p.ring) {
    return {p.e, p.f};
  }
  const double across = std::sqrt(std::max(0.0, 1.0 - nz * nz));
  const auto toward = [&](ProfilePoint q) { return q.rho * across - q.z * nz; };
  ProfilePoint best{0.0, 0.0};
  const auto consider = [&](ProfilePoint q) { best = toward(q) > toward(best) ? q : best; };
  if (nz <= p.cosAlpha && nz >= p.sinBeta) {
    consider({p.e + p.r * across, p.f - p.r * nz});
  } else {
    consider(p.bottomEnd);
    consider(p.sideStart);
  }
  consider(p.sideEnd);
  return best;
}

double reach(const Profile& p, double nz) {
  const double across = std::sqrt(std::max(0.0, 1.0 - nz * nz));
  const auto toward = [&](ProfilePoint q) { return q.rho * across - q.z * nz; };
  if (p.ring) {
    return toward({p.e, p.f});
  }
  const bool onArc = nz <= p.cosAlpha && nz >= p.sinBeta;
  const double corner =
      onArc ? toward({p.e, p.f}) + p.r : std::max(toward(p.bottomEnd), toward(p.sideStart));
  return std::max({0.0, corner, toward(p.sideEnd)});
}

double distanceTo(const Profile& p, ProfilePoint c, ProfilePoint& nearest) {
  if (p.ring) {
    nearest = {p.e, p.f};
    return apart(c, nearest);
  }
  const double dx = c.rho - p.e;
  const double dz = c.z - p.f;
  const double length = lengthOf(dx, dz);
  const bool towardArc = insideArc(p, dx, dz, length);
  if (towardArc && isRounded(p) && length > 0.0) {
    const double share = p.r / length;
    nearest = {p.e + share * dx, p.f + share * dz};
    return length - p.r;
  }
  if (p.alpha == 0.0 && c.z <= 0.0 && c.rho <= p.bottomEnd.rho && isRounded(p)) {
    nearest = {c.rho, 0.0};
    return -c.z;
  }
  Nearest best{c, apart(c, {0.0, 0.0}), {0.0, 0.0}};
  best.considerLine({0.0, 0.0}, p.bottomEnd);
  best.considerLine(p.sideStart, p.sideEnd);
  if (p.r > 0.0 && length > 0.0 && towardArc) {
    best.consider({p.e + p.r * dx / length, p.f + p.r * dz / length});
  }
  nearest = best.point;
  const bool aboveBottom = c.z * p.cosAlpha - c.rho * p.sinAlpha > 0.0;
  const bool withinSide =
      (c.rho - p.sideStart.rho) * p.cosBeta - (c.z - p.sideStart.z) * p.sinBeta < 0.0;
  const bool withinArc = !towardArc || length < p.r;
  return aboveBottom && withinSide && withinArc && c.z < p.h ? -best.distance : best.distance;
}

double distanceUnderTop(const Profile& p, ProfilePoint c, ProfilePoint& nearest) {
  const double distance = distanceTo(p, c, nearest);
  const double above = c.z - p.h;
  if (p.ring || above >= 0.0 || above <= distance) {
    return distance;
  }
  nearest = {c.rho, p.h};
  return above;
}

double farthestFrom(const Profile& p, ProfilePoint c, ProfilePoint& farthest) {
  double best = -1.0;
  const auto consider = [&](ProfilePoint q) {
    const double distance = lengthOf(q.rho + c.rho, q.z - c.z);
    if (distance > best) {
      best = distance;
      farthest = q;
    }
  };
  if (p.ring) {
    consider({p.e, p.f});
    return best;
  }
  consider({0.0, 0.0});
  consider(p.bottomEnd);
  consider(p.sideStart);
  consider(p.sideEnd);
  const double dx = p.e + c.rho;
  const double dz = p.f - c.z;
  const double length = lengthOf(dx, dz);
  if (p.r > 0.0 && length > 0.0 && insideArc(p, dx, dz, length)) {
    consider({p.e + p.r * dx / length, p.f + p.r * dz / length});
  }
  return best;
}

}  // namespace arelem::tool
