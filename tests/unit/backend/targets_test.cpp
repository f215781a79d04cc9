#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/backend/writing.h"

namespace arelem::test {
namespace {

std::string_view nameFor(std::string_view path) {
  const backend::Target* target = backend::targetForFile(path);
  return target == nullptr ? "" : target->name;
}

TEST(Targets, AreFoundByNameAndBySuffix) {
  EXPECT_EQ(backend::findTarget("json")->name, "json");
  EXPECT_EQ(backend::findTarget("g-code"), nullptr);
  EXPECT_EQ(nameFor("part.cl"), "cl");
  EXPECT_EQ(nameFor("dir.svg/part.CLS"), "cl");
  EXPECT_EQ(nameFor("part.cltape"), "cltape");
  EXPECT_EQ(nameFor("part.jsonl"), "json");
  EXPECT_EQ(nameFor("part.lst"), "listing");
  EXPECT_EQ(nameFor("part.svg"), "svg");
  EXPECT_EQ(nameFor("part.ir"), "ir");
  EXPECT_EQ(nameFor("part.deck"), "deck");
  EXPECT_EQ(nameFor("part"), "");
  EXPECT_EQ(nameFor(".svg"), "");
  EXPECT_EQ(nameFor("part.svg.gz"), "");
}

TEST(Targets, HaveNamesAndSuffixesOfTheirOwn) {
  std::set<std::string_view> names, suffixes;
  for (const backend::Target& target : backend::targets()) {
    EXPECT_TRUE(names.insert(target.name).second) << target.name;
    ASSERT_FALSE(target.suffixes.empty()) << target.name;
    for (const std::string_view suffix : target.suffixes) {
      EXPECT_TRUE(suffixes.insert(suffix).second) << suffix;
    }
    EXPECT_FALSE(target.summary.empty());
  }
}

TEST(Targets, TheProgramNeedsAProgram) {
  CollectingSink sink;
  EXPECT_EQ(written("ir", {}, backend::Context{}, sink), "");
  ASSERT_EQ(sink.errors(), 1U);
  EXPECT_EQ(sink.all()[0].kind().code, "E0603");

  ir::Program program;
  backend::Context context;
  context.program = &program;
  std::ostringstream expected;
  ir::print(expected, program);
  CollectingSink quiet;
  EXPECT_EQ(written("ir", {record(1, cl::Fini{})}, context, quiet), expected.str());
  EXPECT_EQ(quiet.errors(), 0U);
}

TEST(Targets, TheDeckIsWhatWasPunched) {
  backend::Context context;
  context.deck = "A,0,SCALAR,1,4\nENDPCH\n";
  CollectingSink sink;
  EXPECT_EQ(written("deck", {}, context, sink), context.deck);
  EXPECT_EQ(sink.errors(), 0U);
}

}  // namespace
}  // namespace arelem::test
