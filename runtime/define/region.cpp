// REGION definitions.
#include "runtime/region/region.h"

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "ir/diag/spray.h"
#include "ir/space/tolerance.h"
#include "runtime/define/resolve.h"
#include "runtime/region/drawing.h"

namespace arelem::define {

using geometry::Vec2;
using region::Boundary;

namespace {
Failure tooMany(std::uint64_t mostCorners) {
  return fail(diag::RegionSize, mostCorners).withHelp("a larger CHORD makes fewer");
}

/// `chord`: what CHORD says; none where nothing is said.
Result<Resolved> resolved(std::vector<Boundary> boundaries,
                          std::optional<double> chord,
                          std::uint64_t mostCorners) {
  std::size_t corners = 0;
  Eigen::AlignedBox3d box;
  for (const Boundary& boundary : boundaries) {
    corners += boundary.corners.size();
    for (const Vec3& corner : boundary.corners) {
      box.extend(corner);
    }
  }
  if (corners > mostCorners) {
    return tooMany(mostCorners);
  }
  const double coarsest = box.isEmpty() ? HUGE_VAL : box.diagonal().norm() / 4.0;
  if (chord && *chord > coarsest) {
    return fail(diag::RegionChord, *chord,
                fmt::format("at most {:.6g}, a quarter of the region", coarsest));
  }
  Result<region::Region> made = region::regionOf(std::move(boundaries));
  if (!made) {
    return made.takeFailure();
  }
  return Resolved(made->canon());
}

std::string textOf(const Vec2& p) {
  return fmt::format("({:.9g}, {:.9g})", p.x(), p.y());
}

bool startsBoundary(const Arguments& given, std::size_t i) {
  return given.is(i, Word::HOLE) || given.is(i, Word::ISLAND);
}

Boundary::Role roleAt(const Arguments& given, std::size_t i) {
  return given.is(i, Word::HOLE)     ? Boundary::Role::hole
         : given.is(i, Word::ISLAND) ? Boundary::Role::island
                                     : Boundary::Role::outline;
}

/// An element of a boundary: a line, or a circle run through one way or the other.
struct Element {
  bool isCircle = false;
  geometry::Line line;
  geometry::Circle circle;
  std::optional<bool> clockwise;  ///< as written
  std::optional<Word> side;       ///< picks the meeting with the element before
};

/// Distance of a place along the direction that a side word names.
double along(Word side, const Vec2& p) {
  switch (side) {
    case Word::XLARGE:
      return p.x();
    case Word::XSMALL:
      return -p.x();
    case Word::YLARGE:
      return p.y();
    default:
      return -p.y();
  }
}

/// Meetings of a line with a circle about the origin's foot: none, one (tangent) or two; `apart` is
/// how far they are off when there is none.
std::vector<Vec2> meetings(const geometry::Line& line,
                           const geometry::Circle& circle,
                           double& apart) {
  const double height = line.height(circle.middle());
  const Vec2 foot = circle.middle() - height * line.normal;
  const double square = circle.radius * circle.radius - height * height;
  if (std::abs(std::abs(height) - circle.radius) <= tolerance::coincidence) {
    return {foot};
  }
  if (square < 0.0) {
    apart = std::abs(height) - circle.radius;
    return {};
  }
  return {foot - std::sqrt(square) * line.along(), foot + std::sqrt(square) * line.along()};
}

std::vector<Vec2> meetings(const geometry::Line& a, const geometry::Line& b, double& apart) {
  const double sine = a.normal.x() * b.normal.y() - a.normal.y() * b.normal.x();
  if (std::abs(sine) <= tolerance::singular) {
    apart = std::abs(std::abs(a.distance) - std::abs(b.distance));
    return {};
  }
  return {Vec2((a.distance * b.normal.y() - b.distance * a.normal.y()) / sine,
               (b.distance * a.normal.x() - a.distance * b.normal.x()) / sine)};
}

std::vector<Vec2> meetings(const geometry::Circle& a, const geometry::Circle& b, double& apart) {
  const Vec2 step = b.middle() - a.middle();
  const double d = step.norm();
  if (!(d > tolerance::coincidence)) {
    apart = std::abs(a.radius - b.radius);
    return {};
  }
  if (std::abs(d - a.radius - b.radius) <= tolerance::coincidence ||
      std::abs(d - std::abs(a.radius - b.radius)) <= tolerance::coincidence) {
    const double sign = d < std::max(a.radius, b.radius) && b.radius > a.radius ? -1.0 : 1.0;
    return {a.middle() + sign * a.radius * step / d};
  }
  // The radical line of the two circles.
  const double t = (d * d + a.radius * a.radius - b.radius * b.radius) / (2.0 * d);
  geometry::Line radical;
  radical.normal = step / d;
  radical.distance = radical.normal.dot(a.middle()) + t;
  return meetings(radical, a, apart);
}

std::vector<Vec2> meetings(const Element& a, const Element& b, double& apart) {
  if (a.isCircle) {
    return b.isCircle ? meetings(a.circle, b.circle, apart) : meetings(b.line, a.circle, apart);
  }
  return b.isCircle ? meetings(a.line, b.circle, apart) : meetings(a.line, b.line, apart);
}

/// One boundary of lines and circles, chorded.
class CurveBoundary {
 public:
  /// A boundary of more corners than `most` ends early: it is refused by their number.
  CurveBoundary(std::vector<Element> elements,
                std::size_t firstNumber,
                double chord,
                std::uint64_t most)
      : elements_(std::move(elements)), firstNumber_(firstNumber), chord_(chord), most_(most) {}

  Result<region::Corners> corners() {
    const std::size_t n = elements_.size();
    if (n == 1 && elements_[0].isCircle) {
      const geometry::Circle& c = elements_[0].circle;
      add(region::arcPoints(c.middle(), c.radius, 0.0, 2.0 * std::numbers::pi, chord_, most_));
      return std::move(corners_);
    }
    for (std::size_t i = 0; i < n; ++i) {
      Result<Vec2> place = joint((i + n - 1) % n, i);
      if (!place) {
        return place.takeFailure();
      }
      joints_.push_back(*place);
    }
    for (std::size_t i = 0; i < n && corners_.size() <= most_; ++i) {
      elements_[i].isCircle ? addArc(i) : add({joints_[i]});
    }
    return std::move(corners_);
  }

 private:
  Result<Vec2> joint(std::size_t before, std::size_t after) {
    double apart = 0.0;
    const std::vector<Vec2> places = meetings(elements_[before], elements_[after], apart);
    const std::size_t a = firstNumber_ + before;
    const std::size_t b = firstNumber_ + after;
    if (places.empty()) {
      return fail(diag::BoundaryMissed, a, b, apart);
    }
    if (places.size() == 1) {
      return places[0];
    }
    if (!elements_[after].side) {
      return fail(diag::BoundaryUndecided, a, b, textOf(places[0]), textOf(places[1]));
    }
    const Word side = *elements_[after].side;
    return along(side, places[0]) > along(side, places[1]) ? places[0] : places[1];
  }

  /// The arc from joint i to the next one: as written, else the way on in which the boundary does
  /// not turn back, else counterclockwise.
  void addArc(std::size_t i) {
    const geometry::Circle& c = elements_[i].circle;
    const Vec2 from = joints_[i] - c.middle();
    const Vec2 to = joints_[(i + 1) % joints_.size()] - c.middle();
    const bool clockwise = elements_[i].clockwise.value_or(goesOnClockwise(i, from));
    const double start = std::atan2(from.y(), from.x());
    double sweep = std::atan2(to.y(), to.x()) - start;
    if (clockwise) {
      sweep -= sweep >= 0.0 ? 2.0 * std::numbers::pi : 0.0;
    } else {
      sweep += sweep <= 0.0 ? 2.0 * std::numbers::pi : 0.0;
    }
    add(region::arcPoints(c.middle(), c.radius, start, sweep, chord_, most_));
  }

  [[nodiscard]] bool goesOnClockwise(std::size_t i, const Vec2& from) const {
    const std::size_t n = joints_.size();
    const Element& before = elements_[(i + n - 1) % n];
    if (before.isCircle) {
      return false;
    }
    const Vec2 travel = joints_[i] - joints_[(i + n - 1) % n];
    const Vec2 onward(-from.y(), from.x());  // counterclockwise
    const double cosine = travel.normalized().dot(onward.normalized());
    return cosine < -0.5;  // tangent and the other way round
  }

  void add(const std::vector<Vec2>& points) {
    for (const Vec2& p : points) {
      corners_.emplace_back(p.x(), p.y(), 0.0);
    }
  }

  std::vector<Element> elements_;
  std::size_t firstNumber_;
  double chord_;
  std::uint64_t most_;
  std::vector<Vec2> joints_;
  region::Corners corners_;
};

Element elementAt(const Arguments& given, std::size_t& i) {
  Element element;
  if (!given.isEntity(i) && !given.is(i, Word::CLW) && !given.is(i, Word::CCLW)) {
    element.side = given.word(i++);
  }
  if (!given.isEntity(i)) {
    element.clockwise = given.is(i++, Word::CLW);
  }
  element.isCircle = given.is(i, EntityType::circle);
  if (element.isCircle) {
    element.circle = given.circle(i);
  } else {
    element.line = given.line(i);
  }
  ++i;
  return element;
}

double defaultChord(const Arguments& given) {
  return tolerance::boundaryChord / given.millimeters();
}

/// What CHORD says, none without it.
std::optional<double> chordAt(const Arguments& given, std::size_t i) {
  return given.is(i, Word::CHORD) ? std::optional(given.scalar(i + 1)) : std::nullopt;
}

std::optional<Failure> objectionToChord(const std::optional<double>& chord) {
  return !chord || *chord > 0.0 ? std::nullopt
                                : std::optional(fail(diag::RegionChord, *chord, "above 0"));
}

std::string joined(const std::vector<std::string>& names) {
  return fmt::format("{}", fmt::join(names, ", "));
}
}  // namespace

/// Boundaries one after another, each of points or of lines and circles.
Result<Resolved> regionOfBoundaries(const Arguments& given) {
  std::size_t end = given.count();
  if (end >= 2 && given.is(end - 2, Word::CHORD)) {
    end -= 2;
  }
  const std::optional<double> chord = chordAt(given, end);
  if (auto failure = objectionToChord(chord)) {
    return *std::move(failure);
  }
  std::vector<Boundary> boundaries;
  std::size_t number = 1;  // of the element, in messages
  std::size_t all = 0;     // corners
  std::size_t i = 0;
  while (i < end) {
    Boundary& boundary = boundaries.emplace_back(Boundary{roleAt(given, i), {}});
    i += startsBoundary(given, i) ? 1 : 0;
    while (i < end && given.is(i, EntityType::point)) {
      boundary.corners.push_back(given.point(i++));
      ++number;
    }
    std::vector<Element> elements;
    while (i < end && !startsBoundary(given, i)) {
      elements.push_back(elementAt(given, i));
    }
    if (elements.empty()) {
      continue;
    }
    const std::size_t count = elements.size();
    Result<region::Corners> corners =
        CurveBoundary(std::move(elements), number, chord.value_or(defaultChord(given)),
                      given.mostCorners())
            .corners();
    if (!corners) {
      return corners.takeFailure();
    }
    number += count;
    boundary.corners = *std::move(corners);
    all += boundary.corners.size();
    if (all > given.mostCorners()) {
      return tooMany(given.mostCorners());
    }
  }
  return resolved(std::move(boundaries), chord, given.mostCorners());
}

/// Kinds of entities with their numbers and the line of the first.
std::string listed(const region::Drawing::Kinds& kinds) {
  std::vector<std::string> list;
  for (const auto& [entity, kind] : kinds) {
    list.push_back(fmt::format("{} {} ({}line {})", kind.count, entity,
                               kind.count > 1 ? "the first in " : "", kind.line));
  }
  return joined(list);
}

Result<Resolved> regionOfDrawing(const Arguments& given) {
  const std::string& name = given.text(1);
  region::DrawingRules rules;
  rules.layer = given.is(2, Word::LAYER) ? given.text(3) : "";
  const std::optional<double> chord = chordAt(given, given.is(2, Word::LAYER) ? 4 : 2);
  if (auto failure = objectionToChord(chord)) {
    return *std::move(failure);
  }
  Result<std::string> text = given.fileText(name);
  if (!text) {
    return text.takeFailure();
  }
  rules.chord = chord.value_or(defaultChord(given));
  rules.unit = given.millimeters();
  rules.mostPoints = given.mostCorners();
  Result<region::Drawing> drawing = region::readDrawing(*text, name, rules);
  if (!drawing) {
    return drawing.takeFailure();
  }
  if (!drawing->useless.empty()) {
    const bool choice = rules.layer.empty() && drawing->layers.size() > 1;
    return fail(diag::DrawingEntities, name, listed(drawing->useless))
        .withHelp(choice ? "LAYER, 'name' takes the curves of one layer; the layers are " +
                               joined(drawing->layers)
                         : "put them on another layer than the boundary, and name that of the "
                           "boundary: LAYER, 'name'; or hide them");
  }
  if (!drawing->hidden.empty()) {
    given.remark(fail(diag::DrawingHidden, name, listed(drawing->hidden))
                     .withHelp("LAYER, 'name' takes a layer that is off or frozen too"));
  }
  if (drawing->curves.empty()) {
    return fail(diag::DrawingEmpty, name,
                rules.layer.empty() ? "any layer" : "layer `" + rules.layer + "`",
                drawing->layers.empty() ? "none" : joined(drawing->layers));
  }
  const double height = drawing->height;
  Result<std::vector<spray::Loop>> loops =
      region::chained(std::move(drawing->curves), name, tolerance::drawingJoint);
  if (!loops) {
    return loops.takeFailure();
  }
  std::vector<Boundary> boundaries;
  for (const spray::Loop& loop : *loops) {
    Boundary& boundary = boundaries.emplace_back();
    boundary.role = Boundary::Role::byPlace;
    for (const Vec2& p : loop) {
      boundary.corners.emplace_back(p.x(), p.y(), height);
    }
  }
  return resolved(std::move(boundaries), chord, given.mostCorners());
}

}  // namespace arelem::define
