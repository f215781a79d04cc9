// MACRO, CALL, LIBRY, READ, INCLUDE: language reference 2.7, 2.8, 2.11.
#include <filesystem>
#include <fstream>

#include "tests/unit/frontend/program_text.h"

namespace arelem::frontend {
namespace {

using Lines = std::vector<std::string>;
namespace fs = std::filesystem;

TEST(Macros, BodiesAreInstancesWithTheirValues) {
  const auto c = compileText(
      "M=MACRO/X,Y=2,CO\nGOTO/X,Y,0\nCOOLNT/CO\nTERMAC\nCALL/M,X=1,CO=FLOOD\n"
      "CALL/M,CO=MIST,X=-1,Y=3\nCALL/M,CO=FLOOD,X=1\nFINI\n");
  EXPECT_EQ(c->codes(), "");
  EXPECT_EQ(c->block(0), (Lines{"CALL/ M block 1", "CALL/ M block 2", "CALL/ M block 1", "FINI"}));
  EXPECT_EQ(c->block(1), (Lines{"GOTO/ 1, 2, 0", "COOLNT/ FLOOD", "TERMAC"}));
  EXPECT_EQ(c->block(2), (Lines{"GOTO/ -1, 3, 0", "COOLNT/ MIST", "TERMAC"}));
}

TEST(Macros, BodyStatementsKeepTheirNumbers) {
  const auto c = compileText("M=MACRO/\nGOTO/1,2,3\nPPRINT HELLO\nTERMAC\nCALL/M\nFINI\n");
  EXPECT_EQ(c->program.blocks[0].statements[0].isn, 5U);
  EXPECT_EQ(c->program.blocks[1].statements[0].isn, 2U);
  EXPECT_EQ(c->program.blocks[1].statements[1].isn, 3U);
}

TEST(Macros, ArrayNamesAndWordsAsValues) {
  const auto c = compileText(
      "RESERV/A,5\nA(3)=1\nM=MACRO/N,W\nB=N(3)\nW/1\nTERMAC\nCALL/M,N=A,W=DELAY\nFINI\n");
  EXPECT_EQ(c->codes(), "");
  EXPECT_EQ(c->block(1), (Lines{"B = A(3)", "DELAY/ 1", "TERMAC"}));
}

TEST(Macros, AVariableMayBeTheTypeOfADefinition) {
  const auto c = compileText(
      "M=MACRO/T,A=1\nP=T/A,2,3\nTERMAC\nCALL/M,T=POINT\nCALL/M,T=POINT,A=4\nGOTO/P\nFINI\n");
  EXPECT_EQ(c->codes(), "");
  EXPECT_EQ(c->block(1), (Lines{"P = POINT/ 1, 2, 3", "TERMAC"}));
  const auto quotient =
      compileText("M=MACRO/T\nX=T/2\nTERMAC\nLOOPST\nI=2\nCALL/M,T=I\nY=X+1\nLOOPND\nFINI\n");
  EXPECT_EQ(quotient->codes(), "");
}

TEST(Macros, ABrokenDefaultIsOneError) {
  EXPECT_EQ(compileText("M=MACRO/A=(2)\nB=A\nTERMAC\nCALL/M\nCALL/M\nFINI\n")->codes(), "E0237");
}

TEST(Macros, VariablesHideOuterNames) {
  const auto c =
      compileText("P1=POINT/1,2\nM=MACRO/P1\nB=P1\nTERMAC\nCALL/M,P1=4\nGOTO/P1\nFINI\n");
  EXPECT_EQ(c->codes(), "");
  EXPECT_EQ(c->block(1)[0], "B = 4");
}

TEST(Macros, ANumberReplacesAVariableAsAValue) {
  EXPECT_EQ(compileText("M=MACRO/X\nB=X**2\nTERMAC\nCALL/M,X=-5\nFINI\n")->block(1)[0],
            "B = (-5 ** 2)");
}

TEST(Macros, LabelsAreLocalAndJumpsNeedNoLoop) {
  const auto c =
      compileText("M=MACRO/X\n1)A=X\nIF(A)1,2,2\n2)TERMAC\nCALL/M,X=1\nCALL/M,X=2\nFINI\n");
  EXPECT_EQ(c->codes(), "");
  EXPECT_EQ(c->block(2), (Lines{"1) A = 2", "IF (A) 1@0, 2@2, 2@2", "2) TERMAC"}));
}

TEST(Macros, KeywordsOfAnInnerCallAreNotReplaced) {
  const auto c = compileText(
      "A=MACRO/X\nB=X\nTERMAC\nC=MACRO/X,Y\nCALL/A,X=X\n1)CALL/A,X=Y\nTERMAC\nCALL/"
      "C,X=3,Y=4\nFINI\n");
  EXPECT_EQ(c->codes(), "");
  ASSERT_EQ(c->program.blocks.size(), 4U);
  EXPECT_EQ(c->block(2).front(), "B = 3");
  EXPECT_EQ(c->block(3).front(), "B = 4");
}

TEST(Macros, RecursionIsFiniteHere) {
  const auto c = compileText("M=MACRO/\nA=1\nIF(A)1,1,2\n1)CALL/M\n2)TERMAC\nCALL/M\nFINI\n");
  EXPECT_EQ(c->codes(), "");
  EXPECT_EQ(c->block(1)[2], "1) CALL/ M block 1");
}

TEST(Macros, NestedCallsAreBounded) {
  std::string text;
  for (int i = 0; i < 100; ++i) {
    text += "M" + std::to_string(i) + "=MACRO/\n" +
            (i > 0 ? "CALL/M" + std::to_string(i - 1) + "\n" : "A=1\n") + "TERMAC\n";
  }
  EXPECT_EQ(errors(text + "CALL/M50"), "");
  EXPECT_EQ(errors(text + "CALL/M99"), "231");
}

TEST(Macros, ErrorsNameTheCall) {
  const auto c = compileText("M=MACRO/X\nGOTO/X\nTERMAC\nCALL/M,X=QQ\nFINI\n");
  ASSERT_EQ(c->codes(), "E0201");
  ASSERT_EQ(c->sink.all()[0].calledFrom.size(), 1U);
  EXPECT_EQ(c->sources.text(c->sink.all()[0].calledFrom[0]), "CALL/M,X=QQ");
}

TEST(Macros, DefinitionErrors) {
  EXPECT_EQ(errors("M=MACRO/TO\nTERMAC"), "207");
  EXPECT_EQ(errors("M=MACRO/X,X\nTERMAC"), "207");
  EXPECT_EQ(errors("M=MACRO\nTERMAC"), "203");
  EXPECT_EQ(errors("A=1\nA=MACRO/\nTERMAC"), "202");
  EXPECT_EQ(errors("TERMAC"), "209");
  EXPECT_EQ(errors("M=MACRO/\nA=1"), "36");
  EXPECT_EQ(errors("M=MACRO/\nN=MACRO/\nTERMAC\nTERMAC"), "201");
  EXPECT_EQ(errors("M=MACRO/\nLOOPST\nTERMAC"), "210");
  EXPECT_EQ(errors("M=MACRO/\nRESERV/A,5\nTERMAC"), "252");
  EXPECT_EQ(errors("M=MACRO/\nSYN/A,GOTO\nTERMAC"), "353");
  EXPECT_EQ(errors("M=MACRO/\nA=(1\nTERMAC"), "10");
  EXPECT_EQ(errors("M=MACRO/X=(1+2)\nTERMAC"), "234");
  std::string many = "M=MACRO/V0=1";
  for (int i = 1; i <= 50; ++i) {
    many += ",$\nV" + std::to_string(i) + "=1";
  }
  EXPECT_EQ(errors(many + "\nTERMAC", Dialect::apt360), "205");
}

TEST(Macros, CallErrors) {
  const std::string m = "M=MACRO/X,Y=1\nA=X+Y\nTERMAC\n";
  EXPECT_EQ(errors(m + "CALL/M"), "230");
  EXPECT_EQ(errors(m + "CALL/M,Z=1"), "228");
  EXPECT_EQ(errors(m + "CALL/M,X=1,X=2"), "228");
  EXPECT_EQ(errors(m + "CALL/M,1"), "229");
  EXPECT_EQ(errors(m + "CALL/M,X=(1+2)"), "234");
  EXPECT_EQ(errors(m + "CALL/M,X=PARTNO"), "234");
  EXPECT_EQ(errors(m + "CALL/"), "226");
  EXPECT_EQ(errors("CALL/Q"), "233");
  EXPECT_EQ(errors("CALL/M,X=1\n" + m), "233");
  EXPECT_EQ(errors("CALL/USERP,SEC1,1,2"), "233");
  EXPECT_EQ(errors(m + "B=M"), "211");
}

/// A folder of its own with the texts that a test includes.
class Folder {
 public:
  Folder() : path_(fs::temp_directory_path() / ("arelem_frontend_" + std::to_string(::getpid()))) {
    fs::create_directories(path_ / "inner");
  }
  ~Folder() { fs::remove_all(path_); }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name) << text;
  }
  [[nodiscard]] std::unique_ptr<Compiled> compileFile(const std::string& name,
                                                      const std::string& text) const {
    auto c = std::make_unique<Compiled>();
    Options options;
    options.libraryPath = {path_.string()};
    const BufferId buffer = c->sources.add((path_ / name).string(), text);
    c->program = compile(c->sources, buffer, options, c->sink);
    return c;
  }

 private:
  fs::path path_;
};

TEST(Includes, LibraryMacros) {
  const Folder folder;
  folder.write("strtup.apt", "$$ start\nSTRTUP=MACRO/D,F=10\nCUTTER/D\nFEDRAT/F\nTERMAC\n");
  const auto c =
      folder.compileFile("main.apt", "LIBRY/STRTUP\nCALL/STRTUP,D=5\nGOTO/1,2,3\nFINI\n");
  EXPECT_EQ(c->codes(), "");
  EXPECT_EQ(c->block(1), (Lines{"CUTTER/ 5", "FEDRAT/ 10", "TERMAC"}));
  EXPECT_EQ(c->program.blocks[0].statements[1].isn, 8U);  // the library's five cards are counted
  folder.write("empty.apt", "A=1\n");
  EXPECT_EQ(
      folder.compileFile("main.apt", "LIBRY/EMPTY,NONE\nCALL/EMPTY\nCALL/NONE\nFINI\n")->legacy(),
      "31 31");
  EXPECT_EQ(folder.compileFile("main.apt", "LIBRY/5\nFINI\n")->legacy(), "129");
}

TEST(Includes, Segments) {
  const Folder folder;
  folder.write("seg.apt", "P1=POINT/1,2\n");
  const auto c = folder.compileFile("main.apt", "READ/2,SEG\nGOTO/P1\nFINI\n");
  EXPECT_EQ(c->codes(), "");
  EXPECT_EQ(c->block()[0], "P1 = POINT/ 1, 2");
  EXPECT_EQ(folder.compileFile("main.apt", "READ/2\nREAD/5,A\nFINI\n")->legacy(), "2000 2000");
}

TEST(Includes, FilesInTheirJail) {
  const Folder folder;
  folder.write("inner/a.apt", "A=1\n");
  folder.write("loop.apt", "INCLUDE/'loop.apt'\n");
  EXPECT_EQ(folder.compileFile("main.apt", "INCLUDE/'inner/a.apt'\nB=A\nFINI\n")->codes(), "");
  EXPECT_EQ(folder.compileFile("inner/m.apt", "INCLUDE/'a.apt'\nFINI\n")->codes(), "");
  EXPECT_EQ(folder.compileFile("main.apt", "INCLUDE/'../../etc/passwd'\nFINI\n")->codes(), "E0244");
  EXPECT_EQ(folder.compileFile("main.apt", "INCLUDE/'/etc/passwd'\nFINI\n")->codes(), "E0244");
  EXPECT_EQ(folder.compileFile("main.apt", "INCLUDE/'none.apt'\nINCLUDE/'inner'\nFINI\n")->codes(),
            "E0246 E0246");
  EXPECT_EQ(folder.compileFile("main.apt", "INCLUDE/'loop.apt'\nFINI\n")->codes(), "E0245");
}

TEST(Includes, Decks) {
  const auto c = compileText(
      "RESERV/Q,3\nREAD/1\nP1,0,POINT,3,1,2,3\nA,0,SCALAR,1,-4.5\nQ,2,POINT,3,1,1,1\nENDPCH\n"
      "GOTO/P1,A\nFINI\n");
  EXPECT_EQ(c->codes(), "");
  EXPECT_EQ(c->block(), (Lines{"P1 = POINT/ CANON, 1, 2, 3", "A = -4.5",
                               "Q(2) = POINT/ CANON, 1, 1, 1", "GOTO/ P1, A", "FINI"}));
  EXPECT_EQ(compileText("READ/1\nP1,0,POINT,4,1,2,3\nENDPCH\nFINI\n")->legacy().substr(0, 4),
            "2000");
  EXPECT_EQ(compileText("READ/1\nA,0,SCALAR,1,1\n")->legacy(), "2000 23");
}

}  // namespace
}  // namespace arelem::frontend
