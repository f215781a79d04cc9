#pragma once
#include <ostream>
#include <string>

#include "app/repl/session.h"

namespace arelem::app::repl {

/// How values are shown.
struct Style {
  bool color = false;
  bool exact = true;  ///< the canonical numbers too, so that they read back to the same doubles
  int digits = 6;     ///< significant digits of the readable form
};

/// Text in a color of the palette, or as it is.
enum class Ink : std::uint8_t { name, kind, faint, good, bad };
[[nodiscard]] std::string inked(const Style& style, Ink ink, const std::string& text);

/// "center (80, 40)  radius 40": the canonical form in words.
[[nodiscard]] std::string readable(const Entity& entity, const Style& style);
/// Canonical numbers as they read back to the same doubles.
[[nodiscard]] std::string exactNumbers(std::span<const double> values);

/// One definition: name, type, readable form and, below, the exact numbers.
void printDefined(std::ostream& out, const runtime::Defined& defined, const Style& style);
/// The motion of a statement.
void printMotion(std::ostream& out,
                 const runtime::MotionFact& fact,
                 const std::string& unit,
                 const Style& style);

/// What an accepted entry brought: new definitions, scalars that changed, PRINT, motions.
void printNews(std::ostream& out, const Run& run, const Run& before, const Style& style);

/// The last location of a path, or nothing.
[[nodiscard]] std::optional<Vec3> lastPlace(const cl::Recording& path);
[[nodiscard]] std::string unitOf(const Run& run);

}  // namespace arelem::app::repl
