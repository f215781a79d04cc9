// Meshes from files of every kind, whole and damaged.
#include <cmath>
#include <cstring>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runtime/mesh/mesh.h"

namespace arelem::mesh {
namespace {

using testing::HasSubstr;

/// A square of two triangles, 4 by 4.
template <class Number>
void put(std::string& bytes, Number value, bool swapped = false) {
  char raw[sizeof value];
  std::memcpy(raw, &value, sizeof value);
  if (swapped) {
    std::reverse(std::begin(raw), std::end(raw));
  }
  bytes.append(raw, sizeof value);
}

std::string binaryStl() {
  std::string bytes(80, ' ');
  bytes.replace(0, 12, "solid but no");  // as some programs write it
  put(bytes, std::uint32_t{2});
  const float corners[2][3][3] = {{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}},
                                  {{0, 0, 0}, {4, 4, 0}, {0, 4, 0}}};
  for (const auto& triangle : corners) {
    for (const float n : {0.0F, 0.0F, 1.0F}) {
      put(bytes, n);
    }
    for (const auto& corner : triangle) {
      for (const float x : corner) {
        put(bytes, x);
      }
    }
    put(bytes, std::uint16_t{0});
  }
  return bytes;
}

std::string binaryPly(bool big) {
  std::string bytes = std::string("ply\nformat binary_") + (big ? "big" : "little") +
                      "_endian 1.0\nelement vertex 4\nproperty double x\nproperty float y\n"
                      "property short z\nproperty uchar red\nelement face 1\n"
                      "property list uchar uint vertex_index\nend_header\n";
  for (const auto& [x, y] : {std::pair{0, 0}, {4, 0}, {4, 4}, {0, 4}}) {
    put(bytes, static_cast<double>(x), big);
    put(bytes, static_cast<float>(y), big);
    put(bytes, std::int16_t{-7}, big);
    bytes += '\xff';
  }
  bytes += '\x04';
  for (const std::uint32_t i : {0U, 1U, 2U, 3U}) {
    put(bytes, i, big);
  }
  return bytes;
}

double areaOf(const Mesh& mesh) {
  double twice = 0.0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    twice += mesh.spanned(t).z();
  }
  return twice / 2.0;
}

TEST(ReadMesh, BinaryFiles) {
  for (const auto& [bytes, format] : {std::pair{binaryStl(), Format::stl},
                                      {binaryPly(false), Format::ply},
                                      {binaryPly(true), Format::ply}}) {
    const Result<Mesh> mesh = readMesh(bytes, format, "a");
    ASSERT_TRUE(mesh.ok()) << mesh.failure().message;
    EXPECT_EQ(mesh->corners.size(), 4U);
    EXPECT_EQ(mesh->triangles.size(), 2U);
    EXPECT_DOUBLE_EQ(areaOf(*mesh), 16.0);
    EXPECT_EQ(mesh->corners[2].z(), format == Format::ply ? -7.0 : 0.0);
    for (std::size_t cut = 0; cut + 1 < bytes.size(); cut += 7) {
      EXPECT_FALSE(readMesh(bytes.substr(0, cut), format, "a").ok()) << cut;
    }
  }
}

TEST(ReadMesh, TextsSayTheLineOfWhatIsWrong) {
  const auto message = [](std::string_view text, Format format) {
    const Result<Mesh> mesh = readMesh(text, format, "a");
    return mesh ? std::string("good") : mesh.failure().message;
  };
  EXPECT_THAT(message("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 x\n3 0 1 2\n", Format::off),
              HasSubstr("line 5"));
  EXPECT_THAT(message("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", Format::off),
              HasSubstr("line 6: a face names corner 3, there are 3"));
  EXPECT_THAT(message("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1\n", Format::off),
              HasSubstr("line 6"));
  EXPECT_THAT(message("OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", Format::off),
              HasSubstr("ends after 4 of 5"));
  EXPECT_THAT(message("OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n4 4\n", Format::off),
              HasSubstr("goes on"));
  EXPECT_THAT(message("OFF\n99999999999 1 0\n", Format::off), HasSubstr("ends after 0"));
  EXPECT_THAT(message("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n", Format::obj), HasSubstr("line 4"));
  EXPECT_THAT(message("v 0 0 0\nv 1 0 inf\n", Format::obj), HasSubstr("line 2"));
  EXPECT_THAT(message("v 0 0 0\ncurv 0 1 1 2\n", Format::obj), HasSubstr("`curv` is not read"));
  EXPECT_THAT(message("v 0 0 0\nv 1 0 0\nf 1 2\n", Format::obj), HasSubstr("2 corners"));
  EXPECT_THAT(message("solid a\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1\n", Format::stl),
              HasSubstr("line 5"));
  EXPECT_THAT(message("solid a\nouter loop\nvertex 0 0 0\n", Format::stl),
              HasSubstr("inside a loop"));
  EXPECT_THAT(message("solid a\nendsolid a\n", Format::stl), HasSubstr("no triangle"));
  EXPECT_THAT(message("ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nend_header\n1\n",
                      Format::ply),
              HasSubstr("ends among its 2 vertex"));
  EXPECT_THAT(
      message("ply\nformat ascii 1.0\nelement vertex 9000000000\nend_header\n", Format::ply),
      HasSubstr("no properties"));
  EXPECT_THAT(message("ply\nformat text 1.0\n", Format::ply), HasSubstr("line 2"));
  EXPECT_THAT(message("", Format::ply), HasSubstr("first line"));
}

TEST(ReadMesh, CornersCountBackInObjAndTrianglesWithoutAreaAreLeftOut) {
  const Result<Mesh> mesh =
      readMesh("v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\nvn 0 0 1\nf -4//1 -3//1 -2//1 -1//1\nf 1 1 2\n",
               Format::obj, "a");
  ASSERT_TRUE(mesh.ok()) << mesh.failure().message;
  EXPECT_EQ(mesh->triangles.size(), 2U);
  EXPECT_DOUBLE_EQ(areaOf(*mesh), 16.0);
}

TEST(Mesh, IsItsCanonAgain) {
  const Mesh mesh = *readMesh(binaryStl(), Format::stl, "a");
  const std::vector<double> canon = mesh.canon();
  ASSERT_TRUE(Mesh::readable(canon));
  EXPECT_EQ(Mesh::of(canon).canon(), canon);
  std::vector<double> bad = canon;
  bad.back() = 4.0;
  EXPECT_FALSE(Mesh::readable(bad));
  bad.back() = 0.5;
  EXPECT_FALSE(Mesh::readable(bad));
  EXPECT_FALSE(Mesh::readable(std::span(canon).first(5)));
}

}  // namespace
}  // namespace arelem::mesh
