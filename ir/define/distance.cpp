#include "ir/define/distance.h"

#include <algorithm>
#include <limits>

#include "ir/define/matcher.h"

namespace arelem::define {

namespace {

constexpr int likeCost = 2;
constexpr int otherCost = 3;
constexpr int surplusWordCost = 4;  // a word is written by intention, a number is forgotten
constexpr int unreached = std::numeric_limits<int>::max();

/// Costs of the states (number of parameters used, node) and how each was reached.
class Grid {
 public:
  Grid(const Pattern& pattern, std::span<const Symbol> parameters)
      : pattern_(pattern),
        parameters_(parameters),
        nodes_(pattern.nodes.size()),
        cells_((parameters.size() + 1) * nodes_) {
    cell(0, pattern.start).cost = 0;
    for (std::size_t used = 0; used <= parameters.size(); ++used) {
      settle(used);
      if (used < parameters.size()) {
        consume(used);
      }
    }
  }

  [[nodiscard]] EditPath path() {
    EditPath result;
    std::size_t used = parameters_.size();
    int node = endNode();
    result.cost = node < 0 ? unreached : cell(used, node).cost;
    while (node >= 0 && result.cost != unreached) {
      const Cell& here = cell(used, node);
      if (here.edited) {
        result.edits.push_back(here.edit);
      }
      const int before = here.node;
      used = here.used;
      node = before;
    }
    std::reverse(result.edits.begin(), result.edits.end());
    return result;
  }

 private:
  struct Cell {
    int cost = unreached;
    std::size_t used = 0;
    int node = -1;  ///< predecessor, -1 at the start
    bool edited = false;
    Edit edit;
    int lacks = -1;  ///< where a parameter lacks, if that is all that is changed up to here
  };

  Cell& cell(std::size_t used, int node) {
    return cells_[used * nodes_ + static_cast<std::size_t>(node)];
  }
  const Pattern::Node& node(int index) const {
    return pattern_.nodes[static_cast<std::size_t>(index)];
  }

  bool relax(std::size_t fromUsed, int from, std::size_t used, int to, int step, const Edit* edit) {
    if (to < 0 || cell(fromUsed, from).cost == unreached) {
      return false;
    }
    const int cost = cell(fromUsed, from).cost + step;
    const int lacks = edit == nullptr ? cell(fromUsed, from).lacks
                      : edit->kind == Edit::Kind::missing && cost == otherCost
                          ? static_cast<int>(edit->position)
                          : -1;
    Cell& target = cell(used, to);
    // Where one may lack at several places the last is told: whoever stops short forgot the end.
    const bool later = cost == target.cost && target.lacks >= 0 && lacks > target.lacks;
    if (cost >= target.cost && !later) {
      return false;
    }
    target = {cost, fromUsed, from, edit != nullptr, edit != nullptr ? *edit : Edit{}, lacks};
    return true;
  }

  /// Free splits and missing parameters inside one column, until nothing gets cheaper.
  void settle(std::size_t used) {
    for (bool changed = true; changed;) {
      changed = false;
      for (int i = 0; i < static_cast<int>(nodes_); ++i) {
        if (node(i).kind == Pattern::Node::Kind::split) {
          changed |= relax(used, i, used, node(i).next, 0, nullptr);
          changed |= relax(used, i, used, node(i).other, 0, nullptr);
        } else if (node(i).kind == Pattern::Node::Kind::take) {
          const Edit edit{Edit::Kind::missing, used, node(i).wanted};
          changed |= relax(used, i, used, node(i).next, otherCost, &edit);
        }
      }
    }
  }

  /// Steps that use up parameter `used`.
  void consume(std::size_t used) {
    const Symbol& symbol = parameters_[used];
    const int surplusCost = symbol.sort == Symbol::Sort::word ? surplusWordCost : otherCost;
    for (int i = 0; i < static_cast<int>(nodes_); ++i) {
      const Edit surplus{Edit::Kind::surplus, used, {}};
      relax(used, i, used + 1, i, surplusCost, &surplus);
      if (node(i).kind != Pattern::Node::Kind::take) {
        continue;
      }
      const Expectation& wanted = node(i).wanted;
      if (wanted.accepts(symbol)) {
        relax(used, i, used + 1, node(i).next, 0, nullptr);
      } else {
        const Edit replace{Edit::Kind::replace, used, wanted};
        relax(used, i, used + 1, node(i).next, wanted.sort == symbol.sort ? likeCost : otherCost,
              &replace);
      }
    }
  }

  [[nodiscard]] int endNode() const {
    for (std::size_t i = 0; i < nodes_; ++i) {
      if (pattern_.nodes[i].kind == Pattern::Node::Kind::end) {
        return static_cast<int>(i);
      }
    }
    return -1;
  }

  const Pattern& pattern_;
  std::span<const Symbol> parameters_;
  std::size_t nodes_;
  std::vector<Cell> cells_;
};

/// A symbol that this expectation accepts.
Symbol example(const Expectation& wanted) {
  switch (wanted.sort) {
    case Symbol::Sort::word:
      return Symbol::of(wanted.word);
    case Symbol::Sort::entity:
      for (unsigned code = 0; code < 64; ++code) {
        if ((wanted.types >> code & 1U) != 0) {
          return Symbol::of(static_cast<EntityType>(code));
        }
      }
      break;
    case Symbol::Sort::scalar:
      return Symbol::scalar();
    case Symbol::Sort::text:
      return Symbol::text();
    case Symbol::Sort::empty:
      break;
  }
  return Symbol::empty();
}

}  // namespace

EditPath editPath(const Pattern& pattern, std::span<const Symbol> parameters) {
  const std::size_t seen = std::min(parameters.size(), editLimit);
  EditPath path = Grid(pattern, parameters.first(seen)).path();
  if (seen < parameters.size() && path.cost != unreached) {
    path.cost += otherCost * static_cast<int>(parameters.size() - seen);
    path.edits.push_back({Edit::Kind::surplus, seen, {}});
    path.edits.push_back({Edit::Kind::surplus, seen, {}});
  }
  return path;
}

std::vector<Expectation> oneChange(const Pattern& pattern,
                                   std::span<const Symbol> parameters,
                                   const Edit& edit) {
  std::vector<Symbol> trial(parameters.begin(), parameters.end());
  if (edit.kind == Edit::Kind::missing) {
    trial.insert(trial.begin() + static_cast<std::ptrdiff_t>(edit.position), Symbol::empty());
  }
  std::vector<Expectation> found;
  for (const Pattern::Node& node : pattern.nodes) {
    if (node.kind != Pattern::Node::Kind::take) {
      continue;
    }
    trial[edit.position] = example(node.wanted);
    if (accepts(pattern, trial)) {
      found.push_back(node.wanted);
    }
  }
  return found;
}

}  // namespace arelem::define
