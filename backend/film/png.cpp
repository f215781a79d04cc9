// The only file that knows libpng.
#include <cmath>
#include <csetjmp>
#include <ostream>

#include <png.h>

#include "backend/film/picture.h"

namespace arelem::backend {

namespace {
constexpr std::size_t scaleRows = 24;  // of the color scale below the picture
constexpr std::size_t gapRows = 6;
constexpr double scaleEnd = 2.0;
constexpr double pale = 0.55;  // how much of its color is left beside the work

void put(png_structp png, png_bytep bytes, png_size_t count) {
  static_cast<std::ostream*>(png_get_io_ptr(png))
      ->write(reinterpret_cast<const char*>(bytes), static_cast<std::streamsize>(count));
}
void flush(png_structp /*png*/) {}

unsigned char paled(unsigned char value) {
  return static_cast<unsigned char>(255.0 - pale * (255.0 - value));
}

void pixel(std::vector<unsigned char>& row, Color color) {
  row.insert(row.end(), {color.red, color.green, color.blue});
}

std::vector<unsigned char> filmRow(const FilmPicture& p, std::size_t r) {
  std::vector<unsigned char> row;
  for (std::size_t c = 0; c < p.columns; ++c) {
    const std::size_t i = r * p.columns + c;
    const double relative = (*p.film)[i] / p.wanted;
    Color color = relative > 0.0 ? filmColor(relative) : Color{255, 255, 255};
    if (!(*p.onWork)[i]) {
      color = {paled(color.red), paled(color.green), paled(color.blue)};
    } else if (relative <= 0.0) {
      color = {20, 20, 20};
    }
    pixel(row, color);
  }
  return row;
}

std::vector<unsigned char> scaleRow(const FilmPicture& p) {
  std::vector<unsigned char> row;
  for (std::size_t c = 0; c < p.columns; ++c) {
    pixel(row, filmColor(scaleEnd * static_cast<double>(c) /
                         static_cast<double>(std::max<std::size_t>(p.columns - 1, 1))));
  }
  return row;
}
}  // namespace

bool writeFilmPng(std::ostream& out, const FilmPicture& p) {
  std::vector<std::vector<unsigned char>> rows;
  for (std::size_t r = p.rows; r-- > 0;) {
    rows.push_back(filmRow(p, r));
  }
  rows.insert(rows.end(), gapRows, std::vector<unsigned char>(3 * p.columns, 255));
  rows.insert(rows.end(), scaleRows, scaleRow(p));
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png != nullptr ? png_create_info_struct(png) : nullptr;
  if (info == nullptr || setjmp(png_jmpbuf(png)) != 0) {
    png_destroy_write_struct(&png, &info);
    return false;
  }
  png_set_write_fn(png, &out, put, flush);
  png_set_IHDR(png, info, static_cast<png_uint_32>(p.columns),
               static_cast<png_uint_32>(rows.size()), 8, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_write_info(png, info);
  for (std::vector<unsigned char>& row : rows) {
    png_write_row(png, row.data());
  }
  png_write_end(png, info);
  png_destroy_write_struct(&png, &info);
  return static_cast<bool>(out);
}

}  // namespace arelem::backend
