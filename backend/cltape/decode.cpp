#include "backend/cltape/decode.h"

#include <array>
#include <cmath>

#include <fmt/format.h>

#include "backend/text/clean.h"

namespace arelem::backend::tape {

namespace {
using Words = std::span<const TapeWord>;

Decoded malformed(std::string why) {
  return Decoded::malformed(std::move(why));
}

cl::Body raw(int type, int sub, Words words) {
  return cl::Raw{type, sub, {words.begin(), words.end()}};
}

/// Finite numbers, or nullopt.
std::optional<std::vector<double>> numbers(Words words) {
  std::vector<double> values;
  values.reserve(words.size());
  for (const TapeWord word : words) {
    const double value = asNumber(word);
    if (!std::isfinite(value)) {
      return std::nullopt;
    }
    values.push_back(value);
  }
  return values;
}

cl::Body text(Word word, Words words) {
  std::string characters;
  for (const TapeWord w : words) {
    characters += sixCharacters(w);
  }
  characters.resize(trimmedRight(characters).size());
  return cl::Text{word, std::move(characters)};
}

Decoded post(int sub, Words words, const Codes& codes) {
  if (sub == 0) {
    return decodeForeignPost(words, codes);
  }
  auto begun = codes.majorOf(sub);
  if (!begun) {
    return raw(2000, sub, words);
  }
  if (begun->foreign.empty() && row(begun->word).wordClass == WordClass::fixedField) {
    return text(begun->word, words);
  }
  return decodePost(*std::move(begun), words, codes);
}

Decoded surface(int sub, Words words) {
  constexpr std::size_t fixedPart = 5;  // condition, type, count, name, subscript
  if (words.size() < fixedPart) {
    return malformed(
        fmt::format("{} words, and a surface has at least {}", words.size(), fixedPart));
  }
  const auto value = namedSurface(words.subspan(3), words.size() - fixedPart);
  const auto type = typeOf(words[1]);
  if (!value || !type || asInteger(words[2]) != static_cast<int>(words.size() - 3)) {
    return malformed("its type, count, name or numbers are not those of a surface");
  }
  cl::Surface body{sub, asInteger(words[0]), *value};
  body.surface.type = *type;
  return cl::Body(std::move(body));
}

Decoded motion(int sub, Words words, const DecodeState& state) {
  if (words.size() < 2) {
    return malformed(
        fmt::format("{} words, and a motion begins with name and subscript", words.size()));
  }
  cl::Motion body;
  body.kind = static_cast<cl::Motion::Kind>(sub);
  body.withAxis = state.withAxis;
  const auto name = asName(words[0]);
  const auto subscript = asSubscript(words[1]);
  auto coordinates = numbers(words.subspan(2));
  if (!name || !subscript) {
    return malformed("its first two words are no name and subscript");
  }
  if (!coordinates) {
    return malformed("a coordinate is not finite");
  }
  if (coordinates->size() % body.stride() != 0) {
    return malformed(
        fmt::format("{} numbers, not a multiple of {}", coordinates->size(), body.stride()));
  }
  body.name = *name;
  body.subscript = *subscript;
  body.coordinates = std::move(*coordinates);
  return cl::Body(std::move(body));
}

Decoded values(Word word, Words words) {
  auto list = numbers(words);
  if (!list) {
    return malformed("a value is not finite");
  }
  return cl::Body(cl::Values{word, std::move(*list)});
}

/// Class 15000: arcs and splines, which end in one location.
Decoded curve(int sub, Words words, const DecodeState& state) {
  using Way = cl::Motion::Way;
  constexpr int go = static_cast<int>(cl::Motion::Kind::go);
  Decoded result = motion(go, words, state);
  auto* body = std::get_if<cl::Motion>(&result.body);
  if (body == nullptr || body->points() != 1) {
    return malformed("an arc ends in one location");
  }
  body->way = sub == 5 ? Way::counterclockwise : sub == 7 ? Way::clockwise : Way::spline;
  return result;
}

/// Class 6000.
Decoded parameter(int sub, Words words) {
  switch (sub) {
    case 4:
      return values(Word::INTOL, words);
    case 5:
      return values(Word::OUTTOL, words);
    case 6:
      return values(Word::CUTTER, words);
    case 1:
    case 2:
      break;
    default:
      return raw(6000, sub, words);
  }
  const int value = words.size() == 1 ? asInteger(words[0]) : -1;
  if (value < 0 || value > sub) {
    return malformed("a switch is one word of 0, 1 or 2");
  }
  constexpr std::array<Word, 2> cut = {Word::CUT, Word::DNTCUT};
  constexpr std::array<Word, 3> calculation = {Word::W_2DCALC, Word::W_3DCALC, Word::NDTEST};
  const auto index = static_cast<std::size_t>(value);
  return cl::Body(cl::Switch{sub == 1 ? cut[index] : calculation[index]});
}

Decoded units(Words words) {
  constexpr std::array<Word, 4> unit = {Word::MM, Word::CM, Word::INCHES, Word::FEET};
  const int code = asInteger(words[0]);
  if (code < 1 || code > static_cast<int>(unit.size())) {
    return malformed(fmt::format("unit {}, and units are 1 to 4", code));
  }
  return cl::Body(cl::Units{unit[static_cast<std::size_t>(code - 1)]});
}

/// Classes of one integer word: MULTAX, UNITS, motion diagnostics, CLPRNT.
Decoded single(int type, int sub, Words words, DecodeState& state) {
  if (words.size() != 1) {
    return malformed(fmt::format("{} words instead of one", words.size()));
  }
  const int value = asInteger(words[0]);
  if (type == 13000 && sub == 3) {
    return cl::Body(cl::Diagnostic{value});
  }
  if (type == 9000 && sub == 9) {
    return units(words);
  }
  if (value != 0 && value != 1) {
    return malformed(fmt::format("switch {}, and a switch is 0 or 1", value));
  }
  if (type == 13000) {
    return cl::Body(cl::Listing{value == 1});
  }
  state.withAxis = value == 1;
  return cl::Body(cl::Multax{value == 1});
}
Decoded decodeClass(int type, int sub, Words words, DecodeState& state) {
  const bool isSingle =
      (type == 9000 && (sub == 2 || sub == 9)) || (type == 13000 && (sub == 3 || sub == 4));
  if (isSingle) {
    return single(type, sub, words, state);
  }
  switch (type) {
    case 1000:
      return cl::Body(cl::Card{});
    case 2000:
      return post(sub, words, state.codes);
    case 3000:
      return surface(sub, words);
    case 5000:
      return sub == 3 || sub == 5 || sub == 6 ? motion(sub, words, state)
                                              : Decoded(raw(type, sub, words));
    case 6000:
      return parameter(sub, words);
    case 15000:
      return sub == 5 || sub == 7 || sub == 8 ? curve(sub, words, state)
                                              : Decoded(raw(type, sub, words));
    case 14000:
      return sub == 0 && words.empty() ? Decoded(cl::Body(cl::Fini{}))
                                       : malformed("FINI has no words");
    default:
      return raw(type, sub, words);
  }
}
}  // namespace

Decoded decode(int type, int sub, Words words, DecodeState& state) {
  Decoded result = decodeClass(type, sub, words, state);
  if (!result.fault.empty()) {
    result.body = raw(type, sub, words);
  }
  return result;
}

}  // namespace arelem::backend::tape
