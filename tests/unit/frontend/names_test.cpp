// Classes of names, definition before use, poisoned names, --define: language reference 1.8.
#include "tests/unit/frontend/program_text.h"

namespace arelem::frontend {
namespace {

TEST(Names, ClassIsFixedByTheFirstAssignment) {
  EXPECT_EQ(errors("A=1\nA=2"), "");
  EXPECT_EQ(errors("P1=POINT/1,2\nP1=3"), "1002");
  EXPECT_EQ(errors("A=1\nA=POINT/1,2"), "1002");
  EXPECT_EQ(errors("P1=POINT/1,2\nP1=LINE/XAXIS"), "1002");
  EXPECT_EQ(errors("P1=POINT/1,2\nP1=POINT/(POINT/3,4),CANON"), "");
}

TEST(Names, UndefinedNamesAreReportedOnceWithNearNames) {
  const auto c = compileText("SETPT=POINT/1,2\nGOTO/SETP\nGOTO/SETP\nFINI\n");
  EXPECT_EQ(c->codes(), "E0201");
  EXPECT_EQ(c->blamed(), "SETP");
  EXPECT_NE(c->sink.all()[0].help.find("SETPT"), std::string::npos);
}

TEST(Names, UseBeforeDefinition) {
  EXPECT_EQ(errors("GOTO/P1\nP1=POINT/1,2"), "101");
  EXPECT_EQ(errors("A=A+1"), "101");
  EXPECT_EQ(errors("LOOPST\nGOTO/P1\nP1=POINT/1,2\nLOOPND"), "");
  EXPECT_EQ(errors("LOOPST\nGOTO/P2\nLOOPND"), "101");
  EXPECT_EQ(errors("M=MACRO/\nGOTO/P1\nTERMAC\nP1=POINT/1,2\nCALL/M"), "");
}

TEST(Names, ABrokenDefinitionGivesNoFurtherErrors) {
  EXPECT_EQ(errors("P1=POINT/1,(2\nGOTO/P1\nL1=LINE/P1,P1"), "10");
  EXPECT_EQ(errors("A=1.5X\nB=A+1"), "4");
  EXPECT_EQ(errors("P1=POINT/QQ,2\nGOTO/P1"), "101");
}

TEST(Names, AMisspelledTypeIsNamed) {
  const auto c = compileText("C=CIRCEL/CENTER,0,0,RADIUS,5\nP=POINT/CENTER,C\nFINI\n");
  EXPECT_EQ(c->codes(), "E0299");
  EXPECT_EQ(c->blamed(), "CIRCEL");
  EXPECT_EQ(c->sink.all()[0].help, "did you mean `CIRCLE`");
  EXPECT_EQ(errors("A=B/2"), "101");  // a quotient
  EXPECT_EQ(errors("SSURF=4\nA=SSURF/2"), "");
}

TEST(Names, SculpturedNounsCountAsDefined) {
  for (const std::string noun : {"SCURV/CURSEG,P", "SSURF/SPLINE,P", "SMESH/P"}) {
    const auto c = compileText("P=POINT/0,0\nX=" + noun + "\nQ=POINT/INTOF,X,X\nFINI\n");
    EXPECT_EQ(c->codes(), "E0299") << noun;
    EXPECT_EQ(c->blamed(), noun.substr(0, 5));
    ASSERT_EQ(c->sink.all()[0].notes.size(), 1U);
    EXPECT_NE(c->sink.all()[0].notes[0].find("not supported"), std::string::npos);
  }
}

TEST(Names, ASynonymOfNoWordNamesIt) {
  const auto c = compileText("SYN/W,WEIGHT\nFINI\n");
  ASSERT_EQ(c->codes(), "E0248");
  EXPECT_EQ(c->sink.all()[0].notes, std::vector<std::string>{"neither `W` nor `WEIGHT` is a word"});
}

TEST(Names, LabelsOnTheOtherSideOfALoopAreShown) {
  const auto c =
      compileText("LOOPST\nA)B=1\nLOOPND\nJUMPTO/A\nC)D=1\nLOOPST\nE=1\nJUMPTO/C\nLOOPND\nFINI\n");
  std::vector<std::string> labels;
  for (const Diagnostic& d : c->sink.all()) {
    if (d.kind().code == "E0216") {
      ASSERT_EQ(d.labels.size(), 1U);
      labels.push_back(std::string(c->sources.text(d.labels[0].span)) + ": " + d.labels[0].text);
    }
  }
  EXPECT_EQ(labels, (std::vector<std::string>{"C: it stands outside, and jumps do not leave loops",
                                              "A: it stands in a loop, and jumps do not enter "
                                              "loops"}));
}

TEST(Names, UnknownWords) {
  EXPECT_EQ(errors("FOOBAR/1,2,3"), "82");
  const auto c = compileText("SPINDLE/100\nFINI\n");
  EXPECT_EQ(c->legacy(), "82");
  EXPECT_NE(c->sink.all()[0].help.find("SPINDL"), std::string::npos);
}

TEST(Names, UnknownParametersOfPostWordsAreText) {
  const auto c = compileText("LOADTL/1,OSETNO,2\nFINI\n");
  EXPECT_EQ(c->codes(), "W0204");
  EXPECT_EQ(c->block()[0], "LOADTL/ 1, 'OSETNO', 2");
  EXPECT_EQ(errors("LOADTL/1,OSETNO,2", Dialect::apt360), "101");
  EXPECT_EQ(statement("MACHIN/PMILL,02"), "MACHIN/ 'PMILL', 2");
  EXPECT_EQ(statement("MACHIN/DXF", Dialect::apt360), "MACHIN/ 'DXF'");
  EXPECT_EQ(errors("MACHIN/1"), "129");
}

TEST(Names, ErrorsOfAFileAreAllReported) {
  EXPECT_EQ(errors("A=\nB=(1\nGOTO/P9\nC=1"), "11 10 101");
}

TEST(Names, DefineReplacesTheFirstAssignment) {
  Options options;
  options.defines = {{"depth", 2.5}, {"EXTRA", 7.0}};
  const auto c =
      compileText("DEPTH=1\nA=DEPTH+EXTRA\nDEPTH=9\nFINI\n", Dialect::automatic, options);
  EXPECT_EQ(c->codes(), "");
  EXPECT_EQ(c->block(), (std::vector<std::string>{"EXTRA = 7", "DEPTH = 2.5", "DEPTH = 2.5",
                                                  "A = (DEPTH + EXTRA)", "DEPTH = 9", "FINI"}));
  options.defines = {{"GOTO", 1.0}, {"1", 1.0}, {"P1", 2.0}};
  EXPECT_EQ(compileText("P1=POINT/1,2\nFINI\n", Dialect::automatic, options)->codes(),
            "E0298 E0298 E0298");
}

TEST(Names, Interrupt) {
  InterruptFlag flag{true};
  Options options;
  options.interrupted = &flag;
  EXPECT_LT(compileText("A=1\nB=2\nFINI\n", Dialect::automatic, options)
                ->program.blocks[0]
                .statements.size(),
            3U);
}

TEST(Names, AnExponentWithoutAPointIsExplained) {
  const auto c = compileText("INTOL/3E-05\nFINI\n");
  EXPECT_EQ(c->sink.all().back().kind().code, "E0201");
  EXPECT_EQ(c->sink.all().back().help, "a number with an exponent has a decimal point: 3.E");
  const auto positive = compileText("INTOL/1E300\nFINI\n");
  EXPECT_EQ(positive->sink.all().back().help,
            "a number with an exponent has a decimal point: 1.E300");
}

TEST(Names, DoWithALabelHasTheFormOfDo) {
  const auto c = compileText("DO/10,I=1,5\nA=I\n10)B=I\nFINI\n");
  EXPECT_EQ(c->sink.all().front().help,
            "the form is DO/ variable = first, last [, step] ... ENDDO");
}

TEST(Names, AWordAndANameWithoutTheirComma) {
  const auto helpOf = [](const std::string& statement) {
    return compileText("L1=LINE/0,0,1,0\n" + statement + "\nFINI\n")->sink.all().back().help;
  };
  EXPECT_EQ(helpOf("GO/TO L1"), "blanks do not count; with a comma: TO,L1");
  EXPECT_EQ(helpOf("GO/TO,L1,PAST L1"), "blanks do not count; with a comma: PAST,L1");
  EXPECT_EQ(helpOf("GO/TO,L2"), "did you mean `L1`");
  EXPECT_EQ(helpOf("GO/TOL7"), "");  // no name is there behind the word
}

}  // namespace
}  // namespace arelem::frontend
