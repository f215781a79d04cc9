#include "app/output_set.h"

#include "ir/diag/render_text.h"

namespace arelem::app {

void OutputSet::report(Failure failure) {
  sink_.accept(at(nowhere, std::move(failure)));
}

bool OutputSet::open(const std::vector<PlannedOutput>& outputs, const backend::Context& context) {
  for (const PlannedOutput& output : outputs) {
    Result<std::unique_ptr<OutputFile>> file = openOutput(output.path);
    if (!file) {
      report(file.takeFailure());
      open_.clear();
      return false;
    }
    Open opened;
    opened.file = *std::move(file);
    opened.writer = output.target->make(opened.file->stream(), context, watch_);
    if (!output.target->takesCurves) {
      opened.chords = path::makeChordStage(*opened.writer, watch_);
    }
    open_.push_back(std::move(opened));
  }
  return true;
}

void OutputSet::accept(const cl::Record& record) {
  for (const Open& output : open_) {
    output.chords ? output.chords->accept(record) : output.writer->accept(record);
  }
}

bool OutputSet::complete() {
  for (Open& output : open_) {
    output.writer->finish();
    Result<std::uint64_t> bytes = output.file->complete();
    if (!bytes) {
      report(bytes.takeFailure());
      return false;
    }
    output.bytes = *bytes;
  }
  return true;
}

bool OutputSet::close(bool partial) {
  // An error of a writer leaves nothing behind, also where it shows only at the end of the path.
  const bool good = complete() && (partial || !watch_.failed());
  for (const Open& output : open_) {
    if (!good) {
      break;
    }
    Result<std::string> name = output.file->commit(partial);
    if (!name) {
      report(name.takeFailure());
      open_.clear();
      return false;
    }
    if (!name->empty()) {
      written_.push_back({*name, output.bytes});
    }
  }
  open_.clear();
  return good;
}

}  // namespace arelem::app
