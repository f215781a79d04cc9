#include "runtime/motion/missed.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>

#include "ir/diag/motion.h"
#include "ir/space/tolerance.h"
#include "runtime/certify/motion_check.h"
#include "runtime/motion/told.h"

namespace arelem::motion {

namespace {
/// Where a path ends the axis is asked for this far ahead. Part unit.
constexpr std::array looksAhead{0.0, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2};
/// So far too where many gaps led nowhere.
constexpr std::array looksFarAhead{3e-2, 1e-1};

/// Beside its middle a hollow is lower: a cutter has room in one so many times as wide as it is
/// high.
constexpr double roomy = 2.0;

/// A path that is nearest to a surface so far on comes nearer to it for ever. Part unit.
constexpr double endless = 0.5 * tolerance::farAway;

std::string atTheStart(const CheckWatch& w) {
  return fmt::format(
      "the tool is within the tolerance {} of it where the motion begins, which does not count",
      w.band());
}

/// Where on the drive surface the check surface faces as it does: from a place close by, along the
/// drive surface to where the normals agree. Steps to and fro between surfaces that touch come
/// there ever more slowly.
Vec3 whereParallel(const surface::AnySurface& drive, const surface::AnySurface& check, Vec3 place) {
  constexpr int steps = 20;
  constexpr double trial = 1e-4;
  const auto onDrive = [&](const Vec3& p) {
    const surface::Foot foot = footOn(drive, p);
    return Vec3(p - foot.distance * foot.normal);
  };
  const auto across = [&](const Vec3& p) {
    const Vec3 normal = footOn(drive, p).normal;
    const Vec3 other = footOn(check, p).normal;
    return Vec3(other - other.dot(normal) * normal);
  };
  for (int i = 0; i < steps; ++i) {
    const Vec3 off = across(place);
    const double sine = off.norm();
    if (sine <= tolerance::nullDirection) {
      break;
    }
    const Vec3 way = off / sine;
    const double rate = (across(onDrive(place + trial * way)).dot(way) - sine) / trial;
    if (std::abs(rate) * trial <= tolerance::nullDirection) {
      break;
    }
    place = onDrive(place - sine / rate * way);
  }
  return place;
}

/// Of a fillet that is too narrow for the tool: where drive and check surface touch the latter is
/// hollow. They come together by steps to and fro between them.
std::optional<Failure> doesNotFit(const Course& course, const CheckWatch& w, const Vec3& toolEnd) {
  constexpr int steps = 100;
  constexpr double parallelCosine = 0.99;
  if (w.usesPart() || !(w.toolRadius() > 0.0)) {
    return std::nullopt;
  }
  const surface::AnySurface& drive = course.drive.surface;
  const surface::AnySurface& check = w.surface().surface;
  const tool::Contact guide = course.path.guides[driveRole].field->at(toolEnd, course.start.axis);
  Vec3 place = guide.point;
  for (int i = 0; i < steps; ++i) {
    const surface::Foot on = footOn(check, place);
    place -= on.distance * on.normal;
    const surface::Foot back = footOn(drive, place);
    place -= back.distance * back.normal;
  }
  if (const Vec3 closer = whereParallel(drive, check, place);
      std::abs(footOn(check, closer).distance) <= std::abs(footOn(check, place).distance)) {
    place = closer;
  }
  const surface::Foot there = footOn(check, place);
  const double cosine = there.normal.dot(guide.normal);
  const double hollow = hollowRadius(check, cosine < 0.0 ? -1.0 : 1.0, place);
  const double over = w.toolRadius() - hollow;
  if (std::abs(cosine) < parallelCosine || over <= std::max(w.band(), std::abs(there.distance))) {
    return std::nullopt;
  }
  const Vec3 p = told(place);
  return fail(diag::CutterDoesNotFit, w.toolRadius(), w.surface().name, hollow, over, p.x(), p.y(),
              p.z());
}

/// Of a plane that is parallel to a plane that guides the tool: that stays as far from it as it is.
bool keepsAway(const Course& course, const CheckWatch& w) {
  const auto* check = std::get_if<surface::Plane>(&w.surface().surface);
  const auto isParallel = [&](const NamedSurface& guide) {
    const auto* plane = std::get_if<surface::Plane>(&guide.surface);
    return plane != nullptr &&
           plane->normal.cross(check->normal).norm() <= tolerance::nullDirection;
  };
  return check != nullptr && course.path.axis.isFixed() &&
         (isParallel(course.drive) || isParallel(course.part));
}

/// Of a motion that is nowhere nearer to the check surface than where it begins.
std::string_view neverNearer(const Course& course, const CheckWatch& w) {
  if (keepsAway(course, w)) {
    return "it is parallel to the way: the tool stays as far from it as it is";
  }
  return course.drive.isPlane() && course.part.isPlane()
             ? "the tool moves away from it from the start on"
             : "the tool is nowhere nearer to it than at the start";
}

/// Of a part surface that goes over into a hollow, a fillet: there the check surface bends towards
/// the tool.
bool isHollow(const Course& course, const CheckWatch& w, const Vec3& toolEnd) {
  const surface::Foot foot = footOn(w.surface().surface, toolEnd);
  const double side = foot.normal.dot(course.start.axis) < 0.0 ? -1.0 : 1.0;
  return hollowRadius(w.surface().surface, side, toolEnd) < endless;
}

/// Why no tangency was met.
Failure noTangency(const Course& course, const CheckWatch& w) {
  const std::string& partner = w.usesPart() ? course.part.name : course.drive.name;
  const double gap = w.parallel() ? w.parallel()->gap : w.nearest();
  const Vec3 where = told(w.parallel() ? w.parallel()->place : w.nearestPlace());
  const bool cross = !w.parallel() && gap <= w.band();
  const bool overlaps = w.parallel() ? gap < 0.0 : w.nearestOverlaps();
  if (auto narrow = cross ? std::nullopt : doesNotFit(course, w, where)) {
    return *std::move(narrow);
  }
  Failure none = fail(diag::NoTangency, partner, w.surface().name, w.band(),
                      cross      ? "cross without being parallel, off"
                      : overlaps ? "overlap"
                                 : "miss each other",
                      std::abs(told(gap)), where.x(), where.y(), where.z());
  if (overlaps && w.usesPart() && isHollow(course, w, where)) {
    return std::move(none).withHelp(fmt::format(
        "the bottom is level there and does not fit into the hollow `{}`: TO a plane through the "
        "line where they touch stops with the bottom at that line; a ball fits",
        w.surface().name));
  }
  const double away = (where - course.start.toolEnd).norm();
  if (cross && away > endless) {
    return std::move(none).withHelp("they come nearer to each other without end");
  }
  return cross && away <= tolerance::coincidence ? std::move(none).withHelp(atTheStart(w)) : none;
}

/// Of a check surface that is met, but PAST for TO or TO for PAST.
Failure metTheOtherWay(const CheckWatch& w) {
  const Vec3 last = told(w.lastContact());
  const bool asksPast = w.condition() == ir::Condition::past;
  Failure never = fail(diag::CheckNotReached, w.surface().name, certify::spell(w.condition()), 0.0,
                       last.x(), last.y(), last.z());
  if (w.startedAt() && !asksPast) {
    return std::move(never).withHelp(
        "the tool stands at it at the start, so that it is PAST it first; without a way to go, "
        "leave the motion out");
  }
  return std::move(never).withHelp(
      asksPast ? "the tool is TO it there and never comes clear of it again"
               : "the tool is PAST it there: it begins in it, comes clear of it and never meets it "
                 "again");
}

/// Why one check surface did not end the motion.
Failure missedOne(const Course& course, const CheckWatch& w) {
  const Vec3 p = told(w.nearestPlace());
  const std::string_view condition = certify::spell(w.condition());
  if (w.neverLeft()) {
    return fail(diag::CheckNeverLeft, w.surface().name, condition, w.band());
  }
  if (w.isTangent()) {
    return noTangency(course, w);
  }
  if (w.touchedAny() && w.nth() > 1) {
    const Vec3 last = told(w.lastContact());
    return fail(diag::CheckMetTooSeldom, w.met(), w.nth(), condition, w.surface().name, last.x(),
                last.y(), last.z());
  }
  if (w.touchedAny()) {
    return metTheOtherWay(w);
  }
  Failure never = fail(diag::CheckNotReached, w.surface().name, condition, told(w.nearest()), p.x(),
                       p.y(), p.z());
  if (w.thickPassesTool()) {
    return std::move(never).withHelp(
        "the negative THICK of the check surface is deeper than the radius of the tool, which is "
        "never clear of it then");
  }
  if (w.startedAt()) {
    return std::move(never).withHelp(atTheStart(w));
  }
  if ((w.nearestPlace() - course.start.toolEnd).norm() <= tolerance::coincidence) {
    return std::move(never).withHelp(std::string(neverNearer(course, w)));
  }
  return never;
}

/// Facets are parallel up to this sine: the rounding of a file is 6e-8 of the coordinates, and an
/// edge of a triangle may be shorter than these.
constexpr double levelFacet = 1e-5;

/// Sine of the angle between the surfaces where the tool touches them.
double sineOf(const PathPoint& at) {
  return at.contacts[0].normal.cross(at.contacts[1].normal).norm();
}

Failure parallelAt(const Course& course, const PathPoint& at) {
  const Vec3 p = told(at.toolEnd);
  return fail(diag::SurfacesParallel, course.drive.name, course.part.name, p.x(), p.y(), p.z());
}

/// An axis that turns by more than this within a band has leapt. Radians.
constexpr double leastLeap = 1e-3;

/// By how much the axis turns within a band ahead of a place, where the path is straight.
double leapOfAxis(Path& path, const PathPoint& last) {
  const auto& guides = path.guides;
  if (path.axis.isFixed() || !(guides[0].field->isFaceted() || guides[1].field->isFaceted())) {
    return 0.0;
  }
  const Vec3 ahead = path.axis.at(last.toolEnd + path.band() * last.tangent);
  return std::atan2(last.axis.cross(ahead).norm(), last.axis.dot(ahead));
}

/// Sine from which on a cylinder lies across the tool.
constexpr double crossing = 0.5;

/// The diameter of a cylinder or sphere if the tool lies in it and not on it: if the center is
/// above the tool end. 0 of others, and of cylinders along the tool.
double hollowOver(const surface::AnySurface& surface, const PathPoint& tool) {
  Vec3 center = tool.toolEnd;
  double radius = 0.0;
  if (const auto* sphere = std::get_if<surface::Sphere>(&surface)) {
    center = sphere->center;
    radius = sphere->radius;
  } else if (const auto* c = std::get_if<surface::Cylinder>(&surface);
             c != nullptr && tool.axis.cross(c->axis).norm() > crossing) {
    center = c->point + (tool.toolEnd - c->point).dot(c->axis) * c->axis;
    radius = c->radius;
  }
  return (center - tool.toolEnd).dot(tool.axis) > 0.0 ? 2.0 * radius : 0.0;
}
}  // namespace

std::optional<Failure> axisEnds(Course& course, const PathPoint& last) {
  for (const double ahead : looksAhead) {
    auto bad = course.path.axis.fault(last.toolEnd + ahead * last.tangent);
    if (bad && bad->row == diag::AxisImpossible.row) {
      return bad;
    }
  }
  return std::nullopt;
}

namespace {
std::optional<Failure> axisFails(Course& course,
                                 const PathPoint& last,
                                 std::span<const double> looks) {
  for (const double ahead : looks) {
    if (auto bad = course.path.axis.fault(last.toolEnd + ahead * last.tangent)) {
      return bad;
    }
  }
  return std::nullopt;
}

/// Where there is no axis any more steps beyond end nowhere. It is looked for from where the tool
/// is: where else it was looked for depends on steps that led nowhere.
std::optional<Failure> axisFails(Course& course, const PathPoint& last) {
  course.path.axis.stand(last.toolEnd, last.axis);
  return axisFails(course, last, looksAhead);
}
}  // namespace

Failure tooMuch(Course& course,
                const PathPoint& last,
                std::uint64_t gaps,
                std::uint64_t cutVectors) {
  if (auto jump = course.path.axis.jump(last.toolEnd)) {
    return *std::move(jump);
  }
  auto bad = axisFails(course, last);
  if (!bad) {
    bad = axisFails(course, last, looksFarAhead);
  }
  if (bad) {
    return *std::move(bad);
  }
  const Vec3 p = told(last.toolEnd);
  return fail(diag::MotionEffort, gaps, cutVectors, p.x(), p.y(), p.z());
}

Failure tooMany(const Course& course, const PathPoint& last, double cutVectors) {
  if (std::all_of(course.watches.begin(), course.watches.end(),
                  [&](const CheckWatch& w) { return keepsAway(course, w); })) {
    return missed(course);
  }
  const Vec3 p = told(last.toolEnd);
  const CheckWatch& w = course.watches.front();
  // Of a tangency what counts is where the surfaces are parallel: the tool may cross elsewhere.
  const double nearest = w.parallel() ? std::abs(w.parallel()->gap) : w.nearest();
  const Vec3 q = told(w.parallel() ? w.parallel()->place : w.nearestPlace());
  Failure limit = fail(diag::CutVectorLimit, cutVectors, p.x(), p.y(), p.z(), w.surface().name,
                       told(nearest), q.x(), q.y(), q.z());
  return w.isTangent() ? std::move(limit).note(missedOne(course, w).message) : limit;
}

std::optional<Failure> parallelBetween(const Course& course,
                                       const PathPoint& a,
                                       const PathPoint& b) {
  const auto& guides = course.path.guides;
  const bool faceted = guides[0].field->isFaceted() || guides[1].field->isFaceted();
  const bool parallel = faceted && sineOf(a) <= levelFacet && sineOf(b) <= levelFacet &&
                        (b.toolEnd - a.toolEnd).norm() > tolerance::coincidence;
  return parallel ? std::optional(parallelAt(course, a)) : std::nullopt;
}

Failure lost(Course& course, const PathPoint& last) {
  if (auto bad = axisFails(course, last)) {
    return *std::move(bad);
  }
  if (sineOf(last) <= tolerance::nullDirection) {
    return parallelAt(course, last);
  }
  const Vec3 p = told(last.toolEnd);
  Failure end = fail(diag::ContactLost, course.drive.name, course.part.name, p.x(), p.y(), p.z());
  const double leap = leapOfAxis(course.path, last);
  return leap > leastLeap
             ? std::move(end).withHelp(fmt::format(
                   "the tool axis leaps by {:.3g} degrees there, as the normal does from one "
                   "triangle to the next: while it turns the cutter leaves the tolerance",
                   leap * 180.0 / std::numbers::pi))
             : end;
}

Failure missed(const Course& course) {
  Failure all = missedOne(course, course.watches.front());
  for (std::size_t i = 1; i < course.watches.size(); ++i) {
    all.notes.push_back(missedOne(course, course.watches[i]).message);
  }
  return all;
}

bool tellsNearest(const Failure& failure) {
  return failure.row == diag::CheckNotReached.row || failure.row == diag::NoTangency.row ||
         failure.row == diag::CutVectorLimit.row || failure.row == diag::RunsOffEnd.row ||
         failure.row == diag::ContactLost.row;
}

Failure withStart(Failure failure, const Course& course) {
  const bool ofPath = failure.row == diag::ContactLost.row || failure.row == diag::RunsOffEnd.row ||
                      failure.row == diag::SurfacesParallel.row ||
                      failure.row == diag::CutVectorLimit.row;
  for (const CheckWatch& w : course.watches) {
    // Often it is the check surface that is not where it was thought to be.
    if (failure.row == diag::ContactLost.row) {
      failure.notes.push_back(missedOne(course, w).message);
    }
    if (ofPath && failure.help.empty() && w.startedAt() && !w.isTangent()) {
      failure.help = fmt::format(
          "the tool stands at check surface `{}` where the motion begins, which does not count: it "
          "went on past it",
          w.surface().name);
    }
  }
  return failure;
}

Failure withHeight(Failure failure, const Course& course, const tool::Profile& cutter) {
  std::vector<const NamedSurface*> surfaces{&course.part};
  for (const CheckWatch& w : course.watches) {
    surfaces.push_back(&w.surface());
  }
  for (const NamedSurface* surface : surfaces) {
    const double wide = hollowOver(surface->surface, course.start);
    if (failure.help.empty() && wide > 0.0 && wide < roomy * cutter.h) {
      failure.help = fmt::format(
          "the cutter is {:.6g} high, the hollow `{}` {:.6g}: if only its lower end lies in it, "
          "give "
          "the height that cuts, the seventh number of CUTTER",
          cutter.h, surface->name, wide);
    }
  }
  return failure;
}

}  // namespace arelem::motion
