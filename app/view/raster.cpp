#include "app/view/raster.h"

#include <cmath>
#include <memory>

#include <cairo.h>
#include <dlfcn.h>
#include <librsvg/rsvg.h>

namespace arelem::app {

namespace {
constexpr const char* libraryName = "librsvg-2.so.2";

/// librsvg and what it brings along, 40 libraries, loaded by the first picture: linked, they would
/// cost every run more time than all of its other start-up.
class Library {
 public:
  /// Null where the machine does not have it.
  static const Library* loaded() {
    static const Library library;
    return library.complete_ ? &library : nullptr;
  }

  decltype(&::rsvg_handle_new_from_data) read = nullptr;
  decltype(&::rsvg_handle_get_intrinsic_size_in_pixels) size = nullptr;
  decltype(&::rsvg_handle_render_document) render = nullptr;
  decltype(&::g_object_unref) freePicture = nullptr;
  decltype(&::cairo_image_surface_create) newSurface = nullptr;
  decltype(&::cairo_surface_destroy) freeSurface = nullptr;
  decltype(&::cairo_create) newContext = nullptr;
  decltype(&::cairo_destroy) freeContext = nullptr;
  decltype(&::cairo_surface_write_to_png_stream) write = nullptr;

 private:
  Library() : handle_(dlopen(libraryName, RTLD_LAZY | RTLD_LOCAL)) {
    // The handle finds the functions of the libraries that librsvg needs, too.
    complete_ =
        handle_ != nullptr && find(read, "rsvg_handle_new_from_data") &&
        find(size, "rsvg_handle_get_intrinsic_size_in_pixels") &&
        find(render, "rsvg_handle_render_document") && find(freePicture, "g_object_unref") &&
        find(newSurface, "cairo_image_surface_create") &&
        find(freeSurface, "cairo_surface_destroy") && find(newContext, "cairo_create") &&
        find(freeContext, "cairo_destroy") && find(write, "cairo_surface_write_to_png_stream");
  }
  template <class Function>
  bool find(Function& function, const char* name) {
    function = reinterpret_cast<Function>(dlsym(handle_, name));  // NOLINT: dlsym gives void*
    return function != nullptr;
  }

  void* handle_;
  bool complete_ = false;
};

cairo_status_t put(void* out, const unsigned char* bytes, unsigned int n) {
  auto& stream = *static_cast<std::ostream*>(out);
  stream.write(reinterpret_cast<const char*>(bytes), n);  // NOLINT: bytes are bytes
  return stream.good() ? CAIRO_STATUS_SUCCESS : CAIRO_STATUS_WRITE_ERROR;
}

template <class T, class Function>
auto owned(T* object, Function free) {
  return std::unique_ptr<T, Function>(object, free);
}
}  // namespace

bool writePng(std::ostream& out, const std::string& svg, int width) {
  const Library* const lib = Library::loaded();
  if (lib == nullptr) {
    return false;
  }
  const auto picture = owned(lib->read(reinterpret_cast<const guint8*>(svg.data()),  // NOLINT
                                       svg.size(), nullptr),
                             lib->freePicture);
  double w = 0.0;
  double h = 0.0;
  if (!picture || lib->size(picture.get(), &w, &h) == FALSE || !(w > 0.0) || !(h > 0.0)) {
    return false;
  }
  const int height = static_cast<int>(std::lround(width * h / w));
  const auto surface = owned(lib->newSurface(CAIRO_FORMAT_ARGB32, width, height), lib->freeSurface);
  const auto context = owned(lib->newContext(surface.get()), lib->freeContext);
  const RsvgRectangle page{0.0, 0.0, static_cast<double>(width), static_cast<double>(height)};
  return lib->render(picture.get(), context.get(), &page, nullptr) == TRUE &&
         lib->write(surface.get(), put, &out) == CAIRO_STATUS_SUCCESS;
}

std::string pngFault() {
  return Library::loaded() != nullptr
             ? std::string("the picture cannot be made")
             : std::string("PNG needs ") + libraryName + ", which this machine does not have";
}

}  // namespace arelem::app
