#include "ir/define/matcher.h"

#include <algorithm>
#include <utility>

#include "ir/define/compiled.h"
#include "ir/define/distance.h"

namespace arelem::define {

namespace {

constexpr std::size_t longestSignature = 16;

bool isOf(const FormRow& form, Word noun) {
  return form.anyNoun || form.noun == noun;
}

Mismatch::Kind kindOf(const Edit& edit, std::span<const Symbol> parameters) {
  switch (edit.kind) {
    case Edit::Kind::missing:
      return Mismatch::Kind::missing;
    case Edit::Kind::surplus:
      return Mismatch::Kind::surplus;
    case Edit::Kind::replace:
      break;
  }
  const bool words = parameters[edit.position].sort == Symbol::Sort::word &&
                     edit.expected.sort == Symbol::Sort::word;
  return words ? Mismatch::Kind::wrongWord : Mismatch::Kind::wrongType;
}

/// What would fit at `position` in any of the forms that one change there would satisfy.
std::vector<std::string> fitting(Word noun, std::span<const Symbol> parameters, const Edit& edit) {
  std::vector<std::string> texts;
  for (const FormRow& form : formTable()) {
    if (!isOf(form, noun)) {
      continue;
    }
    for (const Expectation& wanted : oneChange(compiledForm(form.id), parameters, edit)) {
      // Any number fits where one does: the name that it has there is told.
      const bool number = wanted.sort == Symbol::Sort::scalar;
      const std::string text(number && edit.expected.sort == wanted.sort ? edit.expected.text
                                                                         : wanted.text);
      if (std::find(texts.begin(), texts.end(), text) == texts.end()) {
        texts.push_back(text);
      }
    }
  }
  return texts;
}

/// Whether the form may begin with the symbol.
bool begins(FormId form, const Symbol& symbol) {
  const std::vector<Expectation>& first = firstOf(form);
  return std::any_of(first.begin(), first.end(),
                     [&](const Expectation& wanted) { return wanted.accepts(symbol); });
}

struct Near {
  FormId form;
  EditPath path;
};

/// A word in front that begins a form says which one is meant: forms in which it would be another
/// word come behind those that lack one parameter.
void trustTheFirstWord(std::vector<Near>& all, std::span<const Symbol> parameters) {
  constexpr int anotherForm = 2;
  if (parameters.empty() || parameters.front().sort != Symbol::Sort::word ||
      std::none_of(all.begin(), all.end(),
                   [&](const Near& near) { return begins(near.form, parameters.front()); })) {
    return;
  }
  for (Near& near : all) {
    const std::vector<Edit>& edits = near.path.edits;
    if (!edits.empty() && edits.front().position == 0 &&
        edits.front().kind == Edit::Kind::replace) {
      near.path.cost += anotherForm;
    }
  }
}

Mismatch explain(Word noun, std::span<const Symbol> parameters) {
  std::vector<Near> all;
  for (const FormRow& form : formTable()) {
    if (isOf(form, noun)) {
      all.push_back({form.id, editPath(compiledForm(form.id), parameters)});
    }
  }
  trustTheFirstWord(all, parameters);
  std::stable_sort(all.begin(), all.end(),
                   [](const Near& a, const Near& b) { return a.path.cost < b.path.cost; });
  Mismatch mismatch;
  for (std::size_t i = 0; i < std::min(all.size(), mismatchForms); ++i) {
    mismatch.nearest.push_back(all[i].form);
  }
  if (!all.empty() && all.front().path.edits.size() == 1) {
    const Edit& edit = all.front().path.edits.front();
    mismatch.kind = kindOf(edit, parameters);
    mismatch.position = edit.position;
    if (edit.kind != Edit::Kind::surplus) {
      mismatch.expected = fitting(noun, parameters, edit);
    }
  }
  return mismatch;
}

}  // namespace

bool accepts(const Pattern& pattern, std::span<const Symbol> parameters) {
  NodeSet now(pattern);
  NodeSet before(pattern);
  now.add(pattern.start);
  for (const Symbol& symbol : parameters) {
    std::swap(now, before);
    now.takeBehind(before, symbol);
    if (now.members().empty()) {
      return false;
    }
  }
  return std::any_of(now.members().begin(), now.members().end(), [&](int member) {
    return pattern.nodes[static_cast<std::size_t>(member)].kind == Pattern::Node::Kind::end;
  });
}

std::variant<FormId, Mismatch> match(Word noun, std::span<const Symbol> parameters) {
  for (const FormRow& form : formTable()) {
    if (isOf(form, noun) && (parameters.empty() || begins(form.id, parameters.front())) &&
        accepts(compiledForm(form.id), parameters)) {
      return form.id;
    }
  }
  return explain(noun, parameters);
}

bool takesText(Word noun) {
  const std::span<const FormRow> forms = formTable();
  return std::any_of(forms.begin(), forms.end(), [noun](const FormRow& form) {
    return !form.anyNoun && form.noun == noun && form.pattern.find('\'') != std::string_view::npos;
  });
}

std::string syntaxLine(Word noun, FormId form) {
  return std::string(spell(noun)) + "/ " + std::string(row(form).pattern);
}

std::string signature(Word noun, std::span<const Symbol> parameters) {
  std::string text = std::string(spell(noun)) + "/";
  const std::size_t shown = std::min(parameters.size(), longestSignature);
  for (std::size_t i = 0; i < shown; ++i) {
    text += (i == 0 ? " " : ", ") + describe(parameters[i]);
  }
  if (shown < parameters.size()) {
    text += ", ... (" + std::to_string(parameters.size()) + " parameters)";
  }
  return text;
}

}  // namespace arelem::define
