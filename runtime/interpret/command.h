#pragma once
#include "runtime/interpret/item.h"

namespace arelem::runtime::interpret {

void execute(State& state, const ir::Command& command);
void execute(State& state, const ir::ForeignCommand& command);
void execute(State& state, const ir::Text& text);

/// REFSYS and ZSURF.
void referenceSystem(State& state, const ir::Command& command);
void zsurf(State& state, const ir::Command& command);
/// INTOL OUTTOL TOLER THICK MAXDP NUMPTS CUTTER.
void motionParameter(State& state, const ir::Command& command);
void toolAxis(State& state, const ir::Command& command);
/// INDIRV INDIRP SRFVCT.
void direction(State& state, const ir::Command& command);
void partSurface(State& state, const ir::Command& command);
void pocket(State& state, const ir::Command& command);
/// CUT DNTCUT MULTAX GOUGCK AUTOPS NDTEST NOPS 2DCALC 3DCALC.
void toggle(State& state, const ir::Command& command);
/// CLPRNT NOPLOT NOPOST PTONLY CLTV DAC TUNEUP DEBUG DYNDMP.
void runControl(State& state, const ir::Command& command);
/// Every word of the post-processor, and TRACUT, INDEX, COPY, MACHIN.
void post(State& state, const ir::Command& command);

/// STENCL: letters painted on the ground.
void stencil(State& state, const ir::Command& command);
/// ENGRAV: lines of letters cut into a face.
void engrave(State& state, const ir::Command& command);
/// SPRAY/ON and SPRAY/OFF as they stand; SPRAY of a region or surface: passes of a gun.
void spray(State& state, const ir::Command& command);

}  // namespace arelem::runtime::interpret
