#include "runtime/spray/surface/kept.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace arelem::spray {

namespace {
constexpr int bisections = 60;

LinePoint pointAt(const Patch& patch, const geometry::Vec2& uv) {
  return {patch.at(uv.x(), uv.y()), patch.normal(uv.x(), uv.y()), uv};
}

/// Parameters between a place that is kept and one that is not, on the border, on the kept side.
geometry::Vec2 border(const Patch& patch, geometry::Vec2 kept, geometry::Vec2 lost) {
  for (int i = 0; i < bisections; ++i) {
    const geometry::Vec2 middle = (kept + lost) / 2.0;
    (patch.keeps(middle.x(), middle.y()) ? kept : lost) = middle;
  }
  return kept;
}

geometry::Vec2 node(const Patch& patch, int i, int k, int count) {
  return {patch.u0 + (patch.u1 - patch.u0) * i / count,
          patch.v0 + (patch.v1 - patch.v0) * k / count};
}

/// The stretch of a line between two neighboring points that is kept, as shares of the way; none
/// where nothing is. As far as a chord tells: planes cut at most one piece out of it.
using Stretch = std::pair<double, double>;

geometry::Vec2 middleOf(const LinePoint& a, const LinePoint& b, const Stretch& kept) {
  const double share = kept.first == 0.0    ? 0.0
                       : kept.second == 1.0 ? 1.0
                                            : (kept.first + kept.second) / 2.0;
  return a.uv + share * (b.uv - a.uv);
}

std::optional<Stretch> keptShare(const Patch& patch, const LinePoint& a, const LinePoint& b) {
  Stretch kept = {0.0, 1.0};
  for (const HalfSpace& side : patch.keep) {
    const double from = side.over(a.place);
    const double to = side.over(b.place);
    if (from < 0.0 && to < 0.0) {
      return std::nullopt;
    }
    if (from < 0.0) {
      kept.first = std::max(kept.first, from / (from - to));
    } else if (to < 0.0) {
      kept.second = std::min(kept.second, from / (from - to));
    }
  }
  const geometry::Vec2 inside = middleOf(a, b, kept);
  const bool some = kept.first < kept.second && patch.keeps(inside.x(), inside.y());
  return some ? std::optional(kept) : std::nullopt;
}

/// The range of a parameter down to the nodes that are kept and one more on each side. Where it
/// goes round, it begins behind the widest gap, so that no line ends at 0.
std::pair<double, double> shrunk(const std::vector<bool>& kept,
                                 double from,
                                 double to,
                                 bool turns) {
  const auto last = static_cast<int>(kept.size()) - 1;
  const auto isKept = [&](int i) { return kept[static_cast<std::size_t>(i % last)]; };
  const double step = (to - from) / last;
  if (!turns) {
    const int first = static_cast<int>(std::find(kept.begin(), kept.end(), true) - kept.begin());
    const int end =
        last - static_cast<int>(std::find(kept.rbegin(), kept.rend(), true) - kept.rbegin());
    return {from + step * std::max(first - 1, 0), from + step * std::min(end + 1, last)};
  }
  int widest = 0;
  int behind = 0;
  int run = 0;
  for (int i = 0; i < 2 * last; ++i) {
    run = isKept(i) ? 0 : run + 1;
    if (run > widest && run < last) {
      widest = run;
      behind = (i + 1) % last;
    }
  }
  if (widest < 2) {
    return {from, to};
  }
  return {from + step * (behind - 1), from + step * (behind + last - widest)};
}

/// A corner of a polygon that a triangle becomes.
struct ShadedCorner {
  std::uint32_t vertex = 0;
  Vec3 normal = Vec3::UnitZ();
};

ShadedMesh clippedBy(const ShadedMesh& whole, const HalfSpace& side) {
  ShadedMesh result;
  result.mesh.vertices = whole.mesh.vertices;
  const std::vector<Vec3>& places = whole.mesh.vertices;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> cuts;
  // The same place for both triangles of an edge.
  const auto cut = [&](const ShadedCorner& a, const ShadedCorner& b) {
    const auto [low, high] = std::minmax(a.vertex, b.vertex);
    const auto [found, added] =
        cuts.try_emplace({low, high}, static_cast<std::uint32_t>(result.mesh.vertices.size()));
    const double share =
        side.over(places[low]) / (side.over(places[low]) - side.over(places[high]));
    if (added) {
      result.mesh.vertices.push_back(places[low] + share * (places[high] - places[low]));
    }
    const double way = a.vertex == low ? share : 1.0 - share;
    return ShadedCorner{found->second, (a.normal + way * (b.normal - a.normal)).normalized()};
  };
  for (std::size_t t = 0; t < whole.mesh.triangles.size(); ++t) {
    std::vector<ShadedCorner> kept;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t next = (i + 1) % 3;
      const ShadedCorner a = {whole.mesh.triangles[t][i], whole.normals[t][i]};
      const ShadedCorner b = {whole.mesh.triangles[t][next], whole.normals[t][next]};
      const bool in = side.over(places[a.vertex]) >= 0.0;
      if (in) {
        kept.push_back(a);
      }
      if (in != (side.over(places[b.vertex]) >= 0.0)) {
        kept.push_back(cut(a, b));
      }
    }
    for (std::size_t i = 2; i < kept.size(); ++i) {
      result.mesh.triangles.push_back({kept[0].vertex, kept[i - 1].vertex, kept[i].vertex});
      result.normals.push_back({kept[0].normal, kept[i - 1].normal, kept[i].normal});
    }
  }
  return result;
}

/// Leaves out the vertices of no triangle.
geometry::TriangleMesh withoutLoose(const geometry::TriangleMesh& mesh) {
  geometry::TriangleMesh result;
  std::vector<std::optional<std::uint32_t>> numbers(mesh.vertices.size());
  for (geometry::TriangleMesh::Triangle triangle : mesh.triangles) {
    for (std::uint32_t& corner : triangle) {
      if (!numbers[corner]) {
        numbers[corner] = static_cast<std::uint32_t>(result.vertices.size());
        result.vertices.push_back(mesh.vertices[corner]);
      }
      corner = *numbers[corner];
    }
    result.triangles.push_back(triangle);
  }
  return result;
}
}  // namespace

std::vector<SurfaceLine> keptPieces(const Patch& patch, const SurfaceLine& line) {
  if (patch.keep.empty()) {
    return {line};
  }
  std::vector<SurfaceLine> pieces;
  bool open = false;  // the last piece goes on
  for (std::size_t i = 1; i < line.size(); ++i) {
    const LinePoint& a = line[i - 1];
    const LinePoint& b = line[i];
    const auto kept = keptShare(patch, a, b);
    if (!kept) {
      open = false;
      continue;
    }
    const auto [low, high] = *kept;
    if (low > 0.0 || !open) {
      pieces.push_back(
          {low > 0.0 ? pointAt(patch, border(patch, middleOf(a, b, *kept), a.uv)) : a});
    }
    open = high == 1.0;
    pieces.back().push_back(open ? b : pointAt(patch, border(patch, middleOf(a, b, *kept), b.uv)));
  }
  return pieces;
}

KeptGrid keptGrid(const Patch& patch, int count) {
  KeptGrid grid;
  const int side = count + 1;
  std::vector<std::optional<std::size_t>> numbers(static_cast<std::size_t>(side * side));
  for (int n = 0; n < side * side; ++n) {
    const geometry::Vec2 uv = node(patch, n / side, n % side, count);
    if (patch.keeps(uv.x(), uv.y())) {
      numbers[static_cast<std::size_t>(n)] = grid.places.size();
      grid.places.push_back(patch.at(uv.x(), uv.y()));
    }
  }
  const auto join = [&](int i, int k, int i2, int k2) {
    const auto& a = numbers[static_cast<std::size_t>(i * side + k)];
    const auto& b = numbers[static_cast<std::size_t>(i2 * side + k2)];
    if (a && b) {
      grid.neighbors.emplace_back(*a, *b);
    } else if (a || b) {
      const geometry::Vec2 uv =
          border(patch, a ? node(patch, i, k, count) : node(patch, i2, k2, count),
                 a ? node(patch, i2, k2, count) : node(patch, i, k, count));
      grid.neighbors.emplace_back(a ? *a : *b, grid.places.size());
      grid.places.push_back(patch.at(uv.x(), uv.y()));
    }
  };
  for (int i = 0; i < side; ++i) {
    for (int k = 0; k < side; ++k) {
      if (i + 1 < side) {
        join(i, k, i + 1, k);
      }
      if (k + 1 < side) {
        join(i, k, i, k + 1);
      }
    }
  }
  return grid;
}

bool shrinkToKept(Patch& patch, bool uTurns, bool vTurns) {
  constexpr int count = 128;
  std::vector<bool> columns(count + 1, false);
  std::vector<bool> rows(count + 1, false);
  bool some = false;
  for (int i = 0; i <= count; ++i) {
    for (int k = 0; k <= count; ++k) {
      const geometry::Vec2 uv = node(patch, i, k, count);
      if (patch.keeps(uv.x(), uv.y())) {
        columns[static_cast<std::size_t>(i)] = true;
        rows[static_cast<std::size_t>(k)] = true;
        some = true;
      }
    }
  }
  if (some) {
    std::tie(patch.u0, patch.u1) = shrunk(columns, patch.u0, patch.u1, uTurns);
    std::tie(patch.v0, patch.v1) = shrunk(rows, patch.v0, patch.v1, vTurns);
  }
  return some;
}

ShadedMesh clipped(ShadedMesh whole, const std::vector<HalfSpace>& keep) {
  for (const HalfSpace& side : keep) {
    whole = clippedBy(whole, side);
  }
  whole.mesh = withoutLoose(whole.mesh);
  return whole;
}

}  // namespace arelem::spray
