#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "ir/diag/motion.h"
#include "ir/space/tolerance.h"
#include "runtime/motion/angle_rule.h"
#include "runtime/motion/between_contacts.h"
#include "runtime/motion/zero.h"

namespace arelem::motion {

namespace {
/// The contacts depend on the axis and the axis on the contacts' normals: repeated until both
/// agree.
class AngleAxis final : public AxisSource {
 public:
  AngleAxis(
      const Tilt& tilt, AngleSide control, AngleSide other, const Vec3& start, const Vec3& forward)
      : rule_(tilt, std::move(control), std::move(other), forward), start_{start, forward} {
    startAnew();
  }

  Vec3 at(const Vec3& toolEnd) override {
    // Places far off may have led anywhere: what is nearer to where the tool stands begins there.
    if (stand_ && (toolEnd - stand_->toolEnd).norm() < (toolEnd - toolEnd_).norm()) {
      recall(*stand_);
    }
    toolEnd_ = toolEnd;
    if (const auto upright = rule_.onToolEnd(toolEnd, last_)) {
      return found(*upright);
    }
    if (state_ == State::between) {
      if (const auto followed = between_.follow(toolEnd)) {
        last_ = *followed;
        return last_;
      }
    }
    if (const auto near = steadily(toolEnd, last_)) {
      return found(rule_.liesFlat(*near) ? ofFlat(toolEnd, *near).value_or(*near) : *near);
    }
    Vec3 axis = last_;
    double before = 2.0, least = before;
    int idle = 0;
    bool hurried = false;
    const int most = inVain_ < mostInVain ? patience : littlePatience;
    for (repeats_ = 1; repeats_ <= repeatLimit && idle < most; ++repeats_) {
      const auto next = rule_.step(toolEnd, axis);
      if (!next) {
        const auto possible = rule_.possible(toolEnd, axis);
        if (!possible) {
          state_ = State::impossible;
          return last_;
        }
        axis = *possible;
        continue;
      }
      if (rule_.liesFlat(axis, nearlyFlat)) {
        if (const auto chosen = ofFlat(toolEnd, axis)) {
          return found(*chosen);
        }
      }
      const double moved = (*next - axis).norm();
      // Half steps where whole ones go to and fro.
      axis = moved < slowShare * before ? *next : Vec3((axis + *next).normalized());
      before = moved;
      idle = moved < smaller * least ? 0 : idle + 1;
      least = std::min(least, moved);
      if (moved <= tolerance::rounding) {
        break;
      }
      if (!hurried && moved <= learning) {
        hurried = true;
        if (const auto near = steadily(toolEnd, axis)) {
          return found(rule_.liesFlat(*near) ? ofFlat(toolEnd, *near).value_or(*near) : *near);
        }
      }
    }
    state_ = before <= tolerance::symmetric ? State::found : State::restless;
    if (state_ == State::restless && inVain_ < mostInVain) {
      auto settled = byNewton(toolEnd, axis);
      state_ = settled ? State::found : State::between;
      settled = settled ? settled : between_.find(toolEnd, axis);
      state_ = settled ? state_ : State::restless;
      inVain_ = settled ? 0 : inVain_ + 1;
      axis = settled.value_or(axis);
    }
    last_ = axis;
    return axis;
  }

  void hold(const Vec3& toolEnd) override {
    const Vec3 axis = at(toolEnd);
    if (!fault()) {
      rule_.hold(toolEnd, axis);
    }
  }

  void stand(const Vec3& toolEnd, const Vec3& axis) override {
    if (const Memory* marked = markedAt(toolEnd, axis)) {
      recall(*marked);
    } else if (toolEnd != toolEnd_) {
      (void)at(toolEnd);
    }
    if ((last_ - axis).norm() > tolerance::symmetric) {
      // It turned there from one axis to another.
      stand_.reset();
      state_ = State::found;
      last_ = axis;
      (void)at(toolEnd);
    }
    rule_.keep(toolEnd, last_);
    stand_ = here(toolEnd);
    inVain_ = 0;
  }

  void mark() override {
    marks_[marked_] = here(toolEnd_);
    marked_ = (marked_ + 1) % marks_.size();
  }

  void back(const Vec3& toolEnd, const Vec3& axis) override {
    if (const Memory* marked = markedAt(toolEnd, axis)) {
      recall(*marked);
    } else {
      (void)at(toolEnd);
    }
  }

  void startAnew() override {
    stand_.reset();
    marks_.fill(std::nullopt);
    rule_.startAnew();
    recall(start_);
    inVain_ = 0;
  }

  [[nodiscard]] std::optional<Failure> fault() const override {
    if (state_ == State::impossible) {
      return fail(diag::AxisImpossible, rule_.tilt().alpha * degrees, rule_.controlName(),
                  rule_.reason());
    }
    return state_ == State::restless ? std::optional(restless()) : std::nullopt;
  }
  [[nodiscard]] bool settles() const override { return state_ != State::restless; }
  [[nodiscard]] std::optional<Failure> jump() const override {
    return state_ == State::between ? std::optional(restless()) : std::nullopt;
  }

 private:
  enum class State { found, between, impossible, restless };
  static constexpr double degrees = 180.0 / std::numbers::pi;
  [[nodiscard]] Failure restless() const {
    return fail(diag::AxisDiverges, rule_.tilt().alpha * degrees, rule_.controlName(), repeats_);
  }
  static constexpr int repeatLimit = 100;
  /// Repeats without a smaller move after which there will be none; and where many searches found
  /// nothing.
  static constexpr int patience = 12, littlePatience = 5;
  static constexpr double slowShare = 0.9;
  /// A move is smaller by this share at least: where repeats turn to and fro, rounding makes each a
  /// little smaller or not, and would tell on which side they end.
  static constexpr double smaller = 0.999;
  /// Of Newton; after so many searches in a row that found nothing there are no more.
  static constexpr int newtonLimit = 12, mostInVain = 50;
  /// Steady steps: most of them, the longest one, what is left after each of what was before unless
  /// it is little and not much more than at first, and what may be left at last; a step is at most
  /// so many times as long as what is missed.
  static constexpr int quickLimit = 12;
  static constexpr double nearEnough = 0.1, quickShare = 0.5, learning = 1e-3, astray = 4.0;
  static constexpr double stillRounding = 1e-12, mostOfMiss = 20.0;
  /// Newton ends at what is left of an axis, turns by at most so much at once, and tries steps down
  /// to this share.
  static constexpr double newtonMiss = 1e-14, largestTurn = 0.3, leastShare = 1e-3;

  /// Of a level bottom that lies: the first turn that is tried, and by how much the next is more.
  /// What the other normal is off the axis beside its edge, where repeats turn by next to nothing.
  static constexpr double leastFlatTurn = 1e-6, flatGrowth = 8.0, nearlyFlat = 0.05;

  /// With what a search begins.
  struct Memory {
    Vec3 axis, forward;
    Vec3 toolEnd = Vec3::Zero();
    Eigen::Matrix3d slope = Eigen::Matrix3d::Zero();
    State state = State::found;
    BetweenContacts::Last between{};
  };

  [[nodiscard]] Memory here(const Vec3& toolEnd) const {
    return {last_, rule_.forward(), toolEnd, slope_, state_, between_.last()};
  }

  [[nodiscard]] const Memory* markedAt(const Vec3& toolEnd, const Vec3& axis) const {
    for (const auto& m : marks_) {
      if (m && m->toolEnd == toolEnd && m->axis == axis) {
        return &*m;
      }
    }
    return nullptr;
  }

  void recall(const Memory& m) {
    last_ = m.axis;
    rule_.setForward(m.forward);
    toolEnd_ = m.toolEnd;
    slope_ = m.slope;
    state_ = m.state;
    between_.setLast(m.between);
  }

  Vec3 found(const Vec3& axis) {
    state_ = State::found;
    last_ = axis;
    return axis;
  }

  /// The axis that its own normals give back, near one: steps as long as the change of the axis
  /// that follows with the one before tells, which is learned from steps (Broyden). None where they
  /// do not come nearer fast.
  std::optional<Vec3> steadily(const Vec3& toolEnd, Vec3 axis) {
    Vec3 step = Vec3::Zero(), miss = Vec3::Zero();
    double first = 0.0;
    for (int i = 0; i < quickLimit; ++i) {
      const auto next = rule_.step(toolEnd, axis);
      if (!next) {
        break;
      }
      const Vec3 missBefore = miss;
      miss = *next - axis;
      const double left = miss.norm();
      if (left <= tolerance::rounding) {
        return next;
      }
      if (i == 0) {
        first = left;
      } else {
        // What was foretold: the axis that follows moves by slope_ times the step.
        slope_ +=
            (miss + step - missBefore - slope_ * step) * step.transpose() / step.squaredNorm();
        const bool isFast = left <= quickShare * missBefore.norm();
        if (!isFast && left <= stillRounding) {
          return next;
        }
        if (!isFast && left > std::min(learning, astray * first)) {
          break;
        }
      }
      step = (Eigen::Matrix3d::Identity() - slope_).inverse() * miss;
      if (!(step.norm() <= mostOfMiss * left)) {
        slope_.setZero();
        step = miss;
      }
      if (step.norm() > nearEnough) {
        break;
      }
      const Vec3 there = (axis + step).normalized();
      step = there - axis;
      axis = there;
    }
    slope_.setZero();
    return std::nullopt;
  }

  /// Of the axes with which a level bottom lies on the other surface that which is the rule's with
  /// any other bottom: by the place alone, not by the axis before.
  std::optional<Vec3> ofFlat(const Vec3& toolEnd, const Vec3& axis) {
    const auto first = rule_.aside(toolEnd, axis);
    if (!first) {
      return std::nullopt;
    }
    const Vec3 way = rule_.turning(first->axis);
    const auto turned = [&](double turn) {
      return rule_.aside(toolEnd, std::cos(turn) * first->axis + std::sin(turn) * way);
    };
    const auto distance = [&](double turn) -> std::optional<double> {
      const auto there = turned(turn);
      return there ? std::optional(there->distance) : std::nullopt;
    };
    // On a surface that bulges towards the tool the contact goes where the axis leans.
    double before = 0.0;
    for (double turn = -std::copysign(leastFlatTurn, first->distance); std::abs(turn) < largestTurn;
         turn *= flatGrowth) {
      const auto there = distance(turn);
      if (!there) {
        return std::nullopt;
      }
      if ((*there > 0.0) != (first->distance > 0.0)) {
        const auto zero = zeroBetween(distance, std::min(before, turn), std::max(before, turn));
        const auto chosen = zero ? turned(*zero) : std::nullopt;
        return chosen ? std::optional(chosen->axis) : std::nullopt;
      }
      before = turn;
    }
    return std::nullopt;
  }

  /// The axis that its own normals give back, by Newton: where the place of the contact follows the
  /// axis by as much as it turns (a ball in a narrow hollow, over an edge), repeats do not come
  /// nearer.
  std::optional<Vec3> byNewton(const Vec3& toolEnd, Vec3 axis) {
    constexpr double h = 1e-6;
    auto next = rule_.step(toolEnd, axis);
    for (int i = 0; i < newtonLimit && next; ++i) {
      const Vec3 miss = *next - axis;
      if (miss.norm() <= newtonMiss) {
        return axis;
      }
      // Contacts jump with some turns: directions that go with the surfaces make each the same turn
      // wherever these lie, and mirrored.
      const Vec3 across = withinPlane(axis, miss);
      const Vec3 e1 = across.norm() > tolerance::rounding * miss.norm() ? Vec3(across.normalized())
                                                                        : axis.unitOrthogonal();
      const Vec3 e2 = axis.cross(e1);
      const auto along1 = rule_.step(toolEnd, (axis + h * e1).normalized());
      const auto along2 = rule_.step(toolEnd, (axis + h * e2).normalized());
      const auto against2 = rule_.step(toolEnd, (axis - h * e2).normalized());
      if (!along1 || !along2 || !against2) {
        return std::nullopt;
      }
      const Vec3 moved1 = (*along1 - *next) / h;
      const Vec3 moved2 = (*along2 - *against2) / (2.0 * h);
      slope_ = moved1 * e1.transpose() + moved2 * e2.transpose();
      const Vec3 d1 = moved1 - e1;
      const Vec3 d2 = moved2 - e2;
      Eigen::Matrix2d change;
      change << d1.dot(e1), d2.dot(e1), d1.dot(e2), d2.dot(e2);
      const Eigen::Vector2d turn =
          change.fullPivLu().solve(Eigen::Vector2d(-miss.dot(e1), -miss.dot(e2)));
      std::optional<Vec3> better;
      for (double share = std::min(1.0, largestTurn / std::max(turn.norm(), h)); share > leastShare;
           share *= 0.5) {
        const Vec3 there = (axis + share * (turn.x() * e1 + turn.y() * e2)).normalized();
        const auto behind = rule_.step(toolEnd, there);
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

  AngleRule rule_;
  BetweenContacts between_{rule_};
  const Memory start_;
  std::optional<Memory> stand_;                  ///< what was found where the tool stands
  std::array<std::optional<Memory>, 16> marks_;  ///< ends of steps: as many as are tried for one
  std::size_t marked_ = 0;                       ///< where the next one goes
  Vec3 last_, toolEnd_;                          ///< found last, and where
  Eigen::Matrix3d slope_;                        ///< of the axis that follows with an axis
  State state_ = State::found;
  int repeats_ = 0;
  int inVain_ = 0;  ///< searches in a row that found no axis
};
}  // namespace

std::unique_ptr<AxisSource> atAngle(
    const Tilt& tilt, AngleSide control, AngleSide other, const Vec3& start, const Vec3& forward) {
  return std::make_unique<AngleAxis>(tilt, std::move(control), std::move(other), start, forward);
}

}  // namespace arelem::motion
