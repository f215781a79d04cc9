#include "runtime/geometry/mesh_file.h"

#include <cstring>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace arelem::geometry {
namespace {

using ::testing::HasSubstr;

/// A tetrahedron of volume 1/6, seen from outside counterclockwise.
constexpr std::string_view tetrahedronOff =
    "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n";

double volume(const TriangleMesh& mesh) {
  double sum = 0.0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    sum += mesh.corner(i, 0).dot(mesh.corner(i, 1).cross(mesh.corner(i, 2))) / 6.0;
  }
  return sum;
}

std::string stlText(const TriangleMesh& mesh) {
  std::string text = "solid made by a test\n";
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    text += "facet normal 0 0 0\n outer loop\n";
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& v = mesh.corner(i, k);
      text += fmt::format("  vertex {} {:e} {}\n", v.x(), v.y(), v.z());
    }
    text += " endloop\nendfacet\n";
  }
  return text + "endsolid made by a test\n";
}

std::string stlBinary(const TriangleMesh& mesh, std::string_view header = "solid or not") {
  std::string bytes(header);
  bytes.resize(80, ' ');
  const auto put = [&](auto value) {
    std::array<char, sizeof value> raw{};
    std::memcpy(raw.data(), &value, sizeof value);
    bytes.append(raw.data(), raw.size());
  };
  put(static_cast<std::uint32_t>(mesh.triangles.size()));
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    for (int c = 0; c < 3; ++c) {
      put(0.0F);
    }
    for (std::size_t k = 0; k < 3; ++k) {
      for (const double c : mesh.corner(i, k)) {
        put(static_cast<float>(c));
      }
    }
    put(std::uint16_t{0});
  }
  return bytes;
}

std::string refusal(std::string_view bytes, MeshFormat format) {
  Result<TriangleMesh> mesh = readMesh(bytes, format, "x");
  return mesh ? "" : mesh.takeFailure().message;
}

TEST(MeshFile, EveryFormatGivesTheSameTetrahedron) {
  const Result<TriangleMesh> off = readMesh(tetrahedronOff, MeshFormat::off, "x");
  ASSERT_TRUE(off.ok());
  EXPECT_EQ(off->vertices.size(), 4U);
  EXPECT_EQ(off->triangles.size(), 4U);
  EXPECT_NEAR(volume(*off), 1.0 / 6.0, 1e-15);
  EXPECT_EQ(openEdges(*off), 0U);
  const std::string obj =
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty "
      "float z\nelement face 4\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 "
      "0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n";
  const std::vector<std::pair<std::string, MeshFormat>> files = {
      {obj, MeshFormat::obj},
      {ply, MeshFormat::ply},
      {stlText(*off), MeshFormat::stl},
      {stlBinary(*off), MeshFormat::stl}};
  for (const auto& [bytes, format] : files) {
    const Result<TriangleMesh> mesh = readMesh(bytes, format, "x");
    ASSERT_TRUE(mesh.ok()) << spell(format);
    EXPECT_EQ(mesh->vertices.size(), 4U) << spell(format);
    EXPECT_NEAR(volume(*mesh), 1.0 / 6.0, 1e-15) << spell(format);
    EXPECT_EQ(openEdges(*mesh), 0U) << spell(format);
  }
}

TEST(MeshFile, PolygonsAreCutIntoTriangles) {
  const Result<TriangleMesh> square =
      readMesh("OFF\n4 1 0\n0 0 0\n2 0 0\n2 2 0\n0 2 0\n4 0 1 2 3\n", MeshFormat::off, "x");
  ASSERT_TRUE(square.ok());
  EXPECT_EQ(square->triangles.size(), 2U);
  EXPECT_EQ(openEdges(*square), 4U);
}

TEST(MeshFile, CanonicalFormGoesBothWays) {
  const Result<TriangleMesh> mesh = readMesh(tetrahedronOff, MeshFormat::off, "x");
  ASSERT_TRUE(mesh.ok());
  const auto canon = mesh->canon();
  EXPECT_EQ(canon.size(), 2U + 3U * 4U + 3U * 4U);
  const Result<TriangleMesh> again = meshOfCanon(canon);
  ASSERT_TRUE(again.ok());
  EXPECT_EQ(again->vertices, mesh->vertices);
  EXPECT_EQ(again->triangles, mesh->triangles);
  auto wrong = canon;
  wrong.back() = 5.0;  // there are four vertices
  EXPECT_FALSE(meshOfCanon(wrong).ok());
  wrong.pop_back();
  EXPECT_FALSE(meshOfCanon(wrong).ok());
}

TEST(MeshFile, WhatIsWrongIsNamed) {
  const Result<TriangleMesh> mesh = readMesh(tetrahedronOff, MeshFormat::off, "x");
  std::string cut = stlBinary(*mesh, "binary");
  cut.resize(cut.size() - 1);
  EXPECT_THAT(refusal(cut, MeshFormat::stl), HasSubstr("announces 4 triangles, which need 284"));
  EXPECT_THAT(refusal("", MeshFormat::stl), HasSubstr("it has 0 bytes"));
  EXPECT_THAT(refusal("solid\nfacet normal 0 0 1\nouter loop\nvertex 1 2 x\n", MeshFormat::stl),
              HasSubstr("line 4 has `x` where `a number` is needed"));
  EXPECT_THAT(refusal("solid a\nendsolid a\n", MeshFormat::stl), HasSubstr("no triangle"));
  for (const MeshFormat format : {MeshFormat::obj, MeshFormat::ply, MeshFormat::off}) {
    EXPECT_NE(refusal("", format), "") << spell(format);
    EXPECT_NE(refusal(std::string(300, '\xff'), format), "") << spell(format);
    EXPECT_NE(refusal("PARTNO A PROGRAM\nFINI\n", format), "") << spell(format);
  }
  EXPECT_THAT(refusal("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n", MeshFormat::off),
              HasSubstr("line 6: a face names vertex 7; there are 0 to 2"));
  EXPECT_THAT(refusal("OFF\n999999999 1 0\n0 0 0\n", MeshFormat::off),
              HasSubstr("announces 999999999 vertices and 1 faces; it ends behind 1 of"));
  EXPECT_THAT(refusal("OFF\n3 1 0\n0 0 0\n1 0 0\nnan 1 0\n3 0 1 2\n", MeshFormat::off),
              HasSubstr("finite number"));
  EXPECT_THAT(refusal("# two\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2/7 9\n", MeshFormat::obj),
              HasSubstr("line 5: a face names vertex 9; there are 1 to 3"));
  EXPECT_THAT(refusal("v 0 0 0\nv 1 0\nv 0 1 0\nf 1 2 3\n", MeshFormat::obj),
              HasSubstr("line 2: a vertex has 2 coordinates; it needs 3"));
  EXPECT_THAT(refusal("ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float "
                      "y\nproperty float z\nelement face 1\nproperty list uchar int "
                      "vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 5\n",
                      MeshFormat::ply),
              HasSubstr("line 13: a face names vertex 5; there are 0 to 2"));
  EXPECT_THAT(refusal("OFF\n3 1 0\n0 0 0\n1 0 0\n2 0 0\n3 0 1 2\n", MeshFormat::off),
              HasSubstr("no triangle with an area"));
}

TEST(MeshFile, SurfacesOnly) {
  // Three leaves at one edge.
  EXPECT_THAT(refusal("OFF\n5 3 0\n0 0 0\n0 0 1\n1 0 0\n0 1 0\n-1 0 0\n3 0 1 2\n3 1 0 3\n3 0 1 4\n",
                      MeshFormat::off),
              HasSubstr("3 triangles meet"));
  // Two triangles of which one is turned over.
  EXPECT_THAT(
      refusal("OFF\n4 2 0\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n3 0 1 2\n3 1 2 3\n", MeshFormat::off),
      HasSubstr("turned against each other"));
}

}  // namespace
}  // namespace arelem::geometry
