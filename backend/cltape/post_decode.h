#pragma once
#include <optional>
#include <span>
#include <string>

#include "backend/cltape/codes.h"
#include "backend/cltape/word.h"
#include "ir/cl/record.h"

/// The parameters of post words (class 2000) from their words.
namespace arelem::backend::tape {

/// A body, or why the words are none: then `body` means nothing.
struct Decoded {
  Decoded(cl::Body good) : body(std::move(good)) {}  // NOLINT(google-explicit-constructor)
  static Decoded malformed(std::string why) {
    Decoded result{cl::Body(cl::Card{})};
    result.fault = std::move(why);
    return result;
  }
  cl::Body body;
  std::string fault;  ///< "" when the body is good
};

/// The parameters behind a word that is known already.
[[nodiscard]] Decoded decodePost(cl::Post post, std::span<const TapeWord> words, const Codes& codes);
/// 2000/0: the major word is the text in front.
[[nodiscard]] Decoded decodeForeignPost(std::span<const TapeWord> words, const Codes& codes);

/// The entity type with this number.
[[nodiscard]] std::optional<EntityType> typeOf(TapeWord word);
/// A whole number written as a double.
[[nodiscard]] std::optional<int> asSubscript(TapeWord word);
/// Name, subscript and `count` canonical numbers; the type is left to the caller.
[[nodiscard]] std::optional<cl::SurfaceValue> namedSurface(std::span<const TapeWord> words,
                                                           std::size_t count);

}  // namespace arelem::backend::tape
