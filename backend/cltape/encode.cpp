#include "backend/cltape/encode.h"

#include <algorithm>
#include <unordered_map>

#include "ir/cl/post_word.h"

namespace arelem::backend::tape {

namespace {
constexpr std::size_t textWords = 11;  // 66 characters: columns 7 to 72

bool isLaterModifier(Word word) {
  const WordRow& r = row(word);
  return r.extension && r.wordClass == WordClass::modifier;
}

/// Turns the body into words behind `out`.
class BodyEncoder {
 public:
  BodyEncoder(const Codes& codes, std::vector<TapeWord>& out) : codes_(codes), out_(out) {}

  void operator()(const cl::Post& post) {
    if (!post.foreign.empty() && codes_.major(post.foreign) == 0) {
      text(post.foreign);
    }
    bool first = true;
    const bool named = cl::is(post, Word::MACHIN);
    const bool surfaces = cl::is(post, Word::CLRSRF) || cl::is(post, Word::CLEARP);
    for (const cl::Value& value : post.arguments) {
      if (const auto* surface = std::get_if<cl::SurfaceValue>(&value)) {
        this->surface(*surface, surfaces);
      } else if (const auto* word = std::get_if<Word>(&value); word != nullptr && named && first) {
        text(spell(*word));
      } else {
        plain(value);
      }
      first = false;
    }
  }
  void operator()(const cl::Text& body) {
    const std::size_t whole = (body.text.size() + wordCharacters - 1) / wordCharacters;
    for (std::size_t i = 0; i < std::max(whole, textWords); ++i) {
      const std::size_t at = i * wordCharacters;
      out_.push_back(textWord(at < body.text.size() ? std::string_view(body.text).substr(at) : ""));
    }
  }
  void operator()(const cl::Surface& body) {
    out_.push_back(integerWord(body.condition));
    typed(body.surface);
  }
  void operator()(const cl::Motion& motion) {
    out_.push_back(nameWord(motion.name));
    out_.push_back(numberWord(motion.subscript));
    numbers(motion.coordinates);
  }
  void operator()(const cl::Switch& body) { out_.push_back(integerWord(switchValue(body.word))); }
  void operator()(const cl::Values& body) { numbers(body.values); }
  void operator()(const cl::Multax& body) { out_.push_back(integerWord(body.on ? 1 : 0)); }
  void operator()(const cl::Units& body) { out_.push_back(integerWord(row(body.unit).code)); }
  void operator()(const cl::Diagnostic& body) { out_.push_back(integerWord(body.number)); }
  void operator()(const cl::Listing& body) { out_.push_back(integerWord(body.on ? 1 : 0)); }
  void operator()(const cl::Fini&) {}
  void operator()(const cl::Card&) {}
  void operator()(const cl::Raw& body) {
    out_.insert(out_.end(), body.words.begin(), body.words.end());
  }

 private:
  /// 6000/1: 0 CUT, 1 DNTCUT. 6000/2: 0 2DCALC, 1 3DCALC, 2 NDTEST.
  static int switchValue(Word word) {
    if (word == Word::NDTEST) {
      return 2;
    }
    return word == Word::DNTCUT || word == Word::W_3DCALC ? 1 : 0;
  }
  void plain(const cl::Value& value) {
    if (const auto* number = std::get_if<double>(&value)) {
      out_.push_back(parameterWord(*number));
    } else if (const auto* word = std::get_if<Word>(&value)) {
      const auto code = codes_.minor(*word);
      code ? out_.push_back(integerWord(*code)) : text(spell(*word));
    } else {
      const auto& characters = std::get<std::string>(value);
      const auto code = codes_.minor(characters);
      code ? out_.push_back(integerWord(*code)) : text(characters);
    }
  }
  void text(std::string_view word) {
    while (word.size() > wordCharacters) {
      out_.push_back(continuedTextWord(word));
      word.remove_prefix(wordCharacters);
    }
    out_.push_back(textWord(word));
  }
  void numbers(const std::vector<double>& values) {
    for (const double value : values) {
      out_.push_back(numberWord(value));
    }
  }
  /// A plane of CLEARP or CLRSRF and a matrix need no type: the word in front tells it.
  void surface(const cl::SurfaceValue& value, bool planeExpected) {
    const bool bare = value.type == (planeExpected ? EntityType::plane : EntityType::matrix);
    bare ? named(value) : typed(value);
  }
  void typed(const cl::SurfaceValue& value) {
    out_.push_back(integerWord(static_cast<int>(value.type)));
    out_.push_back(integerWord(static_cast<int>(value.canon.size() + 2)));
    named(value);
  }
  void named(const cl::SurfaceValue& value) {
    out_.push_back(nameWord(value.name));
    out_.push_back(numberWord(value.subscript));
    numbers(value.canon);
  }

  const Codes& codes_;
  std::vector<TapeWord>& out_;
};

/// The subclass of a 2000 record, which a code file may have changed.
int subclass(const cl::Body& body, const Codes& codes, int usual) {
  if (const auto* post = std::get_if<cl::Post>(&body)) {
    return post->foreign.empty() ? codes.major(post->word) : codes.major(post->foreign);
  }
  const auto* text = std::get_if<cl::Text>(&body);
  return text != nullptr ? codes.major(text->word) : usual;
}
}  // namespace

std::optional<Word> modifierOf(int code) {
  static const auto later = [] {
    std::unordered_map<int, Word> map;
    for (std::size_t i = 0; i < static_cast<std::size_t>(Word::count); ++i) {
      if (const auto word = static_cast<Word>(i); isLaterModifier(word)) {
        map.emplace(row(word).code, word);
      }
    }
    return map;
  }();
  if (const auto word = findModifier(code)) {
    return word;
  }
  const auto found = later.find(code);
  return found == later.end() ? std::nullopt : std::optional(found->second);
}

std::optional<int> modifierCode(Word word) {
  const WordRow& r = row(word);
  if (r.wordClass != WordClass::modifier || r.code == 0) {
    return std::nullopt;
  }
  const bool synonym = word == Word::CW || word == Word::CCW;
  if (r.extension && !synonym && modifierOf(r.code) != word) {
    return std::nullopt;  // MM and its like share their code with another word
  }
  return r.code;
}

void encode(const cl::Body& body, const Codes& codes, Encoded& out) {
  const auto [type, sub] = cl::typeCode(body);
  out.type = type;
  out.sub = subclass(body, codes, sub);
  out.words.clear();
  std::visit(BodyEncoder(codes, out.words), body);
}

}  // namespace arelem::backend::tape
