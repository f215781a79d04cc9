#include "app/code_file.h"

#include <filesystem>

#include "app/library_file.h"

namespace arelem::app {

namespace {
Result<backend::tape::Codes> codesOf(const Settings& settings, std::vector<std::string>& read) {
  if (settings.codes.empty()) {
    return backend::tape::Codes();
  }
  std::string name = settings.codes;
  if (!std::filesystem::path(name).has_extension()) {
    name += ".toml";
  }
  Result<LibraryFile> file = readLibraryFile(name, settings, "codes");
  if (!file) {
    return file.takeFailure();
  }
  read.push_back(file->name);
  return backend::tape::Codes::read(file->text, file->name);
}
}  // namespace

bool readCodes(Compilation& job) {
  Result<backend::tape::Codes> codes = codesOf(job.settings, job.filesRead);
  if (!codes) {
    job.log.accept(codes.takeFailure());
    return false;
  }
  job.codes = *std::move(codes);
  return true;
}

}  // namespace arelem::app
