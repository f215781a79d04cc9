#include "app/picture_file.h"

#include "app/output_file.h"
#include "app/view/raster.h"

#include "ir/diag/output.h"

namespace arelem::app {

void putPicture(DiagnosticLog& log,
                const std::string& path,
                const std::function<bool(std::ostream&)>& write) {
  Result<std::unique_ptr<OutputFile>> file = openOutput(path);
  if (!file) {
    log.accept(file.takeFailure());
  } else if (!write((*file)->stream())) {
    log.accept(fail(diag::OutputWrite, path, std::uint64_t{0}, pngFault()));
  } else if (Result<std::string> name = (*file)->commit(false); !name) {
    log.accept(name.takeFailure());
  }
}

}  // namespace arelem::app
