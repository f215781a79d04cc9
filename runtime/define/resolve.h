#pragma once
#include <concepts>
#include <utility>

#include "runtime/define/arguments.h"

namespace arelem::define {

/// What a definition amounts to.
struct Resolved {
  geometry::Canon canon;
  PatternShape pattern;  ///< only of a PATERN

  Resolved(geometry::Canon values, PatternShape shape = {})  // NOLINT(google-explicit-constructor)
      : canon(std::move(values)), pattern(shape) {}
  template <class Shape>
  requires requires(const Shape& shape) {
    { shape.canon() } -> std::same_as<geometry::Canon>;
  }
  Resolved(const Shape& shape) : canon(shape.canon()) {}  // NOLINT(google-explicit-constructor)
};

/// The method of each form, found by the linker: a row of forms.def without its function does not
/// link. The parameters are as the form's pattern says.
#define ARELEM_FORM(id, noun, method, pattern, meaning) \
  [[nodiscard]] Result<Resolved> method(const Arguments& given);
#define ARELEM_ANY_FORM(id, method, pattern, meaning) \
  [[nodiscard]] Result<Resolved> method(const Arguments& given);
#include "ir/define/forms.def"
#undef ARELEM_FORM
#undef ARELEM_ANY_FORM

}  // namespace arelem::define
