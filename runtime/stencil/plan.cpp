#include "runtime/stencil/plan.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "ir/diag/stencil.h"
#include "ir/diag/told_factor.h"
#include "ir/space/stencil_tolerance.h"
#include "ir/space/tolerance.h"
#include "runtime/geometry/angle.h"

namespace arelem::stencil {

namespace {
Vec3 nozzleOf(const Pose& pose) {
  return {pose.place.x(), pose.place.y(), pose.height};
}

/// Nozzle and height of a pose whose line, yaw and tilt are known.
void place(Pose& pose, const FanGun& gun) {
  const double width = widthOf(pose.line);
  const Tilted tilted = placeTilted(width, gun.fan, pose.tilt);
  const auto [sine, cosine] = geometry::sinCosDegrees(pose.yaw);
  pose.place = middleOf(pose.line) + tilted.shift * Vec2(cosine, sine);
  pose.height = heightOf(gun, width) + tilted.height - heightFor(width, gun.fan);
}

/// The yaw nearest to the one before.
double unwound(double yaw, double before) {
  return yaw + 360.0 * std::round((before - yaw) / 360.0);
}

/// Speed of the move over a cell: the paint of a cell is speedTimesWidth per time, so that its film
/// is that of all others when the time is its area over that. For a square cell this is K / width.
double speedOver(const Pose& from, const Pose& to, const Job& job) {
  if (job.asSource) {
    return job.speedTimesWidth / widthOf(from.line);
  }
  const double area = areaOf(from.line, to.line);
  const double way = (nozzleOf(to) - nozzleOf(from)).norm();
  const double width = 0.5 * (widthOf(from.line) + widthOf(to.line));
  // A cell without area is turned over at the speed of its width.
  const double thin = tolerance::rounding * width * width;
  return area > thin ? job.speedTimesWidth * way / area : job.speedTimesWidth / width;
}

/// A pose on the way from one to the other.
Pose between(const Pose& a, const Pose& b, double t, const FanGun& gun) {
  Pose pose = a;
  pose.line = {a.line.first + t * (b.line.first - a.line.first),
               a.line.second + t * (b.line.second - a.line.second)};
  pose.yaw = unwound(yawOf(pose.line), a.yaw);
  pose.tilt = a.tilt + t * (b.tilt - a.tilt);
  place(pose, gun);
  return pose;
}

/// Run-up: the gun comes from where it would have been `leadOn` before its first line.
void addRunUp(Track& track, const FanGun& gun) {
  if (gun.leadOn <= 0.0 || track.poses.size() < 2) {
    return;
  }
  Pose start = track.poses[0];
  const Vec2 way = track.poses[1].place - start.place;
  if (way.norm() <= tolerance::coincidence) {
    return;
  }
  const Vec2 back = start.speed * gun.leadOn / way.norm() * way;
  start.line.first -= back;
  start.line.second -= back;
  start.place -= back;
  track.poses.insert(track.poses.begin(), start);
  ++track.off;
  ++track.first;
}

/// Puts the pose in at which the gun is switched off, `leadOff` before the end of the last line.
void addSwitchOff(Track& track, const FanGun& gun) {
  track.off = track.poses.size() - 1;
  double left = gun.leadOff;
  for (std::size_t i = track.poses.size() - 1; i-- > track.on && left > 0.0;) {
    const Pose& a = track.poses[i];
    const Pose& b = track.poses[i + 1];
    const double seconds = (nozzleOf(b) - nozzleOf(a)).norm() / a.speed;
    if (seconds > left) {
      track.poses.insert(track.poses.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                         between(a, b, 1.0 - left / seconds, gun));
      track.off = i + 1;
      return;
    }
    left -= seconds;
    track.off = i;
  }
}

/// Cells longer than wide are divided where the gun tilts in the run, so that its tilt can come and
/// go along them.
std::vector<Line> dividedForTilt(const std::vector<Line>& lines, const Job& job) {
  const auto tilts = [&](std::size_t i) {
    constexpr double level = 0.1;  // degrees
    return std::abs(tiltFor(quadrilateralShare(lines[i], lines[i + 1]), job.gun.fan)) > level;
  };
  bool any = false;
  for (std::size_t i = 0; i + 1 < lines.size() && !any; ++i) {
    any = tilts(i);
  }
  if (!any || job.tilt == TiltRule::off || job.asSource) {
    return lines;
  }
  std::vector<Line> divided = {lines.front()};
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const Line& a = lines[i - 1];
    const Line& b = lines[i];
    const double way = (middleOf(b) - middleOf(a)).norm();
    constexpr double mostParts = 1000.0;
    const double width = std::max(std::min(widthOf(a), widthOf(b)), way / mostParts);
    const int parts =
        width > 0.0 ? std::max(1, static_cast<int>(std::ceil(way / width - tolerance::rounding)))
                    : 1;
    for (int k = 1; k <= parts; ++k) {
      const double t = static_cast<double>(k) / parts;
      divided.push_back({a.first + t * (b.first - a.first), a.second + t * (b.second - a.second)});
    }
  }
  return divided;
}
}  // namespace

double heightOf(const FanGun& gun, double width) {
  return gun.heightSlope > 0.0 ? gun.heightAtZero + gun.heightSlope * width
                               : heightFor(width, gun.fan);
}

std::optional<Failure> objectionToSpeeds(std::span<const Track> tracks,
                                         const Job& job,
                                         const std::function<double()>& mostFactor) {
  const Track* track = nullptr;
  const Pose* fastest = nullptr;
  for (const Track& one : tracks) {
    for (const Pose& pose : one.poses) {
      if (fastest == nullptr || pose.speed > fastest->speed) {
        track = &one;
        fastest = &pose;
      }
    }
  }
  const double most = job.gun.speed;
  if (most <= 0.0 || fastest == nullptr || fastest->speed <= most * (1.0 + tolerance::gunSpeed)) {
    return std::nullopt;
  }
  const double factor = std::min(most / fastest->speed, mostFactor());
  return fail(diag::StencilSpeed, track->stroke, track->symbol, fastest->speed, fastest->place.x(),
              fastest->place.y(), widthOf(fastest->line), most, diag::toldFactor(factor));
}

Result<Track> planRun(const Run& run, const Job& job) {
  Track track{run.symbol, run.position, run.stroke, {}, 0, 0, 0};
  const std::vector<Line> lines = dividedForTilt(run.lines, job);
  for (const Line& line : lines) {
    Pose pose;
    pose.line = line;
    pose.yaw = track.poses.empty() ? yawOf(line) : unwound(yawOf(line), track.poses.back().yaw);
    place(pose, job.gun);
    track.poses.push_back(pose);
  }
  const auto setSpeeds = [&] {
    for (std::size_t i = 0; i < track.poses.size(); ++i) {
      const bool last = i + 1 == track.poses.size();
      track.poses[i].speed = job.asSource || !last
                                 ? speedOver(track.poses[i], track.poses[last ? i : i + 1], job)
                                 : (i > 0 ? track.poses[i - 1].speed : 0.0);
    }
  };
  setSpeeds();
  if (job.tilt != TiltRule::off) {
    std::vector<double> seconds;
    for (std::size_t i = 0; i + 1 < track.poses.size(); ++i) {
      seconds.push_back((nozzleOf(track.poses[i + 1]) - nozzleOf(track.poses[i])).norm() /
                        track.poses[i].speed);
    }
    const std::vector<double> tilts =
        job.tilt == TiltRule::best ? evenestTilts(lines, job.gun.fan, job.limits, seconds)
                                   : tiltsOf(lines, job.tilt, job.gun.fan, job.limits, seconds);
    for (std::size_t i = 0; i < tilts.size(); ++i) {
      track.poses[i].tilt = tilts[i];
      place(track.poses[i], job.gun);
    }
    setSpeeds();
  }
  addSwitchOff(track, job.gun);
  if (track.off <= track.on) {
    double whole = 0.0;
    for (std::size_t i = 0; i + 1 < track.poses.size(); ++i) {
      whole +=
          (nozzleOf(track.poses[i + 1]) - nozzleOf(track.poses[i])).norm() / track.poses[i].speed;
    }
    return fail(diag::StencilLead, track.stroke, track.symbol, whole, job.gun.leadOff);
  }
  addRunUp(track, job.gun);
  for (const Pose& pose : track.poses) {
    if (!(pose.height >= tolerance::nozzleHeight)) {
      return fail(
          diag::StencilNumber,
          fmt::format("the height of the nozzle over a line {:.6g} mm wide", widthOf(pose.line)),
          pose.height,
          fmt::format("{:g} mm or more: it stands over the ground", tolerance::nozzleHeight));
    }
  }
  return track;
}

}  // namespace arelem::stencil
