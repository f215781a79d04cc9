#pragma once
#include <vector>

#include "app/repl/console.h"

namespace arelem::app::repl {

/// A statement as it was typed.
struct StatementLines {
  std::uint32_t line = 0;          ///< of its first card, from 1 on
  std::vector<std::string> cards;  ///< without line ends, safe to print
};

/// The statements that give `defined` its value: of a scalar all that assign it, since a loop or a
/// jump decides which was the last; of an entity the one that defined it.
[[nodiscard]] std::vector<StatementLines> statementsThatDefine(const SourceMap& sources,
                                                               const runtime::Defined& defined,
                                                               const Settings& settings);

}  // namespace arelem::app::repl
