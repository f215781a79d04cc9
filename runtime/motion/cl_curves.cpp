#include "runtime/motion/cl_curves.h"

#include <cmath>
#include <numbers>
#include <utility>

#include "ir/diag/curves.h"
#include "ir/diag/words.h"
#include "ir/space/motion_tolerance.h"
#include "ir/space/tolerance.h"
#include "ir/words/units.h"
#include "runtime/interpret/passed_post.h"

namespace arelem::motion {

namespace {
/// Chords this fine, relative to the size of the curve, measure its length.
constexpr double measure = 0.0001;

/// Points that a CAM system puts on an arc are so near to one another that the arc rises by less
/// than this over their chords; the part unit where the program names none.
double dividedRise(std::optional<Word> unit) {
  constexpr double millimeters = 0.025;
  constexpr double unknown = 0.001;
  return unit ? millimeters / millimetersOf(*unit) : unknown;
}
}  // namespace

namespace {
/// What is lost where `next`, null at the end of all, is not the end of an arc; none where the arc
/// goes on waiting.
std::optional<Failure> lostBefore(const runtime::Action* next, bool positioned) {
  constexpr std::string_view otherMotion =
      "its end is a GOTO or GODLTA, and another motion follows";
  if (next == nullptr || std::holds_alternative<runtime::Fini>(next->body)) {
    return fail(diag::ArcOpen);
  }
  if (std::holds_alternative<runtime::Arc>(next->body)) {
    return fail(diag::ArcLost, "another arc follows before its GOTO");
  }
  if (const auto* place = std::get_if<runtime::Locate>(&next->body)) {
    if (place->word == Word::FROM || place->axial) {
      return fail(diag::ArcLost, otherMotion);
    }
    return positioned ? std::nullopt
                      : std::optional(
                            fail(diag::ArcLost, "no FROM or GOTO before it says where it starts"));
  }
  const bool moves = std::holds_alternative<runtime::Startup>(next->body) ||
                     std::holds_alternative<runtime::Follow>(next->body) ||
                     std::holds_alternative<runtime::FollowSpline>(next->body) ||
                     std::holds_alternative<runtime::Pocket>(next->body);
  return moves ? std::optional(fail(diag::ArcLost, otherMotion)) : std::nullopt;
}
}  // namespace

void ClCurves::tellLost(const runtime::Action* next) {
  now_ = next;
  auto lost = waiting_ ? lostBefore(next, state_.positioned) : std::nullopt;
  if (lost) {
    reporter_.report(*std::exchange(waiting_, std::nullopt), *std::move(lost));
  }
}

/// The turn of a move of less than a whole one, at one height and on the circle; none of others.
std::optional<double> ClCurves::levelTurn(const ArcMove& move) const {
  if (move.pieces.size() != 1 || !move.warnings.empty()) {
    return std::nullopt;
  }
  const std::vector<double>& circle = move.pieces[0].circle.surface.canon;
  const Vec3 axis(circle[3], circle[4], circle[5]);
  const bool level = std::abs((move.pieces[0].end - state_.toolEnd).dot(axis)) <= tolerance::arcEnd;
  return level ? std::optional(move.length / circle[6]) : std::nullopt;
}

/// How far the chord of a move is off its arc.
double ClCurves::riseOf(const ArcMove& move, double turn) {
  const double radius = move.pieces[0].circle.surface.canon[6];
  return turn < std::numbers::pi ? radius * (1.0 - std::cos(turn / 2.0)) : radius;
}

bool ClCurves::takes(const runtime::Locate& to, std::uint64_t step) {
  step_ = step;
  const std::optional<Divided> before = std::exchange(divided_, std::nullopt);
  if (waiting_) {
    return true;
  }
  if (!before || before->step + 1 != step || to.word != Word::GOTO || to.axis || to.feed) {
    return false;
  }
  const Result<ArcMove> move = arcMove(before->arc, state_.toolEnd, to.point, std::nullopt);
  const std::optional<double> turn = move ? levelTurn(*move) : std::nullopt;
  const double whole = 2.0 * std::numbers::pi + tolerance::symmetric;
  if (!turn || (to.point - state_.toolEnd).norm() <= tolerance::arcEnd ||
      before->turned + *turn > whole) {
    return false;
  }
  const double rise = riseOf(*move, *turn);
  if (creo_ && before->fine && rise <= dividedRise(unit_)) {
    divided_ = before;
    return true;
  }
  if (tellsChords_ && rise > tolerance::arcEnd) {
    constexpr double degrees = 180.0 / std::numbers::pi;
    reporter_.report(*now_, fail(diag::ChordOfArc, *turn * degrees, rise));
    tellsChords_ = false;
  }
  return false;
}

Result<CurveFact> ClCurves::goAlong(const runtime::Locate& to) {
  const double turned = divided_ ? divided_->turned : 0.0;
  const runtime::Arc arc = divided_ ? divided_->arc : std::get<runtime::Arc>(waiting_->body);
  const Vec3 end = to.word == Word::GODLTA ? Vec3(state_.toolEnd + to.point) : to.point;
  divided_.reset();
  waiting_.reset();
  Result<ArcMove> move = arcMove(arc, state_.toolEnd, end, state_.direction[0]);
  state_.direction = {};  // INDIRV was for this arc
  if (!move) {
    return move.takeFailure();
  }
  const std::optional<double> turn =
      arc.axis && !arc.sweepDegrees ? levelTurn(*move) : std::nullopt;
  if (turn) {
    divided_ = Divided{arc, step_, turned + *turn, riseOf(*move, *turn) <= dividedRise(unit_)};
  }
  for (const ArcMove::Piece& piece : move->pieces) {
    if (state_.output) {
      writer_.put(piece.circle);
      writer_.putCurve(cl::Motion::Way::counterclockwise, piece.end, state_.axis, state_.multax);
    }
  }
  state_.toolEnd = end;
  state_.forward = state_.lastAcross = move->tangent;
  return CurveFact{"CIRCLE", move->length, std::move(move->warnings)};
}

void ClCurves::look(const cl::Body& body) {
  if (const auto* units = std::get_if<cl::Units>(&body)) {
    unit_ = units->unit;
  } else if (const auto* text = std::get_if<cl::Text>(&body)) {
    creo_ = creo_ || text->text.find("FEATNO /") == 1;  // `$$-> FEATNO / 605`, kept as PPRINT
  }
  if (const auto* post = std::get_if<cl::Post>(&body)) {
    spline_.take(*post);
  }
}

bool ClCurves::endsSpline(const runtime::Action& next) const {
  const cl::Post* post = passedPost(next);
  const bool goesOn = post != nullptr && path::ClSpline::isPart(*post) && post->foreign != "NURBS";
  return !spline_.empty() && !goesOn;
}

Result<CurveFact> ClCurves::goAlong() {
  const path::ClSpline spline = std::exchange(spline_, {});
  const Vec3 start = state_.toolEnd;
  const Vec3 end = spline.end().value_or(start);
  const auto points = spline.points(start, measure * (end - start).norm() + tolerance::coincidence);
  if (!points) {
    return points.failure();
  }
  CurveFact fact{"NURBS", 0.0, {}};
  Vec3 before = start;
  for (const Vec3& p : *points) {
    fact.length += (p - before).norm();
    before = p;
  }
  if (state_.output) {
    writer_.putCurve(cl::Motion::Way::spline, end, state_.axis, state_.multax);
  }
  state_.toolEnd = end;
  state_.positioned = true;
  return fact;
}

void endAxes(State& state, const runtime::Toggle& toggle) {
  if (toggle.word == Word::MULTAX && !toggle.on) {
    state.axis = Vec3::UnitZ();
    state.axisRule = {};
  }
}

void showAxis(State& state, RecordWriter& writer) {
  if (!state.multax && (state.axis - Vec3::UnitZ()).norm() > tolerance::symmetric) {
    state.multax = true;
    writer.put(cl::Multax{true});
  }
}

}  // namespace arelem::motion
