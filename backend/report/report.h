#pragma once
#include <cstdint>
#include <iosfwd>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "backend/report/place.h"
#include "backend/report/spray.h"

/// The machine-readable account of a run (`--report FILE.json`), see docs/manual/report.md.
namespace arelem::backend {

/// What one motion statement did in all its executions. Lengths and deviations in the unit of the
/// program; deviations are those of the cut vectors' end points, positive on the outside, and
/// absent where the motion was not along that surface.
struct ReportedMotion {
  SourcePlace place;
  int isn = 0;
  std::string statement;  ///< "FROM", "GO", "GOFWD", ...
  std::uint64_t executions = 1;
  std::uint64_t cutVectors = 0;
  double pathLength = 0.0;
  struct Deviation {
    double inner = 0.0;
    double outer = 0.0;
  };
  std::optional<Deviation> drive;
  std::optional<Deviation> part;
  double seconds = 0.0;  ///< wall time; written only with Report::timing
};

/// A word that was accepted and had no effect on the result.
struct WordWithoutEffect {
  SourcePlace place;
  std::string word;
  std::string reason;
  std::uint64_t times = 1;
};

/// Wall times of the stages. They differ from run to run: without them two reports of one run are
/// equal.
struct Timing {
  double parse = 0.0, evaluate = 0.0, execute = 0.0, write = 0.0;
};

struct Report {
  std::string toolVersion;
  std::vector<std::string> sources;
  std::vector<ReportedMotion> motions;
  std::vector<ReportedSpray> sprays;  ///< one a SPRAY statement and execution
  std::map<std::string, std::uint64_t> statements;  ///< counts by kind
  std::map<std::string, std::uint64_t> features;    ///< counts by id of the language reference
  std::string dialect;                              ///< in which the program was read
  std::vector<WordWithoutEffect> wordsWithoutEffect;
  std::uint64_t errors = 0;
  std::uint64_t warnings = 0;
  bool complete = true;  ///< false when the run stopped before its end
  std::optional<Timing> timing;
};

/// Number of the format; grows with a change that an old reader could misread.
inline constexpr int reportFormat = 1;

/// One JSON document that satisfies docs/manual/report.schema.json.
void writeReport(std::ostream& out, const Report& report);

}  // namespace arelem::backend
