#pragma once
#include <string_view>

namespace arelem::frontend {

/// REFUSE/'text',value,...: a macro tells of parameters that it cannot work with. It is no word of
/// the vocabulary; its token has the form of another statement with texts.
inline constexpr std::string_view refusal = "REFUSE";

}  // namespace arelem::frontend
