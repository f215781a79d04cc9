#pragma once
#include "runtime/interpret/item.h"

/// Statements of motion: from evaluated arguments to actions (spec section 4).
namespace arelem::runtime::interpret {

void execute(State& state, const ir::LocateNumbers& locate);
void execute(State& state, const ir::Locate& locate);
void execute(State& state, const ir::Startup& startup);
/// `block` is the block that the labels of check surfaces belong to.
void execute(State& state, const ir::Follow& follow, ir::BlockId block);

/// GOTO/pattern with its modifiers; `items[0]` is the pattern.
void gotoPattern(State& state, const Items& items);

/// The direction of a vector or point given as an entity.
[[nodiscard]] Vec3 tripleOf(const Entity& entity);
/// Whether every component is at most tolerance::nullDirection.
[[nodiscard]] bool isNull(const Vec3& vector);
/// The entity if motion can use it as a surface; else null with a report.
[[nodiscard]] EntityPtr surfaceOf(State& state, const Item& item, std::string_view statement);

}  // namespace arelem::runtime::interpret
