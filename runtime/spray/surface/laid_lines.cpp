#include "runtime/spray/surface/laid_lines.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/LU>

#include "ir/diag/spray.h"
#include "ir/space/spray_tolerance.h"
#include "ir/space/tolerance.h"
#include "runtime/spray/surface/kept.h"
#include "runtime/spray/surface/past.h"
#include "runtime/spray/surface/patch_grid.h"
#include "runtime/spray/surface/section_planes.h"
#include "runtime/spray/surface/walls.h"

namespace arelem::spray {

namespace {
/// The job with the wide work in place of its own.
SurfaceJob widened(const SurfaceJob& job) {
  SurfaceJob wide = job;
  wide.patch = job.widePatch.value_or(job.patch);
  wide.mesh = job.wideMesh ? job.wideMesh : job.mesh;
  return wide;
}

class Layer {
 public:
  Layer(const SurfaceJob& job, double widest, const Walls* walls)
      : job_(widened(job)), widest_(widest), walls_(walls) {}

  Result<LaidLines> run() {
    if (auto failure =
            std::holds_alternative<SurfaceJob::Way>(job_.lines) ? parameterLines() : sections()) {
      return *std::move(failure);
    }
    if (job_.past > 0.0 && !laid_.lines.empty()) {
      addBeside();
      for (std::size_t i = 0; i < laid_.lines.size(); ++i) {
        goBeyond(i);
      }
    }
    return std::move(laid_);
  }

 private:
  [[nodiscard]] Failure tooFine(double points) const {
    return fail(diag::SprayPoints, points, job_.chord, job_.mostPoints)
        .withHelp("a larger CHORD needs fewer");
  }

  std::optional<Failure> parameterLines() {
    alongU_ = std::get<SurfaceJob::Way>(job_.lines) == SurfaceJob::Way::alongU;
    if (auto failure =
            objectionToLines(longestWay(job_.patch, !alongU_) / widest_, job_.mostLines)) {
      return failure;
    }
    const Layout layout = {alongU_, widest_, job_.chord, job_.mostPoints};
    const double points = pointsNeeded(job_.patch, layout);
    if (points > static_cast<double>(job_.mostPoints)) {
      return tooFine(points);
    }
    LineSet set = linesOn(job_.patch, layout);
    if (!set.complete) {
      return tooFine(points);
    }
    laid_.whole = std::move(set.lines);
    laid_.step = set.count.step;
    sides_ = !closesAlong(job_.patch, !alongU_);
    last_ = laid_.whole.size() - 1;
    // The lines of u or v between the planes of LIMITS.
    for (std::size_t i = 0; i < laid_.whole.size(); ++i) {
      for (SurfaceLine& piece : keptPieces(job_.patch, laid_.whole[i])) {
        add(std::move(piece), i);
      }
    }
    leaveOutShort();
    return std::nullopt;
  }

  void add(SurfaceLine line, std::size_t rank) {
    laid_.lines.push_back(std::move(line));
    laid_.ranks.push_back(rank);
  }

  /// Lines at a pole, a vertex or a corner: their nozzle goes far while their spray does not move.
  void leaveOutShort() {
    const double least = tolerance::shortestLine * job_.gun.footprint.across;
    LaidLines all;
    std::swap(all.lines, laid_.lines);
    std::swap(all.ranks, laid_.ranks);
    for (std::size_t n = 0; n < all.lines.size(); ++n) {
      const double length = lengthOf(all.lines[n]);
      if (length < least) {
        ++laid_.leftOut;
        laid_.shortest = std::min(laid_.shortest, length);
      } else {
        add(std::move(all.lines[n]), all.ranks[n]);
      }
    }
  }

  std::optional<Failure> sections() {
    std::optional<PatchGrid> grid;
    if (!job_.mesh) {
      Result<PatchGrid> made = PatchGrid::of(job_.patch, job_.chord, job_.mostPoints);
      if (!made) {
        return made.takeFailure();
      }
      grid = *std::move(made);
    }
    const auto cut = [&](const CuttingPlane& plane) {
      return job_.mesh ? job_.mesh->sections({plane}, job_.chord) : patchSections(*grid, plane);
    };
    Result<SectionPlanes> sections = sectionPlanes(job_, widest_);
    if (sections && !sections->closed) {
      const Tips tips = {isTip(cut(sections->planes.front())), isTip(cut(sections->planes.back()))};
      if (tips.low || tips.high) {
        sections = sectionPlanes(job_, widest_, tips);
      }
    }
    if (!sections) {
      return sections.takeFailure();
    }
    laid_.sections = *std::move(sections);
    laid_.step = laid_.sections.step;
    sides_ = !laid_.sections.closed;
    last_ = planes().size() - 1;
    for (std::size_t i = 0; i < planes().size(); ++i) {
      takeSections(cut(planes()[i]), i);
    }
    leaveOutShort();
    return std::nullopt;
  }

  [[nodiscard]] const std::vector<CuttingPlane>& planes() const { return laid_.sections.planes; }

  /// Whether an outermost section goes round a tip that it would paint as a spot.
  [[nodiscard]] bool isTip(const std::vector<SurfaceLine>& pieces) const {
    double length = 0.0;
    for (const SurfaceLine& piece : pieces) {
      length += lengthOf(piece);
      const auto meets = [&](const Vec3& end) {
        int ends = 0;
        for (const SurfaceLine& other : pieces) {
          for (const Vec3& place : {other.front().place, other.back().place}) {
            ends += (place - end).norm() <= tolerance::coincidence ? 1 : 0;
          }
        }
        return ends > 1;
      };
      if (!meets(piece.front().place) || !meets(piece.back().place) ||
          (!job_.mesh && onEdge(piece[piece.size() / 2], tolerance::edgeOfSection))) {
        return false;
      }
    }
    return length < std::numbers::pi * widest_;
  }

  [[nodiscard]] std::vector<SurfaceLine> patchSections(const PatchGrid& grid,
                                                       const CuttingPlane& plane) const {
    std::vector<SurfaceLine> all;
    for (const SurfaceLine& line : sectionOf(job_.patch, grid, plane, job_.chord)) {
      for (SurfaceLine& piece : onItsSide(line, plane)) {
        if (piece.size() < 2) {
          continue;
        }
        if (plane.half) {
          putOntoAxis(piece.front(), plane);
          putOntoAxis(piece.back(), plane);
        }
        all.push_back(std::move(piece));
      }
    }
    return all;
  }

  /// An end where the axis of radial planes cuts a chord goes to where it cuts the surface: by
  /// Newton's method from there.
  void putOntoAxis(LinePoint& end, const CuttingPlane& plane) const {
    constexpr int rounds = 8;
    const Patch& p = job_.patch;
    if (std::abs(plane.half->dot(end.place - plane.place)) > tolerance::coincidence) {
      return;
    }
    const auto off = [&](const Vec2& uv) {
      const Vec3 place = p.at(uv.x(), uv.y());
      return Vec2(plane.normal.dot(place) - plane.level, plane.half->dot(place - plane.place));
    };
    const Vec2 step = tolerance::normalStep * Vec2(p.u1 - p.u0, p.v1 - p.v0);
    Vec2 uv = end.uv;
    for (int i = 0; i < rounds; ++i) {
      Eigen::Matrix2d slope;
      slope.col(0) = (off(uv + Vec2(step.x(), 0.0)) - off(uv - Vec2(step.x(), 0.0))) / 2.0;
      slope.col(1) = (off(uv + Vec2(0.0, step.y())) - off(uv - Vec2(0.0, step.y()))) / 2.0;
      if (!(std::abs(slope.determinant()) > 0.0)) {
        break;
      }
      uv -= step.cwiseProduct(Vec2(slope.inverse() * off(uv)));
      uv = uv.cwiseMax(Vec2(p.u0, p.v0)).cwiseMin(Vec2(p.u1, p.v1)).eval();
    }
    const Vec3 place = p.at(uv.x(), uv.y());
    // Where the axis only touches the surface, what lies on it at the chord's end is near enough.
    const bool good = (place - end.place).norm() <= 4.0 * job_.chord;
    end.uv = good ? uv : end.uv;
    end.place = p.at(end.uv.x(), end.uv.y());
    end.normal = p.normal(end.uv.x(), end.uv.y());
  }

  void takeSections(std::vector<SurfaceLine> pieces, std::size_t rank) {
    for (SurfaceLine& piece : pieces) {
      appendToAndFro(laid_.lines, std::move(piece));
      laid_.ranks.push_back(rank);
    }
  }

  /// Where the side of a line lies that has no neighbor.
  [[nodiscard]] Vec3 outside(const SurfaceLine& line, bool first) const {
    if (!planes().empty()) {
      return first ? Vec3(-planes().front().normal) : planes().back().normal;
    }
    const Vec3& middle = line[line.size() / 2].place;
    const SurfaceLine& neighbor = laid_.whole[first ? 1 : last_ - 1];
    const auto nearest = std::min_element(
        neighbor.begin(), neighbor.end(), [&middle](const LinePoint& a, const LinePoint& b) {
          return (a.place - middle).squaredNorm() < (b.place - middle).squaredNorm();
        });
    return middle - nearest->place;
  }

  /// The first and the last section of a closed body lie at no edge.
  [[nodiscard]] bool runsAlongEdge(const SurfaceLine& line) const {
    if (planes().empty()) {
      return true;
    }
    if ((line.front().place - line.back().place).norm() > tolerance::coincidence) {
      return true;
    }
    return !job_.mesh && onEdge(line[line.size() / 2], tolerance::edgeOfSection);
  }

  /// Lines beside those at the edges, as long as their spray reaches the work.
  void addBeside() {
    const double width = job_.gun.footprint.across;
    const int more = static_cast<int>(std::ceil(std::min(job_.past, width) / laid_.step)) - 1;
    if (!sides_ || last_ == 0 || more < 1) {
      return;
    }
    LaidLines own;
    std::swap(own.lines, laid_.lines);
    std::swap(own.ranks, laid_.ranks);
    const auto copies = [&](int k, bool first) {
      for (std::size_t i = 0; i < own.lines.size(); ++i) {
        const SurfaceLine& line = own.lines[i];
        if (own.ranks[i] == (first ? 0 : last_) && lengthOf(line) >= width && runsAlongEdge(line)) {
          SurfaceLine copy = beside(line, k * laid_.step, outside(line, first));
          if (k % 2 == 1) {
            std::reverse(copy.begin(), copy.end());
          }
          add(std::move(copy), own.ranks[i]);
        }
      }
    };
    for (int k = more; k >= 1; --k) {
      copies(k, true);
    }
    for (std::size_t i = 0; i < own.lines.size(); ++i) {
      add(std::move(own.lines[i]), own.ranks[i]);
      own.lines[i] = laid_.lines.back();
    }
    for (int k = 1; k <= more; ++k) {
      copies(k, false);
    }
  }

  void goBeyond(std::size_t i) {
    Ends ends = job_.ends;
    if (!planes().empty() && planes()[laid_.ranks[i]].half) {
      const CuttingPlane& plane = planes()[laid_.ranks[i]];
      ends.push_back({*plane.half, plane.half->dot(plane.place)});
    }
    goPast(laid_.lines[i], {job_.past, job_.gun.standOff, walls_}, ends,
           [this](const LinePoint& end) { return job_.mesh || onEdge(end); });
  }

  /// Not where the surface only begins again, and not at a pole.
  [[nodiscard]] bool onEdge(const LinePoint& end, double share = tolerance::similarity) const {
    const Patch& p = job_.patch;
    const auto near = [share](double value, double limit, double from, double to) {
      return std::abs(value - limit) <= share * (to - from);
    };
    const bool atU = near(end.uv.x(), p.u0, p.u0, p.u1) || near(end.uv.x(), p.u1, p.u0, p.u1);
    const bool atV = near(end.uv.y(), p.v0, p.v0, p.v1) || near(end.uv.y(), p.v1, p.v0, p.v1);
    constexpr double aside = 0.37;
    const double dot = tolerance::shortestLine * job_.gun.footprint.across;
    const auto wide = [&](const Vec3& a, const Vec3& b) { return (a - b).norm() > dot; };
    const Vec2& uv = end.uv;
    return (atU && !closesAlong(p, true) &&
            wide(p.at(uv.x(), p.v0), p.at(uv.x(), p.v0 + aside * (p.v1 - p.v0)))) ||
           (atV && !closesAlong(p, false) &&
            wide(p.at(p.u0, uv.y()), p.at(p.u0 + aside * (p.u1 - p.u0), uv.y())));
  }

  const SurfaceJob job_;
  double widest_;
  const Walls* walls_;
  LaidLines laid_;
  bool alongU_ = true;
  bool sides_ = false;    // the first and the last line lie at edges
  std::size_t last_ = 0;  // rank
};

std::string textOf(const Vec3& p) {
  return fmt::format("({:.6g}, {:.6g}, {:.6g})", p.x(), p.y(), p.z());
}
}  // namespace

Result<LaidLines> layLines(const SurfaceJob& job, double widest, const Walls* walls) {
  return Layer(job, widest, walls).run();
}

std::optional<Failure> objectionToWalls(const std::vector<SurfaceLine>& lines,
                                        double standOff,
                                        const Walls& walls) {
  const double lift = tolerance::wallLift * standOff + walls.blur();
  const auto blocked = [standOff](const LinePoint& at, double distance) {
    return fail(diag::SurfaceBlocked, standOff, textOf(at.place), distance)
        .withHelp("a smaller stand-off, or REVERS for the other side; MINRAD, OFF sprays anyway");
  };
  if (lift >= standOff) {
    return std::nullopt;
  }
  for (const SurfaceLine& line : lines) {
    for (std::size_t i = 0; i < line.size(); ++i) {
      const Vec3 nozzle = line[i].place + standOff * line[i].normal;
      if (const auto way = walls.between(line[i].place + lift * line[i].normal, nozzle)) {
        return blocked(line[i], lift + *way);
      }
      const double clear = walls.from(nozzle);
      if (clear + walls.blur() < tolerance::wallClear * standOff) {
        return fail(diag::SurfaceBeside, standOff, textOf(line[i].place), clear,
                    tolerance::wallClear * standOff)
            .withHelp("planes of LIMITS keep the gun off the wall; MINRAD, OFF sprays anyway");
      }
      if (i > 0 && walls.between(line[i - 1].place + standOff * line[i - 1].normal, nozzle)) {
        return blocked(line[i], standOff);
      }
    }
  }
  return std::nullopt;
}

}  // namespace arelem::spray
