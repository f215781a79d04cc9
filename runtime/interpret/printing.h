#pragma once
#include "runtime/interpret/item.h"

namespace arelem::runtime::interpret {

/// PRINT/0 to PRINT/4, PRINT/ON, PRINT/OFF.
void print(State& state, const ir::Command& command);
/// PUNCH/1 (all), /2 (scalars), /3 (entities): lines for Evaluation::deck.
void punch(State& state, const ir::Command& command);
void title(State& state, const ir::Text& text);
/// What PRINT/ON asks for when an entity was computed.
void listDefinition(State& state, const EntityPtr& entity);

}  // namespace arelem::runtime::interpret
