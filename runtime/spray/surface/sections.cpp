// Sections of a patch: contours of a field over the parameters, by marching squares, each crossing
// found on its grid line by bisection.
#include <algorithm>
#include <cmath>
#include <map>

#include "runtime/spray/surface/kept.h"

namespace arelem::spray {

namespace {
constexpr int cells = 160;
constexpr int bisections = 50;

struct Place {
  double u = 0.0, v = 0.0;
};
/// A grid line between two neighboring nodes: column, row, and whether it runs along u.
using EdgeKey = std::tuple<int, int, bool>;

class Contour {
 public:
  Contour(const Patch& patch, const std::function<double(const Vec3&)>& field, double level)
      : patch_(patch), field_(field), level_(level) {}

  std::vector<std::vector<Place>> run(const std::vector<double>& values) {
    for (int i = 0; i < cells; ++i) {
      for (int k = 0; k < cells; ++k) {
        cell(values, i, k);
      }
    }
    std::vector<std::vector<Place>> lines;
    // Open lines begin at an end; what is left are closed ones.
    for (const bool openOnly : {true, false}) {
      for (const auto& [key, links] : links_) {
        if (!used_[key] && (!openOnly || links.size() == 1)) {
          lines.push_back(follow(key));
        }
      }
    }
    return lines;
  }

 private:
  [[nodiscard]] Place node(int i, int k) const {
    return {patch_.u0 + (patch_.u1 - patch_.u0) * i / cells,
            patch_.v0 + (patch_.v1 - patch_.v0) * k / cells};
  }
  [[nodiscard]] double over(const Place& p) const { return field_(patch_.at(p.u, p.v)) - level_; }

  void cell(const std::vector<double>& values, int i, int k) {
    const auto value = [&](int a, int b) {
      return values[static_cast<std::size_t>(a * (cells + 1) + b)] - level_;
    };
    const std::array<EdgeKey, 4> edges = {EdgeKey{i, k, true}, EdgeKey{i + 1, k, false},
                                          EdgeKey{i, k + 1, true}, EdgeKey{i, k, false}};
    const std::array<std::pair<double, double>, 4> ends = {std::pair{value(i, k), value(i + 1, k)},
                                                           {value(i + 1, k), value(i + 1, k + 1)},
                                                           {value(i, k + 1), value(i + 1, k + 1)},
                                                           {value(i, k), value(i, k + 1)}};
    std::vector<EdgeKey> cut;
    for (std::size_t e = 0; e < 4; ++e) {
      if ((ends[e].first < 0.0) != (ends[e].second < 0.0)) {
        cut.push_back(edges[e]);
      }
    }
    for (std::size_t e = 0; e + 1 < cut.size(); e += 2) {
      links_[cut[e]].push_back(cut[e + 1]);
      links_[cut[e + 1]].push_back(cut[e]);
    }
  }

  [[nodiscard]] Place crossing(const EdgeKey& key) const {
    const auto [i, k, alongU] = key;
    Place a = node(i, k);
    Place b = alongU ? node(i + 1, k) : node(i, k + 1);
    const bool below = over(a) < 0.0;
    for (int n = 0; n < bisections; ++n) {
      const Place middle{(a.u + b.u) / 2.0, (a.v + b.v) / 2.0};
      ((over(middle) < 0.0) == below ? a : b) = middle;
    }
    return a;
  }

  std::vector<Place> follow(EdgeKey key) {
    std::vector<Place> line;
    const EdgeKey start = key;
    while (!used_[key]) {
      used_[key] = true;
      line.push_back(crossing(key));
      for (const EdgeKey& next : links_[key]) {
        if (!used_[next]) {
          key = next;
          break;
        }
      }
    }
    const auto& back = links_[key];
    if (line.size() > 2 && key != start &&
        std::find(back.begin(), back.end(), start) != back.end()) {
      line.push_back(line.front());
    }
    return line;
  }

  const Patch& patch_;
  const std::function<double(const Vec3&)>& field_;
  double level_;
  std::map<EdgeKey, std::vector<EdgeKey>> links_;
  std::map<EdgeKey, bool> used_;
};

}  // namespace

std::vector<SurfaceLine> sectionsOf(const Patch& patch,
                                    const std::function<double(const Vec3&)>& field,
                                    const std::vector<double>& levels,
                                    double chord) {
  std::vector<double> values;
  for (int i = 0; i <= cells; ++i) {
    for (int k = 0; k <= cells; ++k) {
      values.push_back(field(patch.at(patch.u0 + (patch.u1 - patch.u0) * i / cells,
                                      patch.v0 + (patch.v1 - patch.v0) * k / cells)));
    }
  }
  std::vector<SurfaceLine> sections;
  for (const double level : levels) {
    for (const std::vector<Place>& places : Contour(patch, field, level).run(values)) {
      SurfaceLine line;
      for (const Place& p : places) {
        line.push_back({patch.at(p.u, p.v), patch.normal(p.u, p.v), {p.u, p.v}});
      }
      if (line.size() < 2) {
        continue;
      }
      for (const SurfaceLine& piece : keptPieces(patch, line)) {
        appendToAndFro(sections, thinned(piece, chord));
      }
    }
  }
  return sections;
}

}  // namespace arelem::spray
