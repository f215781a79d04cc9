// Formats of polygons, read by CGAL.
#include <algorithm>
#include <cstdlib>
#include <exception>
#include <sstream>
#include <string>

#include <CGAL/IO/OBJ.h>
#include <CGAL/IO/OFF.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/Simple_cartesian.h>

#include "runtime/geometry/mesh_file.h"

namespace arelem::geometry {

namespace {
using SoupPoint = CGAL::Simple_cartesian<double>::Point_3;
using SoupPolygon = std::vector<std::size_t>;

/// Whether a header counts more than the file has bytes: CGAL's readers make room for the count
/// before they look for the rest.
bool countsTooMuch(std::string_view bytes, MeshFormat format) {
  std::istringstream in{std::string(bytes)};
  std::vector<double> counts;
  std::string word;
  if (format == MeshFormat::off) {
    while (counts.size() < 2 && in >> word) {
      if (word[0] == '#') {
        std::getline(in, word);
      } else if (word.find("OFF") == std::string::npos) {
        counts.push_back(std::strtod(word.c_str(), nullptr));
      }
    }
  } else if (format == MeshFormat::ply) {
    while (in >> word && word != "end_header") {
      std::string name, count;
      if (word == "element" && in >> name >> count) {
        counts.push_back(std::strtod(count.c_str(), nullptr));
      }
    }
  }
  return std::any_of(counts.begin(), counts.end(),
                     [&](double count) { return !(count <= static_cast<double>(bytes.size())); });
}
}  // namespace

std::optional<TriangleMesh> readPolygons(std::string_view bytes, MeshFormat format) {
  if (countsTooMuch(bytes, format)) {
    return std::nullopt;
  }
  std::vector<SoupPoint> points;
  std::vector<SoupPolygon> polygons;
  try {
    std::istringstream in{std::string(bytes)};
    const auto quiet = CGAL::parameters::verbose(false);
    const bool good = format == MeshFormat::obj   ? CGAL::IO::read_OBJ(in, points, polygons, quiet)
                      : format == MeshFormat::ply ? CGAL::IO::read_PLY(in, points, polygons, quiet)
                                                  : CGAL::IO::read_OFF(in, points, polygons, quiet);
    if (!good) {
      return std::nullopt;
    }
  } catch (const std::exception&) {
    // Counts in a header that no file can hold, and what else its readers refuse.
    return std::nullopt;
  }
  TriangleMesh mesh;
  for (const SoupPoint& p : points) {
    mesh.vertices.emplace_back(p.x(), p.y(), p.z());
  }
  for (const SoupPolygon& p : polygons) {
    for (const std::size_t v : p) {
      if (v >= points.size()) {
        return std::nullopt;
      }
    }
    for (std::size_t k = 2; k < p.size(); ++k) {
      mesh.triangles.push_back({static_cast<std::uint32_t>(p[0]),
                                static_cast<std::uint32_t>(p[k - 1]),
                                static_cast<std::uint32_t>(p[k])});
    }
  }
  return mesh;
}

}  // namespace arelem::geometry
