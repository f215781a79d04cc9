// Tokens: language reference 1.3; words and synonyms 1.7.
#include "tests/unit/frontend/program_text.h"

namespace arelem::frontend {
namespace {

TEST(Tokens, Numbers) {
  EXPECT_EQ(statement("GOTO/1,1.,.5"), "GOTO/ 1, 1, 0.5");
  EXPECT_EQ(statement("GOTO/1.0E2,1.E-3,+.5"), "GOTO/ 100, 0.001, 0.5");
  EXPECT_EQ(statement("A=1.5E+2"), "A = 150");
  EXPECT_EQ(statement("A=-.25"), "A = -0.25");
}

TEST(Tokens, ALetterAfterDigitsMakesASymbol) {
  EXPECT_EQ(statement("3X=1\n1E5=3X"), "1E5 = 3X");
  EXPECT_EQ(statement("5E=2\nA=5E"), "A = 5E");
  EXPECT_EQ(errors("A=1E5"), "101");  // a symbol, not 100000
  EXPECT_EQ(statement("A=1.E5"), "A = 100000");
  EXPECT_EQ(statement("GOTO/1E2,2,3", Dialect::cl), "GOTO/ 100, 2, 3");
}

TEST(Tokens, MalformedNumbers) {
  EXPECT_EQ(errors("A=1.5X"), "4");
  EXPECT_EQ(errors("A=1.E"), "4");
  EXPECT_EQ(errors("A=1.2.3"), "20");
  EXPECT_EQ(errors("A=."), "20");
  EXPECT_EQ(errors("A=1.E999"), "2");
  EXPECT_EQ(statement("A=1.E-999"), "A = 0");
}

TEST(Tokens, SixteenDigitsInApt360) {
  EXPECT_EQ(statement("A=1234567890.123456", Dialect::apt360), "A = 1234567890.123456");
  EXPECT_EQ(errors("A=1.2345678901234567", Dialect::apt360), "2");
  EXPECT_EQ(errors("A=1.2345678901234567"), "");
  EXPECT_EQ(errors("A=0000000000000000001.5", Dialect::apt360), "");
}

TEST(Tokens, NamesOfSixCharactersInApt360) {
  EXPECT_EQ(errors("TOOLONG=1", Dialect::apt360), "1");
  EXPECT_EQ(statement("TOOLONG=1"), "TOOLONG = 1");
}

TEST(Tokens, WordsWithDigits) {
  EXPECT_EQ(statement("3DCALC"), "3DCALC");
  EXPECT_EQ(statement("A=LOG10F(10)"), "A = LOG10F(10)");
  EXPECT_EQ(statement("A=ATAN2F(2,.5)"), "A = ATAN2F(2, 0.5)");
}

TEST(Tokens, TwoStarsWithBlanksBetweenArePower) {
  EXPECT_EQ(statement("A=2* *3"), "A = (2 ** 3)");
}

TEST(Tokens, AWordIsNotAName) {
  EXPECT_EQ(errors("TO=1"), "7");
  EXPECT_EQ(errors("CIRCLE=1"), "7");
  EXPECT_EQ(errors("LEFT) A=1"), "17");
}

TEST(Tokens, ExtensionWordsYieldToTheProgramsNames) {
  EXPECT_EQ(statement("UNITS/MM"), "UNITS/ MM");
  EXPECT_EQ(statement("MM=3\nA=MM"), "A = MM");
  EXPECT_EQ(statement("TORUS=3\nA=TORUS+1"), "A = (TORUS + 1)");
  EXPECT_EQ(statement("T1=TORUS/0,0,0,0,0,1,5,1"), "T1 = TORUS/ 0, 0, 0, 0, 0, 1, 5, 1");
  EXPECT_EQ(errors("UNITS/MM", Dialect::apt360), "82");
  EXPECT_EQ(statement("GOUGE/ON"), "GOUGCK/ ON");
  EXPECT_EQ(statement("LTV=3\nA=LTV"), "A = LTV");  // reserved without a use
}

TEST(Tokens, Synonyms) {
  EXPECT_EQ(statement("SYN/PT,POINT,VEC,VECTOR\nP1=PT/1,2,3"), "P1 = POINT/ 1, 2, 3");
  EXPECT_EQ(statement("SYN/GOTO,GT\nGT/1,2,3"), "GOTO/ 1, 2, 3");
  EXPECT_EQ(statement("SYN/PT,POINT\nP1=POINT/1,2,3"), "P1 = POINT/ 1, 2, 3");
  EXPECT_EQ(statement("SYN/PT,POINT\nLOOPST\nL1=LINE/P1,P1\nP1=PT/1,2\nLOOPND"), "LOOPND");
  EXPECT_EQ(errors("SYN/PT"), "351");
  EXPECT_EQ(errors("SYN/PT,QT"), "356");
  EXPECT_EQ(errors("SYN/S,SYN"), "355");
  EXPECT_EQ(errors("A=1\nSYN/A,POINT"), "355");
  EXPECT_EQ(errors("LOOPST\nSYN/PT,POINT\nLOOPND"), "353");
  std::string many = "SYN/N0,POINT";
  for (int i = 1; i <= 50; ++i) {
    many += ",$\nN" + std::to_string(i) + ",POINT";
  }
  EXPECT_EQ(errors(many, Dialect::apt360), "354");
  EXPECT_EQ(errors(many), "");
}

TEST(Tokens, Strings) {
  EXPECT_EQ(statement("DISPLY/'Hello, $ world'"), "DISPLY/ 'Hello, $ world'");
  EXPECT_EQ(reported("DISPLY/'HELLO"), "E0110");
  EXPECT_EQ(errors("DISPLY/'A'", Dialect::apt360), "19 101");
  EXPECT_EQ(errors("P1=POINT/'A'"), "7");
}

TEST(Tokens, ElementsOfOneStatement) {
  std::string text = "GODLTA/1";
  for (int i = 0; i < 300; ++i) {
    text += ",$\n1";
  }
  EXPECT_EQ(errors(text, Dialect::apt360), "13");
  Options options;
  options.limits.elements = 20;
  EXPECT_EQ(compileText(text + "\nFINI\n", Dialect::automatic, options)->codes(), "E0820");
}

TEST(Tokens, SpansNameTheSourceText) {
  const auto c = compileText("GOTO/P 9\nFINI\n");
  EXPECT_EQ(c->codes(), "E0201");
  EXPECT_EQ(c->blamed(), "P 9");
}

}  // namespace
}  // namespace arelem::frontend
