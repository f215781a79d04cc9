#include "app/view/raster.h"

#include <cmath>
#include <memory>

#include <cairo.h>
#include <dlfcn.h>
#include <librsvg/rsvg.h>

namespace arelem::app {

namespace {
/// librsvg, loaded by the first picture: with cairo, pango and glib behind it it takes longer to
/// load than a small part program takes to compile.
class Library {
 public:
  [[nodiscard]] static const Library& instance() {
    static const Library library;
    return library;
  }
  [[nodiscard]] bool isLoaded() const { return loaded_; }

  decltype(&g_object_unref) unref = nullptr;
  decltype(&rsvg_handle_new_from_data) read = nullptr;
  decltype(&rsvg_handle_get_intrinsic_size_in_pixels) size = nullptr;
  decltype(&rsvg_handle_render_document) render = nullptr;
  decltype(&cairo_image_surface_create) createSurface = nullptr;
  decltype(&cairo_surface_destroy) destroySurface = nullptr;
  decltype(&cairo_create) createContext = nullptr;
  decltype(&cairo_destroy) destroyContext = nullptr;
  decltype(&cairo_surface_write_to_png_stream) writePng = nullptr;

 private:
  /// It stays loaded: glib does not stand being unloaded.
  Library() : handle_(dlopen("librsvg-2.so.2", RTLD_LAZY | RTLD_LOCAL)) {
    loaded_ = handle_ != nullptr && find(unref, "g_object_unref") &&
              find(read, "rsvg_handle_new_from_data") &&
              find(size, "rsvg_handle_get_intrinsic_size_in_pixels") &&
              find(render, "rsvg_handle_render_document") &&
              find(createSurface, "cairo_image_surface_create") &&
              find(destroySurface, "cairo_surface_destroy") &&
              find(createContext, "cairo_create") && find(destroyContext, "cairo_destroy") &&
              find(writePng, "cairo_surface_write_to_png_stream");
  }
  template <class Function>
  bool find(Function& function, const char* name) {
    function = reinterpret_cast<Function>(dlsym(handle_, name));  // NOLINT: what dlsym is for
    return function != nullptr;
  }

  void* handle_;
  bool loaded_ = false;
};

cairo_status_t put(void* out, const unsigned char* bytes, unsigned int n) {
  auto& stream = *static_cast<std::ostream*>(out);
  stream.write(reinterpret_cast<const char*>(bytes), n);  // NOLINT: bytes are bytes
  return stream.good() ? CAIRO_STATUS_SUCCESS : CAIRO_STATUS_WRITE_ERROR;
}
}  // namespace

bool writePng(std::ostream& out, const std::string& svg, int width) {
  const Library& library = Library::instance();
  if (!library.isLoaded()) {
    return false;
  }
  const std::unique_ptr<RsvgHandle, decltype(library.unref)> picture(
      library.read(reinterpret_cast<const guint8*>(svg.data()), svg.size(), nullptr),  // NOLINT
      library.unref);
  double w = 0.0;
  double h = 0.0;
  if (!picture || library.size(picture.get(), &w, &h) == FALSE || !(w > 0.0) || !(h > 0.0)) {
    return false;
  }
  const int height = static_cast<int>(std::lround(width * h / w));
  const std::unique_ptr<cairo_surface_t, decltype(library.destroySurface)> surface(
      library.createSurface(CAIRO_FORMAT_ARGB32, width, height), library.destroySurface);
  const std::unique_ptr<cairo_t, decltype(library.destroyContext)> context(
      library.createContext(surface.get()), library.destroyContext);
  const RsvgRectangle page{0.0, 0.0, static_cast<double>(width), static_cast<double>(height)};
  return library.render(picture.get(), context.get(), &page, nullptr) == TRUE &&
         library.writePng(surface.get(), put, &out) == CAIRO_STATUS_SUCCESS;
}

}  // namespace arelem::app
