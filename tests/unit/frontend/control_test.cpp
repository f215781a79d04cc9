// Labels, IF, JUMPTO, loops, blocks: language reference 1.5, 2.5, 2.6 and the block forms.
#include "tests/unit/frontend/program_text.h"

namespace arelem::frontend {
namespace {

using Lines = std::vector<std::string>;

TEST(Control, Loop) {
  EXPECT_EQ(statements("LOOPST\nI=1\n10)I=I+1\nIF(I-8)10,10,FIN\nFIN)LOOPND"),
            (Lines{"LOOPST", "I = 1", "10) I = (I + 1)", "IF ((I - 8)) 10@2, 10@2, FIN@4",
                   "FIN) LOOPND"}));
}

TEST(Control, JumpToTheLabelOfLoopst) {
  EXPECT_EQ(statements("ST)LOOPST\nJUMPTO/ST\nLOOPND"),
            (Lines{"ST) LOOPST", "JUMPTO/ ST@0", "LOOPND"}));
}

TEST(Control, LabelsAreLocalToTheirLoop) {
  EXPECT_EQ(errors("LOOPST\nA1)B=1\nJUMPTO/A1\nLOOPND\nLOOPST\nA1)B=1\nJUMPTO/A1\nLOOPND"), "");
  EXPECT_EQ(errors("A1)B=1\nLOOPST\nJUMPTO/A1\nLOOPND"), "406");
  EXPECT_EQ(errors("A1)B=1\nA1)B=2"), "6");
  EXPECT_EQ(errors("A1=1\nA1)B=2"), "3");
  EXPECT_EQ(errors("LABELLONG)A=1", Dialect::apt360), "1");
}

TEST(Control, ALabelAloneIsAPlace) {
  EXPECT_EQ(statements("LOOPST\nJUMPTO/7\n7)\nA=1\nLOOPND"),
            (Lines{"LOOPST", "JUMPTO/ 7@2", "7) A = 1", "LOOPND"}));
}

TEST(Control, JumpsOutsideAreas) {
  EXPECT_EQ(errors("A1)B=1\nJUMPTO/A1", Dialect::apt360), "407");
  EXPECT_EQ(reported("A1)B=1\nJUMPTO/A1"), "W0208");
  EXPECT_EQ(reported("A1)B=1\nJUMPTO/A1", Dialect::native), "");
  EXPECT_EQ(errors("A1)B=1\nIF(B)A1,A1,A1", Dialect::apt360), "407");
}

TEST(Control, LoopErrors) {
  EXPECT_EQ(errors("LOOPST\nLOOPST\nLOOPND"), "206");
  EXPECT_EQ(errors("LOOPND"), "208");
  EXPECT_EQ(errors("LOOPST\nA=1"), "16 212");
  EXPECT_EQ(errors("LOOPST\nJUMPTO/(1+2)\nLOOPND"), "403");
  EXPECT_EQ(errors("LOOPST\nJUMPTO/A,B\nLOOPND"), "7");
  EXPECT_EQ(errors("LOOPST\nM=MACRO/\nTERMAC\nLOOPND"), "201");
  EXPECT_EQ(errors("LOOPST\nREAD/2,X\nLOOPND"), "37");
}

TEST(Control, Tranto) {
  EXPECT_EQ(statements("TRANTO/END1\nGOTO/1,2,3\nEND1)GOTO/4,5,6"),
            (Lines{"TRANTO/ END1@2", "GOTO/ 1, 2, 3", "END1) GOTO/ 4, 5, 6"}));
  EXPECT_EQ(errors("TRANTO/NOWHERE"), "406");
}

TEST(Control, BlockIf) {
  EXPECT_EQ(statements("A=1\nIF(A.LT.2)THEN\nB=1\nELSE\nB=2\nENDIF\nC=3"),
            (Lines{"A = 1", "IF ((A - 2)) @2, @4, @4", "B = 1", "JUMPTO/ @5", "B = 2", "C = 3"}));
  EXPECT_EQ(statements("A=1\nIF(A.EQ.2)THEN\nB=1\nELSE IF(A.GE.3)THEN\nB=2\nEND IF\nC=3"),
            (Lines{"A = 1", "IF ((A - 2)) @4, @2, @4", "B = 1", "JUMPTO/ @6",
                   "IF ((A - 3)) @6, @5, @5", "B = 2", "C = 3"}));
}

TEST(Control, ConditionsShortCut) {
  EXPECT_EQ(
      statements("A=1\nIF(A.GT.0.AND.A.LT.9)THEN\nB=1\nENDIF\nC=3"),
      (Lines{"A = 1", "IF ((A - 0)) @4, @4, @2", "IF ((A - 9)) @3, @4, @4", "B = 1", "C = 3"}));
  EXPECT_EQ(
      statements("A=1\nIF(A.EQ.0.OR..NOT.A.LE.9)THEN\nB=1\nENDIF\nC=3"),
      (Lines{"A = 1", "IF ((A - 0)) @2, @3, @2", "IF ((A - 9)) @4, @4, @3", "B = 1", "C = 3"}));
  EXPECT_EQ(statements("A=1\nIF(1.NE.A)THEN\nB=1\nENDIF\nC=3"),
            (Lines{"A = 1", "IF ((1 - A)) @2, @3, @2", "B = 1", "C = 3"}));
}

TEST(Control, DoBlock) {
  const auto lines = statements("DO/I=1,10,2\nGOTO/I,0,0\nENDDO\nC=3");
  ASSERT_EQ(lines.size(), 6U);
  EXPECT_EQ(lines[0], "I = 1");
  EXPECT_EQ(lines[1], "IF ((((I - 10) - (2 * 1e-09)) * 2)) @2, @2, @5");
  EXPECT_EQ(lines[2], "GOTO/ I, 0, 0");
  EXPECT_EQ(lines[3], "I = (I + 2)");
  EXPECT_EQ(lines[4], "JUMPTO/ @1");
}

TEST(Control, BlockErrors) {
  EXPECT_EQ(reported("A=1\nIF(A.LT.2)THEN"), "E0291");
  EXPECT_EQ(reported("DO/I=1,2"), "E0291");
  EXPECT_EQ(reported("ENDIF"), "E0292");
  EXPECT_EQ(reported("ELSE"), "E0292");
  EXPECT_EQ(reported("ENDDO"), "E0292");
  EXPECT_EQ(reported("DO/I=1,2\nENDIF\nENDDO"), "E0292");
  EXPECT_EQ(reported("A=1\nIF(A.LT.2)THEN\nELSE\nELSE\nENDIF"), "E0292");
  EXPECT_EQ(reported("A=1\nIF(A.LT.2)THEN\nELSE\nELSEIF(A.LT.1)THEN\nENDIF"), "E0292");
  EXPECT_EQ(reported("DO/I=1,2,0\nENDDO"), "E0293");
  EXPECT_EQ(errors("A=1\nIF(A)THEN\nENDIF"), "402");
}

TEST(Control, BlockWordsStayFreeAsNames) {
  EXPECT_EQ(statement("DO=1\nELSE=DO\nTHEN=ELSE"), "THEN = ELSE");
  EXPECT_EQ(errors("DO/I=1,2", Dialect::apt360), "82");
}

TEST(Control, Fini) {
  EXPECT_EQ(errors("LOOPST\nFINI"), "16 212");
  EXPECT_EQ(compileText("FINI/1\n")->legacy(), "23");
  EXPECT_EQ(compileText("A1)FINI\n")->codes(), "");
}

}  // namespace
}  // namespace arelem::frontend
