#include "runtime/motion/facets/upright_places.h"

#include <random>

#include <gtest/gtest.h>

#include "tests/unit/runtime/motion/facets/random_cutters.h"

// What an upright cutter touches first, against the heights of all triangles one by one.
namespace arelem::motion {
namespace {

/// A waved square from -2 to 2 about z = 0 whose corners are moved at random, with a hole where
/// `hole` triangles are missing; `turned`: it looks down.
surface::Mesh waved(Random& random, int side, double roughness, int hole, bool turned) {
  geometry::TriangleMesh mesh;
  for (int i = 0; i <= side; ++i) {
    for (int k = 0; k <= side; ++k) {
      const double x = (4.0 * i + random.in(0, 0.8)) / side - 2.0;
      const double y = (4.0 * k + random.in(0, 0.8)) / side - 2.0;
      mesh.vertices.emplace_back(
          x, y, 0.3 * std::sin(2 * x) * std::cos(1.5 * y) + random.in(0, roughness));
    }
  }
  const auto number = [&](int i, int k) { return static_cast<std::uint32_t>(i * (side + 1) + k); };
  for (int i = 0; i < side; ++i) {
    for (int k = 0; k < side; ++k) {
      mesh.triangles.push_back({number(i, k), number(i + 1, k), number(i + 1, k + 1)});
      mesh.triangles.push_back({number(i, k), number(i + 1, k + 1), number(i, k + 1)});
    }
  }
  const auto middle =
      mesh.triangles.begin() + static_cast<std::ptrdiff_t>(mesh.triangles.size() / 2);
  mesh.triangles.erase(middle, middle + hole);
  for (auto& t : mesh.triangles) {
    if (turned) {
      std::swap(t[0], t[1]);
    }
  }
  return surface::Mesh(std::make_shared<surface::MeshShape>(std::move(mesh)));
}

/// How many triangles are found at a place, in the middle.
double expectFirst(const FacetTask& task, const std::string& what) {
  const auto shape = tool::UprightProfile::of(*task.cutter, task.low);
  if (!shape) {
    ADD_FAILURE() << what << " does not stand upright";
    return 0.0;
  }
  const tool::UprightProfile& profile = *shape;
  const tool::UprightTouch touch(profile);
  const UprightFrame frame(task, profile);
  const auto places =
      UprightPlaces::of(task.mesh->shape(), profile, frame.bounds().radius(), task.section.up);
  std::vector<UprightPlaces::Found> found;
  const std::size_t count = task.mesh->shape().mesh.triangles.size();
  EXPECT_TRUE(places->find(task.section, {-0.5, 0.5}, count, found));
  std::size_t met = 0;
  constexpr int steps = 100;
  for (int i = 0; i < steps; ++i) {
    const double s = (i + 0.5) / steps - 0.5;
    double highest = -10.0;
    for (std::size_t k = 0; k < count; ++k) {
      const auto one = touch.of(frame.facetOf(k), s);
      highest = one ? std::max(highest, one->z) : highest;
    }
    double first = -10.0;
    for (const UprightPlaces::Found& f : found) {
      if (f.range.first <= s && s <= f.range.last) {
        const auto one = touch.of(frame.facetOf(f.triangle), s);
        first = one ? std::max(first, one->z) : first;
        ++met;
      }
    }
    EXPECT_NEAR(first, highest, 1e-12) << what << " at " << s;
  }
  return static_cast<double>(met) / steps;
}

TEST(UprightPlaces, WhatIsTouchedFirstIsFound) {
  Random random(5);
  for (const double roughness : {0.0, 0.01, 0.1}) {
    for (const int hole : {0, 5}) {
      for (const bool turned : {false, true}) {
        const surface::Mesh mesh = waved(random, 24, roughness, hole, turned);
        for (const auto& values : cutters) {
          for (const double low : {0.0, 0.01, -0.01}) {
            const tool::Profile cutter = *tool::makeProfile(values);
            FacetTask task{&mesh, &cutter, Vec3::UnitZ(), {}, low, low + 0.001};
            const double angle = random.in(0.0, 6.0);
            task.section = {Vec3(random.in(-1, 1), random.in(-1, 1), random.in(-1, 1)),
                            Vec3(std::cos(angle), std::sin(angle), 0.0), Vec3::UnitZ()};
            expectFirst(task,
                        fmt::format("roughness {} hole {} turned {} diameter {} radius {} low {}",
                                    roughness, hole, turned, cutter.d, cutter.r, low));
          }
        }
      }
    }
  }
}

TEST(UprightPlaces, OfAFineMeshOnlyFewTrianglesAreFound) {
  Random random(7);
  const surface::Mesh mesh = waved(random, 100, 0.0, 0, false);
  const tool::Profile ball = *tool::makeProfile(std::vector<double>{0.75, 0.375});
  const FacetTask task{
      &mesh, &ball, Vec3::UnitZ(), {Vec3(0.6, 0.3, 0.0), Vec3::UnitX(), Vec3::UnitZ()}, 0.0, 0.001};
  EXPECT_LT(expectFirst(task, "fine"), 60.0);
}

}  // namespace
}  // namespace arelem::motion
