// What a drawing shows: layers that are off or frozen, blocks and where INSERT places them.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "runtime/region/drawing.h"

namespace arelem::region {
namespace {

constexpr double pi = std::numbers::pi;

std::string section(const std::string& name, const std::string& objects) {
  return "0\nSECTION\n2\n" + name + "\n" + objects + "0\nENDSEC\n";
}
std::string file(const std::string& entities,
                 const std::string& blocks = "",
                 const std::string& tables = "") {
  return section("TABLES", tables) + section("BLOCKS", blocks) + section("ENTITIES", entities) +
         "0\nEOF\n";
}
std::string circle(double x, double y, double radius, const std::string& layer = "0") {
  return fmt::format("0\nCIRCLE\n8\n{}\n10\n{}\n20\n{}\n40\n{}\n", layer, x, y, radius);
}
std::string block(const std::string& name,
                  const std::string& entities,
                  double x = 0,
                  double y = 0) {
  return fmt::format("0\nBLOCK\n2\n{}\n10\n{}\n20\n{}\n30\n0\n{}0\nENDBLK\n", name, x, y, entities);
}
std::string layer(const std::string& name, int color, int flags) {
  return fmt::format("0\nLAYER\n2\n{}\n70\n{}\n62\n{}\n", name, flags, color);
}
Drawing read(const std::string& text, const std::string& only = "") {
  DrawingRules rules;
  rules.chord = 1e-4;
  rules.layer = only;
  Result<Drawing> drawing = readDrawing(text, "a.dxf", rules);
  EXPECT_TRUE(drawing.ok()) << (drawing ? "" : drawing.failure().message);
  return drawing ? *std::move(drawing) : Drawing{};
}
double areaOf(const Curve& curve) {
  return spray::areaOf({{spray::Loop(curve.points.begin(), curve.points.end())}});
}
Vec2 middleOf(const Curve& curve) {
  Vec2 low = curve.points.front();
  Vec2 high = low;
  for (const Vec2& p : curve.points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  return (low + high) / 2.0;
}

TEST(DrawingLayers, OffOrFrozenIsHidden) {
  const std::string text =
      file(circle(0, 0, 9, "shown") + circle(0, 0, 3, "dark") + circle(0, 0, 2, "cold") +
               circle(0, 0, 1, "cold") + circle(0, 0, 4) + "60\n1\n",
           "", layer("dark", -7, 0) + layer("cold", 7, 1) + layer("shown", 7, 0));
  const Drawing all = read(text);
  ASSERT_EQ(all.curves.size(), 1U);
  EXPECT_EQ(all.hidden.at("CIRCLE on layer `dark`, which is off").count, 1U);
  EXPECT_EQ(all.hidden.at("CIRCLE on layer `cold`, which is frozen").count, 2U);
  EXPECT_EQ(all.hidden.at("CIRCLE that is invisible").count, 1U);
  EXPECT_EQ(all.hidden.size(), 3U);
  // A layer that is named is taken.
  EXPECT_EQ(read(text, "dark").curves.size(), 1U);
  EXPECT_EQ(read(text, "cold").curves.size(), 2U);
  EXPECT_TRUE(read(text, "cold").hidden.empty());
}

TEST(DrawingBlocks, AreScaledTurnedAndPlaced) {
  // A circle of radius 1 at (3, 2), from the base point (1, 2) 2 along x: turned by 90 degrees and
  // twice as large that is 4 along y, from (10, 20).
  const std::string blocks = block("B", circle(3, 2, 1), 1, 2);
  const Drawing one = read(file("0\nINSERT\n2\nB\n10\n10\n20\n20\n41\n2\n42\n2\n50\n90\n", blocks));
  ASSERT_EQ(one.curves.size(), 1U);
  EXPECT_NEAR((middleOf(one.curves[0]) - Vec2(10, 24)).norm(), 0.0, 1e-3);
  EXPECT_NEAR(areaOf(one.curves[0]), 4.0 * pi, 1e-2);
  // Twice along x only: an ellipse. Mirrored, its sense turns round.
  const Drawing oval = read(file("0\nINSERT\n2\nB\n10\n0\n20\n0\n41\n-2\n", blocks));
  EXPECT_NEAR(areaOf(oval.curves[0]), -2.0 * pi, 1e-2);
  EXPECT_NEAR((middleOf(oval.curves[0]) - Vec2(-4, 0)).norm(), 0.0, 1e-3);
}

TEST(DrawingBlocks, ChordsKeepToTheToleranceAfterTheScale) {
  const Drawing large =
      read(file("0\nINSERT\n2\nB\n41\n1000\n42\n1000\n", block("B", circle(0, 0, 1))));
  for (std::size_t i = 1; i < large.curves[0].points.size(); ++i) {
    const Vec2 half = (large.curves[0].points[i - 1] + large.curves[0].points[i]) / 2.0;
    EXPECT_GT(half.norm(), 1000.0 - 1.01e-4);
  }
}

TEST(DrawingBlocks, RowsAndColumns) {
  const std::string text =
      file("0\nINSERT\n2\nB\n10\n5\n20\n0\n50\n90\n70\n3\n71\n2\n44\n10\n45\n20\n",
           block("B", circle(0, 0, 1)));
  const Drawing six = read(text);
  ASSERT_EQ(six.curves.size(), 6U);  // columns go up, rows to the left: turned by 90 degrees
  EXPECT_NEAR((middleOf(six.curves[2]) - Vec2(5, 20)).norm(), 0.0, 1e-3);
  EXPECT_NEAR((middleOf(six.curves[5]) - Vec2(-15, 20)).norm(), 0.0, 1e-3);
}

TEST(DrawingBlocks, OneInAnother) {
  const std::string blocks = block("A", circle(1, 0, 1)) +
                             block("B", "0\nINSERT\n2\nA\n8\n0\n10\n10\n20\n0\n41\n2\n42\n2\n");
  const Drawing nested =
      read(file("0\nINSERT\n2\nB\n8\nwork\n10\n100\n20\n0\n50\n180\n", blocks), "work");
  ASSERT_EQ(nested.curves.size(), 1U);  // layer 0 in a block is that of its INSERT
  EXPECT_NEAR((middleOf(nested.curves[0]) - Vec2(88, 0)).norm(), 0.0, 1e-3);
  EXPECT_NEAR(areaOf(nested.curves[0]), 4.0 * pi, 1e-2);
  EXPECT_TRUE(read(file("0\nINSERT\n2\nB\n8\nwork\n", blocks), "0").curves.empty());
}

TEST(DrawingBlocks, WhatCannotBePlacedIsTold) {
  const std::string self = block("B", "0\nINSERT\n2\nB\n");
  EXPECT_EQ(read(file("0\nINSERT\n2\nB\n", self)).useless.begin()->first,
            "INSERT of block `B`, which lies in too many blocks or in itself");
  EXPECT_EQ(read(file("0\nINSERT\n2\nC\n", self)).useless.begin()->first,
            "INSERT of block `C`, which the drawing does not have");
  EXPECT_EQ(read(file("0\nINSERT\n2\nB\n41\n0\n", self)).useless.begin()->first,
            "INSERT that is not parallel to the xy plane or has a scale of 0");
  // So many that they would take for ever: a block of nothing, a million times a million.
  DrawingRules rules;
  rules.chord = 0.1;
  const Result<Drawing> many = readDrawing(
      file("0\nINSERT\n2\nE\n70\n1000000\n71\n1000000\n", block("E", "")), "a.dxf", rules);
  ASSERT_FALSE(many.ok());
  EXPECT_EQ(many.failure().row->code, "E0393");
}

}  // namespace
}  // namespace arelem::region
