#pragma once
#include "ir/cl/record.h"
#include "runtime/interpret/item.h"

/// Statements of CL files whose meaning the motion needs.
namespace arelem::runtime::interpret {

/// CIRCLE and MOVARC in the spellings of all systems; false when `word` is neither.
///   CIRCLE/x,y,z,i,j,k[,r[,tool and tolerance]][,TIMES,n][,CLOCKWISE]
///   CIRCLE/x,y,z,r                with the direction of INDIRV
///   MOVARC/x,y,z,i,j,k,r[,ANGLE,degrees]
bool arcStatement(State& state, std::string_view word, const Items& items);

/// CSYS behind TRNTYP/WORLD: places are in the system of the world, the tool stands along the third
/// column of the matrix; OPFEATEND: the tables stand as before the operation. Called for every
/// foreign word.
void frameStatement(State& state, std::string_view word, const Items& items);

/// A feed of 0 or below would stop the tool or be misread by a control: reported, and false.
[[nodiscard]] bool checkFeed(State& state, std::string_view word, const Items& items);

/// ROTABL of CAMWorks: the places behind it are in a turned frame, TLAXIS is not. The tool axis is
/// brought into the frame of the places. Called for every post word.
void turnTable(State& state, const cl::Post& post);

/// TLAXIS in such a file: the axis as the frame of the places has it.
[[nodiscard]] Vec3 axisInFrame(State& state, const Vec3& axis);

/// Feeds in units of the other system, told once.
void checkFeedUnits(State& state, std::string_view word, const Items& items);

}  // namespace arelem::runtime::interpret
