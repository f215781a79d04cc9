#include "app/cl_input.h"

#include <sstream>

#include "app/code_file.h"
#include "app/source_file.h"

#include "backend/cltape/reader.h"
#include "backend/json/reader.h"

namespace arelem::app {

InputFormat formatOf(std::string_view bytes) {
  if (bytes.substr(0, 16).find('\0') != std::string_view::npos) {
    return InputFormat::tape;
  }
  const std::size_t first = bytes.find_first_not_of(" \t\r\n");
  return first != std::string_view::npos && bytes[first] == '{' ? InputFormat::json
                                                                : InputFormat::text;
}

bool readRecords(Compilation& job,
                 const std::string& path,
                 std::string bytes,
                 cl::RecordSink& records,
                 const InterruptFlag& interrupted) {
  const InputFormat format = formatOf(bytes);
  if (format == InputFormat::text) {
    return load(job, path, std::move(bytes), interrupted) && evaluate(job, interrupted) &&
           execute(job, records, interrupted);
  }
  job.main = job.sources.add(displayName(path), "");
  std::unique_ptr<cl::RecordSink> frames;
  if (job.settings.partFrame) {
    frames = frameStage(job.settings, records, job.log);
  }
  cl::RecordSink& first = frames ? *frames : records;
  bool whole = false;
  if (format == InputFormat::json) {
    whole = backend::readJsonRecords(bytes, displayName(path), first, job.log);
  } else {
    std::istringstream in(std::move(bytes));
    whole = readCodes(job) &&
            backend::readTape(in, first, job.log, job.settings.limits, job.codes).complete;
  }
  return whole && job.log.errors() == 0 && !interrupted;
}

}  // namespace arelem::app
