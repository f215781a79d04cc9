// Every diagnostic of this room is shown by a program that makes it.
#include <set>

#include "tests/unit/frontend/program_text.h"

namespace arelem::frontend {
namespace {

struct Example {
  std::string code;
  std::string text;
  Dialect dialect = Dialect::automatic;
};

std::string repeated(const std::string& part, int count) {
  std::string all;
  for (int i = 0; i < count; ++i) {
    all += part;
  }
  return all;
}

std::string numbered(const std::string& before, const std::string& after, int count) {
  std::string all;
  for (int i = 0; i < count; ++i) {
    all += before + std::to_string(i) + after;
  }
  return all;
}

std::vector<Example> lexical() {
  return {{"E0101", "A=1;2"},
          {"E0102", "A=1\x01"},
          {"W0103", "PARTNO \xE9"},
          {"W0104", "$$ \xE2\x80\x8B"},
          {"E0105", "ABCDEFG=1", Dialect::apt360},
          {"E0106", "A=1.2345678901234567", Dialect::apt360},
          {"E0107", "A=1.5X"},
          {"E0108", "A=."},
          {"E0109", "A=1.E999"},
          {"E0110", "DISPLY/'A"},
          {"E0111", "INTOL/1" + repeated(",$\n1", 300), Dialect::apt360},
          {"E0112", "  PPRINT X"},
          {"E0114", "A=1" + repeated("**1", 40), Dialect::cl},
          {"E0115", "A=1" + repeated("+1", 2001), Dialect::cl},
          {"E0820", "A=" + repeated("(", 201) + "1" + repeated(")", 201), Dialect::cl},
          {"W0821", numbered("A=U", "\n", 201)}};
}

std::vector<Example> syntax() {
  return {{"E0201", "A=B"},
          {"E0202", ",A"},
          {"E0203", "A=1)"},
          {"E0204", "A=(1"},
          {"E0205", "A=1+"},
          {"E0206", "A=1*/2"},
          {"E0207", "A=(1)(2)"},
          {"E0208", "A=1+TO"},
          {"E0209", "A=SINF+1"},
          {"W0209", "GOTO/1,2,3,4,5", Dialect::cl},
          {"E0210", "CYCLE,DRILL/1"},
          {"E0211", "FOOBAR/1"},
          {"E0212", "TO=1"},
          {"E0213", "TO)A=1"},
          {"E0214", "A=1\nA)B=1"},
          {"E0215", "A)B=1\nA)B=2"},
          {"E0216", "TRANTO/A"},
          {"E0217", "JUMPTO/A", Dialect::apt360},
          {"E0218", "TRANTO/(1+2)"},
          {"E0219", "LOOPST\nLOOPST\nLOOPND"},
          {"E0220", "LOOPND"},
          {"E0221", "LOOPST"},
          {"E0222", "IF(1)10,20"},
          {"E0260", "P=POINT/1,2\nA=P"},
          {"E0261", "A=1.LT.2"},
          {"E0262", "IF(1)THEN\nENDIF"},
          {"E0263", "A=SINF(1,2)"},
          {"E0264", "A=LNTHF(1)"},
          {"E0265", "A=SINF()"},
          {"E0266", "P=POINT/1,,2"},
          {"E0267", "P=POINT/1+1,2", Dialect::apt360},
          {"E0268", "GO/(TABCYL/NOZ)"},
          {"E0269", "GOTO/(1,2)"},
          {"E0270", "X=LOFT/1"},
          {"E0271", "P=POINT/'A'"},
          {"E0299", "C=CIRCEL/0,0,5"},
          {"W0201", "FINI\nA=1"},
          {"W0202", "A=2**3**2"},
          {"W0203", "P=POINT/1,2\nOBTAIN,POINT,P,A"},
          {"W0204", "DISPLY/HELLO"},
          {"W0205", "P=POINT/1+1,2"},
          {"W0206", "POINT/1,2"},
          {"W0208", "A)B=1\nJUMPTO/A"},
          {"W0207", "STOP/1"}};
}

std::vector<Example> macros() {
  const std::string m = "M=MACRO/X\nA=X\nTERMAC\n";
  return {{"E0223", "M=MACRO/\nLOOPST\nTERMAC"},
          {"E0224", "M=MACRO/\nN=MACRO/\nTERMAC\nTERMAC"},
          {"E0225", "A=1\nA=MACRO/\nTERMAC"},
          {"E0226", "M=MACRO\nTERMAC"},
          {"E0227", "M=MACRO/TO\nTERMAC"},
          {"E0228", "M=MACRO/A" + numbered(",$\nV", "=1", 50) + "\nTERMAC", Dialect::apt360},
          {"E0229", "TERMAC"},
          {"E0230", "M=MACRO/"},
          {"E0231", m + "B=M"},
          {"E0232", "CALL/M"},
          {"E0233", "CALL/"},
          {"E0234", m + "CALL/M,Y=1"},
          {"E0235", m + "CALL/M,1"},
          {"E0236", m + "CALL/M"},
          {"E0237", m + "CALL/M,X=(1+1)"},
          {"E0238", m + "CALL/M,X=1,X=2"},
          {"E0239", "M0=MACRO/\nA=1\nTERMAC\n" +
                        [] {
                          std::string t;
                          for (int i = 1; i < 80; ++i) {
                            t += "M" + std::to_string(i) + "=MACRO/\nCALL/M" +
                                 std::to_string(i - 1) + "\nTERMAC\n";
                          }
                          return t;
                        }() +
                        "CALL/M79"},
          {"E0240", m + numbered("CALL/M,X=", "\n", 100'001)},
          {"E0241", "CALL/M,SEC1"},
          {"E0242", "LIBRY/M\nCALL/M"},
          {"E0247", "LOOPST\nSYN/A,GOTO\nLOOPND"},
          {"E0248", "SYN/A"},
          {"E0249", "SYN/A,GOTO" + numbered(",$\nN", ",GOTO", 50), Dialect::apt360}};
}

std::vector<Example> parameters() {
  const std::string p = "P=POINT/1,2\nL=LINE/XAXIS\nT=PATERN/RANDOM,P\n";
  return {{"E0244", "INCLUDE/'/x'"},
          {"E0246", "INCLUDE/'no-such-file.apt'"},
          {"E0250", "LOOPST\nRESERV/A,1\nLOOPND"},
          {"E0251", "RESERV/A"},
          {"E0252", "A=1\nRESERV/A,2"},
          {"E0253", "RESERV/A,2\nA(1)=1\nB=A"},
          {"E0254", "A(1)=1"},
          {"E0255", "RESERV/A,2\nA(3)=1"},
          {"E0256", "RESERV/A,2\nA(1)=1\nPRINT/3,A(1,THRU)"},
          {"E0257", "RESERV/A,2\nA(1)=1\nCUTTER/A(ALL)"},
          {"E0258", "RESERV/A,2\nA(1)=1\nA(A(1))=1", Dialect::apt360},
          {"E0259", p + "P=1"},
          {"E0272", "CUTTER"},
          {"E0273", "NOPOST/1"},
          {"E0274", p + "SPINDL/P"},
          {"E0275", "GOTO/1"},
          {"E0276", p + "GO/P"},
          {"E0277", p + "GO/LEFT,L"},
          {"E0278", p + "GOLFT/TO,L"},
          {"E0279", p + "GOUP/L"},
          {"E0280", p + "GOFWD/L,TO,L,TO,L"},
          {"E0281", "OBTAIN/A"},
          {"E0282", p + "OBTAIN,LINE/P,A"},
          {"E0283", p + "OBTAIN,POINT/P,A,B,C,D"},
          {"E0284", p + "OBTAIN,POINT/P,1"},
          {"E0285", p + "OBTAIN,PATERN/T,A"},
          {"E0286", p + "REFSYS/P"},
          {"E0287", p + "ZSURF/P"},
          {"E0288", "LOOPST\nFINI"},
          {"E0290", "FINI/1"},
          {"E0291", "DO/I=1,2"},
          {"E0292", "ENDDO"},
          {"E0293", "DO/I=1,2,0\nENDDO"},
          {"E0294", "PRINT/9"},
          {"E0295", "READ/1\nHELLO\nENDPCH"},
          {"E0296", "LOOPST\nREAD/1\nLOOPND"},
          {"E0297", "PTONLY/4"}};
}

/// Shown elsewhere: they need files, options, or a text without FINI.
const std::set<std::string> elsewhere = {"E0113", "E0243", "E0245", "E0289", "E0298"};

TEST(Rows, EveryRowIsShownByAProgram) {
  std::set<std::string> shown = elsewhere;
  for (const auto& list : {lexical(), syntax(), macros(), parameters()}) {
    for (const Example& e : list) {
      const std::string codes = reported(e.text, e.dialect);
      EXPECT_TRUE(codes.find(e.code) != std::string::npos || elsewhere.contains(e.code))
          << e.code << " from\n"
          << e.text.substr(0, 300) << "\ngave " << codes;
      shown.insert(e.code);
    }
  }
  for (const DiagRow& row : diagnosticTable()) {
    const std::string code(row.code);
    const bool ours = code.substr(1, 2) == "01" || code.substr(1, 2) == "02" || code == "E0820" ||
                      code == "W0821";
    EXPECT_TRUE(!ours || shown.contains(code)) << "no program shows " << code << " " << row.name;
  }
}

TEST(Rows, CodesAreUnique) {
  std::set<std::string_view> codes;
  for (const DiagRow& row : diagnosticTable()) {
    const bool ours = row.code.substr(1, 2) == "01" || row.code.substr(1, 2) == "02";
    EXPECT_TRUE(!ours || codes.insert(row.code).second) << row.code;
  }
}

}  // namespace
}  // namespace arelem::frontend
