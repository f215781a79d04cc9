#pragma once
#include "app/settings.h"

#include "backend/cltape/codes.h"

namespace arelem::app {

/// The numbers of words on CL tapes as --codes says: a code file by its path or by its name in the
/// library, its suffix may be left out; the vocabulary's without it.
[[nodiscard]] Result<backend::tape::Codes> codesOf(const Settings& settings);

}  // namespace arelem::app
