#include "app/view/raster.h"

#include <cmath>
#include <memory>

#include <cairo.h>
#include <librsvg/rsvg.h>

namespace arelem::app {

namespace {
cairo_status_t put(void* out, const unsigned char* bytes, unsigned int n) {
  auto& stream = *static_cast<std::ostream*>(out);
  stream.write(reinterpret_cast<const char*>(bytes), n);  // NOLINT: bytes are bytes
  return stream.good() ? CAIRO_STATUS_SUCCESS : CAIRO_STATUS_WRITE_ERROR;
}

template <auto free>
struct Free {
  template <class T>
  void operator()(T* object) const {
    free(object);
  }
};
}  // namespace

bool writePng(std::ostream& out, const std::string& svg, int width) {
  const std::unique_ptr<RsvgHandle, Free<g_object_unref>> picture(rsvg_handle_new_from_data(
      reinterpret_cast<const guint8*>(svg.data()), svg.size(), nullptr));  // NOLINT
  double w = 0.0;
  double h = 0.0;
  if (!picture || rsvg_handle_get_intrinsic_size_in_pixels(picture.get(), &w, &h) == FALSE ||
      !(w > 0.0) || !(h > 0.0)) {
    return false;
  }
  const int height = static_cast<int>(std::lround(width * h / w));
  const std::unique_ptr<cairo_surface_t, Free<cairo_surface_destroy>> surface(
      cairo_image_surface_create(CAIRO_FORMAT_ARGB32, width, height));
  const std::unique_ptr<cairo_t, Free<cairo_destroy>> context(cairo_create(surface.get()));
  const RsvgRectangle page{0.0, 0.0, static_cast<double>(width), static_cast<double>(height)};
  return rsvg_handle_render_document(picture.get(), context.get(), &page, nullptr) == TRUE &&
         cairo_surface_write_to_png_stream(surface.get(), put, &out) == CAIRO_STATUS_SUCCESS;
}

}  // namespace arelem::app
