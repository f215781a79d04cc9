#pragma once
#include "runtime/interpret/state.h"

namespace arelem::runtime::interpret {

/// Evaluates TYPE/ parameters, stores the entity under its name if it has one, and returns it in
/// the system in force. Null when it failed, which is then reported.
EntityPtr evaluateDefinition(State& state, ir::DefinitionId definition);

void execute(State& state, const ir::Assign& assign);
void execute(State& state, const ir::Define& define);
void execute(State& state, const ir::Obtain& obtain);

}  // namespace arelem::runtime::interpret
