#pragma once
#include <string>

#include "ir/program/statement.h"

namespace arelem::app {

/// How a statement is called in counts: its major word, or "assignment" and "definition".
[[nodiscard]] std::string statementWord(const ir::Body& body);

}  // namespace arelem::app
