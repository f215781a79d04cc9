#pragma once
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "app/messages.h"
#include "app/verify_path.h"

#include "backend/backend.h"
#include "backend/robot/machine.h"

namespace arelem::app {

/// The path of a part program and, for a target, the output that compile makes of it: what another
/// output of the same program is compared with.
class Rewritten : public cl::RecordSink {
 public:
  /// Null: only the path is kept.
  Rewritten(const backend::Target* target, std::optional<robot::Machine> machine);

  void accept(const cl::Record& record) override;
  /// Behind the last record.
  void finish();

  [[nodiscard]] const Path& path() const { return path_; }
  [[nodiscard]] std::string text() const { return out_.str(); }
  /// Why the program cannot be written for the machine.
  [[nodiscard]] std::vector<Diagnostic> errors() const;

 private:
  Path path_;
  std::optional<robot::Machine> machine_;
  std::ostringstream out_;
  CollectingSink told_;
  std::unique_ptr<backend::Writer> writer_;
};

/// Whether the program can be written for the machine; if not, the log gets why.
[[nodiscard]] bool isWritten(const Rewritten& rewritten, DiagnosticLog& log);

}  // namespace arelem::app
