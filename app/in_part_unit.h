#pragma once
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ir/cl/record.h"
#include "ir/diag/diagnostic.h"
#include "runtime/interpret/action.h"

namespace arelem::app {

/// What a part program says of the numbers of its CL files.
struct PartFacts {
  std::optional<double> millimeters;  ///< of its unit, where UNITS names one
  std::vector<cl::Values> cutters;    ///< all that it has, lengths in its unit
};
[[nodiscard]] PartFacts partFactsOf(const std::vector<runtime::Action>& actions);

/// Hands the records of a CL file on with their lengths in the unit of its part program. Where one
/// of the two names no unit, numbers stay as they are: W0917 where only the file names one. W0918
/// tells of a cutter that the program does not have.
class InPartUnit : public cl::RecordSink {
 public:
  InPartUnit(PartFacts part, std::string file, cl::RecordSink& next, DiagnosticSink& sink)
      : part_(std::move(part)), file_(std::move(file)), next_(next), sink_(sink) {}
  void accept(const cl::Record& record) override;

 private:
  void takeUnit(const cl::Record& record, const cl::Units& units);
  void takeCutter(const cl::Record& record, const cl::Values& cutter);
  void scale(cl::Body& body) const;

  PartFacts part_;
  std::string file_;
  cl::RecordSink& next_;
  DiagnosticSink& sink_;
  double factor_ = 1.0;  ///< part units of one unit of the file
  bool told_ = false;    ///< of a unit
};

}  // namespace arelem::app
