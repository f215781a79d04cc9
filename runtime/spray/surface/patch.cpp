#include "runtime/spray/surface/patch.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "ir/diag/spray.h"
#include "ir/space/spray_tolerance.h"
#include "ir/space/tolerance.h"
#include "runtime/geometry/ruled_surface.h"
#include "runtime/geometry/tabulated_cylinder.h"
#include "runtime/region/region.h"
#include "runtime/spray/surface/kept.h"
#include "runtime/spray/surface/window.h"

namespace arelem::spray {

namespace {
constexpr double degree = std::numbers::pi / 180.0;

/// A place turned about an axis.
struct Turning {
  Vec3 place, axis, x, y;
  explicit Turning(const Vec3& at, const Vec3& direction)
      : place(at), axis(direction.normalized()) {
    const region::Frame frame = region::frameOf(axis, Vec3::Zero());
    x = frame.x;
    y = frame.y;
  }
  [[nodiscard]] Vec3 at(double degrees, double radius, double height) const {
    const double t = degrees * degree;
    return place + radius * (std::cos(t) * x + std::sin(t) * y) + height * axis;
  }
};

/// A TABCYL's curve by its length, the straight intervals at its ends left out.
class Curve {
 public:
  explicit Curve(std::span<const double> canon) : surface_(geometry::TabulatedCylinder::of(canon)) {
    for (const auto& interval : surface_.intervals) {
      if (!interval.extension) {
        walk(interval);
      }
    }
  }
  [[nodiscard]] double length() const { return lengths_.empty() ? 0.0 : lengths_.back(); }
  [[nodiscard]] const geometry::TabulatedCylinder& surface() const { return surface_; }
  /// The place in the plane of the curve; beyond its ends straight on.
  [[nodiscard]] geometry::Vec2 at(double length) const {
    const auto above = std::upper_bound(lengths_.begin() + 1, lengths_.end() - 1, length);
    const auto i = static_cast<std::size_t>(above - lengths_.begin());
    const double share = (length - lengths_[i - 1]) / (lengths_[i] - lengths_[i - 1]);
    const Knot& from = knots_[i - 1];
    const Knot& to = knots_[i];
    const double t = from.t + share * (to.t - from.t);
    return to.interval->at(t).place;
  }

 private:
  struct Knot {
    const geometry::TabulatedCylinder::Interval* interval = nullptr;
    double t = 0.0;
  };
  static constexpr int pieces = 400;  // of an interval

  void walk(const geometry::TabulatedCylinder::Interval& interval) {
    // At a joint lie two knots: the end of one interval and the begin of the next.
    lengths_.push_back(length());
    knots_.push_back({&interval, 0.0});
    geometry::Vec2 before = interval.at(0.0).place;
    for (int k = 1; k <= pieces; ++k) {
      const double t = interval.length * k / pieces;
      const geometry::Vec2 now = interval.at(t).place;
      lengths_.push_back(lengths_.back() + (now - before).norm());
      knots_.push_back({&interval, t});
      before = now;
    }
  }

  geometry::TabulatedCylinder surface_;
  std::vector<double> lengths_;
  std::vector<Knot> knots_;
};

class Builder {
 public:
  Builder(const Entity& entity, const Limits& limits, double unit)
      : entity_(entity), limits_(limits), unit_(unit) {}

  Result<Patch> run() {
    if (auto failure = build()) {
      return *std::move(failure);
    }
    patch_.keep = limits_.keep;
    if (const auto& ranges = limits_.ranges) {
      patch_.u0 = ranges->u0 * uUnit_;
      patch_.u1 = ranges->u1 * uUnit_;
      patch_.v0 = ranges->v0 * vUnit_;
      patch_.v1 = ranges->v1 * vUnit_;
    } else if (unbounded_) {
      if (limits_.keep.empty()) {
        return fail(diag::SurfaceLimits, spell(entity_.type), "no ends of its own",
                    "LIMITS, u1, u2, v1, v2, or planes that cut it off, are needed");
      }
      if (auto failure = boundByPlanes()) {
        return *std::move(failure);
      }
    }
    if (auto failure = objection()) {
      return *std::move(failure);
    }
    if (!patch_.keep.empty() &&
        !shrinkToKept(patch_, turns_ && wholeTurn(patch_.u0, patch_.u1),
                      entity_.type == EntityType::torus && wholeTurn(patch_.v0, patch_.v1))) {
      return nothingLeft();
    }
    return std::move(patch_);
  }

 private:
  [[nodiscard]] Failure nothingLeft() const {
    return fail(diag::SurfaceLimits, spell(entity_.type), "nothing left",
                "the planes of LIMITS must keep a part of it");
  }

  /// Of surfaces that are straight along their unbounded parameters: the range of these between the
  /// planes.
  std::optional<Failure> boundByPlanes() {
    const WindowBetween window = windowBetween(
        patch_, lowest_, entity_.type == EntityType::plane || entity_.type == EntityType::line);
    if (window == WindowBetween::endless) {
      return fail(diag::SurfaceLimits, spell(entity_.type), "no end between the planes of LIMITS",
                  "planes must cut it off on all sides, or LIMITS, u1, u2, v1, v2");
    }
    if (window == WindowBetween::empty) {
      return nothingLeft();
    }
    return std::nullopt;
  }

  static bool wholeTurn(double from, double to) { return to - from == 360.0; }

  std::optional<Failure> objection() {
    const Patch& p = patch_;
    if (!(p.u1 > p.u0) || !(p.v1 > p.v0)) {
      return fail(diag::SurfaceLimits, spell(entity_.type), "limits that do not rise",
                  "u2 is above u1 and v2 above v1");
    }
    if (turns_ && p.u1 - p.u0 > 360.0) {
      return fail(diag::SurfaceLimits, spell(entity_.type), "more than a whole turn",
                  "u1 to u2 is at most 360 degrees");
    }
    if (p.v0 < lowest_ || p.v1 > highest_) {
      return fail(
          diag::SurfaceLimits, spell(entity_.type), "limits beyond its ends",
          std::isfinite(highest_)
              ? fmt::format("v lies between {:.9g} and {:.9g}", lowest_ / vUnit_, highest_ / vUnit_)
              : fmt::format("v is at least {:.9g}: the vertex has no normal", lowest_ / vUnit_));
    }
    if (p.u0 < lowestU_ || p.u1 > highestU_) {
      return fail(
          diag::SurfaceLimits, spell(entity_.type), "limits beyond its ends",
          fmt::format("u lies between {:.9g} and {:.9g}", lowestU_ / uUnit_, highestU_ / uUnit_));
    }
    return std::nullopt;
  }

  [[nodiscard]] Vec3 vec(std::size_t first) const {
    return {entity_.canon[first], entity_.canon[first + 1], entity_.canon[first + 2]};
  }

  void around(double v0, double v1, bool unbounded) {
    patch_.u0 = 0.0;
    patch_.u1 = 360.0;
    patch_.v0 = v0;
    patch_.v1 = v1;
    turns_ = true;
    unbounded_ = unbounded;
  }

  std::optional<Failure> build() {
    switch (entity_.type) {
      case EntityType::line:
      case EntityType::plane:
        plane();
        break;
      case EntityType::circle:
      case EntityType::cylinder:
        cylinder();
        break;
      case EntityType::cone:
        cone();
        break;
      case EntityType::sphere:
        sphere();
        break;
      case EntityType::torus:
        torus();
        break;
      case EntityType::revolved:
        revolved();
        break;
      case EntityType::tabulatedCylinder:
        tabulated();
        break;
      case EntityType::ruledSurface:
        return ruled();
      default:
        return fail(diag::SurfaceUnsprayable, spell(entity_.type));
    }
    return std::nullopt;
  }

  void plane() {
    const geometry::Plane plane = geometry::Plane::of(entity_.canon);
    const region::Frame frame =
        region::frameOf(plane.normal, plane.distance * unit_ * plane.normal);
    patch_.at = [frame](double u, double v) { return frame.inSpace({u, v}); };
    patch_.bend = [](double) { return Patch::Bend{}; };
    uUnit_ = vUnit_ = unit_;
    unbounded_ = true;
  }
  void cylinder() {
    const geometry::Cylinder c = geometry::Cylinder::of(entity_.canon);
    const Turning turning(c.point * unit_, c.axis);
    const double radius = c.radius * unit_;
    patch_.at = [turning, radius](double u, double v) { return turning.at(u, radius, v); };
    patch_.bend = [radius](double) { return Patch::Bend{radius * degree * degree, 0.0, 0.0}; };
    around(0.0, 0.0, true);
    vUnit_ = unit_;
  }
  void cone() {
    const geometry::Cone c = geometry::Cone::of(entity_.canon);
    const Turning turning(c.vertex * unit_, c.axis);
    const double cosine = c.cosine;
    const double sine = std::sqrt(1.0 - cosine * cosine);
    patch_.at = [turning, cosine, sine](double u, double v) {
      return turning.at(u, v * sine, v * cosine);
    };
    patch_.bend = [sine](double most) {
      return Patch::Bend{most * sine * degree * degree, sine * degree, 0.0};
    };
    around(0.0, 0.0, true);
    vUnit_ = unit_;
    lowest_ = tolerance::coincidence;  // at the vertex there is no normal
  }
  void sphere() {
    const geometry::Sphere s = geometry::Sphere::of(entity_.canon);
    const Turning turning(s.center * unit_, Vec3::UnitZ());
    const double radius = s.radius * unit_;
    patch_.at = [turning, radius](double u, double v) {
      return turning.at(u, radius * std::cos(v * degree), radius * std::sin(v * degree));
    };
    patch_.bend = [most = radius * degree * degree](double) {
      return Patch::Bend{most, most, most};
    };
    around(-90.0, 90.0, false);
    lowest_ = -90.0;
    highest_ = 90.0;
  }
  void torus() {
    const geometry::Torus t = geometry::Torus::of(entity_.canon);
    const Turning turning(t.center * unit_, t.axis);
    const double major = t.major * unit_;
    const double minor = t.minor * unit_;
    patch_.at = [turning, major, minor](double u, double v) {
      return turning.at(u, major + minor * std::cos(v * degree), minor * std::sin(v * degree));
    };
    patch_.bend = [major, minor](double) {
      const double ring = minor * degree * degree;
      return Patch::Bend{(major + minor) * degree * degree, ring, ring};
    };
    around(0.0, 360.0, false);
  }
  void revolved() {
    const auto curve = std::make_shared<const Curve>(std::span(entity_.canon).subspan(8));
    const double unit = unit_;
    const Vec3 place = vec(0);
    const Vec3 axis = vec(3).normalized();
    patch_.at = [curve, unit, place, axis](double u, double v) -> Vec3 {
      const Vec3 p = curve->surface().inSpace(curve->at(v / unit)) - place;
      const double height = p.dot(axis);
      const Vec3 arm = p - height * axis;
      const double t = u * degree;
      return unit * (place + height * axis + std::cos(t) * arm + std::sin(t) * axis.cross(arm));
    };
    around(0.0, curve->length() * unit_, false);
    patch_.u0 = entity_.canon[6];
    patch_.u1 = entity_.canon[7];
    vUnit_ = unit_;
    lowest_ = 0.0;
    highest_ = patch_.v1 * (1.0 + tolerance::similarity);
  }
  void tabulated() {
    const auto curve = std::make_shared<const Curve>(entity_.canon);
    const double unit = unit_;
    patch_.at = [curve, unit](double u, double v) -> Vec3 {
      return unit * curve->surface().inSpace(curve->at(u / unit), v / unit);
    };
    patch_.u1 = curve->length() * unit_;
    unbounded_ = true;
    uUnit_ = vUnit_ = unit_;
    lowestU_ = 0.0;
    highestU_ = patch_.u1 * (1.0 + tolerance::similarity);
  }
  std::optional<Failure> ruled() {
    const auto surface =
        std::make_shared<const geometry::RuledSurface>(geometry::RuledSurface::of(entity_.canon));
    const double unit = unit_;
    for (int i = 0; i <= 64; ++i) {
      if (!surface->at(i / 64.0, 0.0) || !surface->at(i / 64.0, 1.0)) {
        return fail(diag::SurfaceLimits, spell(entity_.type),
                    fmt::format("no place at u = {:.4g}", i / 64.0),
                    "its curves reach from 0 to 1");
      }
    }
    patch_.at = [surface, unit](double u, double v) -> Vec3 {
      const auto place = surface->at(u, v);
      return place ? Vec3(unit * place->place) : Vec3(Vec3::Zero());
    };
    lowest_ = lowestU_ = 0.0;
    highest_ = highestU_ = 1.0;
    return std::nullopt;
  }

  const Entity& entity_;
  const Limits& limits_;
  double unit_;
  Patch patch_;
  double uUnit_ = 1.0, vUnit_ = 1.0;
  double lowest_ = -HUGE_VAL, highest_ = HUGE_VAL;
  double lowestU_ = -HUGE_VAL, highestU_ = HUGE_VAL;
  bool turns_ = false;
  bool unbounded_ = false;
};
}  // namespace

namespace {
/// The derivative of a place by its parameter, with as little error at the ends of its range as
/// inside.
Vec3 slope(const std::function<Vec3(double)>& at, double t, double from, double to, double step) {
  if (t - step < from) {
    return (4.0 * at(t + step) - 3.0 * at(t) - at(t + 2.0 * step)) / 2.0;
  }
  if (t + step > to) {
    return (3.0 * at(t) - 4.0 * at(t - step) + at(t - 2.0 * step)) / 2.0;
  }
  return (at(t + step) - at(t - step)) / 2.0;
}
}  // namespace

Vec3 Patch::normal(double u, double v) const {
  const double hu = tolerance::normalStep * (u1 - u0);
  const double hv = tolerance::normalStep * (v1 - v0);
  const auto spanned = [&](double uAt, double vAt) -> Vec3 {
    return slope([&](double t) { return at(t, vAt); }, uAt, u0, u1, hu)
        .cross(slope([&](double t) { return at(uAt, t); }, vAt, v0, v1, hv));
  };
  const double uc = std::clamp(u, u0 + hu, u1 - hu);
  const double vc = std::clamp(v, v0 + hv, v1 - hv);
  Vec3 n = spanned(uc, vc);
  if (uc != u || vc != v) {
    // At a pole nothing is spanned: it has the normal of what lies beside it.
    const Vec3 here = spanned(u, v);
    n = here.norm() > 0.5 * n.norm() ? here : n;
  }
  n.normalize();
  return flipped ? Vec3(-n) : n;
}

Result<Patch> patchOf(const Entity& entity, const Limits& limits, double unit) {
  return Builder(entity, limits, unit).run();
}

}  // namespace arelem::spray
