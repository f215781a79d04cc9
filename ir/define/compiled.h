#pragma once
#include <vector>

#include "ir/define/forms.h"
#include "ir/define/pattern.h"

namespace arelem::define {

/// The automaton of a form.
[[nodiscard]] const Pattern& compiledForm(FormId form);

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
  void clear() {
    for (const int member : members_) {
      in_[static_cast<std::size_t>(member)] = false;
    }
    members_.clear();
  }
  [[nodiscard]] const std::vector<int>& members() const { return members_; }

 private:
  const Pattern* pattern_;
  std::vector<bool> in_;
  std::vector<int> members_;
};

}  // namespace arelem::define
