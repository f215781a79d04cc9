#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "frontend/compile.h"
#include "ir/limits.h"

namespace arelem::app {

enum class DiagnosticFormat : std::uint8_t { human, json, gnu };
enum class ColorChoice : std::uint8_t { automatic, always, never };

/// What the options that all source-reading commands share ask for.
struct Settings {
  frontend::Dialect dialect = frontend::Dialect::automatic;
  Limits limits;
  std::map<std::string, double> defines;
  std::vector<std::string> libraryPath;
  std::string codes;             ///< of --codes: numbers of words on CL tapes
  bool partFrame = false;        ///< --frame part: places of CL files in one frame
  std::uint64_t maxErrors = 20;  ///< errors shown
  DiagnosticFormat format = DiagnosticFormat::human;
  ColorChoice color = ColorChoice::automatic;
  bool quiet = false;
  bool verbose = false;
};

}  // namespace arelem::app
