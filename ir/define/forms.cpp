#include "ir/define/forms.h"

#include <array>

namespace arelem::define {

namespace {
constexpr std::array table = {
#define ARELEM_FORM(id, noun, method, pattern, meaning) \
  FormRow{FormId::id, #id, false, Word::noun, pattern, meaning},
#define ARELEM_ANY_FORM(id, method, pattern, meaning) \
  FormRow{FormId::id, #id, true, Word::CANON, pattern, meaning},
#include "ir/define/forms.def"
#undef ARELEM_FORM
#undef ARELEM_ANY_FORM
};
}  // namespace

std::span<const FormRow> formTable() {
  return table;
}

const FormRow& row(FormId id) {
  return table[static_cast<std::size_t>(id)];
}

}  // namespace arelem::define
