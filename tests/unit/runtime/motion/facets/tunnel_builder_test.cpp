#include "runtime/motion/facets/tunnel_builder.h"

#include <gtest/gtest.h>

#include "runtime/tool/mesh_contact.h"
#include "tests/unit/runtime/motion/facets/random_cutters.h"

// The tunnel of a tolerance along facets, against the gaps to all triangles one by one.
namespace arelem::motion {
namespace {

/// A rough square from -2 to 2 about z = 0, as a soup: neighbors do not share corners, and one of
/// `holes` triangles is left out.
surface::Mesh rough(Random& random, int side, double roughness, int holes) {
  geometry::TriangleMesh mesh;
  std::vector<Vec3> corners;
  for (int i = 0; i <= side; ++i) {
    for (int k = 0; k <= side; ++k) {
      const double x = 4.0 * i / side - 2.0;
      const double y = 4.0 * k / side - 2.0;
      corners.emplace_back(x, y, 0.3 * std::sin(2 * x) * std::cos(y) + random.in(0, roughness));
    }
  }
  const auto add = [&](int i0, int k0, int i1, int k1, int i2, int k2) {
    if (holes > 0 && random.in(0, holes) < 1.0) {
      return;
    }
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (const auto& [i, k] : {std::pair{i0, k0}, {i1, k1}, {i2, k2}}) {
      mesh.vertices.push_back(corners[static_cast<std::size_t>(i * (side + 1) + k)]);
    }
    mesh.triangles.push_back({first, first + 1, first + 2});
  };
  for (int i = 0; i < side; ++i) {
    for (int k = 0; k < side; ++k) {
      add(i, k, i + 1, k, i + 1, k + 1);
      add(i, k, i + 1, k + 1, i, k + 1);
    }
  }
  return surface::Mesh(std::make_shared<surface::MeshShape>(std::move(mesh)));
}

double leastOfAll(const FacetTask& task, const SectionPoint& p) {
  const surface::MeshShape& shape = task.mesh->shape();
  const tool::TriangleCutter body(tool::Body(*task.cutter), task.section.at(p), task.axis);
  double least = 1e9;
  for (std::size_t i = 0; i < shape.mesh.triangles.size(); ++i) {
    least = std::min(least, body.gapTo(shape.mesh, i).gap);
  }
  return least;
}

/// A place above the mesh at which the least gap is in the middle of the band.
SectionPoint startOf(const FacetTask& task) {
  double low = -1.0;
  double high = 3.0;
  for (int i = 0; i < 60; ++i) {
    const double z = 0.5 * (low + high);
    (leastOfAll(task, {0.0, z}) < 0.5 * (task.low + task.high) ? low : high) = z;
  }
  return {0.0, high};
}

/// Everything in the tunnel keeps the tolerance, and little that keeps it is outside.
void expectTolerance(const FacetTask& task, const std::string& what) {
  const double band = task.high - task.low;
  TunnelBuilder builder(task, std::sqrt(8.0 * 0.4 * band));
  ASSERT_TRUE(builder.begin(startOf(task))) << what;
  while (builder.tunnel().end() < 0.6 && builder.extend()) {
  }
  const Tunnel& tunnel = builder.tunnel();
  int narrow = 0;
  constexpr int places = 25;
  for (int i = 0; i <= places; ++i) {
    const double s = std::min(tunnel.end(), 0.6) * i / places;
    const double bottom = tunnel.bottomAt(s);
    const double top = tunnel.topAt(s);
    EXPECT_LT(bottom, top) << what << " at " << s;
    for (const double z : {bottom, 0.5 * (bottom + top), top}) {
      const double gap = leastOfAll(task, {s, z});
      EXPECT_GE(gap, task.low - 1e-9) << what << " at " << s;
      EXPECT_LE(gap, task.high + 1e-9) << what << " at " << s;
    }
    narrow += leastOfAll(task, {s, top}) - leastOfAll(task, {s, bottom}) < 0.8 * band ? 1 : 0;
  }
  EXPECT_LE(narrow, 2) << what;
}

TEST(TunnelBuilder, TheTunnelIsTheToleranceOfAllTriangles) {
  Random random(3);
  for (const double roughness : {0.0, 0.02}) {
    for (const int holes : {0, 12}) {
      const surface::Mesh mesh = rough(random, 16, roughness, holes);
      for (const auto& values : cutters) {
        const tool::Profile cutter = *tool::makeProfile(values);
        FacetTask task{&mesh, &cutter, Vec3::UnitZ(), {}, 0.0, 0.001};
        const double angle = random.in(0.0, 6.0);
        task.section = {Vec3(random.in(-1, 1), random.in(-1, 1), 0.0),
                        Vec3(std::cos(angle), std::sin(angle), 0.0), Vec3::UnitZ()};
        expectTolerance(task, fmt::format("roughness {} holes {} diameter {} radius {}", roughness,
                                          holes, cutter.d, cutter.r));
      }
    }
  }
}

TEST(TunnelBuilder, ThicknessAndInnerToleranceMoveTheTunnel) {
  Random random(9);
  const surface::Mesh mesh = rough(random, 16, 0.01, 0);
  for (const auto& values : cutters) {
    const tool::Profile cutter = *tool::makeProfile(values);
    for (const auto& [low, high] : {std::pair{-0.002, 0.0}, {-0.0005, 0.0005}, {0.05, 0.051}}) {
      const FacetTask task{&mesh,         &cutter,
                           Vec3::UnitZ(), {Vec3(-0.5, 0.3, 0.0), Vec3::UnitX(), Vec3::UnitZ()},
                           low,           high};
      expectTolerance(task, fmt::format("from {} to {} radius {}", low, high, cutter.r));
    }
  }
}

TEST(TunnelBuilder, ALeaningAxisHasItsTunnelToo) {
  Random random(12);
  const surface::Mesh mesh = rough(random, 16, 0.01, 0);
  for (const auto& values : cutters) {
    const tool::Profile cutter = *tool::makeProfile(values);
    const FacetTask task{&mesh,
                         &cutter,
                         Vec3(0.2, -0.3, 1.0).normalized(),
                         {Vec3(-0.2, 0.1, 0.0), Vec3::UnitX(), Vec3::UnitZ()},
                         0.0,
                         0.001};
    expectTolerance(task, fmt::format("leaning, radius {}", cutter.r));
  }
}

/// The same scene, turned and moved.
FacetTask movedTask(const FacetTask& task,
                    const surface::Mesh& mesh,
                    const Eigen::Matrix3d& turn,
                    const Vec3& move) {
  FacetTask moved = task;
  moved.mesh = &mesh;
  moved.axis = turn * task.axis;
  moved.section = {turn * task.section.origin + move, turn * task.section.along,
                   turn * task.section.up};
  return moved;
}

TEST(TunnelBuilder, ATurnedSceneHasTheSameTunnel) {
  Random random(15);
  const surface::Mesh mesh = rough(random, 16, 0.01, 0);
  const Vec3 around = Vec3(0.3, -0.8, 0.5).normalized();
  for (const Eigen::Matrix3d& turn : {Eigen::AngleAxisd(0.7, Vec3::UnitZ()).toRotationMatrix(),
                                      Eigen::AngleAxisd(1.1, around).toRotationMatrix()}) {
    const Vec3 move(10.0, -20.0, 5.0);
    geometry::TriangleMesh other = mesh.shape().mesh;
    for (Vec3& v : other.vertices) {
      v = turn * v + move;
    }
    const surface::Mesh turned(std::make_shared<surface::MeshShape>(std::move(other)));
    for (const auto& values : cutters) {
      const tool::Profile cutter = *tool::makeProfile(values);
      const FacetTask task{&mesh,         &cutter,
                           Vec3::UnitZ(), {Vec3(-0.5, 0.3, 0.0), Vec3::UnitX(), Vec3::UnitZ()},
                           0.0,           0.001};
      TunnelBuilder first(task, 0.05);
      TunnelBuilder second(movedTask(task, turned, turn, move), 0.05);
      const SectionPoint start = startOf(task);
      ASSERT_TRUE(first.begin(start));
      ASSERT_TRUE(second.begin(start));
      while (first.tunnel().end() < 0.5 && first.extend()) {
      }
      while (second.tunnel().end() < 0.5 && second.extend()) {
      }
      const double end = std::min(first.tunnel().end(), second.tunnel().end());
      EXPECT_GT(end, 0.2);
      for (int i = 0; i <= 20; ++i) {
        // Cells may be divided elsewhere: within what corners and spare take of the band.
        const double s = end * i / 20;
        EXPECT_NEAR(first.tunnel().bottomAt(s), second.tunnel().bottomAt(s), 1e-4);
        EXPECT_NEAR(first.tunnel().topAt(s), second.tunnel().topAt(s), 1e-4);
      }
    }
  }
}

TEST(TunnelBuilder, TheTunnelEndsAtAWall) {
  // A floor from -4 to 4, and a wall across it at x = 1: a flat cutter of radius 0.5 comes to 0.5.
  geometry::TriangleMesh mesh;
  mesh.vertices = {{-4, -4, 0}, {4, -4, 0}, {4, 4, 0}, {-4, 4, 0},
                   {1, -4, 0},  {1, 4, 0},  {1, 4, 3}, {1, -4, 3}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {4, 6, 5}, {4, 7, 6}};
  const surface::Mesh walled(std::make_shared<surface::MeshShape>(std::move(mesh)));
  const tool::Profile cutter = *tool::makeProfile(std::vector<double>{1.0, 0.0});
  const FacetTask task{&walled, &cutter, Vec3::UnitZ(), {}, 0.0, 0.001};
  TunnelBuilder builder(task, 0.06);
  ASSERT_TRUE(builder.begin({0.0, 0.0005}));
  for (int i = 0; i < 10000 && builder.extend(); ++i) {
  }
  EXPECT_LE(builder.tunnel().end(), 0.5 + 1e-9);
  EXPECT_GE(builder.tunnel().end(), 0.499);
}

}  // namespace
}  // namespace arelem::motion
