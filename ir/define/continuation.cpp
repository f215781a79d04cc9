#include "ir/define/continuation.h"

#include <algorithm>

#include "ir/define/compiled.h"
#include "ir/define/matcher.h"

namespace arelem::define {

namespace {
using Kind = Pattern::Node::Kind;

bool same(const Expectation& a, const Expectation& b) {
  return a.sort == b.sort && a.word == b.word && a.types == b.types && a.text == b.text;
}

void add(std::vector<Expectation>& list, const Expectation& wanted) {
  if (std::none_of(list.begin(), list.end(),
                   [&](const Expectation& known) { return same(known, wanted); })) {
    list.push_back(wanted);
  }
}

/// Forms of every noun copy entities of its own type only.
void copyOnly(EntityType own, Continuation& one) {
  for (Expectation& wanted : one.wanted) {
    if (wanted.sort == Symbol::Sort::entity) {
      wanted.types &= std::uint64_t{1} << static_cast<unsigned>(own);
    }
  }
}
}  // namespace

Continuation continuation(const Pattern& pattern, std::span<const Symbol> parameters) {
  NodeSet now(pattern);
  now.add(pattern.start);
  for (const Symbol& symbol : parameters) {
    now = now.behind(symbol);
  }
  Continuation found;
  std::vector<int> members = now.members();
  std::sort(members.begin(), members.end());
  found.possible = !members.empty();
  for (const int member : members) {
    const Pattern::Node& node = pattern.nodes[static_cast<std::size_t>(member)];
    if (node.kind == Kind::take) {
      add(found.wanted, node.wanted);
    }
    found.mayEnd = found.mayEnd || node.kind == Kind::end;
  }
  return found;
}

Continuation continuation(Word noun, std::span<const Symbol> parameters) {
  Continuation all;
  const std::optional<EntityType> own = entityType(noun);
  const bool other = !parameters.empty() && parameters[0].sort == Symbol::Sort::entity &&
                     parameters[0].type != own;
  for (const FormRow& form : formTable()) {
    if (form.anyNoun ? other || !own : form.noun != noun) {
      continue;
    }
    Continuation one = continuation(compiledForm(form.id), parameters);
    if (form.anyNoun) {
      copyOnly(*own, one);
    }
    all.possible = all.possible || one.possible;
    all.mayEnd = all.mayEnd || one.mayEnd;
    for (const Expectation& wanted : one.wanted) {
      add(all.wanted, wanted);
    }
  }
  return all;
}

std::vector<Word> wordsInPlace(FormId form,
                               std::span<const Symbol> parameters,
                               std::size_t position) {
  const Pattern& pattern = compiledForm(form);
  std::vector<Symbol> changed(parameters.begin(), parameters.end());
  std::vector<Word> words;
  for (const Expectation& wanted : continuation(pattern, parameters.first(position)).wanted) {
    if (wanted.sort != Symbol::Sort::word) {
      continue;
    }
    changed[position] = Symbol::of(wanted.word);
    if (accepts(pattern, changed)) {
      words.push_back(wanted.word);
    }
  }
  return words;
}

}  // namespace arelem::define
