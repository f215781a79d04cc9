#pragma once
#include <array>
#include <functional>
#include <iosfwd>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "ir/cl/record.h"
#include "ir/define/forms.h"
#include "ir/diag/diagnostic.h"
#include "ir/limits.h"
#include "ir/program/program.h"
#include "runtime/define/define.h"
#include "runtime/files/files.h"
#include "runtime/interpret/action.h"

namespace arelem::spray {
struct Sprayed;
}
namespace arelem::stencil {
struct Painted;
}

namespace arelem::runtime {

/// Told while something takes long: what, and how far it is. Called from one thread at a time.
using ProgressCall = std::function<void(std::string_view what, std::size_t done, std::size_t all)>;

/// Told of each definition that succeeds, with its parameters as they were computed.
using DefinitionCall = std::function<void(
    const Entity& result, std::span<const define::Parameter>, const define::Context&)>;

/// What CL text says once and what holds for all that follows, from one piece of it to the next.
struct Carried {
  bool multax = false;
  bool worldPlaces = false;  ///< TRNTYP/WORLD
  bool toldOfUnits = false;
  std::optional<Word> unit;                              ///< of UNITS
  Eigen::Matrix3d turned = Eigen::Matrix3d::Identity();  ///< by ROTABL, places to part
  std::optional<Vec3> partAxis;                          ///< of TLAXIS, in the frame of the part
};

struct Options {
  Limits limits;
  const InterruptFlag* interrupted = nullptr;  ///< may be null
  files::Files files;                          ///< data files that definitions name
  bool history = false;                        ///< keep every definition: Evaluation::history
  ProgressCall progress;                       ///< may be empty
  DefinitionCall defined;                      ///< may be empty
  bool axesFollow = false;     ///< an axis that is not z is written without MULTAX: CL files
  Carried* carried = nullptr;  ///< may be null; else read before and written after the evaluation
  bool keepsFacts = true;      ///< MotionOutcome::facts; without, only its sums
};

/// One item of what PRINT and TITLES ask for, in order of execution.
struct Printed {
  int isn = 0;
  int mode = 3;       ///< the number after PRINT/; 3 also for PRINT/ON
  std::string title;  ///< TITLES text, or "" for a value
  std::string name;   ///< "" for an unnamed entity
  int subscript = 0;
  EntityPtr entity;  ///< null for a scalar
  double scalar = 0.0;
  bool undefined = false;  ///< the name had no value
};

/// A named scalar or entity in order of its (first) definition; scalars show their last value.
struct Defined {
  std::string name;  ///< "" for a nested unnamed definition
  int subscript = 0;
  EntityPtr entity;  ///< null for a scalar
  double scalar = 0.0;
  Span definition;
};

/// What a statement did, under DEBUG.
struct Traced {
  Span at;
  int depth = 0;  ///< active CALLs
  std::string text;
};

/// Something that the program says and that changes nothing.
struct Ignored {
  std::string what;  ///< "CLPRNT"
  std::string why;
  Span first;  ///< the first time
  std::uint64_t times = 0;
};

/// The result of Section 1.
struct Evaluation {
  std::vector<Action> actions;
  std::vector<Printed> printed;
  std::vector<Defined> defined;
  /// With Options::history each definition of an entity as it was executed, nested ones and those
  /// that replaced an earlier one too; scalars stand where they got their first value.
  std::vector<Defined> history;
  std::vector<std::shared_ptr<const spray::Sprayed>>
      sprayed;  ///< what each SPRAY statement amounts to
  std::vector<std::shared_ptr<const stencil::Painted>> stencils;  ///< each STENCL statement
  std::string deck;  ///< lines of PUNCH and PRINT/4: name,subscript,type,count,values ... ENDPCH
  std::vector<Ignored> ignored;
  std::vector<Traced> trace;  ///< under DEBUG/SEC1 or DEBUG/ON
  /// How often each definition form was used, by FormId.
  std::array<std::uint64_t, static_cast<std::size_t>(define::FormId::count)> forms{};
  std::uint64_t steps = 0;
  bool complete = true;  ///< false after an interrupt or a limit
};

/// Section 1: executes everything but motion. Errors go to the sink; evaluation goes on after them.
[[nodiscard]] Evaluation evaluate(const ir::Program& program,
                                  const Options& options,
                                  DiagnosticSink& sink);

/// What one motion statement did. Deviations are of the cut vectors' end points, positive outside.
struct MotionFact {
  Span origin;
  int isn = 0;
  std::string statement;  ///< "FROM", "GO", "GOFWD", ...
  std::uint64_t cutVectors = 0;
  double length = 0.0;                        ///< of the path, part unit
  double driveInner = 0.0, driveOuter = 0.0;  ///< extreme signed deviations from the drive surface
  double partInner = 0.0, partOuter = 0.0;    ///< and from the part surface
  double seconds = 0.0;
  bool traced = false;                            ///< under DEBUG/SEC2 or DEBUG/ON
  Vec3 end = Vec3::Zero(), axis = Vec3::UnitZ();  ///< of the tool, after the motion
};

struct MotionOutcome {
  std::vector<MotionFact> facts;
  std::uint64_t motions = 0;
  std::uint64_t cutVectors = 0;
  double length = 0.0;   ///< of the path, part unit
  bool complete = true;  ///< false after an error, an interrupt or a limit
};

/// Section 2 piece by piece: actions whose meaning does not reach over the end of a piece.
class Execution {
 public:
  Execution(const Options& options, cl::RecordSink& records, DiagnosticSink& sink);
  ~Execution();
  void feed(const std::vector<Action>& actions);
  [[nodiscard]] MotionOutcome finish();

 private:
  struct Machine;
  std::unique_ptr<Machine> machine_;
};

/// Section 2 (ARELEM): actions to cutter-location records.
[[nodiscard]] MotionOutcome execute(const std::vector<Action>& actions,
                                    const Options& options,
                                    cl::RecordSink& records,
                                    DiagnosticSink& sink);

}  // namespace arelem::runtime
