// Statement shapes of sections 2.9 to 2.11, 4, 5 and 6.1 of the language reference.
#include "tests/unit/frontend/program_text.h"

namespace arelem::frontend {
namespace {

using Lines = std::vector<std::string>;
const std::string surfaces =
    "P1=POINT/1,2\nV1=VECTOR/0,0,1\nL1=LINE/XAXIS\nC1=CIRCLE/0,0,1\nPL1=PLANE/0,0,1,0\nM1=MATRIX/"
    "SCALE,2\n"
    "PT1=PATERN/RANDOM,P1\nF=5\n";

std::string with(const std::string& s) {
  return statement(surfaces + s);
}
std::string wrong(const std::string& s, Dialect d = Dialect::automatic) {
  return errors(surfaces + s, d);
}

TEST(Statements, PointToPoint) {
  EXPECT_EQ(with("FROM/P1"), "FROM/ P1");
  EXPECT_EQ(with("FROM/P1,V1,F"), "FROM/ P1, V1, F");
  EXPECT_EQ(with("GOTO/P1,0,0,1"), "GOTO/ P1, 0, 0, 1");
  EXPECT_EQ(with("GOTO/1,2,3,V1"), "GOTO/ 1, 2, 3, V1");
  EXPECT_EQ(with("GOTO/1,2"), "GOTO/ 1, 2");
  EXPECT_EQ(with("GODLTA/0,0,-F"), "GODLTA/ 0, 0, (-F)");
  EXPECT_EQ(with("GODLTA/.3"), "GODLTA/ 0.3");
  EXPECT_EQ(with("GODLTA/V1,F"), "GODLTA/ V1, F");
  EXPECT_EQ(with("GOTO/PT1,INVERS,OMIT,2,THRU,4,6"), "GOTO/ PT1, INVERS, OMIT, 2, THRU, 4, 6");
  for (const char* bad : {"GOTO/1", "GOTO/1,2,3,4,5", "GOTO/", "GODLTA/1,2,3,4,5"}) {
    EXPECT_EQ(wrong(bad), "129") << bad;
  }
  EXPECT_EQ(wrong("GOTO/L1"), "1006");
  EXPECT_EQ(wrong("FROM/PT1"), "1006");
  EXPECT_EQ(wrong("GOTO/TO,P1"), "132");
}

TEST(Statements, Startup) {
  EXPECT_EQ(with("GO/L1"), "GO/ L1");
  EXPECT_EQ(with("GO/TO,L1,ON,PL1,PAST,C1,F"), "GO/ TO, L1, ON, PL1, PAST, C1, F");
  EXPECT_EQ(with("GO/L1,PL1,TANTO,C1"), "GO/ L1, PL1, TANTO, C1");
  EXPECT_EQ(with("OFFSET/TO,L1,PL1"), "OFFSET/ TO, L1, PL1");
  EXPECT_EQ(with("GO/ON,(LINE/YAXIS)"), "GO/ ON, (LINE/ YAXIS)");
  EXPECT_EQ(wrong("GO/TO"), "129");
  EXPECT_EQ(wrong("GO/"), "129");
  EXPECT_EQ(wrong("OFFSET/L1,PL1,C1"), "129");
  EXPECT_EQ(wrong("GO/P1"), "1006");
  EXPECT_EQ(wrong("GO/TO,ON,L1"), "132");
  EXPECT_EQ(wrong("GO/LEFT,L1"), "132");
}

TEST(Statements, Follow) {
  EXPECT_EQ(with("GOLFT/L1"), "GOLFT/ L1");
  EXPECT_EQ(with("GORGT/L1,TO,C1,F"), "GORGT/ L1, TO, C1, F");
  EXPECT_EQ(with("GOFWD/C1,DSTAN,L1"), "GOFWD/ C1, TANTO, L1");
  EXPECT_EQ(with("GOFWD/C1,PAST,2,INTOF,L1"), "GOFWD/ C1, 2, INTOF, PAST, L1");
  EXPECT_EQ(with("GOFWD/C1,2,INTOF,L1"), "GOFWD/ C1, 2, INTOF, L1");
  EXPECT_EQ(with("GOUP/L1,ON,PL1"), "GOUP/ L1, ON, PL1");
  EXPECT_EQ(with("GOBACK/L1,50"), "GOBACK/ L1, 50");
  EXPECT_EQ(statements(surfaces + "GOFWD/L1,TO,C1,A1,PAST,PL1,20\nA1)GO/L1\n20)GO/C1")[8],
            "GOFWD/ L1, TO, C1, A1@9, PAST, PL1, 20@10");
  EXPECT_EQ(wrong("GOLFT/TO,L1"), "135");
  EXPECT_EQ(wrong("GOUP/L1"), "136");
  EXPECT_EQ(wrong("GOLFT/"), "129");
  EXPECT_EQ(wrong("GOLFT/L1,TO"), "129");
  EXPECT_EQ(wrong("GOLFT/F"), "132");
  EXPECT_EQ(wrong("GOFWD/L1,TO,C1,PAST,PL1"), "453");
  EXPECT_EQ(wrong("GOFWD/L1,TO,C1,A1,PAST,PL1"), "453");
  EXPECT_EQ(wrong("GOFWD/L1,TO,C1,A1,PAST,PL1,A2"), "406 406");
}

TEST(Statements, PrefixWords) {
  EXPECT_EQ(statements("RAPID,GOTO/1,2,3"), (Lines{"RAPID", "GOTO/ 1, 2, 3"}));
  const auto c = compileText(surfaces + "X)TLON,TLONPS,GOLFT/L1,TO,C1\nFINI\n");
  ASSERT_EQ(c->codes(), "");
  const auto& s = c->program.blocks[0].statements;
  EXPECT_EQ(c->block()[8], "X) TLON");
  EXPECT_EQ(c->block()[9], "TLONPS");
  EXPECT_EQ(s[8].isn, s[10].isn);
  EXPECT_EQ(statements("NOPOST,CUTTER/1"), (Lines{"NOPOST", "CUTTER/ 1"}));
  EXPECT_EQ(statements("CUTTER/1,NOPLOT"), (Lines{"CUTTER/ 1", "NOPLOT"}));
  EXPECT_EQ(statements("FEDRAT/10,PTONLY"), (Lines{"FEDRAT/ 10", "PTONLY"}));
  EXPECT_EQ(errors("CYCLE,DRILL/1"), "7");
  EXPECT_EQ(errors("LEFT/1"), "7");
}

TEST(Statements, CutterOptionWithEitherSeparator) {  // A-12
  EXPECT_EQ(statement("CUTTER,OPTION,1,2,3"), "CUTTER/ OPTION, 1, 2, 3");
  EXPECT_EQ(statement("CUTTER/OPTION,2,OFF"), "CUTTER/ OPTION, 2, OFF");
}

TEST(Statements, ParametersOfMotion) {
  EXPECT_EQ(with("PSIS/PL1"), "PSIS/ PL1");
  EXPECT_EQ(with("INDIRV/V1"), "INDIRV/ V1");
  EXPECT_EQ(with("INDIRP/P1,,P1"), "INDIRP/ P1, , P1");
  EXPECT_EQ(with("SRFVCT/,V1"), "SRFVCT/ , V1");
  EXPECT_EQ(with("TLAXIS/ATANGL,1,30,CUTANG,5"), "TLAXIS/ ATANGL, 1, 30, CUTANG, 5");
  EXPECT_EQ(with("TLAXIS/NORMPS"), "TLAXIS/ NORMPS");
  EXPECT_EQ(with("INTOL/.1,.2,.3,.4"), "INTOL/ 0.1, 0.2, 0.3, 0.4");
  EXPECT_EQ(with("MULTAX"), "MULTAX");
  EXPECT_EQ(with("MULTAX/ON"), "MULTAX/ ON");
  EXPECT_EQ(with("GOUGCK/ON"), "GOUGCK/ ON");
  EXPECT_EQ(with("DNTCUT/PRINT"), "DNTCUT/ PRINT");
  EXPECT_EQ(with("2DCALC"), "2DCALC");
  EXPECT_EQ(with("POCKET/1,2,3,4,5,6,0,1,P1,P1,P1"), "POCKET/ 1, 2, 3, 4, 5, 6, 0, 1, P1, P1, P1");
  EXPECT_EQ(with("CANON/ON"), "CANON/ ON");
  EXPECT_EQ(wrong("PSIS/P1"), "1006");
  EXPECT_EQ(wrong("CUTTER"), "132");
  EXPECT_EQ(wrong("TLLFT/1"), "505");
  EXPECT_EQ(wrong("POCKET/1,2,3"), "377");
}

TEST(Statements, Obtain) {
  EXPECT_EQ(with("OBTAIN,CIRCLE/C1,A,B,,,,,R"), "OBTAIN, CIRCLE/ C1, A, B, , , , , R");
  EXPECT_EQ(with("OBTAIN,POINT/P1,,YY\nA=YY"), "A = YY");
  EXPECT_EQ(with("OBTAIN,POINT/(POINT/1,2),A"), "OBTAIN, POINT/ (POINT/ 1, 2), A");
  const auto comma = compileText(surfaces + "OBTAIN,POINT,P1,A,B\nC=A\nFINI\n");  // A-22
  EXPECT_EQ(comma->codes(), "W0203");
  EXPECT_EQ(comma->block()[8], "OBTAIN, POINT/ P1, A, B");
  EXPECT_EQ(wrong("OBTAIN,POINT,P1,A\nB=A", Dialect::apt360), "155");
  EXPECT_EQ(wrong("OBTAIN/P1,A"), "153");
  EXPECT_EQ(wrong("OBTAIN,POINT/L1,A"), "153");
  EXPECT_EQ(wrong("OBTAIN,POINT/P1,A,B,C,D"), "154");
  EXPECT_EQ(wrong("OBTAIN,POINT/P1,(A)"), "156");
  EXPECT_EQ(wrong("OBTAIN,PATERN/PT1,A"), "157");
  EXPECT_EQ(wrong("OBTAIN,POINT/P1,L1"), "1002");
}

TEST(Statements, ReferenceSystemsAndZsurf) {
  EXPECT_EQ(with("REFSYS/M1"), "REFSYS/ M1");
  EXPECT_EQ(with("REFSYS/NOMORE"), "REFSYS/ NOMORE");
  EXPECT_EQ(with("REFSYS/(M2=MATRIX/SCALE,2)"), "REFSYS/ (M2 = MATRIX/ SCALE, 2)");
  EXPECT_EQ(with("ZSURF/PL1"), "ZSURF/ PL1");
  EXPECT_EQ(with("ZSURF/0,0,1,F"), "ZSURF/ 0, 0, 1, F");
  EXPECT_EQ(wrong("REFSYS/P1"), "651");
  EXPECT_EQ(wrong("REFSYS/(MATRIX/SCALE,2)"), "820");
  EXPECT_EQ(wrong("ZSURF/L1"), "26");
  EXPECT_EQ(wrong("ZSURF/1,2"), "26");
}

TEST(Statements, PrintAndPunch) {
  EXPECT_EQ(with("PRINT/0"), "PRINT/ 0");
  EXPECT_EQ(with("PRINT/ON"), "PRINT/ ON");
  EXPECT_EQ(with("PRINT/3,ALL"), "PRINT/ 3, ALL");
  EXPECT_EQ(with("PUNCH/2,F"), "PUNCH/ 2, F");
  EXPECT_EQ(reported("PRINT/3,NOSUCH"), "W0204");
  EXPECT_EQ(errors("PRINT/9"), "129");
  EXPECT_EQ(errors("PRINT"), "129");
  EXPECT_EQ(errors("PUNCH/ON"), "129");
}

TEST(Statements, PostWords) {
  EXPECT_EQ(with("SPINDL/(F*100),RPM,CLW"), "SPINDL/ (F * 100), RPM, CLW");
  EXPECT_EQ(with("CLEARP/PL1"), "CLEARP/ PL1");
  EXPECT_EQ(with("TRACUT/M1"), "TRACUT/ M1");
  EXPECT_EQ(with("COPY/1,MODIFY,M1,2"), "COPY/ 1, MODIFY, M1, 2");
  EXPECT_EQ(with("LETTER/1,2,3,4"), "LETTER/ 1, 2, 3, 4");  // A-21
  EXPECT_EQ(with("REWIND"), "REWIND");
  EXPECT_EQ(wrong("SPINDL/P1"), "501");
  EXPECT_EQ(wrong("STOP/1", Dialect::apt360), "505");
  EXPECT_EQ(reported("STOP/1"), "W0207");
}

TEST(Statements, RunControl) {
  for (const char* s :
       {"NOPOST", "CLPRNT", "CLPRNT/ ON", "NOPLOT", "CLTV", "CLTV/ OPTION", "PTONLY/ 1",
        "PTONLY/ 3, 20", "DEBUG/ SEC1, ON", "DYNDMP/ 1, 2", "TUNEUP/ 1, 2, 3"}) {
    EXPECT_EQ(statement(s), s);
  }
  EXPECT_EQ(errors("PTONLY/4"), "553");
  EXPECT_EQ(errors("NOPOST/1"), "505");
}

TEST(Statements, DefinitionsWithoutAName) {
  EXPECT_EQ(reported("POINT/1,2"), "W0206");
  EXPECT_EQ(statement("POINT/1,2", Dialect::native), "POINT/ 1, 2");
  EXPECT_EQ(statement("CIRCLE/1,2,3,0,0,1,5"), "CIRCLE/ 1, 2, 3, 0, 0, 1, 5");
  EXPECT_EQ(errors("POINT/1,2", Dialect::apt360), "76");
  EXPECT_EQ(errors("TOOL/1"), "1000");
}

TEST(Statements, ClText) {
  const auto cl = [](const std::string& s) { return statement(s, Dialect::cl); };
  EXPECT_EQ(cl("TOOL  PATH / BOK_7, TOOL, R390-25A"),
            "TOOL PATH/ 'BOK_7', TOOL, 'R390-25A'  $$ foreign");
  EXPECT_EQ(cl("END-OF-PATH"), "END-OF-PATH  $$ foreign");
  EXPECT_EQ(cl("PAINT/COLOR,186"), "PAINT/ 'COLOR', 186  $$ foreign");
  EXPECT_EQ(cl("SPINDL / RPM, 15915.5,  CLW"), "SPINDL/ RPM, 15915.5, CLW");
  EXPECT_EQ(cl("LOADTL/1,LENGTH,5,OSETNO,2"), "LOADTL/ 1, LENGTH, 5, 'OSETNO', 2");
  EXPECT_EQ(cl("TPRINT/T1 Face Mill,T1$\n x"), "TPRINT/ 'T1 Face Mill', 'T1 x'  $$ foreign");
  EXPECT_EQ(cl("SWITCH/9"), "SWITCH/ 9");
  EXPECT_EQ(cl("UNITS / MM"), "UNITS/ MM");
  EXPECT_EQ(cl("UNIT/MM"), "UNITS/ MM");
  EXPECT_EQ(cl("CIRCLE/1,2,3,0,0,-1."), "CIRCLE/ 1, 2, 3, 0, 0, -1  $$ foreign");
  EXPECT_EQ(cl("CIRCLE/1,2,3,0,0,1,5"), "CIRCLE/ 1, 2, 3, 0, 0, 1, 5");
  EXPECT_EQ(cl("TOOLNO/1,,2"), "TOOLNO/ 1, '', 2");
  EXPECT_EQ(cl("NURBS/"), "NURBS/   $$ foreign");
  EXPECT_EQ(cl("TLON,GOFWD/(CIRCLE/0,0,0,5),ON,(LINE/0,0,0,1,1,0)"),
            "GOTO/ 1, 1, 0");  // the last of two: CIRCLE, then the end of the line
  EXPECT_EQ(cl("CSI_SET_FLUTE_LENGTH/10"), "CSI_SET_FLUTE_LENGTH/ 10  $$ foreign");
}

TEST(Dialects, ClTextIsRecognizedByItsFirstLines) {
  const auto dialectOf = [](const std::string& text) {
    return std::string(compileText(text)->program.dialect);
  };
  EXPECT_EQ(dialectOf("TOOL PATH/A,TOOL,B\nGOTO/1,2,3\n"), "cl");
  EXPECT_EQ(dialectOf("\xEF\xBB\xBF$$*   Pro/CLfile  Version 8.0\nGOTO/1,2,3\n"), "cl");
  EXPECT_EQ(dialectOf("$$ A = 1\nPARTNO A=1\nPPRINT/'Roughing'\n"), "cl");
  EXPECT_EQ(dialectOf("A=1\nTLDATA/MILL,1\nFINI\n"), "auto");
  EXPECT_EQ(dialectOf("A1) P1 = POINT/1,2\nPAINT/PATH\nFINI\n"), "auto");
  EXPECT_EQ(dialectOf("PARTNO PART\nGOTO/1,2,3\nFINI\n"), "auto");
  EXPECT_EQ(compileText("TOOL PATH/A\nFINI\n", Dialect::native)->program.dialect, "native");
}

TEST(Dialects, EveryRuleIsTakenBySomeDialectAndRefusedByAnother) {
  for (const DialectRow& row : dialectTable()) {
    bool taken = false, refused = false;
    for (const Leave leave : row.leave) {
      (leave == Leave::refused ? refused : taken) = true;
    }
    EXPECT_TRUE(taken) << row.what;
    EXPECT_TRUE(refused) << row.what;
  }
}

TEST(Statements, AProgramWithoutAnyTellsWhatAFirstOneLooksLike) {
  for (const char* const text : {"", "\n\n", "$$ nothing but a comment\n"}) {
    const auto empty = compileText(text, Dialect::native);
    ASSERT_EQ(empty->codes(), "E0289") << text;
    EXPECT_NE(empty->sink.all()[0].help.find("FROM/0,0,0"), std::string::npos) << text;
  }
  const auto other = compileText("A=1\n", Dialect::native);
  ASSERT_EQ(other->codes(), "E0289");
  EXPECT_EQ(other->sink.all()[0].help, "");
}

}  // namespace
}  // namespace arelem::frontend
