#include "app/verify_hole.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "ir/space/robot_tolerance.h"

namespace arelem::app {

namespace {
using hole::Cycle;

class HoleReader {
 public:
  HoleReader(const Location& hole, std::span<const Location> moves, const Allowed& allowed)
      : hole_(hole),
        cycle_(*hole.hole),
        axis_(hole.axis.value_or(Vec3::UnitZ()).normalized()),
        moves_(moves),
        allowed_(allowed) {}

  HoleRead read() {
    over();
    while (fault_.empty() && !done_ && at_ < moves_.size()) {
      along(moves_[at_++]);
    }
    if (fault_.empty() && !done_) {
      fault_ = "is not finished: the tool does not come back to its height over the hole";
    }
    return {at_, fault_};
  }

 private:
  [[nodiscard]] double heightOf(const Location& move) const {
    return (move.point - hole_.point).dot(axis_);
  }
  [[nodiscard]] double besides(const Location& move) const {
    return (move.point - hole_.point - heightOf(move) * axis_).norm();
  }
  [[nodiscard]] bool isFeed(const Location& move) const {
    return std::abs(move.speed - hole_.speed) <= tolerance::writtenSpeed;
  }

  /// The way to the clearance, which is not below it.
  void over() {
    while (at_ < moves_.size() && fault_.empty()) {
      const Location& move = moves_[at_++];
      const double height = heightOf(move);
      const bool there = besides(move) <= allowed_.distance;
      if (height < cycle_.clearance - allowed_.distance) {
        fault_ = fmt::format("is come to at height {:.6g}, below its clearance of {:.6g}", height,
                             cycle_.clearance);
      } else if (there && height <= cycle_.clearance + allowed_.distance) {
        return;
      }
    }
    if (fault_.empty()) {
      fault_ = "is not drilled: no move goes to its clearance";
    }
  }

  void along(const Location& move) {
    const double height = heightOf(move);
    if (besides(move) > allowed_.distance) {
      fault_ =
          fmt::format("has a move {:.3g} beside its axis at height {:.6g}", besides(move), height);
    } else if (move.axis && degreesBetween(*move.axis, axis_) > allowed_.degrees) {
      fault_ = fmt::format("has a move whose tool axis is {:.3g} degrees off",
                           degreesBetween(*move.axis, axis_));
    } else if (height < lowest_ - allowed_.distance) {
      deeper(move, height);
    } else if (height >= cycle_.clearance - allowed_.distance && bottom()) {
      out(move, height);
    }
    waited_ += bottom() && height <= lowest_ + allowed_.distance ? move.wait : 0.0;
  }

  [[nodiscard]] bool bottom() const { return lowest_ <= -cycle_.depth + allowed_.distance; }

  void deeper(const Location& move, double height) {
    const bool pecks = cycle_.kind == Cycle::Kind::peck || cycle_.kind == Cycle::Kind::chip;
    const double from = std::min(lowest_, 0.0);
    if (!isFeed(move)) {
      fault_ = fmt::format("is drilled with {:.6g} mm/s, the program gives {:.6g}", move.speed,
                           hole_.speed);
    } else if (height < -cycle_.depth - allowed_.distance) {
      fault_ = fmt::format("is {:.6g} deep, the program gives {:.6g}", -height, cycle_.depth);
    } else if (pecks && from - height > cycle_.step + allowed_.distance) {
      fault_ =
          fmt::format("has a peck of {:.6g}, the program gives {:.6g}", from - height, cycle_.step);
    }
    lowest_ = height;
  }

  /// Back over the hole; and then to the height of the retract, where that is higher.
  void out(const Location& move, double height) {
    const bool bores = cycle_.kind == Cycle::Kind::bore || cycle_.kind == Cycle::Kind::boreDwell;
    if (bores && !isOut_ && !isFeed(move)) {
      fault_ = fmt::format("is left with {:.6g} mm/s, the program gives {:.6g}", move.speed,
                           hole_.speed);
    } else if (std::abs(waited_ - cycle_.dwell) > tolerance::writtenTime) {
      fault_ = fmt::format("has a wait of {:.6g} s at its bottom, the program gives {:.6g}",
                           waited_, cycle_.dwell);
    }
    isOut_ = true;
    done_ = height >= cycle_.retract - allowed_.distance;
  }

  const Location& hole_;
  const Cycle& cycle_;
  Vec3 axis_;
  std::span<const Location> moves_;
  const Allowed& allowed_;
  std::size_t at_ = 0;
  double lowest_ = cycle_.clearance;
  double waited_ = 0.0;
  bool isOut_ = false;  // at its clearance
  bool done_ = false;
  std::string fault_;
};
}  // namespace

HoleRead readHole(const Location& hole, std::span<const Location> moves, const Allowed& allowed) {
  return HoleReader(hole, moves, allowed).read();
}

}  // namespace arelem::app
