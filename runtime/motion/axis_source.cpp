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
    if (const auto upright = onToolEnd(toolEnd)) {
      state_ = State::found;
      last_ = *upright;
      return last_;
    }
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
    if (state_ == State::restless && inVain_ < mostInVain) {
      auto settled = byNewton(toolEnd, axis);
      state_ = settled ? State::found : State::between;
      settled = settled ? settled : atBoth(toolEnd, axis);
      state_ = settled ? state_ : State::restless;
      inVain_ = settled ? 0 : inVain_ + 1;
      axis = settled.value_or(axis);
    }
    last_ = axis;
    return axis;
  }

  void hold(const Vec3& toolEnd) override {
    const Vec3 axis = at(toolEnd);
    if (tilt_.across && !fault()) {
      tilt_.turn = turnAbout(*tilt_.across, normalsAt(toolEnd, axis).control, axis);
    }
  }

  [[nodiscard]] std::optional<Failure> fault() const override {
    if (state_ == State::impossible) {
      return fail(diag::AxisImpossible, tilt_.alpha * degrees, control_.name, reason_);
    }
    return state_ == State::restless ? std::optional(restless()) : std::nullopt;
  }
  [[nodiscard]] std::optional<Failure> jump() const override {
    return state_ == State::between ? std::optional(restless()) : std::nullopt;
  }

 private:
  enum class State { found, between, impossible, restless };
  static constexpr double degrees = 180.0 / std::numbers::pi;
  [[nodiscard]] Failure restless() const {
    return fail(diag::AxisDiverges, tilt_.alpha * degrees, control_.name, repeats_);
  }
  static constexpr int repeatLimit = 100;
  /// Repeats without a smaller move after which there will be none.
  static constexpr int patience = 12;
  static constexpr double slowShare = 0.9;
  /// Of Newton, and of searches between two contacts, in one go; after so many in a row that found
  /// nothing there are no more.
  static constexpr int newtonLimit = 12, bothLimit = 6, mostInVain = 50;
  /// Newton ends at what is left of an axis, turns by at most so much at once, and tries steps down
  /// to this share.
  static constexpr double newtonMiss = 1e-14, largestTurn = 0.3, leastShare = 1e-3;
  /// How near two axes with both contacts are that count as the same one.
  static constexpr double bothMoved = 1e-13;

  /// The normals from which the axis follows.
  struct Normals {
    Vec3 control = Vec3::UnitZ(), other = Vec3::UnitX();
    [[nodiscard]] Normals towards(const Normals& to, double share) const {
      return {(control + share * (to.control - control)).normalized(),
              (other + share * (to.other - other)).normalized()};
    }
    [[nodiscard]] double from(const Normals& n) const {
      return (control - n.control).norm() + (other - n.other).norm();
    }
  };

  /// Without an angle any place of a level bottom is the contact for the axis along its normal: of
  /// these axes the one whose contact is the tool end, if that is the contact.
  std::optional<Vec3> onToolEnd(const Vec3& toolEnd) {
    if (tilt_.alpha != 0.0 || tilt_.lead.value_or(0.0) != 0.0 || control_.on || !control_.under) {
      return std::nullopt;
    }
    Vec3 axis = control_.under->at(toolEnd, last_).normal;
    if (tilt_.across) {
      axis = (axis - axis.dot(*tilt_.across) * *tilt_.across).normalized();
    }
    const Vec3 normal = control_.field->at(toolEnd, axis).normal;
    return (normal - axis).norm() <= tolerance::symmetric ? std::optional(axis) : std::nullopt;
  }

  /// The axis that its own normals give back, by Newton: where the place of the contact follows the
  /// axis by as much as it turns (a ball in a narrow hollow, over an edge), repeats do not come
  /// nearer.
  std::optional<Vec3> byNewton(const Vec3& toolEnd, Vec3 axis) {
    constexpr double h = 1e-6;
    auto next = step(toolEnd, axis);
    for (int i = 0; i < newtonLimit && next; ++i) {
      const Vec3 miss = *next - axis;
      if (miss.norm() <= newtonMiss) {
        return axis;
      }
      const Vec3 e1 = axis.unitOrthogonal();
      const Vec3 e2 = axis.cross(e1);
      const auto along1 = step(toolEnd, (axis + h * e1).normalized());
      const auto along2 = step(toolEnd, (axis + h * e2).normalized());
      if (!along1 || !along2) {
        return std::nullopt;
      }
      const Vec3 d1 = (*along1 - *next) / h - e1;
      const Vec3 d2 = (*along2 - *next) / h - e2;
      Eigen::Matrix2d change;
      change << d1.dot(e1), d2.dot(e1), d1.dot(e2), d2.dot(e2);
      const Eigen::Vector2d turn =
          change.fullPivLu().solve(Eigen::Vector2d(-miss.dot(e1), -miss.dot(e2)));
      std::optional<Vec3> better;
      for (double share = std::min(1.0, largestTurn / std::max(turn.norm(), h)); share > leastShare;
           share *= 0.5) {
        const Vec3 there = (axis + share * (turn.x() * e1 + turn.y() * e2)).normalized();
        const auto behind = step(toolEnd, there);
        if (behind && (*behind - there).norm() < miss.norm()) {
          better = there;
          next = behind;
          break;
        }
      }
      if (!better) {
        return miss.norm() <= tolerance::symmetric ? std::optional(axis) : std::nullopt;
      }
      axis = *better;
    }
    return std::nullopt;
  }

  /// The axis with which two places of the cutter touch at once: with more of a turn to either
  /// side one of them does, and its normals turn the axis back. The normals that count are then
  /// between those of the two.
  std::optional<Vec3> atBoth(const Vec3& toolEnd, Vec3 axis) {
    Normals here = normalsAt(toolEnd, axis);
    auto turned = axisOf(here);
    if (!turned) {
      return std::nullopt;
    }
    Normals there = normalsAt(toolEnd, *turned);
    for (int i = 0; i < bothLimit; ++i) {
      double low = 0.0, high = 1.0;  // of the way from `here`: the axis there touches `there`
      Normals atLow = there, atHigh = here;
      while (high - low > tolerance::rounding) {
        const double middle = 0.5 * (low + high);
        const auto between = axisOf(here.towards(there, middle));
        if (!between) {
          return std::nullopt;
        }
        const Normals n = normalsAt(toolEnd, *between);
        const bool isThere = n.from(there) < n.from(here);
        (isThere ? low : high) = middle;
        (isThere ? atLow : atHigh) = n;
      }
      const auto found = axisOf(here.towards(there, low));
      if (!found || low == 0.0 || high == 1.0) {
        return std::nullopt;
      }
      const double moved = (*found - axis).norm();
      axis = *found;
      there = atLow;
      here = atHigh;
      if (moved <= bothMoved) {
        return axis;
      }
    }
    return std::nullopt;
  }

  std::optional<Vec3> step(const Vec3& toolEnd, const Vec3& from) {
    return axisOf(normalsAt(toolEnd, from));
  }

  Normals normalsAt(const Vec3& toolEnd, const Vec3& from) {
    Vec3 normal = control_.field->at(toolEnd, from).normal;
    if (control_.on) {
      const double up = normal.dot(from);
      normal *= (std::abs(up) <= tolerance::symmetric ? control_.side : up) < 0.0 ? -1.0 : 1.0;
    }
    return {normal, other_.field->at(toolEnd, from).normal};
  }

  std::optional<Vec3> axisOf(const Normals& n) {
    const Vec3 common = n.control.cross(n.other);
    const Vec3 forward = common.dot(forward_) < 0.0 ? Vec3(-common) : common;
    if (forward.norm() > tolerance::symmetric) {
      forward_ = forward.normalized();
    }
    auto axis = tilted(tilt_, n.control, n.other, forward_);
    if (!axis) {
      reason_ = whyNotTilted(tilt_, n.control, n.other);
    }
    return axis;
  }

  Tilt tilt_;
  AngleSide control_, other_;
  Vec3 last_, forward_;
  State state_ = State::found;
  int repeats_ = 0;
  int inVain_ = 0;      ///< searches in a row that found no axis
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
