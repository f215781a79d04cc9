#pragma once
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "ir/geometry/entity.h"
#include "ir/text/span.h"
#include "ir/words/words.h"

/// The stream of cutter-location records: the contract between the runtime and the backends.
namespace arelem::cl {

/// A surface as a parameter of a post word (CLRSRF, CLEARP), or the matrix of TRACUT and COPY.
struct SurfaceValue {
  EntityType type = EntityType::plane;
  std::string name;
  int subscript = 0;
  std::vector<double> canon;
  bool operator==(const SurfaceValue&) const = default;
};

/// One parameter of a post word: a number, a minor word, text of an unknown word, or a surface.
using Value = std::variant<double, Word, std::string, SurfaceValue>;

/// 2000: a post-processor word with its parameters, passed on unchanged. `foreign` holds the
/// spelling of a major word outside the vocabulary, and `word` is then meaningless.
struct Post {
  Word word = Word::END;
  std::string foreign;
  std::vector<Value> arguments;
};
/// 2000/1044, 1045, 1046: PPRINT, PARTNO, INSERT with columns 7 to 72.
struct Text {
  Word word = Word::PPRINT;
  std::string text;
};
/// 3000: the circular surface (CIRCLE or CYLNDR) or the path spline (BSPLIN) that the points of the
/// next motion record and its continuations run along. On a spline every chord between successive
/// points, and from the location before to the first of them, is within the tolerance of the curve.
struct Surface {
  int role = 2;  ///< 1 part, 2 drive, 3 check surface
  int condition = 0;
  SurfaceValue surface;
};
/// 5000: 3 FROM, 5 GOTO or the first points of a sequence, 6 its continuation. At most 240 numbers.
struct Motion {
  enum class Kind : std::uint8_t { from = 3, go = 5, continuation = 6 };
  /// How the tool comes to the location: straight; along the circle of the cl::Surface before,
  /// counter-clockwise or clockwise about its axis, rising evenly (to where it started: a whole
  /// turn); along the cubic B-spline whose knots and control points are the posts KNOT and CNTRL
  /// before. All but the first have one location in a record, which stands on a tape as type 15000.
  enum class Way : std::uint8_t { straight, counterclockwise, clockwise, spline };
  Kind kind = Kind::go;
  std::string name;  ///< point, drive surface or pattern; "" when unnamed
  int subscript = 0;
  bool withAxis = false;  ///< six numbers a point (MULTAX) instead of three
  /// Nine numbers: the axis, then the direction of the tool's own x axis, which is square to it.
  /// Poses of spray guns, whose fan or footprint turns about the axis. Only with `withAxis`.
  bool withSide = false;
  /// x y z, x y z i j k or x y z i j k u v w, one location after another.
  std::vector<double> coordinates;
  Way way = Way::straight;
  [[nodiscard]] std::size_t stride() const { return withSide ? 9U : withAxis ? 6U : 3U; }
  [[nodiscard]] std::size_t points() const { return coordinates.size() / stride(); }
  [[nodiscard]] bool isArc() const { return way == Way::counterclockwise || way == Way::clockwise; }
};
/// 6000/1 CUT, DNTCUT; 6000/2 2DCALC, 3DCALC, NDTEST.
struct Switch {
  Word word = Word::CUT;
};
/// 6000/4 INTOL, 6000/5 OUTTOL (four values), 6000/6 CUTTER (as written).
struct Values {
  Word word = Word::CUTTER;
  std::vector<double> values;
};
/// 9000/2.
struct Multax {
  bool on = true;
};
/// 9000/9.
struct Units {
  Word unit = Word::MM;
};
/// 13000/3: a diagnostic of the motion part; negative numbers are warnings (old numbering).
struct Diagnostic {
  int number = 0;
};
/// 13000/4: CLPRNT on or off.
struct Listing {
  bool on = true;
};
/// 14000.
struct Fini {};
/// 1000 alone: a statement begins that leaves no record of its own (INDIRV, PSIS, THICK, TLAXIS,
/// ...), or the same statement is executed once more. Writers make the 1000 records of all other
/// statements from the change of `isn`; this body asks for one where that rule sees nothing. Most
/// targets pass over it.
struct Card {};
/// A record of a tape whose class is unknown here: kept word by word.
struct Raw {
  int type = 0;
  int sub = 0;
  std::vector<std::uint64_t> words;
};

using Body = std::variant<Post,
                          Text,
                          Surface,
                          Motion,
                          Switch,
                          Values,
                          Multax,
                          Units,
                          Diagnostic,
                          Listing,
                          Fini,
                          Card,
                          Raw>;

struct Record {
  int isn = 0;         ///< statement number; the 1000 records of a CLTAPE are made from it
  std::string cardId;  ///< columns 73-80 of the statement
  Span origin;         ///< the statement
  Body body;
};

/// The record class (1000, 2000, ...) and subclass of a record's body.
struct TypeCode {
  int type = 0;
  int sub = 0;
};
[[nodiscard]] TypeCode typeCode(const Body& body);

/// Receives the records in order. A writer may keep none of them: the record is reused by the
/// caller.
class RecordSink {
 public:
  virtual ~RecordSink() = default;
  virtual void accept(const Record& record) = 0;
};

/// Keeps a copy of every record.
class Recording : public RecordSink {
 public:
  void accept(const Record& record) override { records.push_back(record); }
  std::vector<Record> records;
};

}  // namespace arelem::cl
