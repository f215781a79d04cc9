#include "runtime/film/bursts.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "runtime/parallel/crew.h"

namespace arelem::film {

namespace {
constexpr double piecesOfRadius = 8.0;  // of the footprint, in one piece of a stroke
constexpr double followed = 3.0;        // footprints that paint flies past its place
constexpr double straight = 0.9;        // of their way, strokes that are one
constexpr std::size_t portion = 256;    // places that a thread takes at once
constexpr double plainStandOff = 1e6;   // of a gun without one: parallel rays, mm

/// Strokes that follow each other and are short together are one: fine chords make no more bursts.
std::vector<spray::Stroke> joined(const std::vector<spray::Stroke>& strokes, double piece) {
  std::vector<spray::Stroke> all;
  double way = 0.0;  // of the last one
  for (const spray::Stroke& stroke : strokes) {
    const double length = (stroke.to - stroke.from).norm();
    const bool goesOn = !all.empty() && way + length <= piece && !stroke.newPass &&
                        stroke.painting && all.back().painting && stroke.from == all.back().to &&
                        (stroke.to - all.back().from).norm() > straight * (way + length);
    if (!goesOn) {
      all.push_back(stroke);
      way = length;
      continue;
    }
    spray::Stroke& last = all.back();
    const double seconds = (last.to - last.from).norm() / last.speed + length / stroke.speed;
    last.to = stroke.to;
    last.normalTo = stroke.normalTo;
    last.speed = (last.to - last.from).norm() / seconds;
    way += length;
  }
  return all;
}
}  // namespace

Bursts::Bursts(const spray::Sprayed& s)
    : profile_(s.gun.profile()),
      a_(s.gun.footprint.along),
      b_(s.gun.footprint.across),
      d_(s.gun.standOff > 0.0 ? s.gun.standOff : plainStandOff),
      flow_(s.chosen.operation.flow * s.gun.efficiency),
      reach_(followed * std::max(a_, b_)) {
  const double piece = std::max(a_, b_ / piecesOfRadius) / piecesOfRadius;
  // The gun is not turned over from pass to pass: its side lies to the same hand.
  Vec3 side = Vec3::Zero();
  for (spray::Stroke stroke : joined(s.strokes, piece)) {
    const Vec3 across = stroke.normalFrom.cross(stroke.to - stroke.from);
    if (side.dot(across) < 0.0) {
      std::swap(stroke.from, stroke.to);
      std::swap(stroke.normalFrom, stroke.normalTo);
    }
    side = side.dot(across) < 0.0 ? Vec3(-across) : across;
    if (stroke.painting) {
      divide(stroke, piece);
    }
  }
  for (auto& [cell, group] : cells_) {
    bound(group);
  }
}

std::size_t Bursts::mostNear() const {
  constexpr std::size_t cellsAbout = 9;  // a surface goes through that many
  std::size_t most = 0;
  for (const auto& [cell, group] : cells_) {
    most = std::max(most, group.bursts.size());
  }
  return cellsAbout * most;
}

double Bursts::filmAt(const Vec3& place, const Vec3& normal) const {
  Near near;
  return filmAt(place, normal, near);
}

double Bursts::filmAt(const Vec3& place, const Vec3& normal, Near& near) const {
  const Cell cell = cellOf(place);
  if (!near.known || near.cell != cell) {
    near = {cell, true, {}};
    const auto [i, j, k] = cell;
    constexpr auto about = static_cast<long>(followed);
    for (long x = i - about; x <= i + about; ++x) {
      for (long y = j - about; y <= j + about; ++y) {
        // Cells of one column lie side by side.
        for (auto found = cells_.lower_bound({x, y, k - about});
             found != cells_.end() && found->first <= Cell{x, y, k + about}; ++found) {
          near.groups.push_back(&found->second);
        }
      }
    }
  }
  double film = 0.0;
  for (const Group* group : near.groups) {
    if (mayReach(*group, place)) {
      for (const Burst& burst : group->bursts) {
        film += one(burst, place, normal);
      }
    }
  }
  return film;
}

std::vector<double> Bursts::filmsAt(const std::vector<Place>& places) const {
  std::vector<double> films(places.size(), 0.0);
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    Near near;
    for (std::size_t first = next.fetch_add(portion); first < places.size();
         first = next.fetch_add(portion)) {
      for (std::size_t i = first; i < std::min(first + portion, places.size()); ++i) {
        films[i] = filmAt(places[i].at, places[i].normal, near);
      }
    }
  };
  parallel::withCrew(places.size() / portion + 1, work);
  return films;
}

Bursts::Cell Bursts::cellOf(const Vec3& place) const {
  const Vec3 cell = place / (reach_ / followed);
  return {std::lround(std::floor(cell.x())), std::lround(std::floor(cell.y())),
          std::lround(std::floor(cell.z()))};
}

void Bursts::bound(Group& group) const {
  Vec3 low = Vec3::Constant(HUGE_VAL);
  Vec3 high = -low;
  Vec3 sum = Vec3::Zero();
  for (const Burst& burst : group.bursts) {
    const Vec3 target = burst.nozzle - d_ * burst.axis;
    low = low.cwiseMin(target);
    high = high.cwiseMax(target);
    sum += burst.axis;
  }
  group.center = (low + high) / 2.0;
  group.axis = sum.norm() > 0.0 ? Vec3(sum.normalized()) : Vec3(Vec3::UnitZ());
  for (const Burst& burst : group.bursts) {
    const Vec3 target = burst.nozzle - d_ * burst.axis;
    const bool beside = burst.axis.dot(group.axis) <= 0.0;
    group.radius = std::max(group.radius, (target - group.center).norm());
    group.sine = beside ? 1.0 : std::max(group.sine, burst.axis.cross(group.axis).norm());
    group.halfWay = std::max(group.halfWay, burst.halfWay);
  }
}

/// Whether a burst of the group may reach a place: its distance from the group's axis is no more
/// than what the bursts lie about the axis, what they lean, and what their cones are wide there.
bool Bursts::mayReach(const Group& group, const Vec3& place) const {
  const Vec3 arm = place - group.center;
  const double height = arm.dot(group.axis);
  const double lean = group.radius + (arm.norm() + group.radius) * group.sine;
  const double depth = d_ + std::max(0.0, -height) + lean;
  const double cone = std::hypot(b_, std::max(a_, b_ / piecesOfRadius / piecesOfRadius));
  return (arm - height * group.axis).norm() <= lean + group.halfWay + cone * depth / d_;
}

void Bursts::divide(const spray::Stroke& s, double piece) {
  const Vec3 step = s.to - s.from;
  const double length = step.norm();
  const auto count = static_cast<int>(std::max(1.0, std::ceil(length / piece)));
  for (int i = 0; i < count; ++i) {
    const double share = (i + 0.5) / count;
    const Vec3 axis = (s.normalFrom + share * (s.normalTo - s.normalFrom)).normalized();
    const Vec3 target = s.from + share * step;
    cells_[cellOf(target)].bursts.push_back(
        {target + d_ * axis, axis, step / length, length / count / 2.0, length / count / s.speed});
  }
}

/// Film that one burst leaves: the density of the footprint at the stand-off, carried along the
/// ray to the place.
double Bursts::one(const Burst& burst, const Vec3& place, const Vec3& normal) const {
  const Vec3 ray = place - burst.nozzle;
  const double depth = -ray.dot(burst.axis);
  if (!(depth > 0.0) || !(normal.dot(ray) < 0.0)) {
    return 0.0;
  }
  const Vec3 lateral = (ray + depth * burst.axis) * (d_ / depth);
  const double y = lateral.dot(burst.axis.cross(burst.along)) / b_;
  if (!(std::abs(y) < 1.0)) {
    return 0.0;
  }
  const double half = std::max(a_, b_ / piecesOfRadius / piecesOfRadius) * std::sqrt(1.0 - y * y);
  // The share of the burst's way on which the footprint lies over the place.
  const double x = lateral.dot(burst.along);
  const double way = burst.halfWay * d_ / depth;
  const double over = (std::min(half, x + way) - std::max(-half, x - way)) / (2.0 * way);
  if (!(over > 0.0)) {
    return 0.0;
  }
  const double length = ray.norm();
  const double nearer = d_ / depth;
  const double met = -normal.dot(ray) / length;
  const double left = depth / length;
  return flow_ * burst.seconds * over * profile_.density(y) / (b_ * 2.0 * half) * nearer * nearer *
         met / left;
}

}  // namespace arelem::film
