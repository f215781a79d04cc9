#include <cmath>

#include "ir/diag/interpret.h"
#include "ir/space/tolerance.h"
#include "runtime/interpret/cl_statement.h"
#include "runtime/interpret/command.h"
#include "runtime/interpret/motion.h"

namespace arelem::runtime::interpret {

namespace {

constexpr std::string_view axisForms =
    "TLAXIS/vector, TLAXIS/i,j,k, TLAXIS/{NORMPS|NORMDS}, TLAXIS/1, TLAXIS/PARLEL,{1|2} and "
    "TLAXIS/ATANGL,{1|2},alpha[,vector|,CUTANG,beta]";
constexpr double largestAxisAngle = 90.0;

/// Three numbers written in the current system as a vector in the base system; none if they are
/// not.
std::optional<Vec3> threeNumbers(const State& state, const Items& items, bool asPoint) {
  if (items.size() != 3) {
    return std::nullopt;
  }
  Vec3 v;
  for (int i = 0; i < 3; ++i) {
    const double* number = items[static_cast<std::size_t>(i)].number();
    if (number == nullptr) {
      return std::nullopt;
    }
    v[i] = *number;
  }
  return asPoint ? state.systems.pointToBase(v) : state.systems.vectorToBase(v);
}

/// 1 or 2 after PARLEL and ATANGL; 0 with a report.
int axisSurface(State& state, const Items& items) {
  const double* number = items.size() > 1 ? items[1].number() : nullptr;
  if (number == nullptr) {
    state.report(diagnose(state.statement->span, diag::AxisKind, describe(items), axisForms));
    return 0;
  }
  if (*number != 1.0 && *number != 2.0) {
    state.report(
        diagnose(items[1].span, diag::AxisItem, spell(std::get<Word>(items[0].value)), *number));
    return 0;
  }
  return static_cast<int>(*number);
}

std::optional<ToolAxis> axisAtAngle(State& state, const Items& items) {
  ToolAxis axis;
  axis.kind = ToolAxis::Kind::angle;
  axis.surface = axisSurface(state, items);
  if (axis.surface == 0) {
    return std::nullopt;
  }
  const double* alpha = items.size() > 2 ? items[2].number() : nullptr;
  const bool alone = items.size() == 3;
  const EntityPtr* vector = items.size() == 4 ? items[3].entity(EntityType::vector) : nullptr;
  const double* beta = items.size() == 5 && items[3].is(Word::CUTANG) ? items[4].number() : nullptr;
  if (alpha == nullptr || (!alone && vector == nullptr && beta == nullptr)) {
    state.report(diagnose(state.statement->span, diag::AxisCount, describe(items), axisForms));
    return std::nullopt;
  }
  if (std::abs(*alpha) > largestAxisAngle) {
    state.report(diagnose(items[2].span, diag::AxisAngle, *alpha));
    return std::nullopt;
  }
  axis.alphaDegrees = *alpha;
  if (vector != nullptr) {
    axis.vector = tripleOf(**vector);
    axis.fourAxis = true;
    if (isNull(axis.vector)) {
      state.report(diagnose(items[3].span, diag::AxisPlaneVector));
      return std::nullopt;
    }
  }
  if (beta != nullptr) {
    if (std::abs(*beta) > largestAxisAngle) {
      state.report(diagnose(items[4].span, diag::AxisCutAngle, *beta));
      return std::nullopt;
    }
    axis.cutAngleDegrees = *beta;
  }
  return axis;
}

std::optional<ToolAxis> axisOf(State& state, const Items& items) {
  ToolAxis axis;
  const std::size_t count = items.size();
  if (count == 1 && (items[0].is(Word::NORMPS) || items[0].is(Word::NORMDS))) {
    axis.kind =
        items[0].is(Word::NORMPS) ? ToolAxis::Kind::normalPart : ToolAxis::Kind::normalDrive;
    return axis;
  }
  if (const double* one = count == 1 ? items[0].number() : nullptr; one != nullptr && *one == 1.0) {
    axis.kind = ToolAxis::Kind::keep;
    return axis;
  }
  if (count == 2 && items[0].is(Word::PARLEL)) {
    axis.kind = ToolAxis::Kind::parallel;
    axis.surface = axisSurface(state, items);
    return axis.surface != 0 ? std::optional(axis) : std::nullopt;
  }
  if (count > 1 && items[0].is(Word::ATANGL)) {
    return axisAtAngle(state, items);
  }
  const EntityPtr* vector = count == 1 ? items[0].entity(EntityType::vector) : nullptr;
  const std::optional<Vec3> written = threeNumbers(state, items, false);
  if (vector == nullptr && !written) {
    state.report(diagnose(state.statement->span, diag::AxisKind, describe(items), axisForms));
    return std::nullopt;
  }
  axis.vector = vector != nullptr ? tripleOf(**vector) : *written;
  if (isNull(axis.vector)) {
    reportAt(state, items[0].span,
             fail(diag::NullVector, "TLAXIS", axis.vector.x(), axis.vector.y(), axis.vector.z()),
             items);
    return std::nullopt;
  }
  return axis;
}

std::string directionForms(Word word) {
  const std::string_view what = word == Word::INDIRP ? "point" : "vector";
  return fmt::format("{0}/{1}, {0}/three numbers and {0}/[{1} for ds],[{1} for ps],[{1} for cs]",
                     spell(word), what);
}

bool checkDirection(State& state, Word word, const Vec3& value, const Span& span) {
  if (word == Word::INDIRP || !isNull(value)) {
    return true;  // a point is judged against the tool end, which motion knows
  }
  state.report(word == Word::INDIRV ? diagnose(span, diag::NullSense)
                                    : diagnose(span, diag::NullSide));
  return false;
}

}  // namespace

Vec3 tripleOf(const Entity& e) {
  return {e.canon[0], e.canon[1], e.canon[2]};
}

bool isNull(const Vec3& v) {
  return v.lpNorm<Eigen::Infinity>() <= tolerance::nullDirection;
}

void toolAxis(State& state, const ir::Command& command) {
  const auto items = evaluate(state, command.arguments, Use::motion);
  if (!items) {
    return;
  }
  if (std::optional<ToolAxis> axis = axisOf(state, *items)) {
    if (axis->kind == ToolAxis::Kind::vector) {
      axis->vector = axisInFrame(state, axis->vector);
    }
    state.emit(*axis);
  }
}

void direction(State& state, const ir::Command& command) {
  const auto items = evaluate(state, command.arguments, Use::motion);
  if (!items) {
    return;
  }
  Direction action;
  action.word = command.word;
  const bool asPoint = command.word == Word::INDIRP;
  if (const std::optional<Vec3> written = threeNumbers(state, *items, asPoint)) {
    if (checkDirection(state, command.word, *written, items->front().span)) {
      action.values[0] = *written;
      state.emit(action);
    }
    return;
  }
  bool any = false;
  for (std::size_t i = 0; i < items->size() && i < 3; ++i) {
    const Item& item = (*items)[i];
    if (item.omitted()) {
      continue;
    }
    const EntityPtr* entity = item.entity(asPoint ? EntityType::point : EntityType::vector);
    if (entity == nullptr) {
      state.report(diagnose(item.span, diag::MotionOperand, spell(command.word), describe(item),
                            directionForms(command.word)));
      return;
    }
    if (!checkDirection(state, command.word, tripleOf(**entity), item.span)) {
      return;
    }
    action.values[i] = tripleOf(**entity);
    any = true;
  }
  if (!any || items->size() > 3) {
    state.report(diagnose(state.statement->span, diag::MotionArguments, spell(command.word),
                          describe(*items), directionForms(command.word)));
    return;
  }
  state.emit(action);
}

void partSurface(State& state, const ir::Command& command) {
  const auto items = evaluate(state, command.arguments, Use::motion);
  if (!items) {
    return;
  }
  if (items->size() != 1) {
    state.report(diagnose(state.statement->span, diag::MotionArguments, "PSIS", describe(*items),
                          "PSIS/surface"));
    return;
  }
  if (EntityPtr surface = surfaceOf(state, items->front(), "PSIS")) {
    state.emit(PartSurface{std::move(surface)});
  }
}

}  // namespace arelem::runtime::interpret
