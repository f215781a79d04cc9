#include "runtime/interpret/post_arguments.h"

#include <algorithm>

#include "ir/diag/curves.h"
#include "ir/diag/words.h"
#include "ir/words/post_forms.h"

namespace arelem::runtime::interpret {

namespace {
std::string range(const PostForm& form) {
  return form.least == form.most ? fmt::format("{}", form.least)
                                 : fmt::format("{} to {}", form.least, form.most);
}
}  // namespace

void checkPostArguments(State& state, Word word, const Items& items) {
  const PostForm* form = postForm(word);
  const bool bare = row(word).wordClass == WordClass::postWithoutParameters;
  if (form == nullptr || bare || items.empty()) {
    return;
  }
  // Elsewhere the front end has told of names that are no words.
  const bool textCounts = state.program.dialect == "cl";
  for (const Item& item : items) {
    const Word* argument = std::get_if<Word>(&item.value);
    const std::string* text = std::get_if<std::string>(&item.value);
    const std::string_view given = argument != nullptr ? spell(*argument)
                                   : text != nullptr   ? std::string_view(*text)
                                                       : "";
    if ((argument != nullptr || (textCounts && !given.empty())) && !form->takes(given)) {
      state.report(diagnose(item.span, diag::PostArgument, spell(word), given));
    }
  }
  const auto numbers = static_cast<std::size_t>(std::count_if(
      items.begin(), items.end(), [](const Item& item) { return item.number() != nullptr; }));
  const bool few = numbers < static_cast<std::size_t>(form->least);
  if (few || numbers > static_cast<std::size_t>(form->most)) {
    state.report(
        diagnose(state.statement->span, diag::PostNumbers, spell(word), numbers, range(*form)));
  }
}

}  // namespace arelem::runtime::interpret
