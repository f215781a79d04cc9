// G97 programs: the worked example of the notes to the letter, codes, division, what is refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "backend/g97/block.h"
#include "tests/unit/backend/writing.h"

namespace arelem::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

cl::Motion pose(std::vector<double> numbers) {
  cl::Motion m;
  m.withAxis = numbers.size() >= 6;
  m.withSide = numbers.size() == 9;
  m.coordinates = std::move(numbers);
  return m;
}
cl::Post post(Word word, std::vector<cl::Value> values = {}) {
  return {word, "", std::move(values)};
}
cl::Record on(double n = 1) {
  return record(1, post(Word::SPRAY, {Word::ON, n}));
}
cl::Record off(double n = 1) {
  return record(1, post(Word::SPRAY, {Word::OFF, n}));
}
cl::Record feed(double v) {
  return record(1, post(Word::FEDRAT, {v, Word::MMPS}));
}
cl::Record rapid() {
  return record(1, post(Word::RAPID));
}
cl::Record at(std::vector<double> numbers) {
  return record(1, pose(std::move(numbers)));
}

robot::Machine painter() {
  robot::Machine machine;
  machine.rapid = 300;
  return machine;
}

std::string program(const std::vector<cl::Record>& records,
                    const robot::Machine& machine,
                    std::vector<std::string>& codes) {
  backend::Context context;
  context.machine = &machine;
  CollectingSink sink;
  std::string text = written("g97", records, context, sink);
  for (const Diagnostic& d : sink.all()) {
    codes.emplace_back(d.kind().code);
  }
  return text;
}

TEST(G97Writer, TheSpeedThatIsWrittenCounts) {
  robot::Machine machine = painter();
  machine.speed = 1000;
  for (const auto& [speed, fits] : {std::pair{1000.0002, true}, {1000.4, true}, {1000.6, false}}) {
    std::vector<std::string> codes;
    program({rapid(), at({0, 0, 0}), on(), feed(speed), at({50, 0, 0}), off()}, machine, codes);
    EXPECT_EQ(codes.empty(), fits) << speed;
  }
}

TEST(G97Writer, TheWorkedExample) {
  std::vector<std::string> codes;
  const std::string text =
      program({rapid(), at({400, 350, 200, 0, 0, 1}), on(), feed(100),
               at({450, 350, 205, 0.2, 0.3, 0.9}), at({500, 350, 200, 0, 0, 1}), off()},
              painter(), codes);
  EXPECT_THAT(codes, IsEmpty());
  EXPECT_EQ(text,
            "O0001\r\n"
            "N0001 P F0300M G97,N,F,0,0,0\r\n"
            "      X 400.00 Y 350.00 Z 200.00\r\n"
            "      P 0.00 Q 0.00 R 0.00\r\n"
            "      RON,1 BE\r\n"
            "N0002 L F0100M G97,N,F,0,0,0\r\n"
            "      X 450.00 Y 350.00 Z 205.00\r\n"
            "      P -18.43 Q 11.90 R 0.00\r\n"
            "      BE\r\n"
            "N0003 L F0100M G97,N,F,0,0,0\r\n"
            "      X 500.00 Y 350.00 Z 200.00\r\n"
            "      P 0.00 Q 0.00 R 0.00\r\n"
            "      ROF,1 PE\r\n");
  EXPECT_TRUE(g97::readPrograms(text, {}, "a").ok());
}

TEST(G97Writer, SwitchesOnlyWhatChangesAndOffAtTheEnd) {
  std::vector<std::string> codes;
  robot::Machine machine = painter();
  machine.g97.outputs = {7, 8};
  const std::string text =
      program({at({0, 0, 0}), on(), on(), feed(50), at({9, 0, 0}), off(2), on(2)}, machine, codes);
  EXPECT_THAT(codes, ElementsAre("W0642", "W0642"));
  const auto programs = g97::readPrograms(text, machine.g97, "a");
  ASSERT_TRUE(programs.ok()) << programs.failure().message;
  std::vector<std::string> written;
  for (const g97::Block& block : (*programs)[0].blocks) {
    written.push_back(block.code);
  }
  EXPECT_THAT(written, ElementsAre("RON,7", "RON,8", "ROF,7", "ROF,8"));
}

TEST(G97Writer, FeedsOfEveryUnit) {
  std::vector<std::string> codes;
  const std::string text =
      program({at({0, 0, 0}), record(1, post(Word::FEDRAT, {6000.0})), at({1, 0, 0}),
               record(1, post(Word::FEDRAT, {3000.0, Word::MMPM})), at({2, 0, 0}),
               record(1, post(Word::FEDRAT, {60.0, Word::IPM})), at({3, 0, 0})},
              painter(), codes);
  EXPECT_THAT(codes, IsEmpty());
  for (const char* f : {"F0300M", "F0100M", "F0050M", "F0025M"}) {
    EXPECT_THAT(text, HasSubstr(f));
  }
}

TEST(G97Writer, RefusesWhatHasNoForm) {
  const auto codesOf = [](const std::vector<cl::Record>& records, robot::Machine machine) {
    std::vector<std::string> codes;
    program(records, machine, codes);
    return codes;
  };
  EXPECT_THAT(codesOf({at({0, 0, 0}), at({9, 0, 0})}, painter()), ElementsAre("E0640"));
  EXPECT_THAT(codesOf({at({0, 0, 0}), feed(12000), at({9, 0, 0})}, painter()),
              ElementsAre("E0640"));
  EXPECT_THAT(codesOf({feed(-1)}, painter()), ElementsAre("E0641"));
  EXPECT_THAT(codesOf({at({10000, 0, 0})}, painter()), ElementsAre("E0642"));
  EXPECT_THAT(codesOf({on()}, painter()), ElementsAre("E0644"));
  EXPECT_THAT(codesOf({at({0, 0, 0}), record(1, post(Word::DELAY, {2.0}))}, painter()),
              ElementsAre("W0641"));
  robot::Machine machine = painter();
  machine.envelope.emplace().reach = {0, 500};
  EXPECT_THAT(codesOf({at({400, 400, 0})}, machine), ElementsAre("E0667"));
  machine.envelope->reach = {0, 1000};
  machine.envelope->lean = 30;
  EXPECT_THAT(codesOf({at({400, 400, 0, 1, 0, 1})}, machine), ElementsAre("E0667"));
  // One error is enough: SPRAY has a location before it, and so has the straight move.
  EXPECT_THAT(codesOf({at({400, 400, 0, 1, 0, 1}), on(), feed(9), at({9, 0, 0}), off()}, machine),
              ElementsAre("E0667"));
}

/// One message of a kind: the worst location, how many there are and which.
TEST(G97Writer, TellsEachKindOnceWithTheWorst) {
  robot::Machine machine = painter();
  machine.speed = 1000.0;
  machine.envelope.emplace().reach = {0, 500};
  backend::Context context;
  context.machine = &machine;
  CollectingSink sink;
  const std::string text =
      written("g97",
              {at({0, 0, 0}), feed(1200), at({600, 0, 0}), feed(1500), at({100, 0, 0}), feed(900),
               at({0, 700, 0}), at({0, 550, 0}), feed(1100), at({0, 0, 0})},
              context, sink);
  ASSERT_EQ(sink.all().size(), 2U);
  EXPECT_EQ(sink.all()[0].kind().code, "E0667");
  EXPECT_THAT(sink.all()[0].message, HasSubstr("700"));
  EXPECT_THAT(sink.all()[0].notes, ElementsAre(HasSubstr("3 of 6 locations")));
  EXPECT_EQ(sink.all()[1].kind().code, "E0666");
  EXPECT_THAT(sink.all()[1].message, HasSubstr("1500"));
  EXPECT_THAT(sink.all()[1].notes, ElementsAre(HasSubstr("2 of 6 locations")));
}

TEST(G97Writer, LiteralsOfTheMachineFile) {
  robot::Machine machine = painter();
  machine.g97.s63 = "S63,1,1,1";
  machine.g97.words["DELAY"] = "DLY,{1}";
  std::vector<std::string> codes;
  const std::string text = program(
      {at({0, 0, 0}), on(), record(1, post(Word::DELAY, {2.5})), feed(9), at({9, 0, 0}), off()},
      machine, codes);
  EXPECT_THAT(codes, IsEmpty());
  EXPECT_THAT(text, HasSubstr("N0001 P F0300M G97,N,F,0,0,0\r\n      X 0.00 Y 0.00 Z 0.00\r\n"
                              "      P 0.00 Q 0.00 R 0.00\r\n      S63,1,1,1 BE\r\n"));
  EXPECT_THAT(text, HasSubstr("      DLY,2.5 BE\r\n"));
  EXPECT_TRUE(g97::readPrograms(text, machine.g97, "a").ok());
  EXPECT_FALSE(g97::readPrograms(text, {}, "a").ok());
}

TEST(G97Writer, DividesBetweenPasses) {
  robot::Machine machine = painter();
  machine.g97.blocks = 7;
  machine.g97.program = 20;
  std::vector<cl::Record> records;
  for (int i = 0; i < 5; ++i) {  // passes of three blocks
    const double y = 10.0 * i;
    records.insert(records.end(),
                   {rapid(), at({0, y, 0}), on(), feed(100), at({5, y, 0}), at({9, y, 0}), off()});
  }
  std::vector<std::string> codes;
  const std::string text = program(records, machine, codes);
  EXPECT_THAT(codes, ElementsAre("W0640"));
  const auto programs = g97::readPrograms(text, machine.g97, "a");
  ASSERT_TRUE(programs.ok()) << programs.failure().message;
  ASSERT_EQ(programs->size(), 3U);
  EXPECT_EQ((*programs)[2].number, 22);
  EXPECT_EQ((*programs)[0].blocks.size(), 6U);
  EXPECT_EQ((*programs)[2].blocks.size(), 3U);
  machine.g97.blocks = 2;
  codes.clear();
  program(records, machine, codes);
  EXPECT_THAT(codes, ElementsAre("E0643"));
}

TEST(G97Writer, DividesStraightMovesWhereTheGunIsOff) {
  robot::Machine machine = painter();
  machine.g97.blocks = 7;
  std::vector<cl::Record> records = {at({0, 0, 0}), feed(100)};
  for (int i = 1; i <= 3; ++i) {  // straight to each pass of three blocks
    const double y = 10.0 * i;
    records.insert(records.end(), {at({0, y, 0}), on(), at({5, y, 0}), at({9, y, 0}), off()});
  }
  std::vector<std::string> codes;
  const auto programs = g97::readPrograms(program(records, machine, codes), machine.g97, "a");
  EXPECT_THAT(codes, ElementsAre("W0640"));
  ASSERT_TRUE(programs.ok()) << programs.failure().message;
  ASSERT_EQ(programs->size(), 2U);  // 1 + 3 + 3 blocks, then a lead and 3
  EXPECT_EQ((*programs)[0].blocks.size(), 7U);
  const std::vector<g97::Block>& second = (*programs)[1].blocks;
  ASSERT_EQ(second.size(), 4U);
  EXPECT_FALSE(second[0].straight);  // to (9, 20), where the first ended
  EXPECT_EQ(second[0].pose.point.y(), 20.0);
  EXPECT_EQ(second[0].code, "");
  EXPECT_TRUE(second[1].straight);
  EXPECT_EQ(second[1].code, "RON,1");
}

TEST(G97Writer, DividesAPathWithoutSpray) {
  std::vector<cl::Record> records = {feed(100)};
  for (int i = 0; i < 21001; ++i) {
    records.push_back(at({0.1 * i, 0, 0}));
  }
  std::vector<std::string> codes;
  const auto programs = g97::readPrograms(program(records, painter(), codes), {}, "a");
  EXPECT_THAT(codes, ElementsAre("W0640"));
  ASSERT_TRUE(programs.ok()) << programs.failure().message;
  ASSERT_EQ(programs->size(), 3U);
  EXPECT_EQ((*programs)[2].blocks.size(), 21001U - 9999U - 9998U + 1U);
}

TEST(G97Writer, TellsOfAWristThatMayTurnRound) {
  std::vector<std::string> codes;
  program({at({0, 0, 0, 0, -0.1, -1}), feed(9), at({1, 0, 0, 0, 0.1, -1})}, painter(), codes);
  EXPECT_THAT(codes, ElementsAre("W0643"));
}

TEST(G97Reader, TakesNothingButTheForm) {
  std::vector<std::string> codes;
  const std::string good =
      program({at({400, -0.001, 200}), on(), feed(100), at({450, 350, 205, 0, 0, 1}), off()},
              painter(), codes);
  ASSERT_TRUE(g97::readPrograms(good, {}, "a").ok());
  const auto refused = [&](const std::string& from, const std::string& to) {
    std::string bad = good;
    const std::size_t place = bad.find(from);
    ASSERT_NE(place, std::string::npos) << from;
    bad.replace(place, from.size(), to);
    const auto read = g97::readPrograms(bad, {}, "a");
    ASSERT_FALSE(read.ok()) << from << " -> " << to;
    EXPECT_EQ(read.failure().row->code, std::string("E0645"));
  };
  refused("O0001", "O0000");
  refused("N0002", "N0003");
  refused("N0001 P", "N0001  P");
  refused("F0100M", "F0000M");
  refused("F0100M", "F100M");
  refused("G97,N,F", "G97,F,F");
  refused("X 400.00", "X 400.0");
  refused("Y 0.00", "Y -0.00");
  refused("Z 205.00", "Z 20500.00");
  refused("P 0.00", "P 180.01");
  refused("Q 0.00", "Q 90.01");
  refused("R 0.00", "R -180.00");
  refused("RON,1", "RON,0");
  refused("RON,1 BE", "BE");
  refused("ROF,1 PE", "PE");
  refused("ROF,1 PE", "ROF,1 BE");
  refused("RON,1 BE", "RON,1 PE");
  refused("RON,1 BE", "S63,1 BE");
  refused("BE\r\n", "BE\n");
  EXPECT_FALSE(g97::readPrograms("", {}, "a").ok());
  EXPECT_FALSE(g97::readPrograms(good.substr(0, good.size() - 20), {}, "a").ok());
}

}  // namespace
}  // namespace arelem::test
