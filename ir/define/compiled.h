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
    if (node < 0 || in_[static_cast<std::size_t>(node)]) {
      return;
    }
    in_[static_cast<std::size_t>(node)] = true;
    members_.push_back(node);
    const Pattern::Node& n = pattern_->nodes[static_cast<std::size_t>(node)];
    if (n.kind == Pattern::Node::Kind::split) {
      add(n.other);
      add(n.next);
    }
  }
  [[nodiscard]] const std::vector<int>& members() const { return members_; }
  /// The nodes behind those that take the symbol.
  [[nodiscard]] NodeSet behind(const Symbol& symbol) const {
    NodeSet next(*pattern_);
    next.takeBehind(*this, symbol);
    return next;
  }
  /// Becomes the nodes behind those of another set that take the symbol.
  void takeBehind(const NodeSet& before, const Symbol& symbol) {
    for (const int member : members_) {
      in_[static_cast<std::size_t>(member)] = false;
    }
    members_.clear();
    for (const int member : before.members_) {
      const Pattern::Node& node = pattern_->nodes[static_cast<std::size_t>(member)];
      if (node.kind == Pattern::Node::Kind::take && node.wanted.accepts(symbol)) {
        add(node.next);
      }
    }
  }

 private:
  const Pattern* pattern_;
  std::vector<bool> in_;
  std::vector<int> members_;
};

}  // namespace arelem::define
