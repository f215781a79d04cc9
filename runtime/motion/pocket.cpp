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
/// How exactly a step is known, as a share of Re.
constexpr double reachRounding = 1e-12;
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

/// Passes from the outer polygon inwards.
class Passes {
 public:
  Passes(const ConvexPolygon& polygon, const Numbers& numbers, double radius)
      : polygon_(polygon), numbers_(numbers), radius_(radius) {
    if (numbers_.adapts) {
      const double most = numbers_.reach / radius_ * (1.0 + sharpestSine(polygon.corners()));
      numbers_.general = std::min(numbers_.general, most);
      numbers_.finish = std::min(numbers_.finish, most);
    }
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
      const double step =
          clearingStep(distance, (first ? numbers_.finish : numbers_.general) * radius_);
      const auto half = polygon_.inset(distance + step / 2.0);
      if (!half || endsAt(*half)) {
        break;
      }
      distance += step;
      full = polygon_.inset(distance);
      if (!full) {
        passes_.push_back(*half);  // what is left in the middle is more than the cutter reaches
      }
    }
    return std::move(passes_);
  }

 private:
  /// The longest step up to `step` after which nothing stays between two passes. Where sides have
  /// vanished and left sharper corners than any of the wall that is less than elsewhere. What the
  /// pass at `distance` does not reach is the polygon Re further in, and the next one reaches it
  /// where its corners are within Re of what that one goes round.
  [[nodiscard]] double clearingStep(double distance, double step) const {
    const auto left = numbers_.adapts ? polygon_.inset(distance + numbers_.reach) : std::nullopt;
    if (!left) {
      return step;
    }
    const auto clears = [&](double s) {
      const auto next = polygon_.inset(distance + s);
      return next && std::all_of(left->begin(), left->end(), [&](const Vec3& p) {
               return outside(*next, polygon_.normal(), p) <=
                      (1.0 + reachRounding) * numbers_.reach;
             });
    };
    if (step <= numbers_.reach || clears(step)) {
      return step;
    }
    double low = numbers_.reach;
    while (step - low > reachRounding * numbers_.reach) {
      const double middle = 0.5 * (low + step);
      (clears(middle) ? low : step) = middle;
    }
    return low;
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

  const ConvexPolygon& polygon_;
  Numbers numbers_;
  double radius_;
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
    // The walls stand along the axis.
    const bool up = (*polygon).normal().dot(state.axis) > 0.0;
    auto centers = (*polygon).between(radius, up ? state.axis : Vec3(-state.axis));
    if (!centers) {
      return fail(diag::PocketTooSmall, radius);
    }
    polygon = *std::move(centers);
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
