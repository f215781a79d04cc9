#include "app/view/surface_mesh.h"

#include <array>
#include <cmath>
#include <unordered_map>

namespace arelem::app {

namespace {
constexpr int coarse = 4;  // fine cells in one coarse cell, each way

class Mesher {
 public:
  Mesher(const surface::AnySurface& surface, const Vec3& low, const Vec3& high, int cells)
      : surface_(surface), low_(low) {
    const Vec3 size = high - low;
    step_ = size.maxCoeff() / cells;
    for (int k = 0; k < 3; ++k) {
      n_[static_cast<std::size_t>(k)] =
          std::max(coarse, static_cast<int>(std::ceil(size[k] / step_ / coarse)) * coarse);
    }
  }

  backend::SceneMesh run() {
    for (int x = 0; x < n_[0]; x += coarse) {
      for (int y = 0; y < n_[1]; y += coarse) {
        for (int z = 0; z < n_[2]; z += coarse) {
          block(x, y, z);
        }
      }
    }
    for (const auto& [key, vertex] : vertices_) {
      static_cast<void>(vertex);
      faces(key);
    }
    return std::move(mesh_);
  }

 private:
  using Cell = std::array<int, 3>;

  [[nodiscard]] Vec3 corner(int x, int y, int z) const { return low_ + step_ * Vec3(x, y, z); }
  [[nodiscard]] surface::Foot foot(const Vec3& p) const {
    return std::visit(
        [&](const auto& s) {
          typename std::decay_t<decltype(s)>::Hint hint;
          return s.foot(p, hint);
        },
        surface_);
  }
  [[nodiscard]] std::uint64_t key(const Cell& c) const {
    return (static_cast<std::uint64_t>(c[0]) << 42U) | (static_cast<std::uint64_t>(c[1]) << 21U) |
           static_cast<std::uint64_t>(c[2]);
  }
  double distance(const Cell& c) {
    const auto [place, fresh] = distances_.try_emplace(key(c), 0.0);
    if (fresh) {
      place->second = foot(corner(c[0], c[1], c[2])).distance;
    }
    return place->second;
  }

  void block(int x, int y, int z) {
    const double half = 0.5 * coarse * step_;
    const Vec3 middle = corner(x, y, z) + Vec3::Constant(half);
    if (std::abs(foot(middle).distance) > half * std::sqrt(3.0) + step_) {
      return;
    }
    for (int i = x; i < x + coarse; ++i) {
      for (int j = y; j < y + coarse; ++j) {
        for (int k = z; k < z + coarse; ++k) {
          cell({i, j, k});
        }
      }
    }
  }

  void cell(const Cell& c) {
    int negative = 0;
    for (int i = 0; i < 8; ++i) {
      negative += distance({c[0] + (i & 1), c[1] + (i >> 1 & 1), c[2] + (i >> 2)}) < 0.0 ? 1 : 0;
    }
    if (negative == 0 || negative == 8) {
      return;
    }
    Vec3 place = corner(c[0], c[1], c[2]) + Vec3::Constant(0.5 * step_);
    surface::Foot at = foot(place);
    for (int i = 0; i < 3; ++i) {
      place -= at.distance * at.normal;
      at = foot(place);
    }
    vertices_.emplace_back(c, static_cast<std::uint32_t>(mesh_.places.size() / 3));
    index_[key(c)] = vertices_.back().second;
    for (int k = 0; k < 3; ++k) {
      mesh_.places.push_back(static_cast<float>(place[k]));
      mesh_.normals.push_back(static_cast<float>(at.normal[k]));
    }
  }

  /// A face for each grid edge that begins at the cell's low corner and passes the surface.
  void faces(const Cell& c) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      Cell to = c;
      ++to[axis];
      const bool inside = distance(c) < 0.0;
      if (inside == (distance(to) < 0.0)) {
        continue;
      }
      const std::size_t u = (axis + 1) % 3;
      const std::size_t v = (axis + 2) % 3;
      std::array<Cell, 4> around = {c, c, c, c};
      --around[1][u];
      --around[2][u];
      --around[2][v];
      --around[3][v];
      std::array<std::uint32_t, 4> corners{};
      bool all = true;
      for (std::size_t i = 0; i < 4 && all; ++i) {
        const bool in = around[i][u] >= 0 && around[i][v] >= 0;
        const auto found = in ? index_.find(key(around[i])) : index_.end();
        all = found != index_.end();
        corners[i] = all ? found->second : 0;
      }
      if (all) {
        quad(corners, inside);
      }
    }
  }

  void quad(const std::array<std::uint32_t, 4>& c, bool outward) {
    const std::array<std::size_t, 6> order = outward ? std::array<std::size_t, 6>{0, 1, 2, 0, 2, 3}
                                                     : std::array<std::size_t, 6>{0, 2, 1, 0, 3, 2};
    for (const std::size_t i : order) {
      mesh_.triangles.push_back(c[i]);
    }
  }

  const surface::AnySurface& surface_;
  Vec3 low_;
  double step_ = 1.0;
  std::array<int, 3> n_{};
  std::unordered_map<std::uint64_t, double> distances_;
  std::unordered_map<std::uint64_t, std::uint32_t> index_;
  std::vector<std::pair<Cell, std::uint32_t>> vertices_;
  backend::SceneMesh mesh_;
};
}  // namespace

std::optional<backend::SceneMesh> meshOf(const surface::AnySurface& surface,
                                         const Vec3& low,
                                         const Vec3& high,
                                         int cells) {
  backend::SceneMesh mesh = Mesher(surface, low, high, cells).run();
  if (mesh.triangles.empty()) {
    return std::nullopt;
  }
  return mesh;
}

}  // namespace arelem::app
