#pragma once
#include "runtime/interpret/item.h"

/// Statements of CL files whose meaning the motion needs.
namespace arelem::runtime::interpret {

/// CIRCLE and MOVARC in the spellings of all systems; false when `word` is neither.
///   CIRCLE/x,y,z,i,j,k[,r[,tool and tolerance]][,TIMES,n][,CLOCKWISE]
///   CIRCLE/x,y,z,r                with the direction of INDIRV
///   MOVARC/x,y,z,i,j,k,r[,ANGLE,degrees]
bool arcStatement(State& state, std::string_view word, const Items& items);

/// CSYS behind TRNTYP/WORLD: places are in the system of the world, the tool stands along the third
/// column of the matrix. Called for every foreign word.
void frameStatement(State& state, std::string_view word, const Items& items);

/// A feed of 0 or below would stop the tool or be misread by a control: reported, and false.
[[nodiscard]] bool checkFeed(State& state, std::string_view word, const Items& items);

/// Feeds in units of the other system, told once.
void checkFeedUnits(State& state, std::string_view word, const Items& items);

}  // namespace arelem::runtime::interpret
