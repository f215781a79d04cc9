#include "runtime/interpret/post_arguments.h"

#include <algorithm>
#include <array>

#include "ir/diag/curves.h"
#include "ir/diag/words.h"
#include "ir/words/post_forms.h"

namespace arelem::runtime::interpret {

namespace {
/// Words whose numbers are those of tools and codes, or times.
constexpr std::array unsignedWords = {Word::LOADTL, Word::SELCTL, Word::TURRET, Word::TOOLNO,
                                      Word::COOLNT, Word::DELAY,  Word::DWELL,  Word::AUXFUN,
                                      Word::PREFUN, Word::SEQNO};
/// Words that say nothing without a parameter.
constexpr std::array needy = {Word::FEDRAT, Word::SPINDL, Word::COOLNT, Word::CYCLE,
                              Word::LOADTL, Word::SELCTL, Word::TURRET, Word::TOOLNO,
                              Word::CUTCOM, Word::DELAY,  Word::AUXFUN, Word::PREFUN};

template <class List>
bool has(const List& list, Word word) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

std::string range(const PostForm& form) {
  return form.least == form.most ? fmt::format("{}", form.least)
                                 : fmt::format("{} to {}", form.least, form.most);
}

/// A word or a text that the word is not known to take, or a number below 0 where none is.
void checkItem(State& state, const PostForm& form, const Item& item) {
  if (const double* number = item.number()) {
    if (*number < 0.0 && has(unsignedWords, form.word)) {
      state.report(
          diagnose(item.span, diag::PostArgument, spell(form.word), fmt::format("{}", *number)));
    }
    return;
  }
  const Word* word = std::get_if<Word>(&item.value);
  // Elsewhere the front end has told of names that are no words.
  const std::string* text =
      state.program.dialect == "cl" ? std::get_if<std::string>(&item.value) : nullptr;
  const std::string_view given = word != nullptr   ? spell(*word)
                                 : text != nullptr ? std::string_view(*text)
                                                   : "";
  if (!given.empty() && !form.takes(given)) {
    state.report(diagnose(item.span, diag::PostArgument, spell(form.word), given));
  }
}
}  // namespace

void checkPostArguments(State& state, Word word, const Items& items) {
  const PostForm* form = postForm(word);
  if (form == nullptr || row(word).wordClass == WordClass::postWithoutParameters) {
    return;
  }
  const Span& statement = state.statement->span;
  if (items.empty()) {
    if (has(needy, word)) {
      state.report(diagnose(statement, diag::PostNumbers, spell(word), "no parameters",
                            std::string(form->pattern)));
    }
    return;
  }
  for (const Item& item : items) {
    checkItem(state, *form, item);
  }
  const auto numbers = std::count_if(items.begin(), items.end(),
                                     [](const Item& item) { return item.number() != nullptr; });
  if (numbers < form->least || numbers > form->most) {
    state.report(diagnose(statement, diag::PostNumbers, spell(word),
                          fmt::format("{} numbers", numbers), range(*form)));
  }
}

}  // namespace arelem::runtime::interpret
