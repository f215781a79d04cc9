// Formats of polygons, read by CGAL.
#include <exception>
#include <sstream>

#include <CGAL/IO/OBJ.h>
#include <CGAL/IO/OFF.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/Simple_cartesian.h>

#include "runtime/geometry/mesh_file.h"

namespace arelem::geometry {

namespace {
using SoupPoint = CGAL::Simple_cartesian<double>::Point_3;
using SoupPolygon = std::vector<std::size_t>;
}  // namespace

std::optional<TriangleMesh> readPolygons(std::string_view bytes, MeshFormat format) {
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
