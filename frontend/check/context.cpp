#include "frontend/check/context.h"

#include <algorithm>

#include "frontend/read/characters.h"
#include "ir/diag/frontend.h"

namespace arelem::frontend {

void Context::report(Diagnostic diagnostic) {
  const DiagRow* row = diagnostic.row;
  const auto is = [row](const auto&... codes) { return ((row == codes.row) || ...); };
  const auto word = [&] {
    std::string text(sources.text(diagnostic.at));
    std::transform(text.begin(), text.end(), text.begin(), [](char c) { return upper(c); });
    return text;
  };
  if (is(diag::WordAsName, diag::LabelIsWord)) {
    misnamed.insert(word());
  } else if (is(diag::WordInExpression, diag::WordInMotion, diag::ModifierBeforeDrive,
                diag::LabelExpected, diag::LabelNotFound) &&
             misnamed.contains(word())) {
    return;
  }
  reporter.report(std::move(diagnostic));
}

}  // namespace arelem::frontend
