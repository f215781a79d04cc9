#pragma once
#include <memory>
#include <optional>

#include "ir/cl/record.h"
#include "ir/diag/diagnostic.h"
#include "runtime/interpret/action.h"

namespace arelem::path {

/// Section 3: swarf sections. Between VTLAXS/ON and VTLAXS/OFF an upright tool that moves at one
/// height is tilted to a side, by an angle that goes evenly with the length of the path from the
/// first statement's to the last one's; the last location before the section is its first. WCORN
/// cleans an inside corner on the way. No location is added but at a corner. The directions at a
/// location are the mean of those of the moves to it and from it.
/// Source: manual of APT360, 13.4.
class SwarfStage : public cl::RecordSink {
 public:
  /// After the last record: a section without an end is an error.
  virtual void finish() = 0;
};
[[nodiscard]] std::unique_ptr<SwarfStage> makeSwarfStage(cl::RecordSink& next,
                                                         DiagnosticSink& sink);

/// The way back, for the proof of a CL file: the tool of its swarf sections upright again. Each
/// location must be what `makeSwarfStage` makes of the upright ones, up to `slack` (part unit, and
/// of the unit vector of the axis). Corners are errors.
[[nodiscard]] std::unique_ptr<SwarfStage> makeUprightStage(cl::RecordSink& next,
                                                           double slack,
                                                           DiagnosticSink& sink);

/// The first statement that needs the stage; none where none does.
[[nodiscard]] std::optional<Span> firstSwarf(const std::vector<runtime::Action>& actions);

}  // namespace arelem::path
