#include "runtime/motion/settle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <Eigen/Dense>

#include "ir/space/tolerance.h"
#include "runtime/motion/effort.h"
#include "runtime/motion/tilt.h"

namespace arelem::motion {

namespace {
constexpr int iterationLimit = 60;
/// Steps that gain less than this share of what is missed are for nothing; after so many of them in
/// a row a search ends.
constexpr double leastGain = 0.1;
constexpr int patience = 12;
/// So many places in a row without an axis that settles lead nowhere.
constexpr int mostUnsettled = 5;
/// Steps that leave at most this share of what is missed need no new slopes of the axis.
constexpr double stillGood = 0.1;
/// Coming near evenly: the longest and the shortest step, as shares of what is missed at first, how
/// well places on the way are found, and what neighbors have at most: the turn of a contact normal,
/// as a cosine, and their distance for what is gained.
constexpr double longestShare = 0.125;
constexpr double shortestShare = 1e-3;
constexpr double shrunkEnough = 1e-3;
constexpr double sameWay = 0.8;
constexpr double farForGain = 8.0;
/// What is missed up to this many times the rounding of a place is rounding.
constexpr double roundingShare = 1e4;
/// Looking around: places found by whole steps are at most this many times as far from where they
/// began as that is from the middle.
constexpr double nearStart = 2.0;
/// Gaps measured on whole and on even ways until these end: where nothing is found so far, there is
/// hardly anything.
constexpr std::uint64_t mostGaps = 10000;
/// What is left of a direction below this is rounding.
constexpr double noDirection = 4e-16;
/// Looking for the nearest place: trials, the damping that is given up, and steps that are none.
constexpr int trialLimit = 400;
constexpr double mostDamping = 1e12;
constexpr double noStep = 1e-9;

/// Shortest solution of rows * step = rhs for one, two or three rows; falls back to least squares
/// where the rows are nearly dependent.
Vec3 solve(const std::array<Vec3, 3>& rows, const std::array<double, 3>& rhs, std::size_t count) {
  if (count == 3) {
    const Vec3 c = rows[1].cross(rows[2]);
    const double det = rows[0].dot(c);
    if (std::abs(det) > 1e-7) {
      return (rhs[0] * c + rhs[1] * rows[2].cross(rows[0]) + rhs[2] * rows[0].cross(rows[1])) / det;
    }
  }
  if (count == 1) {
    return rhs[0] / rows[0].squaredNorm() * rows[0];
  }
  Eigen::MatrixXd m(static_cast<Eigen::Index>(count), 3);
  Eigen::VectorXd b(static_cast<Eigen::Index>(count));
  for (std::size_t i = 0; i < count; ++i) {
    m.row(static_cast<Eigen::Index>(i)) = rows[i].transpose();
    b[static_cast<Eigen::Index>(i)] = rhs[i];
  }
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> cod;
  cod.setThreshold(1e-10);  // before it is computed: what it holds follows from it
  cod.compute(m);
  return cod.solve(b);
}

/// What is missed at a place, in the first order.
struct Equations {
  std::array<Vec3, 3> rows;
  std::array<double, 3> rhs{};
  std::size_t count = 0;
  double most = 0.0;

  void add(const Vec3& row, double missed) {
    rows[count] = row;
    rhs[count++] = missed;
    most = std::max(most, std::abs(missed));
  }
};

Equations equationsAt(const Settled& at,
                      std::span<const Wanted> wanted,
                      std::span<const Constraint> constraints) {
  Equations e;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    e.add(at.contacts[i].normal, wanted[i].target - at.contacts[i].gap);
  }
  for (const Constraint& c : constraints) {
    e.add(c.normal, c.missedAt(at.toolEnd));
  }
  return e;
}

/// How far a place is from what is wanted.
void compare(Settled& out, std::span<const Wanted> wanted) {
  out.worst = 0.0;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    const double rest = std::abs(wanted[i].target - out.contacts[i].gap);
    if (rest >= out.worst) {
      out.worst = rest;
      out.worstAt = i;
    }
  }
}

/// Axis and contacts where the tool is, and how far it is from what is wanted.
void look(Settled& out, AxisRule& axis, std::span<const Wanted> wanted) {
  out.axis = axis.at(out.toolEnd);
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    out.contacts[i] = wanted[i].field->at(out.toolEnd, out.axis);
  }
  compare(out, wanted);
}
}  // namespace

Settled settle(const Vec3& start,
               AxisRule& axis,
               std::span<const Wanted> wanted,
               std::span<const Constraint> constraints,
               double accept) {
  Settled out = measured(start, axis, wanted);
  settleOn(out, axis, wanted, constraints, accept);
  return out;
}

void settleOn(Settled& out,
              AxisRule& axis,
              std::span<const Wanted> wanted,
              std::span<const Constraint> constraints,
              double accept) {
  Eigen::Matrix3d turning = Eigen::Matrix3d::Zero();
  double previous = 1e300, least = previous;
  int idle = 0, unsettled = 0;
  out.ok = false;
  compare(out, wanted);
  for (out.iterations = 1; out.iterations <= iterationLimit; ++out.iterations) {
    if (out.iterations > 1) {
      look(out, axis, wanted);
    }
    Equations e = equationsAt(out, wanted, constraints);
    const double most = e.most;
    const double rest = roundingAt(out.toolEnd);
    // Done at rounding level, or when Newton has stopped gaining there.
    if (most <= std::max(rest, accept) ||
        (most <= roundingShare * rest && most >= 0.5 * previous)) {
      out.ok = true;
      return;
    }
    idle = most < (1.0 - leastGain) * least ? 0 : idle + 1;
    least = std::min(least, most);
    unsettled = axis.settles() ? 0 : unsettled + 1;
    if (idle >= patience || unsettled >= mostUnsettled) {
      break;
    }
    if (!axis.isFixed()) {
      // How the axis changes takes long to find, and hardly differs as long as steps gain.
      if (unsettled == 0 && (most > stillGood * previous || out.iterations == 1)) {
        turning = axis.change(out.toolEnd).transpose();
      }
      for (std::size_t i = 0; i < wanted.size(); ++i) {
        e.rows[i] += turning * changeWithAxis(out.contacts[i], out.toolEnd, out.axis);
      }
    }
    previous = most;
    const Vec3 step = solve(e.rows, e.rhs, e.count);
    if (!step.allFinite()) {
      return;
    }
    out.toolEnd += step;
  }
  out.ok = out.worst <= 1e-9 * (1.0 + out.toolEnd.cwiseAbs().maxCoeff());
}

FirstStep firstStep(const Settled& from,
                    std::span<const Wanted> wanted,
                    std::span<const Constraint> constraints) {
  const Equations e = equationsAt(from, wanted, constraints);
  return {solve(e.rows, e.rhs, e.count), e.most};
}

Settled measured(const Vec3& place, AxisRule& axis, std::span<const Wanted> wanted) {
  Settled out;
  out.toolEnd = place;
  look(out, axis, wanted);
  return out;
}

namespace {
double squares(const Settled& at, std::span<const Wanted> wanted) {
  double sum = 0.0;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    const double rest = wanted[i].target - at.contacts[i].gap;
    sum += rest * rest;
  }
  return sum;
}

/// Directions in which the constraints let the tool move, as the columns of a projection.
Eigen::Matrix3d freedom(std::span<const Constraint> constraints) {
  Eigen::Matrix3d free = Eigen::Matrix3d::Identity();
  for (const Constraint& c : constraints) {
    const Vec3 n = free * c.normal;
    if (n.norm() > noDirection) {
      free -= n * n.transpose() / n.squaredNorm();
    }
  }
  return free;
}

/// True where one step along the way that shrinks what is missed led from one place to another: the
/// contacts are much the same, and the tool did not go far for what was gained.
bool isNeighbor(const Settled& here, const Settled& there, std::size_t count, double gained) {
  for (std::size_t i = 0; i < count; ++i) {
    if (here.contacts[i].normal.dot(there.contacts[i].normal) < sameWay) {
      return false;
    }
  }
  return (there.toolEnd - here.toolEnd).norm() <= farForGain * gained;
}
}  // namespace

/// Levenberg and Marquardt: a step that misses more is damped until one misses less.
Settled closest(const Vec3& start,
                AxisRule& axis,
                std::span<const Wanted> wanted,
                std::span<const Constraint> constraints) {
  const Eigen::Matrix3d free = freedom(constraints);
  Settled here = measured(start, axis, wanted);
  double damping = 1e-3;
  for (here.iterations = 1; here.iterations < trialLimit && damping < mostDamping;
       ++here.iterations) {
    Eigen::Matrix3d normal = damping * Eigen::Matrix3d::Identity();
    Vec3 right = Vec3::Zero();
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      const Vec3 row = free * here.contacts[i].normal;
      normal += row * row.transpose();
      right += (wanted[i].target - here.contacts[i].gap) * row;
    }
    const Vec3 step = free * normal.ldlt().solve(right);
    const bool far = (here.toolEnd + step - start).norm() > tolerance::farAway;
    if (!step.allFinite() || step.norm() <= noStep || far) {
      break;
    }
    Settled next = measured(here.toolEnd + step, axis, wanted);
    const bool better = squares(next, wanted) < squares(here, wanted);
    damping = better ? damping / 3.0 : damping * 4.0;
    if (better) {
      next.iterations = here.iterations;
      here = next;
    }
  }
  return here;
}

Settled settleEvenly(const Settled& first,
                     AxisRule& axis,
                     std::span<const Wanted> wanted,
                     std::span<const Constraint> constraints) {
  Settled here = first;
  std::vector<Wanted> goals(wanted.begin(), wanted.end());
  std::vector<Constraint> planes(constraints.begin(), constraints.end());
  const auto setGoals = [&](double left) {
    for (std::size_t i = 0; i < goals.size(); ++i) {
      goals[i].target = wanted[i].target + left * (first.contacts[i].gap - wanted[i].target);
    }
    for (std::size_t i = 0; i < planes.size(); ++i) {
      planes[i].through = constraints[i].through + left * (first.toolEnd - constraints[i].through);
    }
  };
  // Where nothing is missed but rounding, no step is short enough for what it gains.
  double left =
      equationsAt(first, wanted, constraints).most > roundingShare * roundingAt(first.toolEnd)
          ? 1.0
          : 0.0;
  for (double share = longestShare; left > 0.0 && share >= shortestShare;) {
    const double next = std::max(0.0, left - share);
    setGoals(next);
    Settled there = here;
    settleOn(there, axis, goals, planes, shrunkEnough * first.worst);
    if (there.ok && isNeighbor(here, there, wanted.size(), (left - next) * first.worst)) {
      here = there;
      left = next;
      share *= 2.0;
    } else {
      share *= 0.5;
    }
  }
  if (left > 0.0) {
    here.ok = false;
    return here;
  }
  settleOn(here, axis, wanted, constraints, 0.0);
  return here;
}

Eigen::Matrix3d frameOf(const Settled& at, std::size_t count) {
  const Vec3 first = at.contacts[0].normal;
  Vec3 second = count > 1 ? at.contacts[1].normal : Vec3(first.unitOrthogonal());
  second -= second.dot(first) * first;
  second = second.norm() > tolerance::nullDirection ? Vec3(second.normalized())
                                                    : Vec3(first.unitOrthogonal());
  Eigen::Matrix3d frame;
  frame << first, second, first.cross(second);
  return frame;
}

namespace {
/// Whole steps that go far lead anywhere, and rounding chooses where: only those that end within a
/// distance count.
Settled settleNear(const Vec3& start,
                   double distance,
                   AxisRule& axis,
                   std::span<const Wanted> wanted,
                   std::span<const Constraint> constraints) {
  Settled found = settle(start, axis, wanted, constraints);
  found.ok = found.ok && (found.toolEnd - start).norm() <= distance;
  return found;
}
}  // namespace

namespace {
/// The directions around a place, the first one towards where the tool comes from: in a plane of
/// symmetry the tool touches at several places at once, and rounding chooses whose normals count.
Eigen::Matrix3d frameTowards(const Vec3& from, const Settled& at, std::size_t count) {
  const Vec3 way = from - at.toolEnd;
  const Eigen::Matrix3d frame = frameOf(at, count);
  if (way.norm() <= tolerance::coincidence) {
    return frame;
  }
  const Vec3 first = way.normalized();
  const Vec3 aside = withinPlane(first, frame.col(0));
  const Vec3 second = aside.norm() > tolerance::nullDirection
                          ? Vec3(aside.normalized())
                          : Vec3(withinPlane(first, frame.col(1)).normalized());
  Eigen::Matrix3d turned;
  turned << first, second, first.cross(second);
  return turned;
}
}  // namespace

Settled nearestAround(const Settled& near,
                      const Vec3& from,
                      AxisRule& axis,
                      std::span<const Wanted> wanted,
                      std::span<const Constraint> constraints) {
  // Distances by what is missed; where the tool nearly fits, that tells nothing about how far off
  // it does, and farther ones are tried until one leads there.
  constexpr double growth = 4.0;
  const double shortest = 0.25 * near.worst;
  const double usual = 16.0 * near.worst;
  const double farthest = std::max(usual, (near.toolEnd - from).norm());
  const Settled next = settleNear(near.toolEnd, farthest, axis, wanted, constraints);
  // Whole steps that lead far end at any of several positions, and rounding chooses at which.
  if (next.ok && (next.toolEnd - near.toolEnd).norm() <= nearStart * near.worst) {
    return next;
  }
  const Eigen::Matrix3d frame = frameTowards(from, near, wanted.size());
  Settled best = next.ok ? next : near;
  double least = next.ok ? (next.toolEnd - from).norm() : tolerance::farAway;
  const auto begun = gapsMeasured();
  // An axis that follows takes long to find, and from so many places no even way finds it either.
  for (const bool evenly : {false, true}) {
    for (double distance = shortest; distance > 0.0 && distance <= farthest; distance *= growth) {
      const bool isFound = least < tolerance::farAway;
      if (isFound ? evenly || distance > usual : evenly && !axis.isFixed()) {
        break;
      }
      for (int cell = 0; cell < 27; ++cell) {
        if (evenly && gapsMeasured() - begun > mostGaps) {
          return best;
        }
        const Vec3 way(cell % 3 - 1, cell / 3 % 3 - 1, cell / 9 - 1);
        const Vec3 start = near.toolEnd + distance * (frame * way);
        axis.startAnew();  // whatever places were tried before
        const Settled found =
            evenly ? settleEvenly(measured(start, axis, wanted), axis, wanted, constraints)
                   : settleNear(start, nearStart * distance, axis, wanted, constraints);
        const double away = (found.toolEnd - from).norm();
        // Mirror images are equally far: the first one stays.
        if (found.ok && away < least - tolerance::coincidence) {
          best = found;
          least = away;
        }
      }
    }
  }
  axis.startAnew();
  axis.stand(best.toolEnd, best.axis);
  return best;
}

}  // namespace arelem::motion
