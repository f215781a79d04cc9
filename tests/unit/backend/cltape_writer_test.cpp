#include <array>
#include <bit>
#include <cstring>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/backend/writing.h"

namespace arelem::test {
namespace {

/// A record as its bytes say, decoded here by hand (the test machine is little-endian).
struct RawRecord {
  int number, words, type, sub;
  std::vector<std::uint64_t> data;
};

std::vector<RawRecord> decoded(const std::string& bytes) {
  std::vector<RawRecord> records;
  std::size_t at = 0;
  while (at + 16 <= bytes.size()) {
    std::array<int, 4> header{};
    std::memcpy(header.data(), bytes.data() + at, 16);
    RawRecord r{header[0], header[1], header[2], header[3], {}};
    at += 16;
    for (int i = 0; i < r.words; ++i, at += 8) {
      std::uint64_t word = 0;
      std::memcpy(&word, bytes.data() + at, 8);
      r.data.push_back(word);
    }
    records.push_back(std::move(r));
  }
  EXPECT_EQ(at + 1, bytes.size());
  EXPECT_EQ(bytes.back(), '\xFF');
  return records;
}

std::string head(const RawRecord& r) {
  return std::to_string(r.number) + ":" + std::to_string(r.type) + "/" + std::to_string(r.sub);
}

cl::Motion path(int points, const std::string& name = "") {
  cl::Motion m;
  m.name = name;
  m.coordinates.assign(static_cast<std::size_t>(3 * points), 1.0);
  return m;
}

cl::Surface circle() {
  cl::Surface c;
  c.surface = {EntityType::circle, "C1", 0, {12, 10, 0, 0, 0, 1, 2}};
  return c;
}

// cldata.md, section 1: the record list of the manual's sample part.
TEST(TapeWriter, RecordListOfTheSamplePart) {
  cl::Motion from = path(1);
  from.kind = cl::Motion::Kind::from;
  std::vector<cl::Record> records = {
      record(1, cl::Text{Word::PARTNO, " SAMPLE"}),
      record(2, cl::Values{Word::INTOL, {0, 0, 0, 0}}),
      record(3, cl::Values{Word::OUTTOL, {0.005, 0.005, 0.005, 0.005}}),
      record(4, cl::Values{Word::CUTTER, {0.25}}),
      record(5, cl::Post{Word::SPINDL, "", {2000.0, Word::CLW}}),
      record(6, cl::Post{Word::COOLNT, "", {Word::ON}}),
      record(7, cl::Post{Word::FEDRAT, "", {20.0}}),
      record(8, from),
      record(20, path(1, "L1")),
      record(21, path(1, "L1")),
      record(22, path(1, "L2")),
      record(23, path(1, "L3")),
      record(24, circle()),
      record(24, path(12, "C1")),
      record(25, path(1)),
      record(26, circle()),
      record(26, path(9, "C1"))};
  for (int isn = 27; isn < 31; ++isn) {
    records.push_back(record(isn, path(1)));
  }
  records.push_back(record(31, cl::Post{Word::END, "", {}}));
  records.push_back(record(32, cl::Fini{}));
  const auto tape = decoded(written("cltape", records));

  std::vector<std::string> heads;
  for (const RawRecord& r : tape) {
    heads.push_back(head(r));
  }
  EXPECT_THAT(heads,
              ::testing::ElementsAre(
                  "1:1000/1", "2:2000/1045", "3:1000/2", "4:6000/4", "5:1000/3", "6:6000/5",
                  "7:1000/4", "8:6000/6", "9:1000/5", "10:2000/1031", "11:1000/6", "12:2000/1030",
                  "13:1000/7", "14:2000/1009", "15:1000/8", "16:5000/3", "17:1000/20", "18:5000/5",
                  "19:1000/21", "20:5000/5", "21:1000/22", "22:5000/5", "23:1000/23", "24:5000/5",
                  "25:1000/24", "26:3000/2", "27:5000/5", "28:1000/25", "29:5000/5", "30:1000/26",
                  "31:3000/2", "32:5000/5", "33:1000/27", "34:5000/5", "35:1000/28", "36:5000/5",
                  "37:1000/29", "38:5000/5", "39:1000/30", "40:5000/5", "41:1000/31", "42:2000/1",
                  "43:1000/32", "44:14000/0"));
  EXPECT_EQ(tape[9].data, (std::vector<std::uint64_t>{std::bit_cast<std::uint64_t>(2000.0), 60}));
  EXPECT_EQ(tape[11].data, (std::vector<std::uint64_t>{71}));
  EXPECT_EQ(tape[1].words, 11);
  EXPECT_EQ(tape[25].words, 12);
  EXPECT_EQ(tape[26].words, 2 + 36);
}

TEST(TapeWriter, BytesOfAPoint) {
  cl::Motion m;
  m.name = "L1";
  m.subscript = 2;
  m.coordinates = {1.0, 2.0, -0.5};
  const std::string bytes = written("cltape", {{258, "A1", Span{}, m}});
  const std::string expected =
      std::string("\x01\0\0\0\x02\0\0\0\xe8\x03\0\0\x02\x01\0\0", 16) + std::string(8, '\0') +
      "A1      " + std::string("\x02\0\0\0\x05\0\0\0\x88\x13\0\0\x05\0\0\0", 16) + "    L1  " +
      std::string("\0\0\0\0\0\0\0\x40", 8) + std::string("\0\0\0\0\0\0\xf0\x3f", 8) +
      std::string("\0\0\0\0\0\0\0\x40", 8) + std::string("\0\0\0\0\0\0\xe0\xbf", 8) + "\xff";
  EXPECT_EQ(bytes, expected);
}

TEST(TapeWriter, LongMotionsContinueAndAxisIsAnnounced) {
  cl::Motion m = path(100);
  const auto tape = decoded(written("cltape", {record(1, m)}));
  ASSERT_EQ(tape.size(), 3U);
  EXPECT_EQ(head(tape[1]), "2:5000/5");
  EXPECT_EQ(tape[1].words, 242);
  EXPECT_EQ(head(tape[2]), "3:5000/6");
  EXPECT_EQ(tape[2].words, 62);

  m.withAxis = true;
  m.coordinates.assign(6, 0.5);
  const auto axis = decoded(written("cltape", {record(1, m), record(1, path(1))}));
  ASSERT_EQ(axis.size(), 5U);
  EXPECT_EQ(head(axis[1]), "2:9000/2");
  EXPECT_EQ(axis[1].data, (std::vector<std::uint64_t>{1}));
  EXPECT_EQ(head(axis[3]), "4:9000/2");
  EXPECT_EQ(axis[3].data, (std::vector<std::uint64_t>{0}));
}

TEST(TapeWriter, ACardIsA1000RecordOfItsOwn) {
  const auto tape = decoded(written("cltape", {record(3, cl::Card{}), record(4, path(1)),
                                               record(4, cl::Card{}), record(4, path(1))}));
  std::vector<std::string> heads;
  for (const RawRecord& r : tape) {
    heads.push_back(head(r));
  }
  EXPECT_THAT(heads,
              ::testing::ElementsAre("1:1000/3", "2:1000/4", "3:5000/5", "4:1000/4", "5:5000/5"));
}

TEST(TapeWriter, PosesLoseTheirSideAndTheWriterSaysSo) {
  cl::Motion pose;
  pose.withAxis = true;
  pose.withSide = true;
  pose.coordinates = {1, 2, 3, 0, 0, 1, 1, 0, 0, 4, 5, 6, 0, 0, 1, 0, 1, 0};
  CollectingSink sink;
  const auto tape =
      decoded(written("cltape", {record(1, pose), record(2, pose)}, backend::Context{}, sink));
  ASSERT_EQ(tape.size(), 5U);
  EXPECT_EQ(tape[2].words, 2 + 12);
  ASSERT_EQ(sink.all().size(), 1U);
  EXPECT_EQ(sink.all()[0].kind().code, "W0604");
}

}  // namespace
}  // namespace arelem::test
