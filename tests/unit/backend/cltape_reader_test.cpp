#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "backend/cltape/dump.h"
#include "backend/cltape/reader.h"
#include "tests/unit/backend/oracle_records.h"
#include "tests/unit/backend/random_records.h"
#include "tests/unit/backend/writing.h"

namespace arelem::test {
namespace {

struct Reading {
  std::vector<cl::Record> records;
  backend::TapeSummary summary;
  CollectingSink sink;
};

std::unique_ptr<Reading> read(const std::string& bytes, const Limits& limits = {}) {
  auto reading = std::make_unique<Reading>();
  std::istringstream in(bytes);
  cl::Recording recording;
  reading->summary = backend::readTape(in, recording, reading->sink, limits);
  reading->records = std::move(recording.records);
  return reading;
}

std::vector<std::string> codes(const CollectingSink& sink) {
  std::vector<std::string> list;
  for (const Diagnostic& d : sink.all()) {
    list.emplace_back(d.kind().code);
  }
  return list;
}

void expectRoundTrip(const std::vector<cl::Record>& records, const std::string& what) {
  const std::string bytes = written("cltape", records);
  const auto reading = read(bytes);
  EXPECT_TRUE(reading->summary.complete) << what;
  EXPECT_EQ(reading->sink.errors(), 0U) << what;
  EXPECT_TRUE(written("cltape", reading->records) == bytes) << what;
}

void expectRoundTrips(const std::vector<OracleCase>& cases) {
  for (const OracleCase& c : cases) {
    std::vector<cl::Record> records = c.records;
    if (!std::holds_alternative<cl::Fini>(records.back().body)) {
      records.push_back(record(records.back().isn + 1, cl::Fini{}));
    }
    expectRoundTrip(records, c.name);
    const std::vector<cl::Record> again = read(written("cltape", records))->records;
    // Compared as text, because a tab of a PPRINT is a blank on the tape.
    EXPECT_TRUE(written("cl", again) == written("cl", records)) << c.name;
  }
}

TEST(TapeReader, OldProgramsComeBackByteForByte) {
  const auto cases = readOracleCases();
  ASSERT_GE(cases.size(), 80U);
  expectRoundTrips(cases);
}

TEST(TapeReader, OldExamplesComeBackByteForByte) {
  const auto examples = readOracleExamples();
  if (examples.empty()) {
    GTEST_SKIP() << "the old system's examples are not here; ARELEM_SHARED names their folder";
  }
  expectRoundTrips(examples);
}

TEST(TapeReader, RandomRecordsComeBackByteForByte) {
  std::mt19937_64 random(1959);
  for (int i = 0; i < 300; ++i) {
    expectRoundTrip(randomRecords(random, 60), "stream " + std::to_string(i));
  }
}

TEST(TapeReader, RandomRecordsComeBackWithTheSameMeaning) {
  std::mt19937_64 random(1961);
  for (int i = 0; i < 300; ++i) {
    std::vector<cl::Record> records = randomRecords(random, 40);
    const auto reading = read(written("cltape", records));
    EXPECT_EQ(written("cl", reading->records), written("cl", records)) << i;
  }
}

TEST(TapeReader, ReadsNamesTextAndStatementNumbers) {
  cl::Motion m;
  m.name = "SP";
  m.subscript = 12;
  m.coordinates = {1, 2, 3};
  const std::vector<cl::Record> records = {{4, "CARD01", Span{}, cl::Text{Word::PARTNO, " A  B"}},
                                           {-9, "", Span{}, m},
                                           {9, "", Span{}, cl::Fini{}}};
  const auto reading = read(written("cltape", records));
  ASSERT_EQ(reading->records.size(), 3U);
  EXPECT_EQ(reading->records[0].isn, 4);
  EXPECT_EQ(reading->records[0].cardId, "CARD01");
  EXPECT_EQ(std::get<cl::Text>(reading->records[0].body).text, " A  B");
  EXPECT_EQ(reading->records[1].isn, -9);
  EXPECT_EQ(std::get<cl::Motion>(reading->records[1].body).name, "SP");
  EXPECT_EQ(std::get<cl::Motion>(reading->records[1].body).subscript, 12);
  EXPECT_EQ(reading->summary.records, 6U);
}

TEST(TapeReader, WhatFollowsFiniIsTold) {
  const std::string good = written("cltape", {record(1, cl::Fini{})});
  const std::size_t end = good.size() - 1;
  EXPECT_TRUE(read(good)->sink.all().empty());
  std::string stale = good;
  stale.insert(end, "stale bytes of a scratch file");
  const auto scratch = read(stale);
  EXPECT_TRUE(scratch->summary.complete);
  ASSERT_THAT(codes(scratch->sink), ::testing::ElementsAre("W0728"));
  EXPECT_THAT(scratch->sink.all()[0].message,
              ::testing::StartsWith(fmt::format("30 bytes from byte {} on", end)));
  const auto joined = read(good + std::string(5000, 'x'));
  ASSERT_THAT(codes(joined->sink), ::testing::ElementsAre("W0728"));
  EXPECT_THAT(joined->sink.all()[0].message,
              ::testing::StartsWith(fmt::format("5000 bytes from byte {} on", end + 1)));
  const auto cut = read(good.substr(0, end));
  EXPECT_TRUE(cut->summary.complete);
  EXPECT_THAT(codes(cut->sink), ::testing::ElementsAre("W0729"));
}

TEST(TapeReader, WrongSequenceNumbersAreWarnings) {
  std::string bytes = written("cltape", {record(1, cl::Fini{})});
  bytes[32] = 7;  // the number of the second record
  const auto reading = read(bytes);
  EXPECT_TRUE(reading->summary.complete);
  EXPECT_THAT(codes(reading->sink), ::testing::ElementsAre("W0723"));
  EXPECT_EQ(reading->sink.all()[0].message,
            "record 7 at byte 32 follows record 1: record numbers count 1, 2, 3");
}

TEST(TapeReader, ATapeCutOffAnywhereIsDiagnosed) {
  std::mt19937_64 random(5);
  const std::string bytes = written("cltape", randomRecords(random, 12));
  for (std::size_t size = 0; size + 17 < bytes.size(); ++size) {
    const auto reading = read(bytes.substr(0, size));
    EXPECT_FALSE(reading->summary.complete);
    EXPECT_EQ(reading->sink.errors(), 1U) << size;
  }
}

TEST(TapeReader, CountsAreNotTrusted) {
  std::string huge = written("cltape", {record(1, cl::Card{})});
  huge[4] = huge[5] = '\xFF';
  huge[6] = '\x0F';  // 0x0FFFFF words, and there are two
  EXPECT_THAT(codes(read(huge)->sink), ::testing::ElementsAre("E0721"));
  huge[7] = '\x7F';  // two thousand million words
  EXPECT_THAT(codes(read(huge)->sink), ::testing::ElementsAre("E0720"));
  huge[7] = '\xFF';  // a negative count
  EXPECT_THAT(codes(read(huge)->sink), ::testing::ElementsAre("E0720"));
  EXPECT_THAT(codes(read("PARTNO / no tape at all, but text\nFINI\n")->sink),
              ::testing::ElementsAre("E0720"));
}

TEST(TapeReader, UnknownClassesAreKeptAndTold) {
  const cl::Raw raw{15000, 3, {1, 2, 0xFFFFFFFFFFFFFFFF}};
  const auto reading = read(written("cltape", {record(1, raw), record(2, cl::Fini{})}));
  EXPECT_THAT(codes(reading->sink), ::testing::ElementsAre("W0725"));
  ASSERT_EQ(reading->records.size(), 2U);
  EXPECT_EQ(std::get<cl::Raw>(reading->records[0].body).words, raw.words);
}

TEST(TapeReader, KnownClassesWithWrongWordsAreKeptAndTold) {
  const std::vector<cl::Raw> wrong = {
      {5000, 5, {0, 0, 0, 0}},                      // two coordinates
      {5000, 5, {0, 0x7ff0000000000000, 0, 0, 0}},  // subscript infinite
      {5000, 5, {0, 0, 0x7ff8000000000000, 0, 0}},  // NaN
      {5000, 5, {0x0101010101010101, 0, 0, 0, 0}},  // a name of control characters
      {6000, 1, {2}},
      {6000, 2, {3}},
      {9000, 2, {2}},
      {9000, 9, {5}},
      {13000, 4, {}},
      {3000, 2, {0, 4, 9}},
      {3000, 2, {0, 99, 3, 0, 0, 0}},
      {2000, 1031, {999}},
      {2000, 0, {}},
      {6000, 6, {0xfff0000000000000}}};
  for (const cl::Raw& raw : wrong) {
    const std::string bytes = written("cltape", {record(1, raw), record(2, cl::Fini{})});
    const auto reading = read(bytes);
    EXPECT_THAT(codes(reading->sink), ::testing::ElementsAre("W0724"))
        << raw.type << "/" << raw.sub;
    EXPECT_EQ(written("cltape", reading->records), bytes);
  }
}

TEST(TapeReader, MutatedTapesNeverCrash) {
  std::mt19937_64 random(360);
  for (int i = 0; i < 4000; ++i) {
    std::string bytes = written("cltape", randomRecords(random, 12));
    for (int k = 0, changes = 1 + static_cast<int>(random() % 6); k < changes; ++k) {
      bytes[random() % bytes.size()] = static_cast<char>(random());
    }
    if (i % 3 == 0) {
      bytes.resize(random() % bytes.size());
    }
    const auto reading = read(bytes);
    EXPECT_LE(reading->records.size(), bytes.size() / 8);
    const auto again = read(written("cltape", reading->records));
    EXPECT_EQ(written("cltape", again->records), written("cltape", reading->records));
    std::istringstream in(bytes);
    std::ostringstream out;
    CollectingSink sink;
    EXPECT_EQ(backend::dump(in, out, sink).records, reading->summary.records);
  }
}

TEST(TapeReader, RepeatedFaultsAreCountedNotListed) {
  std::vector<cl::Record> records(100, record(1, cl::Raw{15000, 1, {}}));
  records.push_back(record(2, cl::Fini{}));
  const auto reading = read(written("cltape", records));
  EXPECT_EQ(reading->sink.all().size(), 21U);
  EXPECT_EQ(reading->sink.all().back().message, "80 more diagnostics W0725 are not shown");
}

TEST(TapeReader, TheLimitOfRecordsHolds) {
  std::vector<cl::Record> records(100, record(1, cl::Multax{true}));
  Limits limits;
  limits.records = 10;
  const auto reading = read(written("cltape", records), limits);
  EXPECT_EQ(reading->summary.records, 10U);
  EXPECT_THAT(codes(reading->sink), ::testing::ElementsAre("E0891"));
}

TEST(Dump, OneLineARecord) {
  cl::Motion m;
  m.name = "L1";
  m.coordinates = {1, 2.5, -3, 4, 5, 6};
  std::istringstream in(
      written("cltape", {{1, "A100", Span{}, cl::Text{Word::PARTNO, " X\x1b"}},
                         record(2, cl::Post{Word::SPINDL, "", {2000.0, Word::CLW}}),
                         record(3, m),
                         record(3, cl::Raw{15000, 1, {255}}),
                         record(4, cl::Fini{})}));
  std::ostringstream out;
  CollectingSink sink;
  backend::dump(in, out, sink);
  EXPECT_THAT(lines(out.str()),
              ::testing::ElementsAre(
                  "  record     offset  class        words  meaning",
                  "       1          0   1000/1          2  statement 1, card A100",
                  "       2         32   2000/1045      11  PARTNO \" X\"",
                  "       3        136   1000/2          2  statement 2",
                  "       4        168   2000/1031       2  SPINDL / 2000.0, CLW",
                  "       5        200   1000/3          2  statement 3",
                  "       6        232   5000/5          8  GOTO L1  1.0 2.5 -3.0; 4.0 5.0 6.0",
                  "       7        312  15000/1          1  raw 00000000000000ff",
                  "       8        336   1000/4          2  statement 4",
                  "       9        368  14000/0          0  FINI"));
}

}  // namespace
}  // namespace arelem::test
