// Expressions, functions, subscripts, nested definitions: language reference 2.1 to 2.4.
#include "tests/unit/frontend/program_text.h"

namespace arelem::frontend {
namespace {

TEST(Expressions, Precedence) {
  EXPECT_EQ(statement("A=1+2*3"), "A = (1 + (2 * 3))");
  EXPECT_EQ(statement("A=8/4/2"), "A = ((8 / 4) / 2)");
  EXPECT_EQ(statement("A=1-2-3"), "A = ((1 - 2) - 3)");
  EXPECT_EQ(statement("B=1\nA=-B*2+3"), "A = (((-B) * 2) + 3)");
  EXPECT_EQ(statement("A=(1+2)*3"), "A = ((1 + 2) * 3)");
}

TEST(Expressions, ASignAppliesToTheWholeTerm) {
  EXPECT_EQ(statement("B=2\nA=-B**2"), "A = (-(B ** 2))");
  EXPECT_EQ(statement("A=2**-1"), "A = (2 ** -1)");
  EXPECT_EQ(statement("A=2*-3"), "A = (2 * -3)");
}

TEST(Expressions, PowersGroupFromTheRightWithAWarning) {
  const auto c = compileText("A=2**3**2\nFINI\n");
  EXPECT_EQ(c->codes(), "W0202");
  EXPECT_EQ(c->block()[0], "A = (2 ** (3 ** 2))");
  EXPECT_EQ(reported("A=2**(3**2)"), "");
}

TEST(Expressions, Errors) {
  EXPECT_EQ(errors("B=1\nA=B*/2"), "54");
  EXPECT_EQ(errors("A=2+"), "11");
  EXPECT_EQ(errors("A="), "11");
  EXPECT_EQ(errors("A=(1+2"), "10");
  EXPECT_EQ(errors("A=1+2)"), "9");
  EXPECT_EQ(errors("A=TO+1"), "61");
  EXPECT_EQ(errors("A=SINF 30"), "101");  // SINF30 is a name
  EXPECT_EQ(errors("A=SINF+30"), "59");
  EXPECT_EQ(errors("A=SINF()"), "78");
  EXPECT_EQ(errors("A=SINF(1,2)"), "66");
  EXPECT_EQ(errors("P1=POINT/1,2\nA=P1+1"), "83");
  EXPECT_EQ(errors("P1=POINT/1,2\nA=SINF(P1)"), "66");
  EXPECT_EQ(errors("A=DOTF(1,2)"), "66");
  EXPECT_EQ(errors("A=B+1"), "101");
  EXPECT_EQ(errors("A=(1)(2)"), "54");
  EXPECT_EQ(errors("A=(1,2)"), "7");
  EXPECT_EQ(errors("A=(POINT/1,2)"), "83");
  EXPECT_EQ(errors("A=1.LT.2"), "402");
  EXPECT_EQ(errors(")=1"), "9");
  EXPECT_EQ(errors("=1"), "5");
}

TEST(Expressions, LimitsOfPowersOperatorsAndNesting) {
  std::string powers = "A=1";
  for (int i = 0; i < 41; ++i) {
    powers += "**1";
  }
  EXPECT_EQ(errors(powers), "56");
  std::string sum = "A=1";
  for (int i = 0; i < 2500; ++i) {
    sum += "+1";
  }
  EXPECT_EQ(reported(sum, Dialect::cl), "E0115");
  EXPECT_EQ(reported("A=" + std::string(300, '(') + "1" + std::string(300, ')'), Dialect::cl),
            "E0820");
  EXPECT_EQ(reported("A=" + std::string(150, '(') + "1" + std::string(150, ')'), Dialect::cl), "");
  EXPECT_EQ(reported("A=" + std::string(5000, '-') + "1", Dialect::cl), "E0820");
}

TEST(Expressions, FunctionsOfEntities) {
  EXPECT_EQ(statement("C1=CIRCLE/0,0,1\nA=ANGLF(C1,(POINT/2,-3))"),
            "A = ANGLF(C1, (POINT/ 2, -3))");
  EXPECT_EQ(statement("V=VECTOR/1,0,0\nA=DOTF(V,V)"), "A = DOTF(V, V)");
  EXPECT_EQ(statement("L1=LINE/XAXIS\nA=DISTF(L1,L1)"), "A = DISTF(L1, L1)");
}

TEST(Expressions, DistanceOfPointsIsAnExtension) {
  EXPECT_EQ(errors("P=POINT/1,2\nA=DISTF(P,P)"), "");
  EXPECT_EQ(errors("P=POINT/1,2\nA=DISTF(P,P)", Dialect::apt360), "66");
}

TEST(Expressions, ParametersNeedParentheses) {
  EXPECT_EQ(errors("X=1\nP1=POINT/X+1,2", Dialect::apt360), "7");
  EXPECT_EQ(reported("X=1\nP1=POINT/X+1,2"), "W0205");
  EXPECT_EQ(statement("X=1\nP1=POINT/X+1,2", Dialect::native), "P1 = POINT/ (X + 1), 2");
  EXPECT_EQ(statement("X=1\nP1=POINT/(X+1),-X"), "P1 = POINT/ (X + 1), (-X)");
}

TEST(Expressions, NestedAssignment) {
  EXPECT_EQ(statement("P1=POINT/(A=1.35),2"), "P1 = POINT/ (A = 1.35), 2");
  EXPECT_EQ(statement("P1=POINT/(A=1.35),2\nB=A"), "B = A");
}

TEST(Subscripts, Elements) {
  EXPECT_EQ(statement("RESERV/A,5,B,3\nI=1\nA(I+1)=2"), "A((I + 1)) = 2");
  EXPECT_EQ(statement("RESERV/5,A,3,B\nA(2.4)=2"), "A(2.4) = 2");
  EXPECT_EQ(errors("RESERV/A,5\nA(6)=1"), "104");
  EXPECT_EQ(errors("RESERV/A,5\nA(0)=1"), "104");
  EXPECT_EQ(errors("RESERV/A,5\nA(.9)=1"), "104");
  EXPECT_EQ(errors("RESERV/A,5\nA(1)=1\nB=A"), "105");
  EXPECT_EQ(errors("A(1)=1"), "108");
  EXPECT_EQ(errors("B=1\nA=B(1)"), "108");
  EXPECT_EQ(errors("RESERV/A,5\nA(1)=1\nA(2)=POINT/1,2"), "106");
  EXPECT_EQ(errors("RESERV/A,5,B,5\nA(1)=1\nB(A(1))=2", Dialect::apt360), "55");
  EXPECT_EQ(errors("RESERV/A,5,B,5\nA(1)=1\nB(A(1))=2"), "");
}

TEST(Subscripts, Reserv) {
  EXPECT_EQ(errors("RESERV/A"), "255");
  EXPECT_EQ(errors("RESERV/A,0"), "255");
  EXPECT_EQ(errors("RESERV/A,2.5"), "255");
  EXPECT_EQ(errors("RESERV/A,(2+3)"), "255");
  EXPECT_EQ(errors("RESERV"), "253");
  EXPECT_EQ(errors("A=1\nRESERV/A,5"), "256");
  EXPECT_EQ(errors("LOOPST\nRESERV/A,5\nLOOPND"), "252");
  Options options;
  options.limits.array = 10;
  EXPECT_EQ(compileText("RESERV/A,11\nFINI\n", Dialect::automatic, options)->codes(), "E0820");
}

TEST(Subscripts, Lists) {
  const std::string p = "RESERV/P,9\nP(1)=POINT/0,0\n";
  const auto list = [&](const std::string& s) {
    return statement(p + "T=TABCYL/NOZ,SPLINE," + s).substr(25);
  };
  EXPECT_EQ(list("P(2,THRU,5)"), "P(2,THRU,5)");
  EXPECT_EQ(list("P(2,THRU,5,INCR,2)"), "P(2,THRU,5,INCR,2)");
  EXPECT_EQ(list("P(2,THRU,ALL,DECR,2)"), "P(2,THRU,ALL,DECR,2)");
  EXPECT_EQ(list("P(THRU,5)"), "P(1,THRU,5)");
  EXPECT_EQ(list("P(ALL)"), "P(1,THRU,ALL)");
  EXPECT_EQ(list("P(ALL,DECR,2)"), "P(1,THRU,ALL,DECR,2)");
  EXPECT_EQ(errors(p + "T=TABCYL/NOZ,SPLINE,P(1,THRU)"), "109");
  EXPECT_EQ(errors(p + "T=TABCYL/NOZ,SPLINE,P(ALL,2)"), "109");
  EXPECT_EQ(errors(p + "GOTO/P(ALL)"), "103");
  EXPECT_EQ(statement(p + "PRINT/3,P(ALL)"), "PRINT/ 3, P(1,THRU,ALL)");
}

TEST(Nesting, Definitions) {
  EXPECT_EQ(statement("L1=LINE/(POINT/1,2),(P2=POINT/3,4)"),
            "L1 = LINE/ (POINT/ 1, 2), (P2 = POINT/ 3, 4)");
  EXPECT_EQ(statement("L1=LINE/(POINT/1,2),(P2=POINT/3,4)\nGOTO/P2"), "GOTO/ P2");
  EXPECT_EQ(statement("L1=LINE/(1,2),(3,4,5)"), "L1 = LINE/ (POINT/ 1, 2), (POINT/ 3, 4, 5)");
  EXPECT_EQ(errors("GOTO/(1,2)"), "7");
  EXPECT_EQ(errors("L1=LINE/(1,2,3,4),(1,2)"), "7");
  EXPECT_EQ(statement("GOTO/(POINT/1,2,3)"), "GOTO/ (POINT/ 1, 2, 3)");
  EXPECT_EQ(errors("GOTO/(PATERN/LINEAR,(POINT/1,2),(POINT/3,4),5)"), "820");
  EXPECT_EQ(errors("GO/ON,(TABCYL/NOZ,SPLINE,1,2,3,4,5,6)"), "820");
}

TEST(Nesting, CanonWithoutAComma) {
  EXPECT_EQ(statement("D3=1\nPL1=PLANE/(PLANE/0,0,1,D3)CANON"),
            "PL1 = PLANE/ (PLANE/ 0, 0, 1, D3), CANON");
}

TEST(Nesting, EmptyParametersOnlyWhereAllowed) {
  EXPECT_EQ(statement("PL1=PLANE/0,0,1,1\nPL2=PLANE/PL1,CANON,,,,2"),
            "PL2 = PLANE/ PL1, CANON, , , , 2");
  EXPECT_EQ(errors("P1=POINT/1,,2"), "7");
  EXPECT_EQ(errors("CUTTER/1,,2"), "7");
}

TEST(Nesting, ReservedTypes) {
  EXPECT_EQ(errors("X1=LOFT/1,2\nGO/X1"), "1000");
  EXPECT_EQ(errors("X1=CONSEC/1"), "1000");
}

}  // namespace
}  // namespace arelem::frontend
