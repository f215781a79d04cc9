#include "runtime/spray/surface/patch_grid.h"

#include <algorithm>

#include "ir/diag/spray.h"

namespace arelem::spray {

namespace {
constexpr std::size_t fewestSteps = 160;
constexpr int deepest = 16;  // halvings of a step
constexpr int lines = 17;    // of the other parameter that are looked at

/// Nodes of one parameter.
class Nodes {
 public:
  Nodes(const Patch& patch, bool ofU, double chord, std::uint64_t most)
      : patch_(patch), ofU_(ofU), chord_(chord), most_(most) {}

  std::vector<double> run() {
    const double from = ofU_ ? patch_.u0 : patch_.v0;
    const double to = ofU_ ? patch_.u1 : patch_.v1;
    nodes_ = {from};
    for (std::size_t i = 0; i < fewestSteps; ++i) {
      const auto at = [&](std::size_t k) {
        return from + (to - from) * static_cast<double>(k) / fewestSteps;
      };
      divide(at(i), at(i + 1), deepest);
    }
    return std::move(nodes_);
  }

 private:
  void divide(double from, double to, int depth) {
    if (nodes_.size() > most_) {
      return;  // told when all are counted
    }
    const double middle = (from + to) / 2.0;
    if (depth > 0 && bends(from, middle, to)) {
      divide(from, middle, depth - 1);
      divide(middle, to, depth - 1);
      return;
    }
    nodes_.push_back(to);
  }

  [[nodiscard]] bool bends(double from, double middle, double to) const {
    for (int k = 0; k < lines; ++k) {
      const auto at = [&](double t) {
        const double share = k / (lines - 1.0);
        return ofU_ ? patch_.at(t, patch_.v0 + share * (patch_.v1 - patch_.v0))
                    : patch_.at(patch_.u0 + share * (patch_.u1 - patch_.u0), t);
      };
      if (((at(from) + at(to)) / 2.0 - at(middle)).norm() > chord_) {
        return true;
      }
    }
    return false;
  }

  const Patch& patch_;
  bool ofU_;
  double chord_;
  std::uint64_t most_;
  std::vector<double> nodes_;
};
}  // namespace

Result<PatchGrid> PatchGrid::of(const Patch& patch, double chord, std::uint64_t most) {
  PatchGrid grid;
  grid.u_ = Nodes(patch, true, chord, most / fewestSteps).run();
  grid.v_ = Nodes(patch, false, chord, most / fewestSteps).run();
  const double nodes = static_cast<double>(grid.u_.size()) * static_cast<double>(grid.v_.size());
  if (nodes > static_cast<double>(most)) {
    return fail(diag::SprayPoints, nodes, chord, most).withHelp("a larger CHORD needs fewer");
  }
  grid.places_.reserve(grid.u_.size() * grid.v_.size());
  for (const double u : grid.u_) {
    for (const double v : grid.v_) {
      grid.places_.push_back(patch.at(u, v));
    }
  }
  return grid;
}

}  // namespace arelem::spray
