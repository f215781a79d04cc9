#include "runtime/motion/pocket.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "ir/diag/motion.h"
#include "ir/diag/pocket.h"
#include "ir/space/tolerance.h"
#include "runtime/motion/convex.h"

namespace arelem::motion {

namespace {
constexpr double degreesOfARadian = 180.0 / std::numbers::pi;
/// Sine of the least angle between tool axis and bottom, about 12 degrees.
constexpr double leastSine = 0.2;
/// From this cosine on the axis stands square on the bottom.
constexpr double square = 0.9999;
constexpr std::size_t mostPasses = 100'000;

/// The eight numbers by their names.
struct Numbers {
  double reach = 0.0;                  ///< Re
  double general = 0.0, finish = 0.0;  ///< c, f: steps in radii of the cutter
  bool adapts = true;                  ///< o = 0
  bool walls = false;                  ///< p = 1, 3: the points are corners of the wall
  bool projects = false;               ///< p = 2, 3: they are projected on the part surface
};

Result<Numbers> numbersOf(const runtime::Pocket& pocket, double radius) {
  const auto& [re, c, f, f1, f2, f3, o, p] = pocket.parameters;
  const std::array<std::pair<std::string_view, double>, 6> positive = {
      {{"Re", re}, {"c", c}, {"f", f}, {"f1", f1}, {"f2", f2}, {"f3", f3}}};
  for (const auto& [name, value] : positive) {
    if (!(value >= 0.0)) {
      return fail(diag::PocketNumber, name, value, "it must not be negative");
    }
  }
  if (!(c > 0.0) || !(f > 0.0)) {
    return fail(diag::PocketNumber, c > 0.0 ? "f" : "c", c > 0.0 ? f : c, "it must be above 0");
  }
  if (o != 0.0 && o != 1.0) {
    return fail(diag::PocketNumber, "o", o, "it is 0 or 1");
  }
  if (p != 0.0 && p != 1.0 && p != 2.0 && p != 3.0) {
    return fail(diag::PocketNumber, "p", p, "it is 0, 1, 2 or 3");
  }
  constexpr double half = 0.5;
  return Numbers{re > 0.0 ? re : half * c * radius, c, f, o == 0.0, p == 1.0 || p == 3.0, p >= 2.0};
}

/// Along the tool axis on the part surface.
Result<std::vector<Vec3>> projected(const std::vector<Vec3>& points, const State& state) {
  surface::Plane bottom{Vec3::UnitZ(), 0.0};
  if (state.part) {
    const auto* plane = std::get_if<surface::Plane>(&state.part->surface);
    if (plane == nullptr) {
      return fail(diag::PocketBottom);
    }
    bottom = *plane;
  }
  const double sine = bottom.normal.dot(state.axis);
  if (std::abs(sine) < leastSine) {
    return fail(diag::PocketAxis, degreesOfARadian * std::asin(std::abs(sine)));
  }
  std::vector<Vec3> on;
  for (const Vec3& p : points) {
    on.emplace_back(p + (bottom.offset - bottom.normal.dot(p)) / sine * state.axis);
  }
  return on;
}

/// Corners of the wall to centers of a cutter whose axis leans: the silhouette across the axis is
/// offset, and the result comes back to the bottom along the axis.
std::vector<Vec3> centersUnderTilt(const ConvexPolygon& wall, const Vec3& axis, double radius) {
  const std::vector<Vec3>& corners = wall.corners();
  const std::size_t n = corners.size();
  std::vector<Vec3> centers;
  const auto across = [&](const Vec3& v) { return Vec3((v - v.dot(axis) * axis).normalized()); };
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3 in = across(corners[i] - corners[(i + n - 1) % n]);
    const Vec3 out = across(corners[(i + 1) % n] - corners[i]);
    const Vec3 middle = (out - in).normalized();
    const double sine = out.cross(middle).norm();
    const Vec3 step = radius / sine * middle;
    centers.emplace_back(corners[i] + step -
                         step.dot(wall.normal()) / axis.dot(wall.normal()) * axis);
  }
  return centers;
}

/// Passes from the outer polygon inwards.
class Passes {
 public:
  Passes(const ConvexPolygon& polygon, const Numbers& numbers, double radius)
      : polygon_(polygon), numbers_(numbers), radius_(radius) {
    sine_ = sharpestSine(polygon.corners());
    adapt(sine_);
  }

  /// None where nothing is left at `distance`.
  Result<std::vector<std::vector<Vec3>>> run(double distance) {
    auto full = polygon_.inset(distance);
    if (!full) {
      return fail(diag::PocketTooSmall, radius_);
    }
    for (bool first = true; full; first = false) {
      passes_.push_back(*full);
      if (passes_.size() > mostPasses) {
        return fail(diag::PocketPasses, mostPasses, numbers_.general * radius_);
      }
      if (isNarrow(*full, 2.0 * numbers_.reach)) {
        break;
      }
      const double step = (first ? numbers_.finish : numbers_.general) * radius_;
      const auto half = polygon_.inset(distance + step / 2.0);
      if (!half || endsAt(*half)) {
        break;
      }
      const std::size_t sides = full->size();
      full = polygon_.inset(distance + step);
      if (sharpens(*half, sides)) {
        distance += smallStep(*half, step);
        full = polygon_.inset(distance);
      } else if (full && sharpens(*full, half->size())) {
        distance += step / 2.0 + smallStep(*full, step);
        full = polygon_.inset(distance);
      } else {
        distance += step;
      }
      if (!full) {
        passes_.push_back(*half);  // what is left in the middle is more than the cutter reaches
      }
    }
    return std::move(passes_);
  }

 private:
  void adapt(double sine) {
    if (numbers_.adapts) {
      const double most = numbers_.reach / radius_ * (1.0 + sine);
      numbers_.general = std::min(numbers_.general, most);
      numbers_.finish = std::min(numbers_.finish, most);
    }
  }

  /// Half a step further in nothing is left that one more pass would not reach: the last pass.
  bool endsAt(const std::vector<Vec3>& half) {
    if (!isNarrow(half, 2.0 * numbers_.reach)) {
      return false;
    }
    if (const auto side = coveringSide(half, numbers_.reach)) {
      const Vec3& a = half[*side];
      const Vec3& b = half[(*side + 1) % half.size()];
      const bool aIsNear = (a - half[0]).norm() <= (b - half[0]).norm();
      passes_.push_back(aIsNear ? std::vector{b, a} : std::vector{a, b});
    } else {
      passes_.push_back(half);
    }
    return true;
  }

  /// Whether sides have vanished and left a sharper corner than any before.
  [[nodiscard]] bool sharpens(const std::vector<Vec3>& corners, std::size_t sides) const {
    return numbers_.adapts && corners.size() < sides && sharpestSine(corners) < sine_;
  }

  /// The next pass is where the sharper corner leaves nothing, and from there on the steps are
  /// smaller.
  double smallStep(const std::vector<Vec3>& corners, double step) {
    sine_ = sharpestSine(corners);
    const double small = std::min(step, 2.0 * numbers_.reach * sine_);
    adapt(sine_);
    return small / 2.0;
  }

  const ConvexPolygon& polygon_;
  Numbers numbers_;
  double radius_;
  double sine_ = 1.0;
  std::vector<std::vector<Vec3>> passes_;
};
}  // namespace

Result<PocketPath> pocketPath(const runtime::Pocket& pocket, const State& state) {
  if (!state.cutter) {
    return fail(diag::CutterUndefined);
  }
  const double radius = state.cutter->d / 2.0;
  if (!(radius > 0.0)) {
    return fail(diag::PocketCutter, 2.0 * radius);
  }
  const Result<Numbers> numbers = numbersOf(pocket, radius);
  if (!numbers) {
    return numbers.failure();
  }
  std::vector<Vec3> points = pocket.points;
  if ((*numbers).projects) {
    Result<std::vector<Vec3>> on = projected(points, state);
    if (!on) {
      return on.takeFailure();
    }
    points = *std::move(on);
  }
  Result<ConvexPolygon> polygon = ConvexPolygon::make(std::move(points));
  if (!polygon) {
    return polygon.takeFailure();
  }
  const double sine = std::abs((*polygon).normal().dot(state.axis));
  if (sine <= leastSine) {
    return fail(diag::PocketAxis, degreesOfARadian * std::asin(sine));
  }
  double distance = (*numbers).walls ? radius : 0.0;
  if ((*numbers).walls && sine < square) {
    polygon = ConvexPolygon::make(centersUnderTilt(*polygon, state.axis, radius));
    if (!polygon) {
      return fail(diag::PocketTooSmall, radius);
    }
    distance = 0.0;
  }
  auto passes = Passes(*polygon, *numbers, radius).run(distance);
  if (!passes) {
    return passes.takeFailure();
  }
  PocketPath path;
  std::reverse((*passes).begin(), (*passes).end());
  Vec3 at = state.toolEnd;
  for (std::vector<Vec3>& pass : *passes) {
    if (pass.size() > 2) {
      pass.push_back(pass.front());
    }
    for (const Vec3& p : pass) {
      path.length += (p - at).norm();
      at = p;
    }
  }
  path.passes = *std::move(passes);
  return path;
}

std::uint64_t putPocket(const PocketPath& path,
                        const runtime::Pocket& pocket,
                        State& state,
                        RecordWriter& writer) {
  std::uint64_t count = 0;
  const auto run = [&](std::size_t pass, std::size_t from) {
    for (std::size_t i = from; i < path.passes[pass].size(); ++i, ++count) {
      writer.add(path.passes[pass][i], state.axis);
    }
  };
  const auto start = [&] { writer.startPoints(cl::Motion::Kind::go, "POCKET", 0, state.multax); };
  const std::size_t last = path.passes.size() - 1;
  writer.putFeed(pocket.parameters[3]);
  start();
  writer.add(path.passes[0][0], state.axis);
  ++count;
  writer.finishPoints();
  writer.putFeed(pocket.parameters[4]);
  start();
  for (std::size_t pass = 0; pass < last; ++pass) {
    run(pass, pass == 0 ? 1 : 0);
  }
  writer.finishPoints();
  writer.putFeed(pocket.parameters[5]);
  start();
  run(last, last == 0 ? 1 : 0);
  writer.finishPoints();
  return count;
}

}  // namespace arelem::motion
