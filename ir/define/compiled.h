#pragma once
#include <vector>

#include "ir/define/forms.h"
#include "ir/define/pattern.h"

namespace arelem::define {

/// The automaton of a form.
[[nodiscard]] const Pattern& compiledForm(FormId form);
/// What the form may begin with: most forms of a noun are told apart by their first parameter.
[[nodiscard]] const std::vector<Expectation>& firstOf(FormId form);

/// A set of automaton nodes, closed under splits.
class NodeSet {
 public:
  explicit NodeSet(const Pattern& pattern) : pattern_(&pattern), in_(pattern.nodes.size(), false) {}

  void add(int node) {
    std::vector<int> open{node};
    while (!open.empty()) {
      const int at = open.back();
      open.pop_back();
      if (at < 0 || in_[static_cast<std::size_t>(at)]) {
        continue;
      }
      in_[static_cast<std::size_t>(at)] = true;
      members_.push_back(at);
      const Pattern::Node& n = pattern_->nodes[static_cast<std::size_t>(at)];
      if (n.kind == Pattern::Node::Kind::split) {
        open.push_back(n.next);
        open.push_back(n.other);
      }
    }
  }
  [[nodiscard]] const std::vector<int>& members() const { return members_; }
  /// The nodes behind those that take the symbol.
  [[nodiscard]] NodeSet behind(const Symbol& symbol) const {
    NodeSet next(*pattern_);
    for (const int member : members_) {
      const Pattern::Node& node = pattern_->nodes[static_cast<std::size_t>(member)];
      if (node.kind == Pattern::Node::Kind::take && node.wanted.accepts(symbol)) {
        next.add(node.next);
      }
    }
    return next;
  }

 private:
  const Pattern* pattern_;
  std::vector<bool> in_;
  std::vector<int> members_;
};

}  // namespace arelem::define
