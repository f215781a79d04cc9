// Whatever the bytes, the frontend answers with a program and diagnostics.
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>

#include "tests/unit/frontend/program_text.h"

namespace arelem::frontend {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> seeds() {
  std::vector<std::string> texts;
  for (const auto& entry :
       fs::directory_iterator(fs::path(ARELEM_SOURCE_DIR) / "tests/data/oracle/cases")) {
    if (entry.path().extension() == ".apt") {
      texts.push_back(readFile(entry.path()));
    }
  }
  std::sort(texts.begin(), texts.end());
  texts.push_back(
      "M=MACRO/X,Y=1\nIF(X)1,2,2\n1)CALL/M,X=Y\n2)TERMAC\nCALL/M,X=1\nDO/I=1,9\nENDDO\nFINI\n");
  return texts;
}

/// Every label of a program without errors points at a statement; every id lies in its table.
void checkProgram(const Compiled& c) {
  if (c.sink.errors() != 0) {
    return;
  }
  for (const auto& block : c.program.blocks) {
    for (const auto& s : block.statements) {
      if (const auto* b = std::get_if<ir::Branch>(&s.body)) {
        EXPECT_LT(b->negative.statement, block.statements.size());
        EXPECT_LT(b->zero.statement, block.statements.size());
        EXPECT_LT(b->positive.statement, block.statements.size());
      }
      if (const auto* j = std::get_if<ir::Jump>(&s.body)) {
        EXPECT_LT(j->label.statement, block.statements.size());
      }
    }
  }
  std::ostringstream out;
  ir::print(out, c.program);
}

constexpr Dialect dialects[] = {Dialect::automatic, Dialect::apt360, Dialect::cl, Dialect::native};

TEST(Robustness, RandomBytes) {
  std::mt19937 random(20240601);
  for (int i = 0; i < 300; ++i) {
    std::string text(random() % 2000, ' ');
    for (char& ch : text) {
      ch = static_cast<char>(random() % 256);
    }
    checkProgram(*compileText(text, dialects[i % 4]));
  }
}

TEST(Robustness, RandomTokens) {
  const std::vector<std::string> words = {
      "POINT", "/",       "(",       ")",    ",",    "=",    "A",    "B(",    "1.5",
      "-",     "**",      "CANON",   "GOTO", "\n",   "$\n",  "IF",   "MACRO", "TERMAC",
      "CALL/", "LOOPST",  "LOOPND",  "THRU", "SINF", ".LT.", "THEN", "DO/",   "ENDDO",
      "'x'",   "RESERV/", "OBTAIN,", "SYN/", "1)",   "TO",   "L1"};
  std::mt19937 random(7);
  for (int i = 0; i < 3000; ++i) {
    std::string text;
    for (unsigned n = random() % 60; n > 0; --n) {
      text += words[random() % words.size()];
    }
    checkProgram(*compileText(text + "\nFINI\n", dialects[i % 4]));
  }
}

TEST(Robustness, MutatedPrograms) {
  const auto texts = seeds();
  std::mt19937 random(42);
  for (int i = 0; i < 1500; ++i) {
    std::string text = texts[random() % texts.size()];
    for (unsigned n = 1 + random() % 8; n > 0 && !text.empty(); --n) {
      const std::size_t at = random() % text.size();
      switch (random() % 4) {
        case 0:
          text.erase(at, 1 + random() % 5);
          break;
        case 1:
          text.insert(at, text.substr(random() % text.size(), random() % 30));
          break;
        case 2:
          text[at] = "()=,/*$.\n"[random() % 9];
          break;
        default:
          text[at] = static_cast<char>(random() % 256);
      }
    }
    checkProgram(*compileText(text, dialects[i % 4]));
  }
}

TEST(Robustness, MacroValuesCannotMultiplyWithoutEnd) {
  // Every instance calls all rotations and swaps of its own values: 7! instances, each made once.
  std::string text =
      "M=MACRO/A,B,C,D,E,F\nCALL/M,A=B,B=C,C=D,D=E,E=F,F=A\nCALL/"
      "M,A=B,B=A,C=C,D=D,E=E,F=F\nTERMAC\n"
      "CALL/M,A=1,B=2,C=3,D=4,E=5,F=6\nFINI\n";
  const auto c = compileText(text);
  EXPECT_LT(c->program.blocks.size(), 1000U);
}

TEST(Robustness, EveryFileOfTheCorpus) {
  const char* set = std::getenv("ARELEM_SHARED");
  const fs::path corpus =
      (set != nullptr ? fs::path(set) : fs::path(ARELEM_SOURCE_DIR) / "../shared") / "corpus";
  if (!fs::exists(corpus)) {
    GTEST_SKIP() << "no corpus at " << corpus << " (set ARELEM_SHARED)";
  }
  for (const auto& entry : fs::recursive_directory_iterator(corpus)) {
    if (!entry.is_regular_file() || entry.path().extension() == ".csv") {
      continue;
    }
    const std::string text = readFile(entry.path());
    const bool legacy = entry.path().parent_path().filename() == "aptos-apt360";
    const auto c = compileText(text, legacy ? Dialect::automatic : Dialect::cl);
    checkProgram(*c);
    if (legacy && c->sink.errors() != 0) {
      std::cout << entry.path().filename() << ": " << c->codes() << "\n";
    }
  }
}

}  // namespace
}  // namespace arelem::frontend
