#pragma once
#include <cstdint>
#include <span>
#include <string_view>

#include "ir/words/words.h"

/// The definition forms of geometry: which parameters a noun accepts and what they mean.
namespace arelem::define {

/// One row of forms.def; enumerators are the ids of the language reference ("PT_03" for PT-03).
enum class FormId : std::uint16_t {
#define ARELEM_FORM(id, noun, method, pattern, meaning) id,
#define ARELEM_ANY_FORM(id, method, pattern, meaning) id,
#include "ir/define/forms.def"
#undef ARELEM_FORM
#undef ARELEM_ANY_FORM
  count
};

struct FormRow {
  FormId id;
  std::string_view idText;   ///< "PT_03"
  bool anyNoun;              ///< fits every noun; then `noun` says nothing
  Word noun;                 ///< POINT, LINE, ...
  std::string_view pattern;  ///< "INTOF, line1, line2"
  std::string_view meaning;  ///< one line for the manual
};

[[nodiscard]] std::span<const FormRow> formTable();
[[nodiscard]] const FormRow& row(FormId id);

}  // namespace arelem::define
