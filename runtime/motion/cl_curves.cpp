#include "runtime/motion/cl_curves.h"

#include <utility>

#include "ir/diag/curves.h"
#include "ir/space/tolerance.h"
#include "runtime/interpret/passed_post.h"

namespace arelem::motion {

namespace {
/// Chords this fine, relative to the size of the curve, measure its length.
constexpr double measure = 0.0001;
}  // namespace

std::optional<Failure> ClCurves::begin(const runtime::Arc& arc) {
  const bool lost = arc_.has_value();
  arc_ = arc;
  return lost ? std::optional(fail(diag::ArcOpen)) : std::nullopt;
}

Failure ClCurves::drop() {
  arc_.reset();
  return fail(diag::ArcOpen);
}

Result<CurveFact> ClCurves::goAlong(const runtime::Locate& to) {
  const runtime::Arc arc = *std::exchange(arc_, std::nullopt);
  Result<ArcMove> move = arcMove(arc, state_.toolEnd, to.point, state_.direction[0]);
  state_.direction = {};  // INDIRV was for this arc
  if (!move) {
    return move.takeFailure();
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
