#pragma once
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "ir/define/forms.h"
#include "ir/define/pattern.h"

namespace arelem::define {

/// Why no form fits, told by the form that needs the fewest changes.
struct Mismatch {
  enum class Kind : std::uint8_t {
    noneIsNear,  ///< more than one change is needed
    wrongWord,   ///< one word must be another word
    wrongType,   ///< one parameter must be of another type
    missing,     ///< one parameter is missing
    surplus      ///< one parameter is too many
  };
  Kind kind = Kind::noneIsNear;
  std::size_t position = 0;  ///< of that parameter, 0 based; of a missing one: where it belongs
  std::vector<std::string> expected;  ///< what would fit there, as the patterns spell it
  std::vector<FormId> nearest;        ///< forms by rising distance, at most `mismatchForms`
};

/// Most forms a mismatch lists.
inline constexpr std::size_t mismatchForms = 5;

/// The form of this noun that accepts exactly these parameters, or why there is none. Where several
/// forms would fit, the first row of the table wins. Time: linear in the number of parameters.
[[nodiscard]] std::variant<FormId, Mismatch> match(Word noun, std::span<const Symbol> parameters);

/// Whether one compiled pattern accepts the parameters.
[[nodiscard]] bool accepts(const Pattern& pattern, std::span<const Symbol> parameters);

/// Whether any form of this noun takes a text in quotes.
[[nodiscard]] bool takesText(Word noun);

/// "POINT/ INTOF, line1, line2": a form as the manual prints it, under this noun.
[[nodiscard]] std::string syntaxLine(Word noun, FormId form);
/// "POINT/ INTOF, line, circle": what was written, in kinds; long lists are shortened.
[[nodiscard]] std::string signature(Word noun, std::span<const Symbol> parameters);

}  // namespace arelem::define
