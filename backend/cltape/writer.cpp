#include "backend/cltape/writer.h"

#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include "backend/cltape/encode.h"
#include "backend/cltape/numbering.h"
#include "backend/text/out_buffer.h"
#include "ir/diag/output.h"

namespace arelem::backend {

namespace {
constexpr char endOfTape = '\xFF';

template <class Integer>
char* writeLittle(char* place, Integer value) {
  if constexpr (std::endian::native == std::endian::little) {
    std::memcpy(place, &value, sizeof value);
    return place + sizeof value;
  }
  for (std::size_t i = 0; i < sizeof value; ++i) {
    *place++ = static_cast<char>((value >> (8U * i)) & 0xFFU);
  }
  return place;
}

class TapeWriter : public Writer {
 public:
  TapeWriter(std::ostream& out, const tape::Codes* codes, DiagnosticSink& sink)
      : out_(out), sink_(sink), codes_(codes != nullptr ? *codes : tape::Codes()) {}

  void accept(const cl::Record& record) override {
    if (const auto* motion = std::get_if<cl::Motion>(&record.body)) {
      this->motion(record, *motion);
      return;
    }
    open(record);
    if (std::holds_alternative<cl::Card>(record.body)) {
      return;
    }
    if (const auto* multax = std::get_if<cl::Multax>(&record.body)) {
      withAxis_ = multax->on;
    }
    tape::encode(record.body, codes_, encoded_);
    write(record, encoded_.type, encoded_.sub, encoded_.words.data(), encoded_.words.size());
  }

  void finish() override {
    out_.append(endOfTape);
    out_.finish();
  }

 private:
  void motion(const cl::Record& record, const cl::Motion& motion) {
    open(record);
    if (motion.withAxis != withAxis_) {
      withAxis_ = motion.withAxis;
      const tape::TapeWord on = withAxis_ ? 1 : 0;
      write(record, 9000, 2, &on, 1);
    }
    const std::vector<double>& numbers =
        motion.withSide ? withoutSides(record, motion) : motion.coordinates;
    std::size_t from = 0;
    int sub = static_cast<int>(motion.kind);
    do {
      const std::size_t count = std::min(numbers.size() - from, tape::motionNumbers);
      chunk(record, motion, sub, {numbers.data() + from, count});
      from += count;
      sub = static_cast<int>(cl::Motion::Kind::continuation);
    } while (from < numbers.size());
  }

  /// The old layout has no place for the turn of the tool about its axis: told once.
  const std::vector<double>& withoutSides(const cl::Record& record, const cl::Motion& motion) {
    if (!toldOfSides_) {
      sink_.accept(diagnose(record.origin, diag::TapeWithoutSide));
      toldOfSides_ = true;
    }
    sixes_.clear();
    for (std::size_t i = 0; i + motion.stride() <= motion.coordinates.size();
         i += motion.stride()) {
      sixes_.insert(sixes_.end(), &motion.coordinates[i], &motion.coordinates[i] + 6);
    }
    return sixes_;
  }

  void chunk(const cl::Record& record,
             const cl::Motion& motion,
             int sub,
             std::span<const double> numbers) {
    const cl::TypeCode code = motion.way == cl::Motion::Way::straight ? cl::TypeCode{5000, sub}
                                                                      : cl::typeCode(record.body);
    char* place = header(record, code.type, code.sub, numbers.size() + 2, numbers.size() + 2);
    place = writeLittle(place, tape::nameWord(motion.name));
    place = writeLittle(place, tape::numberWord(motion.subscript));
    double bad = 0.0;
    for (const double number : numbers) {
      place = writeLittle(place, tape::numberWord(number));
      bad = std::isfinite(number) ? bad : number;
    }
    out_.filled(place);
    if (bad != 0.0) {
      refuse(record, bad);
    }
  }

  void open(const cl::Record& record) {
    if (!numbering_.opensStatement(record)) {
      return;
    }
    char* place = out_.room(32);
    place = writeLittle(place, static_cast<std::uint32_t>(numbering_.last()));
    place = writeLittle(place, std::uint32_t{2});
    place = writeLittle(place, std::uint32_t{1000});
    place = writeLittle(place, static_cast<std::uint32_t>(record.isn));
    place = writeLittle(place, tape::TapeWord{0});
    place = writeLittle(place, tape::eightCharacterWord(record.cardId));
    out_.filled(place);
  }

  /// Writes a header and returns the place behind it, with room for `reserve` words more.
  char* header(
      const cl::Record& record, int type, int sub, std::size_t words, std::size_t reserve) {
    const std::int64_t number = numbering_.next();
    constexpr std::int64_t largest = std::numeric_limits<std::int32_t>::max();
    if (number == largest + 1) {
      sink_.accept(diagnose(record.origin, diag::TapeTooLong, largest));
    }
    char* place = out_.room(16 + 8 * reserve);
    place = writeLittle(place, static_cast<std::uint32_t>(number));
    place = writeLittle(place, static_cast<std::uint32_t>(words));
    place = writeLittle(place, static_cast<std::uint32_t>(type));
    return writeLittle(place, static_cast<std::uint32_t>(sub));
  }

  void write(
      const cl::Record& record, int type, int sub, const tape::TapeWord* words, std::size_t count) {
    out_.filled(header(record, type, sub, count, 0));
    for (std::size_t i = 0; i < count; ++i) {
      char* place = out_.room(8);
      out_.filled(writeLittle(place, words[i]));
    }
  }

  void refuse(const cl::Record& record, double number) {
    if (!refused_) {
      sink_.accept(diagnose(record.origin, diag::OutputNumber, number, record.isn));
      refused_ = true;
    }
  }

  OutBuffer out_;
  DiagnosticSink& sink_;
  const tape::Codes codes_;
  Numbering numbering_;
  tape::Encoded encoded_;
  std::vector<double> sixes_;
  bool withAxis_ = false;
  bool toldOfSides_ = false;
  bool refused_ = false;
};
}  // namespace

std::unique_ptr<Writer> makeTapeWriter(std::ostream& out, const Context& context, DiagnosticSink& sink) {
  return std::make_unique<TapeWriter>(out, context.codes, sink);
}

}  // namespace arelem::backend
