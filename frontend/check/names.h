#pragma once
#include <functional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "ir/program/program.h"

namespace arelem::frontend {

/// What the frontend knows of one name.
struct NameFacts {
  enum class Class : std::uint8_t { unknown, scalar, entity, macro };
  Class kind = Class::unknown;  ///< fixed by the first assignment in the text of the program
  EntityType type = EntityType::point;
  bool defined = false;   ///< an assignment has been passed in order of the text
  bool poisoned = false;  ///< an error was reported; further uses are silent
  std::uint32_t arraySize = 0;
  ir::SymbolId symbol;  ///< none until first used in the program
  Span definition;
};

class Names {
 public:
  [[nodiscard]] NameFacts* find(std::string_view name);
  NameFacts& at(std::string_view name);
  /// Known names and vocabulary words that differ from `name` by at most a third of its letters,
  /// nearest first, at most three.
  [[nodiscard]] std::vector<std::string> similar(std::string_view name, bool wordsToo) const;

 private:
  struct Hash {
    using is_transparent = void;
    std::size_t operator()(std::string_view s) const { return std::hash<std::string_view>{}(s); }
  };
  std::unordered_map<std::string, NameFacts, Hash, std::equal_to<>> facts_;
};

}  // namespace arelem::frontend
