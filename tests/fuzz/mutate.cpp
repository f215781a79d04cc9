#include "tests/fuzz/mutate.h"

#include <array>

#include "ir/words/words.h"

namespace arelem::fuzz {

namespace {
constexpr std::size_t longest = 20'000;  // bytes of a text

constexpr std::array pieces = {"(",
                               ")",
                               ",",
                               "/",
                               "=",
                               "+",
                               "-",
                               "*",
                               "**",
                               "$",
                               "$$",
                               "\n",
                               "\r\n",
                               "'",
                               ".",
                               "1.E300",
                               "-1",
                               "0",
                               "1E5",
                               "1.E-300",
                               ".LT.",
                               ".AND.",
                               "THEN\n",
                               "ELSE\n",
                               "ENDIF\n",
                               "ENDDO\n",
                               "DO/I=1,9\n",
                               "A=A+1\n",
                               "A)",
                               "JUMPTO/A\n",
                               "IF(A)A,A,A\n",
                               "CALL/M,X=1\n",
                               "M=MACRO/X\n",
                               "TERMAC\n",
                               "LOOPST\n",
                               "LOOPND\n",
                               "FINI\n",
                               "(POINT/1,2)",
                               "P(ALL)",
                               "A(1,THRU,9)",
                               "\xEF\xBB\xBF",
                               "\xC3\xA9",
                               "\t"};
}  // namespace

std::string Mutator::token() {
  const std::size_t words = static_cast<std::size_t>(Word::count);
  switch (below(4)) {
    case 0:
      return std::string(spell(static_cast<Word>(below(words))));
    case 1:
      return std::to_string(static_cast<int>(below(41)) - 20);
    case 2:
      return std::to_string(static_cast<double>(below(1000)) / 8.0);
    default:
      return pieces.at(below(pieces.size()));
  }
}

std::pair<std::size_t, std::size_t> Mutator::line(const std::string& text) {
  const std::size_t at = below(text.size());
  const std::size_t before = text.rfind('\n', at);
  const std::size_t begin = before == std::string::npos || before == at ? at : before + 1;
  const std::size_t feed = text.find('\n', at);
  return {begin, (feed == std::string::npos ? text.size() : feed + 1) - begin};
}

void Mutator::change(std::string& text) {
  const std::size_t at = below(text.size() + 1);
  switch (below(9)) {
    case 0:
      if (!text.empty()) {
        text[below(text.size())] = static_cast<char>(below(256));
      }
      return;
    case 1:
      text.erase(at, below(8) + 1);
      return;
    case 2:
    case 3:
      text.insert(at, token());
      return;
    case 4: {
      const auto [begin, size] = line(text);
      const std::string copy = text.substr(begin, size);
      text.insert(line(text).first, copy);
      return;
    }
    case 5: {
      const auto [begin, size] = line(text);
      text.erase(begin, size);
      return;
    }
    case 6: {  // a line of another program
      const std::string& other = corpus_[below(corpus_.size())];
      const auto [begin, size] = line(other);
      text.insert(line(text).first, other.substr(begin, size));
      return;
    }
    case 7: {  // a number becomes another one
      const std::size_t digit = text.find_first_of("0123456789", at);
      if (digit != std::string::npos) {
        const std::size_t end = text.find_first_not_of("0123456789.", digit);
        text.replace(digit, end == std::string::npos ? end : end - digit, token());
      }
      return;
    }
    default: {  // a piece many times
      const std::string piece = token();
      for (std::size_t n = below(40); n > 0; --n) {
        text.insert(std::min(at, text.size()), piece);
      }
    }
  }
}

std::string Mutator::next() {
  std::string text = corpus_[below(corpus_.size())];
  for (std::size_t n = below(8) + 1; n > 0; --n) {
    change(text);
  }
  text.resize(std::min(text.size(), longest));
  return text;
}

}  // namespace arelem::fuzz
