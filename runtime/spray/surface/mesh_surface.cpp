#include "runtime/spray/surface/mesh_surface.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "ir/space/tolerance.h"
#include "runtime/spray/surface/kept.h"

namespace arelem::spray {

namespace {
/// An edge of the mesh by its corners, the smaller number first.
using Edge = std::pair<std::size_t, std::size_t>;

bool creased(const Vec3& a, const Vec3& b) {
  constexpr double cosine = 0.766;  // 40 degrees
  return a.dot(b) < cosine;
}

/// The crossings of one plane with the edges, linked through the triangles.
class Chains {
 public:
  Chains(const MeshSurface& surface, const CuttingPlane& plane)
      : surface_(surface), mesh_(surface.mesh()) {
    heights_.reserve(mesh_.vertices.size());
    for (const Vec3& corner : mesh_.vertices) {
      heights_.push_back(plane.normal.dot(corner) - plane.level);
    }
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      link(t);
    }
  }

  /// Lines end at creases: the gun is turned there switched off.
  std::vector<SurfaceLine> lines() {
    // Open lines begin at an end; what is left are closed ones.
    for (const bool openOnly : {true, false}) {
      for (auto& [edge, links] : links_) {
        if (!openOnly || links.size() == 1) {
          follow(edge);
        }
      }
    }
    return std::move(lines_);
  }

 private:
  struct Link {
    Edge to;
    std::size_t triangle;
  };

  void link(std::size_t t) {
    std::vector<Edge> crossed;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t a = mesh_.triangles[t][i];
      const std::size_t b = mesh_.triangles[t][(i + 1) % 3];
      if ((heights_[a] < 0.0) != (heights_[b] < 0.0)) {
        crossed.emplace_back(std::min(a, b), std::max(a, b));
      }
    }
    if (crossed.size() == 2) {
      links_[crossed[0]].push_back({crossed[1], t});
      links_[crossed[1]].push_back({crossed[0], t});
    }
  }

  [[nodiscard]] LinePoint crossing(const Edge& edge, std::size_t t) const {
    const double share = heights_[edge.first] / (heights_[edge.first] - heights_[edge.second]);
    Vec3 shares = Vec3::Zero();
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t corner = mesh_.triangles[t][i];
      shares[static_cast<Eigen::Index>(i)] = corner == edge.first    ? 1.0 - share
                                             : corner == edge.second ? share
                                                                     : 0.0;
    }
    return surface_.at(t, shares);
  }

  /// One triangle's piece of a line.
  void add(const LinePoint& from, const LinePoint& to, bool begins) {
    if (begins || creased(lines_.back().back().normal, from.normal)) {
      lines_.push_back({from});
    } else {
      LinePoint& joint = lines_.back().back();
      joint.normal = (joint.normal + from.normal).normalized();
    }
    if ((to.place - lines_.back().back().place).norm() > tolerance::coincidence) {
      lines_.back().push_back(to);
    }
  }

  void follow(Edge edge) {
    const std::size_t first = lines_.size();
    for (bool goesOn = true; goesOn;) {
      goesOn = false;
      for (const Link& link : links_[edge]) {
        if (used_.insert(link.triangle).second) {
          add(crossing(edge, link.triangle), crossing(link.to, link.triangle),
              lines_.size() == first);
          edge = link.to;
          goesOn = true;
          break;
        }
      }
    }
    if (lines_.size() > first + 1) {
      joinEnds(first);
    }
  }

  /// A closed line that was begun between two of its creases.
  void joinEnds(std::size_t first) {
    SurfaceLine& begin = lines_[first];
    SurfaceLine& end = lines_.back();
    if ((begin.front().place - end.back().place).norm() <= tolerance::coincidence &&
        !creased(begin.front().normal, end.back().normal)) {
      end.insert(end.end(), begin.begin() + 1, begin.end());
      lines_.erase(lines_.begin() + static_cast<std::ptrdiff_t>(first));
    }
  }

  const MeshSurface& surface_;
  const geometry::TriangleMesh& mesh_;
  std::vector<double> heights_;
  std::map<Edge, std::vector<Link>> links_;
  std::set<std::size_t> used_;  // triangles
  std::vector<SurfaceLine> lines_;
};

}  // namespace

std::vector<SurfaceLine> onItsSide(const SurfaceLine& line, const CuttingPlane& plane) {
  if (!plane.half) {
    return {line};
  }
  std::vector<SurfaceLine> pieces(1);
  const auto height = [&](const LinePoint& p) { return plane.half->dot(p.place - plane.place); };
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (i > 0 && (height(line[i - 1]) < 0.0) != (height(line[i]) < 0.0)) {
      const double share = height(line[i - 1]) / (height(line[i - 1]) - height(line[i]));
      const LinePoint& a = line[i - 1];
      const LinePoint& b = line[i];
      pieces.back().push_back({a.place + share * (b.place - a.place),
                               (a.normal + share * (b.normal - a.normal)).normalized(),
                               a.uv + share * (b.uv - a.uv)});
      if (height(b) < 0.0) {
        pieces.emplace_back();
      }
    }
    if (height(line[i]) >= 0.0) {
      pieces.back().push_back(line[i]);
    }
  }
  return pieces;
}

MeshSurface::MeshSurface(geometry::TriangleMesh mesh, bool flipped) : mesh_(std::move(mesh)) {
  if (flipped) {
    for (auto& triangle : mesh_.triangles) {
      std::swap(triangle[1], triangle[2]);
    }
  }
  std::vector<Vec3> faces;
  std::vector<std::vector<std::size_t>> about(mesh_.vertices.size());
  for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
    faces.push_back(spanned(t).normalized());
    for (const std::size_t corner : mesh_.triangles[t]) {
      about[corner].push_back(t);
    }
  }
  normals_.reserve(mesh_.triangles.size());
  for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
    std::array<Vec3, 3>& own = normals_.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t corner = mesh_.triangles[t][i];
      Vec3 sum = Vec3::Zero();
      for (const std::size_t other : about[corner]) {
        if (!creased(faces[t], faces[other])) {
          sum += angleAt(other, corner) * faces[other];
        }
      }
      own[i] = sum.normalized();
    }
  }
  mean_ = meanOfAll();
}

Vec3 MeshSurface::spanned(std::size_t t) const {
  return (mesh_.corner(t, 1) - mesh_.corner(t, 0)).cross(mesh_.corner(t, 2) - mesh_.corner(t, 0));
}

double MeshSurface::angleAt(std::size_t triangle, std::size_t corner) const {
  const auto& corners = mesh_.triangles[triangle];
  const auto i =
      static_cast<std::size_t>(std::find(corners.begin(), corners.end(), corner) - corners.begin());
  const Vec3 a = mesh_.vertices[corners[(i + 1) % 3]] - mesh_.vertices[corner];
  const Vec3 b = mesh_.vertices[corners[(i + 2) % 3]] - mesh_.vertices[corner];
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

MeshSurface MeshSurface::cutBy(const std::vector<HalfSpace>& keep) const {
  ShadedMesh cut = clipped({mesh_, normals_}, keep);
  MeshSurface result = *this;
  result.mesh_ = std::move(cut.mesh);
  result.normals_ = std::move(cut.normals);
  result.mean_ = result.meanOfAll();
  return result;
}

double MeshSurface::area() const {
  double twice = 0.0;
  for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
    twice += spanned(t).norm();
  }
  return twice / 2.0;
}

Vec3 MeshSurface::meanOfAll() const {
  Vec3 sum = Vec3::Zero();
  for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
    sum += spanned(t);
  }
  const double whole = 2.0 * area();
  return sum.norm() > tolerance::similarity * whole ? sum.normalized() : Vec3(Vec3::Zero());
}

std::pair<double, double> MeshSurface::range(const Vec3& normal) const {
  double low = HUGE_VAL;
  double high = -HUGE_VAL;
  for (const Vec3& corner : mesh_.vertices) {
    low = std::min(low, normal.dot(corner));
    high = std::max(high, normal.dot(corner));
  }
  return {low, high};
}

std::vector<SurfaceLine> MeshSurface::cut(const CuttingPlane& plane) const {
  std::vector<SurfaceLine> result;
  for (const SurfaceLine& line : Chains(*this, plane).lines()) {
    for (SurfaceLine& piece : onItsSide(line, plane)) {
      if (piece.size() >= 2) {
        result.push_back(std::move(piece));
      }
    }
  }
  return result;
}

std::vector<SurfaceLine> MeshSurface::sections(const std::vector<CuttingPlane>& planes,
                                               double chord) const {
  std::vector<SurfaceLine> all;
  for (const CuttingPlane& plane : planes) {
    for (const SurfaceLine& line : cut(plane)) {
      appendToAndFro(all, thinned(line, chord));
    }
  }
  return all;
}

std::optional<double> MeshSurface::smallestRadius(const std::vector<CuttingPlane>& planes,
                                                  double piece) const {
  return bend(planes, piece, false);
}

std::optional<double> MeshSurface::smallestHollow(const std::vector<CuttingPlane>& planes,
                                                  double piece) const {
  return bend(planes, piece, true);
}

std::optional<double> MeshSurface::bend(const std::vector<CuttingPlane>& planes,
                                        double piece,
                                        bool hollowOnly) const {
  double smallest = HUGE_VAL;
  for (const CuttingPlane& plane : planes) {
    for (const SurfaceLine& line : cut(plane)) {
      std::size_t from = 0;
      double way = 0.0;
      for (std::size_t i = 1; i < line.size(); ++i) {
        way += (line[i].place - line[i - 1].place).norm();
        if (way < piece) {
          continue;
        }
        const Vec3& a = line[from].normal;
        const Vec3& b = line[i].normal;
        const double turned = std::atan2(a.cross(b).norm(), a.dot(b));
        const bool hollow = (line[i].place - line[from].place).dot(b - a) < 0.0;
        if (turned > tolerance::similarity && (hollow || !hollowOnly)) {
          smallest = std::min(smallest, way / turned);
        }
        from = i;
        way = 0.0;
      }
    }
  }
  constexpr double flattest = 1e7;  // mm
  return smallest < flattest ? std::optional(smallest) : std::nullopt;
}

LinePoint MeshSurface::at(std::size_t triangle, const Vec3& shares) const {
  LinePoint point{Vec3::Zero(), Vec3::Zero()};
  for (std::size_t i = 0; i < 3; ++i) {
    const double share = shares[static_cast<Eigen::Index>(i)];
    point.place += share * mesh_.vertices[mesh_.triangles[triangle][i]];
    point.normal += share * normals_[triangle][i];
  }
  point.normal.normalize();
  return point;
}

}  // namespace arelem::spray
