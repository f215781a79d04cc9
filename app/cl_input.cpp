#include "app/cl_input.h"

#include <sstream>

#include "app/byte_stream.h"
#include "app/cl_stream.h"
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

Result<ClFile> ClFile::open(const std::string& path, const Limits& limits) {
  Result<std::unique_ptr<std::istream>> in = openBytes(path, limits);
  if (!in) {
    return in.takeFailure();
  }
  ClFile file(path, *std::move(in), limits);
  constexpr std::size_t enough = 4096;  // blanks before the brace of JSON do not matter
  std::string begin(enough, '\0');
  file.in_->read(begin.data(), static_cast<std::streamsize>(begin.size()));
  begin.resize(static_cast<std::size_t>(file.in_->gcount()));
  file.format_ = formatOf(begin);
  file.in_->clear();
  file.in_->seekg(0);
  return file;
}

Result<std::string> ClFile::text() {
  if (path_ != "-") {
    return readBytes(path_, limits_);
  }
  std::ostringstream all;
  all << in_->rdbuf();
  return std::move(all).str();
}

bool readRecords(Compilation& job,
                 ClFile& file,
                 cl::RecordSink& records,
                 const InterruptFlag& interrupted) {
  if (file.format() == InputFormat::text) {
    Result<std::string> text = file.text();
    if (!text) {
      job.log.accept(text.takeFailure());
      return false;
    }
    return load(job, file.path(), *std::move(text), interrupted) && evaluate(job, interrupted) &&
           execute(job, records, interrupted);
  }
  const std::string name = displayName(file.path());
  job.main = job.sources.add(name, "");
  std::unique_ptr<cl::RecordSink> frames;
  if (job.settings.partFrame) {
    frames = frameStage(job.settings, records, job.log);
  }
  cl::RecordSink& first = frames ? *frames : records;
  bool whole = false;
  if (file.format() == InputFormat::json) {
    whole = backend::readJsonRecords(file.stream(), name, first, job.log);
  } else {
    whole =
        readCodes(job) &&
        backend::readTape(file.stream(), first, job.log, job.settings.limits, job.codes).complete;
  }
  return whole && job.log.errors() == 0 && !interrupted;
}

ReadFile readFile(const Settings& settings,
                  const std::string& path,
                  const BeginRecords& begin,
                  const InterruptFlag& interrupted,
                  bool inPieces) {
  if (const auto dialect = inPieces ? streamDialect(path, settings) : std::nullopt) {
    ReadFile streamed{std::make_unique<Compilation>(settings), true};
    CollectingSink messages;
    ClTexts texts;
    ClStreamEnd end{*begin(*streamed.job, &texts), messages, texts};
    if (streamCl(*streamed.job, path, *dialect, end, interrupted) == Streamed::whole) {
      return streamed;
    }
  }
  ReadFile read{std::make_unique<Compilation>(settings), false};
  Result<ClFile> file = ClFile::open(path, settings.limits);
  if (!file) {
    read.job->log.accept(file.takeFailure());
  } else if (cl::RecordSink* records = begin(*read.job, nullptr)) {
    read.whole = readRecords(*read.job, *file, *records, interrupted);
  }
  return read;
}

}  // namespace arelem::app
