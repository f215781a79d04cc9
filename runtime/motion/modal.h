#pragma once
#include "ir/diag/result.h"
#include "runtime/motion/records.h"
#include "runtime/motion/state.h"

/// Statements that move nothing but change what later motions find.
namespace arelem::motion {

/// INDIRV, INDIRP, SRFVCT.
[[nodiscard]] std::optional<Failure> setDirections(State& state, const runtime::Direction& d);
/// TLAXIS.
[[nodiscard]] std::optional<Failure> setToolAxis(State& state, const runtime::ToolAxis& axis);
/// The axis of FROM or GOTO, fixed from there on. `written`: by whatever is put out, MULTAX or not;
/// else the first axis that is not z is told where MULTAX is off.
[[nodiscard]] std::optional<Failure> setAxis(State& state,
                                             const runtime::Locate& locate,
                                             bool written);
/// PSIS.
[[nodiscard]] std::optional<Failure> setPartSurface(State& state, const runtime::PartSurface& p);
/// A startup made this its part surface.
void startAtPart(State& state, const runtime::SurfaceUse& part);
/// TLLFT, TLRGT, TLON, TLNDON, TLONPS, TLOFPS.
void setRelation(State& state, const runtime::ToolRelation& relation);
/// CUTTER. `used`: whether it will move along surfaces, for which its parts must join.
[[nodiscard]] std::optional<Failure> setCutter(State& state,
                                               const runtime::Parameter& p,
                                               bool used);
/// CUTTER/OPTION.
[[nodiscard]] std::optional<Failure> setCutterOption(State& state,
                                                     const runtime::CutterOption& option,
                                                     RecordWriter& writer);
/// INTOL, OUTTOL, TOLER, THICK, MAXDP, NUMPTS, with the records that they leave.
void setParameter(State& state, const runtime::Parameter& p, RecordWriter& writer);
/// The warning of a tolerance band that is wider than the tool.
[[nodiscard]] std::optional<Failure> wideBand(const State& state);
/// The error of a place whose coordinates are too large to keep the tolerances.
[[nodiscard]] std::optional<Failure> tooFarOut(const State& state);
/// The same of one tolerance, for a coordinate or distance of this size.
[[nodiscard]] std::optional<Failure> tooFarOut(const State& state, Role role, double size);
/// MULTAX, NOPS, AUTOPS, 3DCALC, 2DCALC, NDTEST, GOUGCK.
void setToggle(State& state, const runtime::Toggle& toggle, RecordWriter& writer);
/// The tool goes straight to a place; a move that is not along its axis is the forward direction.
void moveTo(State& state, const Vec3& toolEnd);
/// The words that hold for one motion have been used.
void forgetOneShots(State& state);

}  // namespace arelem::motion
