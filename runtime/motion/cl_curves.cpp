#include "runtime/motion/cl_curves.h"

#include <cmath>
#include <numbers>
#include <utility>

#include "ir/diag/curves.h"
#include "ir/diag/words.h"
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
  constexpr std::string_view otherMotion = "its end is a GOTO, and another motion follows";
  if (next == nullptr || std::holds_alternative<runtime::Fini>(next->body)) {
    return fail(diag::ArcOpen);
  }
  if (std::holds_alternative<runtime::Arc>(next->body)) {
    return fail(diag::ArcLost, "another arc follows before its GOTO");
  }
  if (const auto* place = std::get_if<runtime::Locate>(&next->body)) {
    if (place->word != Word::GOTO) {
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
  auto lost = waiting_ ? lostBefore(next, state_.positioned) : std::nullopt;
  if (lost) {
    reporter_.report(*std::exchange(waiting_, std::nullopt), *std::move(lost));
  }
}

/// The turn of a move at one height whose chord stays as near to it as the points of an arc that a
/// CAM system divided; none of others.
std::optional<double> ClCurves::fineTurn(const ArcMove& move) const {
  if (move.pieces.size() != 1 || !move.warnings.empty()) {
    return std::nullopt;
  }
  const std::vector<double>& circle = move.pieces[0].circle.surface.canon;
  const Vec3 axis(circle[3], circle[4], circle[5]);
  const double radius = circle[6];
  const double turn = move.length / radius;
  const double rise = radius * (1.0 - std::cos(turn / 2.0));
  const bool level = std::abs((move.pieces[0].end - state_.toolEnd).dot(axis)) <= arcEnd;
  return level && turn < std::numbers::pi && rise <= dividedRise(unit_) ? std::optional(turn)
                                                                        : std::nullopt;
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
  const std::optional<double> turn = move ? fineTurn(*move) : std::nullopt;
  if (!turn || before->turned + *turn > 2.0 * std::numbers::pi) {
    return false;
  }
  divided_ = before;
  return true;
}

Result<CurveFact> ClCurves::goAlong(const runtime::Locate& to) {
  const double turned = divided_ ? divided_->turned : 0.0;
  const runtime::Arc arc = divided_ ? divided_->arc : std::get<runtime::Arc>(waiting_->body);
  divided_.reset();
  waiting_.reset();
  Result<ArcMove> move = arcMove(arc, state_.toolEnd, to.point, state_.direction[0]);
  state_.direction = {};  // INDIRV was for this arc
  if (!move) {
    return move.takeFailure();
  }
  const std::optional<double> turn = arc.axis && !arc.sweepDegrees ? fineTurn(*move) : std::nullopt;
  if (turn) {
    divided_ = Divided{arc, step_, turned + *turn};
  }
  for (const ArcMove::Piece& piece : move->pieces) {
    if (state_.output) {
      writer_.put(piece.circle);
      writer_.putCurve(cl::Motion::Way::counterclockwise, piece.end, state_.axis, state_.multax);
    }
  }
  state_.toolEnd = to.point;
  state_.forward = state_.lastAcross = move->tangent;
  return CurveFact{"CIRCLE", move->length, std::move(move->warnings)};
}

void ClCurves::look(const cl::Body& body) {
  if (const auto* units = std::get_if<cl::Units>(&body)) {
    unit_ = units->unit;
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

void showAxis(State& state, RecordWriter& writer) {
  if (!state.multax && (state.axis - Vec3::UnitZ()).norm() > tolerance::symmetric) {
    state.multax = true;
    writer.put(cl::Multax{true});
  }
}

}  // namespace arelem::motion
