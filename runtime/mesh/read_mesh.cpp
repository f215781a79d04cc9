// STL, OBJ and OFF. The texts are read line by line, so that damage is told with its line.
#include <bit>
#include <cstring>

#include "runtime/mesh/builder.h"

namespace arelem::mesh {

namespace {
static_assert(std::endian::native == std::endian::little, "binary STL is little-endian");

template <class Value>
Value valueAt(std::string_view bytes, std::size_t at) {
  Value value;
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

constexpr std::size_t stlHead = 84;
constexpr std::size_t stlRecord = 50;

bool isBinaryStl(std::string_view bytes) {
  return bytes.size() >= stlHead &&
         bytes.size() == stlHead + stlRecord * std::size_t{valueAt<std::uint32_t>(bytes, 80)};
}

void readBinaryStl(std::string_view bytes, Builder& builder) {
  for (std::size_t at = stlHead; at < bytes.size() && builder.good(); at += stlRecord) {
    std::array<long long, 3> corners{};
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t place = at + 12 * (k + 1);
      corners[k] = static_cast<long long>(
          builder.sharedCorner(valueAt<float>(bytes, place), valueAt<float>(bytes, place + 4),
                               valueAt<float>(bytes, place + 8), 0));
    }
    if (builder.good()) {
      builder.polygon(corners, 0);
    }
  }
}

void readTextStl(std::string_view bytes, Builder& builder) {
  Lines lines(bytes);
  std::vector<long long> corners;
  bool open = false;
  while (lines.next() && builder.good()) {
    const std::string_view word = *lines.word();
    if (word == "vertex") {
      const auto x = lines.real();
      const auto y = lines.real();
      const auto z = lines.real();
      if (!open || !x || !y || !z) {
        return builder.wrong(lines.number(), "a vertex needs three numbers, inside a loop");
      }
      corners.push_back(static_cast<long long>(builder.sharedCorner(*x, *y, *z, lines.number())));
    } else if (word == "outer") {
      corners.clear();
      open = true;
    } else if (word == "endloop") {
      open = false;
      if (builder.good()) {
        builder.polygon(corners, lines.number());
      }
    } else if (word != "solid" && word != "facet" && word != "endfacet" && word != "endsolid") {
      return builder.wrong(lines.number(), fmt::format("`{}` is no word of STL", word));
    }
  }
  if (open) {
    builder.wrong(lines.number(), "the file ends inside a loop");
  }
}

void readStl(std::string_view bytes, Builder& builder) {
  if (isBinaryStl(bytes)) {
    return readBinaryStl(bytes, builder);
  }
  if (bytes.substr(0, 5) == "solid" || bytes.size() < stlHead) {
    return readTextStl(bytes, builder);
  }
  builder.wrong(0, fmt::format("a binary file of {} triangles has {} bytes, this one {}",
                               valueAt<std::uint32_t>(bytes, 80),
                               stlHead + stlRecord * std::size_t{valueAt<std::uint32_t>(bytes, 80)},
                               bytes.size()));
}

/// "7", "7/1", "7//3", "-2": the place of the corner, counted from 1 or back from the last.
std::optional<long long> cornerOfFace(std::string_view word, std::size_t count) {
  const auto index = parsed<long long>(word.substr(0, word.find('/')));
  if (!index || *index == 0) {
    return std::nullopt;
  }
  return *index > 0 ? *index - 1 : static_cast<long long>(count) + *index;
}

void readObj(std::string_view bytes, Builder& builder) {
  constexpr std::array nothingOfTheShape = {"vt", "vn", "g",      "o",      "s",
                                            "l",  "p",  "usemtl", "mtllib", "vp"};
  Lines lines(bytes);
  while (lines.next() && builder.good()) {
    const std::string_view word = *lines.word();
    if (word == "v") {
      const auto x = lines.real();
      const auto y = lines.real();
      const auto z = lines.real();
      if (!x || !y || !z) {
        return builder.wrong(lines.number(), "v needs three numbers");
      }
      builder.corner(*x, *y, *z, lines.number());
    } else if (word == "f") {
      std::vector<long long> corners;
      while (const auto item = lines.word()) {
        const auto corner = cornerOfFace(*item, builder.corners());
        if (!corner) {
          return builder.wrong(lines.number(), fmt::format("`{}` names no corner", *item));
        }
        corners.push_back(*corner);
      }
      builder.polygon(corners, lines.number());
    } else if (std::find(nothingOfTheShape.begin(), nothingOfTheShape.end(), word) ==
               nothingOfTheShape.end()) {
      return builder.wrong(lines.number(), fmt::format("`{}` is not read: v and f are", word));
    }
  }
}

void readOff(std::string_view bytes, Builder& builder) {
  Lines lines(bytes);
  if (!lines.next() || lines.word() != "OFF") {
    return builder.wrong(1, "the first word of the file is OFF");
  }
  auto first = lines.whole();
  if (!first && lines.next()) {
    first = lines.whole();
  }
  const auto faces = lines.whole();
  if (!first || !faces || *first < 0 || *faces < 0) {
    return builder.wrong(lines.number(), "behind OFF stand the numbers of corners and faces");
  }
  for (long long i = 0; i < *first + *faces && builder.good(); ++i) {
    if (!lines.next()) {
      return builder.wrong(
          lines.number(),
          fmt::format("the file ends after {} of {} corners and faces", i, *first + *faces));
    }
    if (i < *first) {
      const auto x = lines.real();
      const auto y = lines.real();
      const auto z = lines.real();
      if (!x || !y || !z) {
        return builder.wrong(lines.number(), "a corner needs three numbers");
      }
      builder.corner(*x, *y, *z, lines.number());
      continue;
    }
    const auto count = lines.whole();
    std::vector<long long> corners;
    while (count && static_cast<long long>(corners.size()) < *count) {
      const auto corner = lines.whole();
      if (!corner) {
        return builder.wrong(lines.number(),
                             fmt::format("a face of {} corners names {}", *count, corners.size()));
      }
      corners.push_back(*corner);
    }
    builder.polygon(corners, lines.number());
  }
  if (builder.good() && lines.next()) {
    builder.wrong(lines.number(), "the file goes on behind its last face");
  }
}
}  // namespace

Result<Mesh> readMesh(std::string_view bytes, Format format, std::string_view name) {
  Builder builder(name);
  switch (format) {
    case Format::stl:
      readStl(bytes, builder);
      break;
    case Format::obj:
      readObj(bytes, builder);
      break;
    case Format::ply:
      readPly(bytes, builder);
      break;
    case Format::off:
      readOff(bytes, builder);
      break;
  }
  return builder.finish();
}

}  // namespace arelem::mesh
