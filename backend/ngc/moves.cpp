#include "backend/ngc/moves.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "backend/ngc/arc.h"
#include "ir/diag/ngc.h"
#include "ir/space/tolerance.h"

namespace arelem::backend::ngc {

namespace {
constexpr double millimetersOfAnInch = 25.4;
constexpr int feedDecimals = 4;
constexpr int secondsDecimals = 3;
/// An arc is kept if, after rounding, its radius differs by at most so many resolutions between its
/// ends.
constexpr double radiusResolutions = 2.0;

bool isPerTurn(Word unit) {
  return unit == Word::IPR || unit == Word::MMPR;
}
bool isInch(Word unit) {
  return unit == Word::IPR || unit == Word::IPM;
}
}  // namespace

void Moves::report(Failure failure) {
  if (reported_.insert(failure.row).second) {
    sink_.accept(at(record_->origin, std::move(failure)));
  }
}

void Moves::feed(const cl::Post& post) {
  double factor = unit_;
  FeedMode mode = FeedMode::perMinute;
  std::optional<double> value;
  for (const cl::Value& one : post.arguments) {
    if (const double* number = std::get_if<double>(&one); number != nullptr && !value) {
      value = *number;
    } else if (const Word* word = std::get_if<Word>(&one)) {
      const bool isUnit = isPerTurn(*word) || *word == Word::IPM || *word == Word::MMPM;
      if (isUnit) {
        mode = isPerTurn(*word) ? FeedMode::perTurn : FeedMode::perMinute;
        factor = isInch(*word) ? millimetersOfAnInch : 1.0;
      }
    }
  }
  if (value) {
    feed_ = *value * factor;
    feedMode_ = mode;
  }
}

void Moves::cycle(const cl::Post& post) {
  const Word* first = post.arguments.empty() ? nullptr : std::get_if<Word>(&post.arguments[0]);
  if (first != nullptr && *first == Word::OFF) {
    cycle_.reset();
    if (cycleOpen_) {
      block_.code("G80");
      block_.end();
      block_.forget('m');
      block_.forgetAxes();
    }
    cycleOpen_ = false;
    return;
  }
  const auto* text =
      post.arguments.empty() ? nullptr : std::get_if<std::string>(&post.arguments[0]);
  if ((first != nullptr && *first == Word::ON) || (text != nullptr && *text == "INIT")) {
    return;
  }
  Result<Cycle> read = readCycle(post);
  if (!read) {
    return report(read.takeFailure());
  }
  if (!machine_.cycles) {
    return report(fail(diag::NgcCycle, std::string("is off in the control file (cycles = false)")));
  }
  cycle_ = *std::move(read);
  if (cycle_->feed) {
    cl::Post feedPost{Word::FEDRAT, "", {*cycle_->feed}};
    if (cycle_->feedHasUnit) {
      feedPost.arguments.emplace_back(cycle_->feedUnit);
    }
    feed(feedPost);
  }
}

bool Moves::turnsAllowed(const Vec3& axis) {
  const bool tilted = std::hypot(axis.x(), axis.y()) > tolerance::nullDirection || axis.z() < 0.0;
  if (tilted && machine_.turning == Machine::Turning::none) {
    report(fail(diag::NgcTilted, axis.x(), axis.y(), axis.z()));
    return false;
  }
  return true;
}

void Moves::move(const cl::Motion& motion) {
  if (motion.points() == 0) {
    return;
  }
  if (motion.kind != cl::Motion::Kind::continuation) {
    run_ = std::exchange(surface_, std::nullopt);
    if (run_ && run_->canon.size() == 7) {
      for (const std::size_t i : {0U, 1U, 2U, 6U}) {
        run_->canon[i] *= unit_;
      }
    }
  }
  points(motion);
  rapid_ = false;
}

void Moves::points(const cl::Motion& motion) {
  const std::size_t stride = motion.stride();
  std::vector<Vec3> places;
  std::vector<Vec3> axes;
  for (std::size_t i = 0; i + stride <= motion.coordinates.size(); i += stride) {
    places.push_back(unit_ * Vec3(&motion.coordinates[i]));
    axes.push_back(motion.withAxis ? Vec3(Vec3(&motion.coordinates[i + 3]).normalized())
                                   : Vec3(Vec3::UnitZ()));
    if (!turnsAllowed(axes.back())) {
      return;
    }
  }
  if (motion.kind == cl::Motion::Kind::from) {
    return from(places.back(), axes.back());
  }
  for (std::size_t i = 0; i < places.size();) {
    if (cycle_) {
      hole(places[i++]);
      continue;
    }
    std::size_t same = i;
    while (same < axes.size() && (axes[same] - axis_).norm() <= tolerance::symmetric) {
      ++same;
    }
    const std::size_t taken =
        arc(std::span(places).subspan(i, same - i), axes[std::min(i, axes.size() - 1)]);
    if (taken == 0) {
      line(places[i], axes[i]);
    }
    i += std::max<std::size_t>(taken, 1);
  }
}

/// FROM tells where the tool stands; nothing moves.
void Moves::from(const Vec3& toolEnd, const Vec3& axis) {
  at_ = toolEnd;
  axis_ = axis;
  sure_ = false;
  block_.comment(fmt::format("FROM {} {} {}", block_.rounded(toolEnd.x()),
                             block_.rounded(toolEnd.y()), block_.rounded(toolEnd.z())));
}

void Moves::putAxes(const Vec3& toolEnd, const Vec3& axis, const Angles& angles) {
  const Vec3 linear = axesOf(machine_, toolEnd, axis, angles);
  block_.changedLength('X', linear.x());
  block_.changedLength('Y', linear.y());
  block_.changedLength('Z', linear.z());
  if (machine_.turning != Machine::Turning::none) {
    const bool ac = machine_.turning == Machine::Turning::tableAc ||
                    machine_.turning == Machine::Turning::headAc;
    block_.changedAngle(ac ? 'A' : 'B', angles.tilt);
    block_.changedAngle('C', angles.turn);
  }
}

void Moves::putFeed() {
  if (feedMode_ == FeedMode::perTurn && !(turns_ > 0.0)) {
    report(fail(diag::NgcSpindle));
  }
  block_.modal('f', feedMode_ == FeedMode::perTurn ? "G95" : "G94");
  const double scale = machine_.inches ? 1.0 / millimetersOfAnInch : 1.0;
  std::string text = fmt::format("F{:.{}f}", *feed_ * scale, feedDecimals);
  block_.modal('F', text);
}

/// Linear and turning axes together: the feed of the tool end needs the time of each line.
void Moves::inverseTime(const Vec3& to, const Vec3& axis, const Angles& angles) {
  double perMinute = feedMode_ == FeedMode::perTurn ? *feed_ * turns_ : *feed_;
  const double length = at_ ? (to - *at_).norm() : 0.0;
  const double turned =
      std::max(std::abs(angles.tilt - angles_.tilt), std::abs(angles.turn - angles_.turn));
  // Where the tool end stands still, the axes turn as many degrees a minute as millimeters.
  const double inverse = perMinute / (length > block_.resolution() ? length : turned);
  block_.modal('f', "G93");
  block_.modal('m', "G1");
  putAxes(to, axis, angles);
  block_.number('F', inverse, feedDecimals);
  block_.forget('F');
  block_.end();
  block_.modal('f', "G94");
  block_.end();
}

void Moves::line(const Vec3& to, const Vec3& axis) {
  const Angles angles =
      machine_.turning == Machine::Turning::none ? Angles{} : anglesOf(machine_, axis, angles_);
  const bool turns = std::abs(angles.tilt - angles_.tilt) + std::abs(angles.turn - angles_.turn) >
                     tolerance::nullDirection;
  if (!rapid_ && !(feed_ && *feed_ > 0.0)) {
    return report(fail(diag::NgcFeedMissing, to.x() / unit_, to.y() / unit_, to.z() / unit_));
  }
  if (!rapid_ && turns) {
    inverseTime(to, axis, angles);
  } else {
    block_.modal('m', rapid_ ? "G0" : "G1");
    putAxes(to, axis, angles);
    if (!rapid_) {
      putFeed();
    }
    block_.end();
  }
  at_ = to;
  axis_ = axis;
  angles_ = angles;
  sure_ = true;
}

/// Puts out an arc from here through the first of `rest` and tells how many it replaces.
std::size_t Moves::arc(std::span<const Vec3> rest, const Vec3& axis) {
  const bool possible = machine_.arcs && run_ && !rapid_ && sure_ && at_ && feed_ && *feed_ > 0.0 &&
                        angles_.tilt == 0.0 && (axis - axis_).norm() <= tolerance::symmetric;
  if (!possible) {
    return 0;
  }
  const auto found = arcThrough(*run_, *at_, rest, machine_.arcTolerance, band_);
  if (!found) {
    return 0;
  }
  constexpr std::array planes = {"G19", "G18", "G17"};
  constexpr std::array offsets = {'I', 'J', 'K'};
  const auto rounded = [&](const Vec3& p) {
    return Vec3(block_.rounded(p.x()), block_.rounded(p.y()), block_.rounded(p.z()));
  };
  const Vec3 start = rounded(*at_);
  const Vec3 end = rounded(found->end);
  const Vec3 toCenter = rounded(found->center - start);
  const auto radial = [&](Vec3 v) {
    v(found->axis) = 0.0;
    return v.norm();
  };
  const double mismatch = std::abs(radial(toCenter) - radial(end - start - toCenter));
  if (mismatch > radiusResolutions * block_.resolution() ||
      radial(end - start) <= radiusResolutions * block_.resolution()) {
    return 0;  // the resolution of the output would break it
  }
  block_.modal('p', planes.at(static_cast<std::size_t>(found->axis)));
  block_.modal('m', found->positive ? "G3" : "G2");
  putAxes(found->end, axis, angles_);
  for (int k = 0; k < 3; ++k) {
    if (k != found->axis) {
      block_.length(offsets.at(static_cast<std::size_t>(k)), toCenter(k));
    }
  }
  putFeed();
  block_.end();
  at_ = found->end;
  return found->points;
}

/// One location under a canned cycle: back to the clearance, not higher (G99).
void Moves::hole(const Vec3& at) {
  if (std::abs(angles_.tilt) > 0.0) {
    return report(fail(diag::NgcCycle, std::string("under a tilted tool axis")));
  }
  if (!(feed_ && *feed_ > 0.0)) {
    return report(fail(diag::NgcFeedMissing, at.x() / unit_, at.y() / unit_, at.z() / unit_));
  }
  const double clear = at.z() + cycle_->clearance * unit_;
  if (!cycleOpen_) {
    // The way to the first hole: at the height where the tool is, or at the clearance if higher.
    block_.modal('m', "G0");
    if (!at_ || at_->z() < clear) {
      block_.changedLength('Z', clear);
      block_.end();
      block_.modal('m', "G0");
    }
    block_.changedLength('X', at.x());
    block_.changedLength('Y', at.y());
    block_.end();
    block_.modal('p', "G17");
    block_.end();
  }
  constexpr std::array codes = {"G81", "G82", "G83"};
  block_.code("G99");
  block_.code(codes.at(static_cast<std::size_t>(cycle_->kind)));
  block_.length('X', at.x());
  block_.length('Y', at.y());
  block_.length('Z', at.z() - cycle_->depth * unit_);
  block_.length('R', clear);
  if (cycle_->kind == Cycle::Kind::dwell) {
    block_.number('P', cycle_->dwell, secondsDecimals);
  } else if (cycle_->kind == Cycle::Kind::peck) {
    block_.length('Q', cycle_->step * unit_);
  }
  putFeed();
  block_.end();
  block_.forget('m');
  block_.forgetAxes();
  cycleOpen_ = true;
  at_ = Vec3(at.x(), at.y(), clear);
  sure_ = true;
}

}  // namespace arelem::backend::ngc
