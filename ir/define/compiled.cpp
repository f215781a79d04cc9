#include "ir/define/compiled.h"

namespace arelem::define {

namespace {
const std::vector<Pattern>& compiledForms() {
  static const std::vector<Pattern> compiled = [] {
    std::vector<Pattern> list;
    for (const FormRow& form : formTable()) {
      list.push_back(compile(form.pattern));
    }
    return list;
  }();
  return compiled;
}
}  // namespace

const Pattern& compiledForm(FormId form) {
  return compiledForms()[static_cast<std::size_t>(form)];
}

}  // namespace arelem::define
