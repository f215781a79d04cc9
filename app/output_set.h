#pragma once
#include <memory>
#include <string>
#include <vector>

#include "app/output_file.h"
#include "app/output_plan.h"

#include "backend/backend.h"
#include "runtime/path/chords.h"

namespace arelem::app {

/// All outputs of one input: every record goes to each writer, and either all files get their final
/// names or none.
class OutputSet : public cl::RecordSink {
 public:
  explicit OutputSet(DiagnosticSink& sink) : sink_(sink) {}

  /// Opens the files. False when one cannot be written: diagnosed, nothing is left behind.
  [[nodiscard]] bool open(const std::vector<PlannedOutput>& outputs,
                          const backend::Context& context);
  void accept(const cl::Record& record) override;
  /// Ends the writers and puts everything on the disk; with `partial` under names that end in
  /// `.partial`.
  [[nodiscard]] bool close(bool partial);

  struct Written {
    std::string path;
    std::uint64_t bytes = 0;
  };
  [[nodiscard]] const std::vector<Written>& written() const { return written_; }

 private:
  struct Open {
    std::unique_ptr<OutputFile> file;
    std::unique_ptr<backend::Writer> writer;
    std::unique_ptr<path::ChordStage> chords;  ///< before writers that take no curves
    std::uint64_t bytes = 0;
  };
  /// Passes on what writers say and remembers whether one of them met an error.
  class Watch : public DiagnosticSink {
   public:
    explicit Watch(DiagnosticSink& sink) : sink_(sink) {}
    void accept(Diagnostic diagnostic) override {
      failed_ = failed_ || diagnostic.kind().severity == Severity::error;
      sink_.accept(std::move(diagnostic));
    }
    [[nodiscard]] bool failed() const { return failed_; }

   private:
    DiagnosticSink& sink_;
    bool failed_ = false;
  };
  [[nodiscard]] bool complete();
  void report(Failure failure);

  DiagnosticSink& sink_;
  Watch watch_{sink_};
  std::vector<Open> open_;
  std::vector<Written> written_;
};

}  // namespace arelem::app
