// REFUSE/'text' [, value]...: how a macro tells of parameters that it cannot work with.
#include "runtime/interpret/refuse.h"

#include <utility>

#include "ir/diag/words.h"

namespace arelem::runtime::interpret {

namespace {
/// "DIA is not more than CUTR (9, 10)"; none where the parameters are of other kinds.
std::optional<std::string> sentence(const Items& items) {
  const std::string* text =
      items.empty() ? nullptr : std::get_if<std::string>(&items.front().value);
  if (text == nullptr || text->empty()) {
    return std::nullopt;
  }
  std::string values;
  for (auto item = items.begin() + 1; item != items.end(); ++item) {
    if (item->number() == nullptr) {
      return std::nullopt;
    }
    values += fmt::format("{}{}", values.empty() ? "" : ", ", *item->number());
  }
  return values.empty() ? *text : fmt::format("{} ({})", *text, values);
}
}  // namespace

void refuse(State& state, const Items& items) {
  const Span& here = state.statement->span;
  const std::optional<std::string> why = sentence(items);
  if (!why) {
    state.report(diagnose(here, diag::RefuseForm, describe(items)));
    return;
  }
  // The place is the CALL: its parameters are what the user can change.
  const std::shared_ptr<const CallChain> calls = state.calls;
  if (calls != nullptr) {
    state.calls = calls->outer;
    state.report(diagnose(calls->call, diag::Refused, *why).label(here, "the macro refuses here"));
    state.calls = calls;
  } else {
    state.report(diagnose(here, diag::Refused, *why));
  }
  state.stopped = true;
}

}  // namespace arelem::runtime::interpret
