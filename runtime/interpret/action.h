#pragma once
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "ir/cl/record.h"
#include "ir/geometry/entity.h"
#include "ir/program/statement.h"
#include "ir/space/vector.h"

/// What Section 1 hands to Section 2: statements in order of execution with every value computed.
/// Expressions, loops, macros and reference systems are gone; only motion, its parameters and the
/// records that pass through remain. Lengths are in the unit of the part program, angles in
/// degrees.
namespace arelem::runtime {

/// A surface as a motion statement uses it, already in the base reference system.
struct SurfaceUse {
  EntityPtr surface;
  ir::Condition condition = ir::Condition::automatic;
};

/// FROM, GOTO, GODLTA to one place. `point` is absolute, or the displacement for GODLTA;
/// `axial` is set for GODLTA/d, a displacement along the tool axis.
struct Locate {
  Word word = Word::GOTO;
  Vec3 point = Vec3::Zero();
  std::optional<double> axial;
  std::optional<Vec3> axis;  ///< as written, not normalised
  std::optional<Vec3> side;  ///< direction of the tool's own x axis, as written; only with an axis
  std::optional<double> feed;
  std::string name;  ///< of the point or pattern, "" when given by numbers
  int subscript = 0;
};
/// GOTO/spline: the tool goes to the start of the curve, if it is not there, and along it.
struct FollowSpline {
  EntityPtr curve;
  std::optional<double> feed;
};
/// CIRCLE and MOVARC of CL files: the tool goes to the next GOTO along an arc.
struct Arc {
  Vec3 center = Vec3::Zero();  ///< its part along the axis does not count
  std::optional<Vec3> axis;    ///< the arc turns counter-clockwise about it; none: from INDIRV
  std::optional<double> radius;
  std::optional<double> sweepDegrees;  ///< ANGLE
  int turns = 0;                       ///< TIMES: whole turns beside the arc
};
struct Startup {
  bool offset = false;               ///< OFFSET/ instead of GO/
  std::vector<SurfaceUse> surfaces;  ///< drive, part, check
  std::optional<double> feed;
};
struct CheckUse {
  SurfaceUse use;
  int nth = 1;                         ///< n, INTOF
  std::optional<std::uint64_t> label;  ///< key of the Label action to continue at
};
struct Follow {
  ir::Heading heading = ir::Heading::forward;
  EntityPtr drive;
  std::vector<CheckUse> checks;  ///< empty: implied by the next motion
  std::optional<double> feed;
};
/// INDIRV, INDIRP, SRFVCT with one value for each startup surface (drive, part, check) or omitted.
struct Direction {
  Word word = Word::INDIRV;
  std::array<std::optional<Vec3>, 3> values;
};
struct PartSurface {
  EntityPtr surface;
};  ///< PSIS
struct ToolRelation {
  Word word = Word::TLON;
};  ///< TLLFT TLRGT TLON TLNDON TLONPS TLOFPS
/// INTOL OUTTOL TOLER THICK (one to four values, as written), MAXDP, NUMPTS, CUTTER (as
/// written).
struct Parameter {
  Word word = Word::CUTTER;
  std::vector<double> values;
};
/// CUTTER/OPTION,{1|2},{ra,hi|OFF}: a ring instead of the cutter for the part (1) or drive (2)
/// surface.
struct CutterOption {
  int surface = 1;
  std::optional<std::array<double, 2>> ring;
};
/// TLAXIS in all its forms.
struct ToolAxis {
  enum class Kind : std::uint8_t { vector, keep, normalPart, normalDrive, parallel, angle };
  Kind kind = Kind::vector;
  Vec3 vector = Vec3::UnitZ();  ///< vector; or the vector of the 4-axis form of `angle`
  int surface = 1;              ///< parallel, angle: 1 part, 2 drive surface
  double alphaDegrees = 0.0;
  std::optional<double> cutAngleDegrees;  ///< CUTANG
  bool fourAxis = false;                  ///< angle with a vector
};
/// CUT DNTCUT MULTAX GOUGCK AUTOPS NDTEST NOPS 2DCALC 3DCALC.
struct Toggle {
  Word word = Word::CUT;
  bool on = true;
};
/// A record that motion does not change: post words, texts, units, CLPRNT, TRACUT, COPY, INDEX.
struct Pass {
  cl::Body body;
};
struct Transfer {
  std::uint64_t label = 0;
};  ///< TRANTO
struct Label {
  std::uint64_t key = 0;
};  ///< place of a labelled statement, for Transfer and checks
struct Pocket {
  std::array<double, 8> parameters{};
  std::vector<Vec3> points;
};
struct Fini {};

/// The CALL statements that are active, innermost first; shared between the actions of one call.
struct CallChain {
  Span call;
  std::shared_ptr<const CallChain> outer;
};

struct Action {
  using Body = std::variant<Locate,
                            FollowSpline,
                            Arc,
                            Startup,
                            Follow,
                            Direction,
                            PartSurface,
                            ToolRelation,
                            Parameter,
                            CutterOption,
                            ToolAxis,
                            Toggle,
                            Pass,
                            Transfer,
                            Label,
                            Pocket,
                            Fini>;
  Span origin;
  int isn = 0;
  std::string cardId;
  std::shared_ptr<const CallChain> calls;
  Body body;
};

}  // namespace arelem::runtime
