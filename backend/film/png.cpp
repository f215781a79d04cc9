// The only file that knows libpng.
#include "backend/film/png.h"

#include <csetjmp>

#include <png.h>

namespace arelem::backend {

namespace {
void put(png_structp png, png_bytep bytes, png_size_t count) {
  static_cast<std::string*>(png_get_io_ptr(png))
      ->append(reinterpret_cast<const char*>(bytes), count);
}
void flush(png_structp /*png*/) {}
}  // namespace

std::string pngOf(const std::vector<Color>& pixels, std::size_t width) {
  std::string bytes;
  std::vector<unsigned char> row(3 * width);
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png != nullptr ? png_create_info_struct(png) : nullptr;
  if (info == nullptr || setjmp(png_jmpbuf(png)) != 0) {
    png_destroy_write_struct(&png, &info);
    return "";
  }
  png_set_write_fn(png, &bytes, put, flush);
  png_set_IHDR(png, info, static_cast<png_uint_32>(width), static_cast<png_uint_32>(pixels.size() / width), 8,
               PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
               PNG_FILTER_TYPE_DEFAULT);
  png_write_info(png, info);
  for (std::size_t r = 0; r < pixels.size() / width; ++r) {
    for (std::size_t c = 0; c < width; ++c) {
      const Color& color = pixels[r * width + c];
      row[3 * c] = color.red;
      row[3 * c + 1] = color.green;
      row[3 * c + 2] = color.blue;
    }
    png_write_row(png, row.data());
  }
  png_write_end(png, info);
  png_destroy_write_struct(&png, &info);
  return bytes;
}

}  // namespace arelem::backend
