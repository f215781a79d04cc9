#pragma once
#include "app/output_file.h"
#include "app/pipeline.h"

#include "ir/diag/output.h"

namespace arelem::app {

/// One picture or table of one statement; `write` is given the stream and tells whether it could.
template <class Write>
void putPicture(Compilation& job, const std::string& path, Write&& write) {
  Result<std::unique_ptr<OutputFile>> file = openOutput(path);
  if (!file) {
    job.log.accept(file.takeFailure());
    return;
  }
  if (!write((*file)->stream())) {
    job.log.accept(fail(diag::OutputWrite, path, std::uint64_t{0}, "the picture cannot be made"));
    return;
  }
  Result<std::string> name = (*file)->commit(false);
  if (!name) {
    job.log.accept(name.takeFailure());
  }
}

}  // namespace arelem::app
