#include "runtime/geometry/mesh_file.h"

#include <bit>
#include <charconv>
#include <cstring>

#include "ir/diag/geometry.h"

namespace arelem::geometry {

namespace {
constexpr std::size_t headerBytes = 80;
constexpr std::size_t triangleBytes = 50;

/// Little-endian, as the format has it on any machine.
std::uint32_t wordAt(std::string_view bytes, std::size_t at) {
  if constexpr (std::endian::native == std::endian::little) {
    std::uint32_t value = 0;
    std::memcpy(&value, bytes.data() + at, sizeof value);
    return value;
  }
  std::uint32_t value = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    value |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + k])) << (8 * k);
  }
  return value;
}

bool isBinary(std::string_view bytes) {
  return bytes.size() >= headerBytes + 4 &&
         bytes.size() == headerBytes + 4 + triangleBytes * std::size_t{wordAt(bytes, headerBytes)};
}

TriangleMesh readBinary(std::string_view bytes) {
  TriangleMesh mesh;
  const std::uint32_t count = wordAt(bytes, headerBytes);
  mesh.vertices.reserve(3 * std::size_t{count});
  mesh.triangles.reserve(count);
  std::size_t at = headerBytes + 4;
  for (std::uint32_t i = 0; i < count; ++i, at += triangleBytes) {
    // The normal comes first; the order of the corners says the same.
    for (std::size_t k = 0; k < 3; ++k) {
      Vec3 v;
      for (std::size_t c = 0; c < 3; ++c) {
        const std::size_t place = at + 12 + 12 * k + 4 * c;
        v[static_cast<Eigen::Index>(c)] = std::bit_cast<float>(wordAt(bytes, place));
      }
      mesh.vertices.push_back(v);
    }
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return mesh;
}

/// Words of a text with their lines.
class Scanner {
 public:
  explicit Scanner(std::string_view text) : text_(text) {}

  std::string_view next() {
    while (at_ < text_.size() && isBlank(text_[at_])) {
      line_ += text_[at_] == '\n' ? 1 : 0;
      ++at_;
    }
    const std::size_t begin = at_;
    while (at_ < text_.size() && !isBlank(text_[at_])) {
      ++at_;
    }
    return text_.substr(begin, at_ - begin);
  }
  void skipLine() { at_ = std::min(text_.find('\n', at_), text_.size()); }
  [[nodiscard]] std::uint64_t line() const { return line_; }

 private:
  static bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }
  std::string_view text_;
  std::size_t at_ = 0;
  std::uint64_t line_ = 1;
};

bool same(std::string_view word, std::string_view lower) {
  return word.size() == lower.size() &&
         std::equal(word.begin(), word.end(), lower.begin(),
                    [](char a, char b) { return (a >= 'A' && a <= 'Z' ? a - 'A' + 'a' : a) == b; });
}

/// solid ... (facet normal i j k, outer loop, three times vertex x y z, endloop, endfacet) ...
/// endsolid, several times over.
class StlText {
 public:
  explicit StlText(std::string_view text) : scanner_(text) {}

  Result<TriangleMesh> read(std::string_view name) {
    for (std::string_view word = scanner_.next(); !word.empty(); word = scanner_.next()) {
      if (same(word, "solid") || same(word, "endsolid")) {
        scanner_.skipLine();
      } else if (!same(word, "facet")) {
        return wrong(name, "facet", word);
      } else if (auto bad = facet(name)) {
        return *std::move(bad);
      }
    }
    return std::move(mesh_);
  }

 private:
  std::optional<Failure> facet(std::string_view name) {
    for (const std::string_view wanted : {"normal", "", "", "", "outer", "loop"}) {
      const std::string_view word = scanner_.next();
      if (wanted.empty() ? !number(word) : !same(word, wanted)) {
        return wrong(name, wanted.empty() ? "a number" : wanted, word);
      }
    }
    const auto first = static_cast<std::uint32_t>(mesh_.vertices.size());
    for (int k = 0; k < 3; ++k) {
      const std::string_view head = scanner_.next();
      if (!same(head, "vertex")) {
        return wrong(name, "vertex", head);
      }
      Vec3 v;
      for (double& c : v) {
        const std::string_view word = scanner_.next();
        const auto value = number(word);
        if (!value) {
          return wrong(name, "a number", word);
        }
        c = *value;
      }
      mesh_.vertices.push_back(v);
    }
    mesh_.triangles.push_back({first, first + 1, first + 2});
    for (const std::string_view wanted : {"endloop", "endfacet"}) {
      const std::string_view word = scanner_.next();
      if (!same(word, wanted)) {
        return wrong(name, wanted, word);
      }
    }
    return std::nullopt;
  }

  static std::optional<double> number(std::string_view word) {
    double value = 0.0;
    const char* begin = word.data() + (word.starts_with('+') ? 1 : 0);
    const auto [end, error] = std::from_chars(begin, word.data() + word.size(), value);
    return error == std::errc() && end == word.data() + word.size() ? std::optional(value)
                                                                    : std::nullopt;
  }
  Failure wrong(std::string_view name, std::string_view wanted, std::string_view found) const {
    constexpr std::size_t shown = 20;
    std::string seen;
    for (const char c : found.substr(0, shown)) {
      seen += c >= ' ' && c <= '~' ? c : '?';
    }
    return fail(
        diag::MeshBroken, name,
        fmt::format("line {} has `{}` where `{}` is needed", scanner_.line(), seen, wanted));
  }

  Scanner scanner_;
  TriangleMesh mesh_;
};

Result<TriangleMesh> readStl(std::string_view bytes, std::string_view name) {
  if (isBinary(bytes)) {
    return readBinary(bytes);
  }
  const std::size_t begin = bytes.find_first_not_of(" \t\r\n");
  if (begin != std::string_view::npos && same(bytes.substr(begin, 5), "solid")) {
    return StlText(bytes).read(name);
  }
  if (bytes.size() < headerBytes + 4) {
    return fail(diag::MeshBroken, name,
                fmt::format("it has {} bytes; a binary STL has 84 at least, a text begins with "
                            "`solid`",
                            bytes.size()));
  }
  const std::uint64_t count = wordAt(bytes, headerBytes);
  return fail(diag::MeshBroken, name,
              fmt::format("its header announces {} triangles, which need {} bytes; it has {}",
                          count, headerBytes + 4 + triangleBytes * count, bytes.size()));
}
}  // namespace

std::string_view spell(MeshFormat format) {
  switch (format) {
    case MeshFormat::stl:
      return "STL";
    case MeshFormat::obj:
      return "OBJ";
    case MeshFormat::ply:
      return "PLY";
    default:
      return "OFF";
  }
}

Result<TriangleMesh> readMesh(std::string_view bytes, MeshFormat format, std::string_view name) {
  if (format == MeshFormat::stl) {
    Result<TriangleMesh> mesh = readStl(bytes, name);
    return mesh ? checkedMesh(*std::move(mesh), name) : std::move(mesh);
  }
  std::optional<TriangleMesh> mesh = readPolygons(bytes, format);
  if (!mesh) {
    return fail(diag::MeshBroken, name, polygonFault(bytes, format));
  }
  return checkedMesh(*std::move(mesh), name);
}

}  // namespace arelem::geometry
