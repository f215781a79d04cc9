#include "runtime/motion/axis_source.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ir/diag/motion.h"
#include "ir/space/tolerance.h"
#include "runtime/geometry/ruling.h"

namespace arelem::motion {

namespace {
class NormalAxis final : public AxisSource {
 public:
  NormalAxis(const surface::AnySurface& surface, double side)
      : field_(makeField(surface, side, {})) {}
  Vec3 at(const Vec3& toolEnd) override { return field_->at(toolEnd, Vec3::UnitZ()).normal; }

 private:
  std::unique_ptr<Field> field_;
};

class RulingAxis final : public AxisSource {
 public:
  RulingAxis(const surface::AnySurface& surface, const Vec3& start)
      : surface_(surface), last_(start) {}
  Vec3 at(const Vec3& toolEnd) override {
    if (const auto line = surface::rulingAt(surface_, toolEnd)) {
      last_ = line->dot(last_) < 0.0 ? Vec3(-*line) : *line;
    }
    return last_;
  }

 private:
  surface::AnySurface surface_;
  Vec3 last_;
};

/// The contacts depend on the axis and the axis on the contacts' normals: repeated until both
/// agree.
class AngleAxis final : public AxisSource {
 public:
  AngleAxis(
      const Tilt& tilt, AngleSide control, AngleSide other, const Vec3& start, const Vec3& forward)
      : tilt_(tilt),
        control_(std::move(control)),
        other_(std::move(other)),
        last_(start),
        forward_(forward) {}

  Vec3 at(const Vec3& toolEnd) override {
    Vec3 axis = last_;
    double before = 2.0, least = before;
    int idle = 0;
    for (repeats_ = 1; repeats_ <= repeatLimit && idle < patience; ++repeats_) {
      const auto next = step(toolEnd, axis);
      if (!next) {
        state_ = State::impossible;
        return last_;
      }
      const double moved = (*next - axis).norm();
      // Half steps where whole ones go to and fro.
      axis = moved < slowShare * before ? *next : Vec3((axis + *next).normalized());
      before = moved;
      idle = moved < least ? 0 : idle + 1;
      least = std::min(least, moved);
      if (moved <= tolerance::rounding) {
        break;
      }
    }
    state_ = before <= tolerance::symmetric ? State::found : State::restless;
    last_ = axis;
    return axis;
  }

  [[nodiscard]] std::optional<Failure> fault() const override {
    constexpr double degrees = 180.0 / std::numbers::pi;
    switch (state_) {
      case State::impossible:
        return fail(diag::AxisImpossible, tilt_.alpha * degrees, control_.name, reason_);
      case State::restless:
        return fail(diag::AxisDiverges, tilt_.alpha * degrees, control_.name, repeats_);
      default:
        return std::nullopt;
    }
  }

 private:
  enum class State { found, impossible, restless };
  static constexpr int repeatLimit = 100;
  /// Repeats without a smaller move after which there will be none.
  static constexpr int patience = 12;
  static constexpr double slowShare = 0.9;

  std::optional<Vec3> step(const Vec3& toolEnd, const Vec3& from) {
    Vec3 normal = control_.field->at(toolEnd, from).normal;
    if (control_.on) {
      const double up = normal.dot(from);
      normal *= (std::abs(up) <= tolerance::symmetric ? control_.side : up) < 0.0 ? -1.0 : 1.0;
    }
    const Vec3 other = other_.field->at(toolEnd, from).normal;
    const Vec3 common = normal.cross(other);
    const Vec3 forward = common.dot(forward_) < 0.0 ? Vec3(-common) : common;
    if (forward.norm() > tolerance::symmetric) {
      forward_ = forward.normalized();
    }
    auto axis = tilted(tilt_, normal, other, forward_);
    if (!axis) {
      reason_ = whyNotTilted(tilt_, normal, other);
    }
    return axis;
  }

  Tilt tilt_;
  AngleSide control_, other_;
  Vec3 last_, forward_;
  State state_ = State::found;
  int repeats_ = 0;
  std::string reason_;  ///< why there is no axis
};
}  // namespace

std::unique_ptr<AxisSource> normalTo(const surface::AnySurface& surface, double side) {
  return std::make_unique<NormalAxis>(surface, side);
}

Result<std::unique_ptr<AxisSource>> alongRulings(const surface::AnySurface& surface,
                                                 const std::string& name,
                                                 const Vec3& toolEnd,
                                                 const Vec3& start) {
  if (!surface::rulingAt(surface, toolEnd)) {
    return fail(diag::NoRulings, name);
  }
  return std::unique_ptr<AxisSource>(std::make_unique<RulingAxis>(surface, start));
}

std::unique_ptr<AxisSource> atAngle(
    const Tilt& tilt, AngleSide control, AngleSide other, const Vec3& start, const Vec3& forward) {
  return std::make_unique<AngleAxis>(tilt, std::move(control), std::move(other), start, forward);
}

}  // namespace arelem::motion
