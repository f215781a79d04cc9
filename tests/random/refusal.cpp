#include "tests/random/refusal.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "runtime/motion/field.h"

namespace arelem::scenes {

namespace {
using motion::Field;
using surface::AnySurface;

/// Where programs start, and the plane x of their startups.
const Vec3 from(-7.15, 2.55, 6.25);
constexpr double startPlane = -4.25;

/// The grid of places for a startup reaches so far from the axis of x, in these steps.
constexpr double gridReach = 12.0;
constexpr double gridStep = 0.5;
/// Steps along a motion: length, number, and the shortest one where it gets stuck.
constexpr double stride = 0.05;
constexpr int strides = 1500;
constexpr double shortest = 1e-3;
/// A path that is so far away does not come back.
constexpr double outside = 60.0;
/// Gaps smaller than this are closed.
constexpr double closed = 1e-9;

std::optional<AnySurface> surfaceNamed(const Work& work, std::string_view name) {
  const EntityPtr entity = work.entity(name);
  if (!entity) {
    return std::nullopt;
  }
  auto found = surface::surfaceOf(*entity);
  return found ? std::optional<AnySurface>(*found) : std::nullopt;
}

/// The mean normal of a mesh; zero for other shapes.
Vec3 faceOf(const Shape& shape) {
  Vec3 sum = Vec3::Zero();
  if (const auto* mesh = std::get_if<MeshShape>(&shape)) {
    for (const std::array<Vec3, 3>& t : mesh->triangles) {
      sum += (t[1] - t[0]).cross(t[2] - t[0]);
    }
    sum.normalize();
  }
  return sum;
}

/// The two gaps that guide the tool, and those to the check surface.
class Guides {
 public:
  static std::optional<Guides> of(const Scene& scene, const Work& work) {
    const auto part = surfaceNamed(work, "PS1"), drive = surfaceNamed(work, "DS1"),
               check = surfaceNamed(work, "CS1");
    auto cutter = tool::makeProfile(scene.cutter);
    if (!part || !drive || !check || !cutter) {
      return std::nullopt;
    }
    return Guides(scene, *part, *drive, *check, *cutter);
  }

  /// Gaps and normals of drive and part surface at a tool end.
  [[nodiscard]] std::array<tool::Contact, 2> at(const Vec3& toolEnd) {
    return {drive_->at(toolEnd, Vec3::UnitZ()), part_->at(toolEnd, Vec3::UnitZ())};
  }
  /// True where the tool is beside a mesh, over its border: motions end there.
  [[nodiscard]] bool isBesideMesh(const Vec3& toolEnd) {
    constexpr double beside = 0.01;
    const auto [drive, part] = at(toolEnd);
    return (!driveFace_.isZero(0.0) && drive.normal.dot(driveFace_) <= beside) ||
           (!partFace_.isZero(0.0) && part.normal.dot(partFace_) <= beside);
  }
  /// Positive where the tool is clear of the check surface; for ON the distance of the tool end.
  [[nodiscard]] double clear(const Vec3& toolEnd) {
    const double plus = plus_->at(toolEnd, Vec3::UnitZ()).gap;
    return on_ ? plus : std::max(plus, minus_->at(toolEnd, Vec3::UnitZ()).gap);
  }
  [[nodiscard]] bool on() const { return on_; }

 private:
  Guides(const Scene& scene,
         const AnySurface& part,
         const AnySurface& drive,
         const AnySurface& check,
         const tool::Profile& cutter)
      : cutter_(std::make_unique<tool::Profile>(cutter)), on_(scene.stop == "ON") {
    const Vec3 middle = from + Vec3(0, 0, 0.5 * cutter.h);
    const auto sideOf = [&](const AnySurface& s) {
      return motion::footOn(s, middle).distance < 0.0 ? -1.0 : 1.0;
    };
    const auto tool = [&](bool on, double thick) {
      return motion::Tool{on ? nullptr : cutter_.get(), on ? 0.0 : thick};
    };
    const double past = scene.hand == Hand::right ? -1.0 : 1.0;
    driveFace_ = past * sideOf(drive) * faceOf(scene.drive);
    partFace_ = sideOf(part) * faceOf(scene.part);
    drive_ = makeField(drive, past * sideOf(drive), tool(scene.hand == Hand::on, scene.thick[1]));
    part_ = makeField(part, sideOf(part), tool(scene.onPart, scene.thick[0]));
    plus_ = makeField(check, 1.0, tool(on_, scene.thick[2]));
    minus_ = makeField(check, -1.0, tool(on_, scene.thick[2]));
  }

  std::unique_ptr<tool::Profile> cutter_;
  std::unique_ptr<Field> drive_, part_, plus_, minus_;
  Vec3 driveFace_, partFace_;  ///< of meshes: their normals on the tool's side
  bool on_;
};

/// Newton to where both gaps are closed, by the shortest steps square to `held`.
std::optional<Vec3> onto(Guides& guides, Vec3 place, const Vec3& held) {
  constexpr int most = 25;
  constexpr double longest = 0.5;
  for (int i = 0; i < most; ++i) {
    const auto [drive, part] = guides.at(place);
    if (std::max(std::abs(drive.gap), std::abs(part.gap)) < closed) {
      return place;
    }
    Eigen::Matrix<double, 2, 3> slopes;
    slopes.row(0) = (drive.normal - drive.normal.dot(held) * held).transpose();
    slopes.row(1) = (part.normal - part.normal.dot(held) * held).transpose();
    const Eigen::Matrix2d square = slopes * slopes.transpose();
    if (!(std::abs(square.determinant()) > 1e-8)) {
      return std::nullopt;
    }
    Vec3 step = -slopes.transpose() * square.inverse() * Eigen::Vector2d(drive.gap, part.gap);
    step *= std::min(1.0, longest / std::max(step.norm(), longest));
    place += step;
  }
  return std::nullopt;
}

Review reviewStartup(Guides& guides) {
  for (double y = -gridReach; y <= gridReach; y += gridStep) {
    for (double z = -gridReach; z <= gridReach; z += gridStep) {
      const Vec3 place(startPlane, y, z);
      const auto [drive, part] = guides.at(place);
      if (std::max(std::abs(drive.gap), std::abs(part.gap)) > gridStep) {
        continue;
      }
      if (const auto found = onto(guides, place, Vec3::UnitX())) {
        return {false, fmt::format("the tool does touch all of them at ({:.6g}, {:.6g}, {:.6g})",
                                   found->x(), found->y(), found->z())};
      }
    }
  }
  return {true, ""};
}

/// Goes along the path in short steps. Tells each place; false ends the walk.
enum class Ending : std::uint8_t { away, round, stuck, told };
template <class Tell>
Ending walk(Guides& guides, const Vec3& start, const Tell& tell) {
  Vec3 place = start, direction = Vec3::UnitX();
  double length = stride;
  for (int i = 0; i < strides; ++i) {
    const auto [drive, part] = guides.at(place);
    Vec3 tangent = drive.normal.cross(part.normal);
    if (!(tangent.norm() > 1e-4)) {
      return Ending::stuck;
    }
    tangent *= (tangent.dot(direction) < 0.0 ? -1.0 : 1.0) / tangent.norm();
    const auto next = onto(guides, place + length * tangent, tangent);
    if (!next || (*next - place).norm() > 2.0 * length) {
      length *= 0.5;
      if (length < shortest) {
        return Ending::stuck;
      }
      continue;
    }
    direction = (*next - place).normalized();
    place = *next;
    length = std::min(stride, 2.0 * length);
    if (!tell(place)) {
      return Ending::told;
    }
    if (place.norm() > outside) {
      return Ending::away;
    }
    if (i > 4 && (place - start).norm() < stride) {
      return Ending::round;
    }
  }
  return Ending::stuck;
}

/// `lost`: the motion says that it cannot go on; else that it goes on and meets nothing.
Review reviewMotion(Guides& guides, const Scene& scene, const Vec3& start, bool lost) {
  // Positions are the zeros of the clearance: entering is TO, leaving PAST; any is ON.
  double before = guides.clear(start);
  const bool remote = before > 0.0;
  std::optional<Vec3> met;
  const int wanted = guides.on() ? 1 : (scene.stop == "TO") == remote ? 1 : 2;
  int seen = 0;
  bool over = false;
  const Ending ending = walk(guides, start, [&](const Vec3& place) {
    const double now = guides.clear(place);
    seen += (now > 0.0) != (before > 0.0) ? 1 : 0;
    before = now;
    if (seen >= wanted) {
      met = place;
    }
    over = guides.isBesideMesh(place);
    return !met && !over;
  });
  if (met) {
    return {false, fmt::format("the path does meet the check surface near ({:.6g}, {:.6g}, {:.6g})",
                               met->x(), met->y(), met->z())};
  }
  return {(over || ending == Ending::stuck) == lost, ""};
}
}  // namespace

Review review(const Scene& scene, const Work& work, const Motion& refused) {
  const bool plain = scene.axis == AxisWord::fixed && !scene.ring && scene.extra == Extra::none;
  if (!plain) {
    return {};
  }
  const std::string code = refused.outcome();
  const bool startup = code == "E0510" || code == "E0521" || code == "E0544";
  const bool motion = code == "E0508" || code == "E0512";
  auto guides = startup || motion ? Guides::of(scene, work) : std::nullopt;
  if (!guides) {
    return {};
  }
  constexpr std::size_t startupRun = 1;
  if (motion) {
    return refused.runs.size() > startupRun
               ? reviewMotion(*guides, scene, refused.runs[startupRun].places.back(),
                              code == "E0512")
               : Review{};
  }
  return refused.runs.size() > startupRun ? Review{} : reviewStartup(*guides);
}

}  // namespace arelem::scenes
