#include "backend/cltape/post_decode.h"

#include <cmath>
#include <limits>

#include "backend/cltape/encode.h"
#include "backend/text/clean.h"

namespace arelem::backend::tape {

namespace {
using Words = std::span<const TapeWord>;

constexpr std::size_t planeNumbers = 4;
constexpr std::size_t matrixNumbers = 12;
constexpr std::size_t nameAndSubscript = 2;

/// Reads parameters from the front of the words that are left.
class Parameters {
 public:
  Parameters(cl::Post& post, Words words, const Codes& codes)
      : post_(post), words_(words), codes_(codes) {}

  /// False for a word that is no number, code or text.
  bool readAll() {
    while (!words_.empty()) {
      if (!surface() && !plain()) {
        return false;
      }
    }
    return true;
  }
  /// Text of one word or several; the words are used up.
  std::string text() {
    std::string characters;
    bool more = true;
    while (more && !words_.empty() && isText(words_.front())) {
      more = isContinued(words_.front());
      characters += sixCharacters(words_.front());
      words_ = words_.subspan(1);
    }
    return std::string(trimmed(characters));
  }

 private:
  bool plain() {
    const TapeWord word = words_.front();
    if (isCode(word)) {
      auto minor = codes_.minorOf(asInteger(word));
      if (!minor) {
        return false;
      }
      post_.arguments.push_back(*std::move(minor));
    } else if (isText(word)) {
      post_.arguments.emplace_back(text());
      return true;
    } else if (std::isfinite(asNumber(word))) {
      post_.arguments.emplace_back(asNumber(word));
    } else {
      return false;
    }
    words_ = words_.subspan(1);
    return true;
  }

  bool surface() {
    if (!post_.foreign.empty()) {
      return false;
    }
    const std::size_t place = post_.arguments.size();
    switch (post_.word) {
      case Word::CLRSRF:
      case Word::CLEARP:
        return place == 0 && (typed() || bare(EntityType::plane, planeNumbers));
      case Word::TRACUT:
      case Word::TRANS:
        return place == 0 && bare(EntityType::matrix, matrixNumbers);
      case Word::COPY:
        return place == 2 && bare(EntityType::matrix, matrixNumbers);
      default:
        return false;
    }
  }
  bool bare(EntityType type, std::size_t count) {
    const bool named = words_.front() == 0 || isText(words_.front());
    auto value = named ? namedSurface(words_, count) : std::nullopt;
    if (!value) {
      return false;
    }
    value->type = type;
    post_.arguments.emplace_back(std::move(*value));
    words_ = words_.subspan(count + nameAndSubscript);
    return true;
  }
  /// Type and count in front of the name: a surface that is no plane.
  bool typed() {
    if (words_.size() < 2 || !isCode(words_[0]) || !isCode(words_[1])) {
      return false;
    }
    const auto type = typeOf(words_[0]);
    const TapeWord count = words_[1];
    if (!type || count < nameAndSubscript || count > words_.size() - 2) {
      return false;
    }
    const Words all = words_;
    words_ = words_.subspan(2);
    if (!bare(*type, count - nameAndSubscript)) {
      words_ = all;
      return false;
    }
    return true;
  }

  cl::Post& post_;
  Words words_;
  const Codes& codes_;
};

Decoded malformed(std::string why) {
  return Decoded::malformed(std::move(why));
}
}  // namespace

std::optional<EntityType> typeOf(TapeWord word) {
  const bool small = word <= std::numeric_limits<std::uint8_t>::max();
  const auto type = static_cast<EntityType>(word);
  return small && spell(type) != "?" ? std::optional(type) : std::nullopt;
}

std::optional<int> asSubscript(TapeWord word) {
  const double value = asNumber(word);
  constexpr double largest = std::numeric_limits<int>::max();
  if (!(std::abs(value) <= largest) || value != std::trunc(value)) {
    return std::nullopt;
  }
  return static_cast<int>(value);
}

std::optional<cl::SurfaceValue> namedSurface(Words words, std::size_t count) {
  if (words.size() < count + nameAndSubscript) {
    return std::nullopt;
  }
  const auto name = asName(words[0]);
  const auto subscript = asSubscript(words[1]);
  if (!name || !subscript) {
    return std::nullopt;
  }
  cl::SurfaceValue value{EntityType::plane, *name, *subscript, {}};
  for (const TapeWord word : words.subspan(nameAndSubscript, count)) {
    if (!std::isfinite(asNumber(word))) {
      return std::nullopt;
    }
    value.canon.push_back(asNumber(word));
  }
  return value;
}

Decoded decodePost(cl::Post post, Words words, const Codes& codes) {
  if (!Parameters(post, words, codes).readAll()) {
    return malformed("a parameter is no number, minor word or text");
  }
  return cl::Body(std::move(post));
}

Decoded decodeForeignPost(Words words, const Codes& codes) {
  cl::Post post;
  Parameters front(post, words, codes);
  post.foreign = front.text();
  if (post.foreign.empty()) {
    return malformed("a word outside the vocabulary begins with its text");
  }
  if (!front.readAll()) {
    return malformed("a parameter is no number, minor word or text");
  }
  return cl::Body(std::move(post));
}

}  // namespace arelem::backend::tape
