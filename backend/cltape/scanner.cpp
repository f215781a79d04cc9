#include <array>
#include <istream>

#include "backend/cltape/reader.h"
#include "ir/diag/output.h"

namespace arelem::backend::tape {

namespace {
constexpr std::size_t headerBytes = 16;
constexpr unsigned char endOfTape = 0xFF;
constexpr int fini = 14000;
constexpr int smallestClass = 1000;
constexpr int largestClass = 100000;

std::uint64_t little(const char* bytes, std::size_t count) {
  std::uint64_t value = 0;
  for (std::size_t i = count; i-- > 0;) {
    value = (value << 8U) | static_cast<unsigned char>(bytes[i]);
  }
  return value;
}

int littleInteger(const char* bytes) {
  return static_cast<int>(static_cast<std::uint32_t>(little(bytes, 4)));
}
}  // namespace

Scanner::Scanner(std::istream& in, DiagnosticSink& sink, const Limits& limits)
    : in_(in), sink_(sink), limits_(limits) {}

const TapeRecord* Scanner::next() {
  if (ended_) {
    return nullptr;
  }
  if (records_ >= limits_.records) {
    report(diag::TapeRecordLimit, limits_.records);
    stop();
    return nullptr;
  }
  const int previous = record_.number;
  if (!readHeader()) {
    stop();
    return nullptr;
  }
  ++records_;
  if (record_.number != previous + 1) {
    report(diag::TapeSequence, record_.number, record_.offset, previous);
  }
  if (record_.type == fini) {
    complete_ = true;
    ended_ = true;
    checkEnd();
  }
  return &record_;
}

bool Scanner::readHeader() {
  std::array<char, headerBytes> header{};
  record_.offset = offset_;
  const std::size_t got = readBytes(header.data(), headerBytes);
  const bool end = got == 0 || (got == 1 && static_cast<unsigned char>(header[0]) == endOfTape);
  if (end) {
    report(diag::TapeWithoutFini, records_, record_.offset);
    return false;
  }
  if (got < headerBytes) {
    report(diag::TapeTruncated, records_ + 1, record_.offset, headerBytes, got);
    return false;
  }
  record_.number = littleInteger(header.data());
  const int words = littleInteger(header.data() + 4);
  record_.type = littleInteger(header.data() + 8);
  record_.sub = littleInteger(header.data() + 12);
  const bool plausible = record_.number > 0 && words >= 0 &&
                         words <= static_cast<int>(wordsOfARecord) &&
                         record_.type >= smallestClass && record_.type <= largestClass;
  if (!plausible) {
    report(diag::TapeHeader, records_ + 1, record_.offset, record_.number, words, record_.type);
    return false;
  }
  return readWords(static_cast<std::uint32_t>(words));
}

bool Scanner::readWords(std::uint32_t count) {
  constexpr std::size_t block = 512;
  std::array<char, 8 * block> bytes{};
  record_.words.clear();
  while (record_.words.size() < count) {
    const std::size_t wanted = 8 * std::min(block, count - record_.words.size());
    const std::size_t got = readBytes(bytes.data(), wanted);
    for (std::size_t i = 0; i + 8 <= got; i += 8) {
      record_.words.push_back(little(bytes.data() + i, 8));
    }
    if (got < wanted) {
      const std::size_t have = 8 * record_.words.size() + got % 8;
      report(diag::TapeTruncated, records_ + 1, record_.offset,
             headerBytes + 8 * std::size_t{count}, headerBytes + have);
      return false;
    }
  }
  return true;
}

std::size_t Scanner::readBytes(char* place, std::size_t count) {
  in_.read(place, static_cast<std::streamsize>(count));
  const auto got = static_cast<std::size_t>(in_.gcount());
  offset_ += got;
  return got;
}

void Scanner::checkEnd() {
  const std::uint64_t end = offset_;
  std::array<char, 4096> bytes{};
  std::size_t got = readBytes(bytes.data(), bytes.size());
  const bool marked = got > 0 && static_cast<unsigned char>(bytes[0]) == endOfTape;
  const std::uint64_t from = end + (marked ? 1 : 0);
  while (got == bytes.size()) {
    got = readBytes(bytes.data(), bytes.size());
  }
  if (offset_ > from) {
    report(diag::TapeBehindFini, offset_ - from, from);
  } else if (!marked) {
    report(diag::TapeWithoutEnd, end);
  }
}

void Scanner::stop() {
  ended_ = true;
}

void Scanner::summary() {
  for (const auto& [code, count] : reported_) {
    if (count > reportsOfAKind) {
      sink_.accept(diagnose(Span{}, diag::TapeMore, count - reportsOfAKind, code));
    }
  }
}

}  // namespace arelem::backend::tape
