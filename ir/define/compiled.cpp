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

std::vector<Expectation> firstOf(const Pattern& pattern) {
  NodeSet first(pattern);
  first.add(pattern.start);
  std::vector<Expectation> wanted;
  for (const int member : first.members()) {
    const Pattern::Node& node = pattern.nodes[static_cast<std::size_t>(member)];
    if (node.kind == Pattern::Node::Kind::take) {
      wanted.push_back(node.wanted);
    }
  }
  return wanted;
}
}  // namespace

const Pattern& compiledForm(FormId form) {
  return compiledForms()[static_cast<std::size_t>(form)];
}

const std::vector<Expectation>& firstOf(FormId form) {
  static const std::vector<std::vector<Expectation>> firsts = [] {
    std::vector<std::vector<Expectation>> list;
    for (const Pattern& pattern : compiledForms()) {
      list.push_back(firstOf(pattern));
    }
    return list;
  }();
  return firsts[static_cast<std::size_t>(form)];
}

}  // namespace arelem::define
