// GOTO/spline: its locations against the curve.
#include "ir/diag/verify.h"
#include "runtime/certify/association.h"
#include "runtime/certify/spline_guide.h"

namespace arelem::certify {

using runtime::Action;

/// The tool goes to the start of the curve, if it is not there, and along it to its end.
void Association::judgeAlong(const Action& action,
                             const runtime::FollowSpline& along,
                             const Run& run) {
  const auto curve = spline::CubicSpline::of(along.curve->canon);
  std::vector<Location> path = pathOf(run);
  StatementResult result;
  result.origin = action.origin;
  result.isn = action.isn;
  result.statement = "GOTO";
  result.cutVectors = path.size();
  const auto objection = [&](Failure failure) {
    result.good = false;
    report(action, std::move(failure));
  };
  if (!curve) {
    objection(fail(diag::NotCertified, curve.failure().message));
  } else {
    const Vec3 start = curve->at(curve->begin());
    const auto isStart = [&](const Vec3& place) {
      return (place - start).norm() <= options_.slack;
    };
    if (path.size() == 1 && isStart(path[0].toolEnd) && !isStart(modal_.toolEnd)) {
      moveTo(path[0]);  // a record of its own: the way to the start
      --index_;
      return;
    }
    if (modal_.positioned && isStart(modal_.toolEnd)) {
      path.insert(path.begin(), {modal_.toolEnd, modal_.axis});
    }
    for (const auto& [end, place] :
         {std::pair{start, path.front().toolEnd}, {curve->at(curve->end()), path.back().toolEnd}}) {
      if (!((end - place).norm() <= options_.slack)) {
        objection(fail(diag::LocationMoved, (end - place).norm()));
      }
    }
    const Allowed allowed{0.0, modal_.inner[driveRole] + modal_.outer[driveRole], options_.slack};
    const std::string name = along.curve->name.empty() ? "(BSPLIN)" : along.curve->name;
    result.drive = GuideFigures{name, allowed, proveAlongSpline(*curve, path, allowed)};
    check_.judge(result, action, *result.drive);
  }
  moveTo(path.back());
  add(std::move(result));
}

}  // namespace arelem::certify
