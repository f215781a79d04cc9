#include "runtime/motion/modal.h"

#include <algorithm>
#include <cmath>

#include "ir/diag/motion.h"
#include "ir/space/tolerance.h"
#include "runtime/motion/route.h"
#include "runtime/motion/written_unit.h"
#include "runtime/tool/profile_check.h"

namespace arelem::motion {

namespace {
/// Spreads one to four values over part, drive, check and second check surface: the last one
/// repeats.
std::array<double, 4> spread(const std::vector<double>& values) {
  std::array<double, 4> all{};
  for (std::size_t i = 0; i < all.size(); ++i) {
    all[i] = values[std::min(i, values.size() - 1)];
  }
  return all;
}

constexpr std::array<std::string_view, 3> bandOwner{"part", "drive", "check"};

/// First number of the CUTTER record that the old system writes for OPTION, n, OFF.
constexpr double endOfOption = 3.0;

void putTolerance(RecordWriter& writer, Word word, const std::array<double, 4>& values) {
  writer.put(cl::Values{word, {values.begin(), values.end()}});
}
}  // namespace

std::optional<Failure> setDirections(State& state, const runtime::Direction& d) {
  auto& target = d.word == Word::SRFVCT ? state.surfaceVector : state.direction;
  target = {};
  for (std::size_t i = 0; i < target.size(); ++i) {
    if (!d.values[i]) {
      continue;
    }
    const Vec3 v = d.word == Word::INDIRP ? Vec3(*d.values[i] - state.toolEnd) : *d.values[i];
    if (v.norm() <= tolerance::nullDirection) {
      return fail(diag::NullIndirection, spell(d.word), v.norm());
    }
    target[i] = v;
  }
  if (d.word != Word::SRFVCT && target[0]) {
    state.forward = *target[0];
  }
  return std::nullopt;
}

std::optional<Failure> setToolAxis(State& state, const runtime::ToolAxis& axis) {
  using Kind = runtime::ToolAxis::Kind;
  switch (axis.kind) {
    case Kind::vector:
      if (axis.vector.norm() <= tolerance::nullDirection) {
        return fail(diag::NullIndirection, "TLAXIS", axis.vector.norm());
      }
      state.axis = axis.vector.normalized();
      break;
    case Kind::keep:
    case Kind::normalPart:
    case Kind::normalDrive:
    case Kind::parallel:
      break;
    case Kind::angle:
      if (axis.fourAxis && axis.vector.norm() <= tolerance::nullDirection) {
        return fail(diag::NullIndirection, "TLAXIS/ATANGL", axis.vector.norm());
      }
      break;
  }
  state.axisRule = axis;
  return std::nullopt;
}

std::optional<Failure> setAxis(State& state, const runtime::Locate& locate, bool written) {
  state.touchesPart = false;
  if (!locate.axis) {
    return std::nullopt;
  }
  if (locate.axis->norm() <= tolerance::nullDirection) {
    return fail(diag::NullIndirection, spell(locate.word), locate.axis->norm());
  }
  const Vec3& axis = state.axis = writtenUnit(*locate.axis);
  state.axisRule = {};  // fixed from here on
  const bool upright = axis.z() > 0.0 && std::hypot(axis.x(), axis.y()) <= tolerance::nullDirection;
  if (written || state.multax || !state.output || locate.side || upright || state.toldOfAxis) {
    return std::nullopt;
  }
  state.toldOfAxis = true;
  return fail(diag::AxisNotWritten, axis.x(), axis.y(), axis.z(), spell(locate.word));
}

std::optional<Failure> setPartSurface(State& state, const runtime::PartSurface& p) {
  auto surface = named(p.surface);
  if (!surface) {
    return surface.takeFailure();
  }
  state.part = *std::move(surface);
  state.touchesPart = false;
  return std::nullopt;
}

void startAtPart(State& state, const runtime::SurfaceUse& part) {
  if (auto surface = named(part.surface); surface) {
    state.part = *std::move(surface);
  }
  // The cutter, not the tool end, is at it now, and stays so until TLONPS comes again.
  if (state.partRelation == Word::TLONPS && part.condition != ir::Condition::on) {
    state.partRelation = Word::TLOFPS;
  }
}

void setRelation(State& state, const runtime::ToolRelation& relation) {
  const bool part = relation.word == Word::TLONPS || relation.word == Word::TLOFPS;
  (part ? state.partRelation : state.driveRelation) = relation.word;
}

std::optional<Failure> setCutter(State& state, const runtime::Parameter& p, bool used) {
  auto profile = tool::makeProfile(p.values);
  state.cutterRefused = !profile;
  if (!profile) {
    return profile.takeFailure();
  }
  state.cutter = tool::joined(*profile);
  state.option = {};
  std::optional<Failure> bad = used ? tool::shapeFault(*profile) : std::nullopt;
  // Parts that do not join are no body: what its contacts would be is anyone's guess.
  state.cutterRefused = bad && bad->row->severity == Severity::error;
  return bad;
}

std::optional<Failure> setCutterOption(State& state,
                                       const runtime::CutterOption& option,
                                       RecordWriter& writer) {
  auto& slot = state.option[option.surface == 1 ? partRole : driveRole];
  if (option.ring) {
    const auto [radius, height] = *option.ring;
    if (radius < 0.0) {
      state.cutterRefused = true;
      return fail(diag::CutterDiameter, 2.0 * radius);
    }
    slot = tool::makeRing(radius, height);
    writer.put(cl::Values{Word::CUTTER, {static_cast<double>(option.surface), radius, height}});
  } else {
    slot.reset();
    writer.put(cl::Values{Word::CUTTER, {endOfOption, 0.0, 0.0}});
  }
  return std::nullopt;
}

void setParameter(State& state, const runtime::Parameter& p, RecordWriter& writer) {
  switch (p.word) {
    case Word::TOLER:
      state.outer = spread(p.values);
      state.inner = {};
      putTolerance(writer, Word::OUTTOL, state.outer);
      putTolerance(writer, Word::INTOL, state.inner);
      break;
    case Word::INTOL:
      state.inner = spread(p.values);
      putTolerance(writer, p.word, state.inner);
      break;
    case Word::OUTTOL:
      state.outer = spread(p.values);
      putTolerance(writer, p.word, state.outer);
      break;
    case Word::THICK:
      state.thick = spread(p.values);
      break;
    case Word::MAXDP:
      state.longestVector = p.values[0];
      break;
    default:
      state.vectorLimit = p.values[0];  // NUMPTS
      break;
  }
}

std::optional<Failure> wideBand(const State& state) {
  if (!state.cutter) {
    return std::nullopt;
  }
  const double radius = state.cutter->maxRadius();
  const double most = radius > 0.0 ? radius : state.longestVector;
  for (const Role role : {partRole, driveRole, checkRole}) {
    if (const double band = state.band(role); band > most) {
      return fail(diag::WideBand, bandOwner[role], band,
                  radius > 0.0 ? "radius of the cutter" : "length of a cut vector", most);
    }
  }
  return std::nullopt;
}

std::optional<Failure> tooFarOut(const State& state, Role role, double size) {
  const double rounding = tolerance::rounding * size;
  const double band = state.band(role);
  return band > 0.0 && rounding > tolerance::roundingOfBand * band
             ? std::optional(fail(diag::TooFarOut, size, rounding, bandOwner[role], band))
             : std::nullopt;
}

std::optional<Failure> tooFarOut(const State& state) {
  const double farthest = state.toolEnd.cwiseAbs().maxCoeff();
  for (const Role role : {partRole, driveRole, checkRole}) {
    if (auto bad = tooFarOut(state, role, farthest)) {
      return bad;
    }
  }
  return std::nullopt;
}

void setToggle(State& state, const runtime::Toggle& toggle, RecordWriter& writer) {
  switch (toggle.word) {
    case Word::MULTAX:
      state.multax = toggle.on;
      writer.put(cl::Multax{toggle.on});
      break;
    case Word::NOPS:
      state.ignorePart = true;
      break;
    case Word::AUTOPS:
      state.automaticPart = true;
      break;
    case Word::TLON:
      state.staysOn = toggle.on;
      break;
    case Word::W_3DCALC:
    case Word::W_2DCALC:
    case Word::NDTEST:
      state.alwaysIterate = toggle.word == Word::W_3DCALC;
      writer.put(cl::Switch{toggle.word});
      break;
    default:
      state.gougeCheck = toggle.on;
      break;
  }
}

void moveTo(State& state, const Vec3& toolEnd) {
  const Vec3 step = toolEnd - state.toolEnd;
  const bool axial =
      step.cross(state.axis).norm() <= tolerance::nullDirection * (1.0 + step.norm());
  if (!axial) {
    state.forward = state.lastAcross = step;
  }
  state.toolEnd = toolEnd;
  state.positioned = true;
  state.adrift = false;
}

void forgetOneShots(State& state) {
  state.direction = {};
  state.surfaceVector = {};
  state.ignorePart = false;
  state.automaticPart = false;
}

}  // namespace arelem::motion
