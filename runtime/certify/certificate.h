#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ir/cl/record.h"
#include "ir/diag/diagnostic.h"
#include "ir/limits.h"
#include "ir/space/tolerance.h"
#include "runtime/certify/guide.h"

/// The certificate of a path: every cut vector of a CL file against the surfaces and tolerances
/// that the part program states for it. It shares surfaces and cutters with the computation of
/// motion, nothing else, so it holds for files of any origin. The mathematics is in
/// docs/manual/verify.md.
namespace arelem::certify {

struct Options {
  std::string file;      ///< as messages call the CL file
  bool numbered = true;  ///< its records carry the statement numbers of the program
  bool own = false;      ///< the locations are our own: what is missing has been told already
  /// How far a location may be from the one that is stated, for rounding in the file. Part unit.
  double slack = tolerance::certifiedSlack;
  /// The same beyond each tolerance; without it `slackOf` its band. Part unit.
  std::optional<double> beyondBand;
  Limits limits;
  const InterruptFlag* interrupted = nullptr;
};

/// What was found for one surface that a motion keeps to.
struct GuideFigures {
  std::string surface;
  Allowed allowed;
  GuideResult result;
};

/// What was found for the stop of a motion.
struct StopFigures {
  std::string surface;
  std::string condition;  ///< "TO", "ON", ...
  double gap = 0.0;       ///< from the position asked for
  bool good = true;
};

/// One execution of a motion statement.
struct StatementResult {
  Span origin;
  int isn = 0;
  std::string statement;  ///< "GOFWD", "GO", "GOTO", ...
  std::uint64_t cutVectors = 0;
  std::optional<GuideFigures> drive, part;
  std::vector<StopFigures> stops;
  bool good = true;
};

struct Summary {
  std::uint64_t statements = 0;
  std::uint64_t cutVectors = 0;  ///< proven ones: those along surfaces
  std::uint64_t places = 0;      ///< at which a gap was measured
  std::uint64_t faults = 0;      ///< statements that are not good
};

/// Receives the records of a CL file in order, as Section 3 left them. Faults go to `sink`, at the
/// statement.
class Certificate : public cl::RecordSink {
 public:
  /// After the last record.
  virtual void finish() = 0;
  [[nodiscard]] virtual const std::vector<StatementResult>& results() const = 0;
  [[nodiscard]] virtual const Summary& summary() const = 0;
};

/// `actions` must outlive the certificate.
[[nodiscard]] std::unique_ptr<Certificate> makeCertificate(
    const std::vector<runtime::Action>& actions, const Options& options, DiagnosticSink& sink);

}  // namespace arelem::certify
