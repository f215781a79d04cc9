// Drawings: those of another program (tests/end_to_end/test_drawings.py) are read by the whole
// command; here are hostile ones.
#include "runtime/region/drawing.h"

#include <cmath>

#include <gtest/gtest.h>

namespace arelem::region {
namespace {

std::string file(const std::string& entities, const std::string& header = "") {
  return header + "0\nSECTION\n2\nENTITIES\n" + entities + "0\nENDSEC\n0\nEOF\n";
}
DrawingRules rules(double chord = 0.01) {
  DrawingRules r;
  r.chord = chord;
  return r;
}
std::string errorOf(const std::string& text) {
  const Result<Drawing> drawing = readDrawing(text, "a.dxf", rules());
  return drawing ? "" : std::string(drawing.failure().row->code) + " " + drawing.failure().message;
}
/// Entities that bound nothing, by name and count.
std::string uselessIn(const std::string& entities) {
  const Result<Drawing> drawing = readDrawing(file(entities), "a.dxf", rules());
  std::string all = drawing ? "" : drawing.failure().message;
  for (const auto& [name, kind] : drawing ? drawing->useless : Drawing::Kinds{}) {
    all += fmt::format("{}{} {}", all.empty() ? "" : "; ", kind.count, name);
  }
  return all;
}
double areaOfOne(const std::string& entities, double chord = 0.001) {
  Result<Drawing> drawing = readDrawing(file(entities), "a.dxf", rules(chord));
  if (!drawing) {
    ADD_FAILURE() << drawing.failure().message;
    return 0.0;
  }
  const auto loops = chained(std::move(drawing->curves), "a.dxf", 1e-3);
  if (!loops) {
    ADD_FAILURE() << loops.failure().message;
    return 0.0;
  }
  return std::abs(spray::areaOf({*loops}));
}

TEST(Drawing, Circle) {
  EXPECT_NEAR(areaOfOne("0\nCIRCLE\n8\n0\n10\n5\n20\n6\n40\n10\n"), 100.0 * M_PI, 0.1);
}
TEST(Drawing, BulgesAreArcs) {
  // Two vertices joined by half circles of radius 5.
  EXPECT_NEAR(areaOfOne("0\nLWPOLYLINE\n90\n2\n70\n1\n10\n0\n20\n0\n42\n1\n10\n10\n20\n0\n42\n1\n"),
              25.0 * M_PI, 0.05);
  // A quarter arc that bends inwards (negative bulge) takes away a quarter circle's segment.
  const double bulge = -std::tan(M_PI / 8.0);
  const double taken = 50.0 * (M_PI / 4.0 * 2.0 - 1.0) / 1.0;
  EXPECT_NEAR(areaOfOne("0\nLWPOLYLINE\n90\n4\n70\n1\n10\n0\n20\n0\n42\n" + std::to_string(bulge) +
                        "\n10\n10\n20\n0\n10\n10\n20\n10\n10\n0\n20\n10\n"),
              100.0 - taken / 2.0, 0.05);
}
/// z is kept, and must be the same everywhere: nothing is flattened.
TEST(Drawing, HeightsAreKept) {
  const auto heightOf = [](const std::string& entities) {
    const Result<Drawing> drawing = readDrawing(file(entities), "a.dxf", rules());
    return drawing ? drawing->height : NAN;
  };
  const std::string circle = "0\nCIRCLE\n10\n5\n20\n6\n40\n10\n";
  EXPECT_EQ(heightOf(circle), 0.0);
  EXPECT_EQ(heightOf(circle + "30\n7\n"), 7.0);
  EXPECT_EQ(heightOf(circle + "30\n7\n230\n-1\n"), -7.0);  // drawn on the back
  EXPECT_EQ(heightOf("0\nLWPOLYLINE\n90\n1\n38\n4\n10\n0\n20\n0\n"), 4.0);
  EXPECT_EQ(heightOf("0\nLINE\n10\n0\n20\n0\n30\n2\n11\n9\n21\n0\n31\n2\n"), 2.0);
  EXPECT_EQ(uselessIn("0\nLINE\n10\n0\n20\n0\n30\n2\n11\n9\n21\n0\n31\n5\n"),
            "1 LINE that is not parallel to the xy plane");
  EXPECT_EQ(uselessIn(circle + circle + "30\n7\n" + circle + "30\n8\n"),
            "2 CIRCLE at another z than 0, that of the first curve");
  EXPECT_EQ(uselessIn("0\nELLIPSE\n10\n0\n20\n0\n11\n9\n21\n0\n31\n4\n40\n.5\n"),
            "1 ELLIPSE that is not parallel to the xy plane");
}
TEST(Drawing, WhatCannotBoundIsListed) {
  EXPECT_EQ(uselessIn("0\nCIRCLE\n10\n0\n20\n0\n40\n0\n0\nTEXT\n1\nA\n0\nTEXT\n1\nB\n"
                      "0\nSPLINE\n71\n3\n11\n0\n21\n0\n"),
            "1 CIRCLE without a radius; 1 SPLINE by fit points; 2 TEXT");
  const Result<Drawing> drawing = readDrawing(
      file("0\nCIRCLE\n10\n0\n20\n0\n40\n0\n0\nCIRCLE\n10\n0\n20\n0\n40\n0\n"), "a.dxf", rules());
  EXPECT_EQ(drawing->useless.begin()->second.line, 5U);
}
/// A polyline in space is flat where its vertices are; each vertex has its own z.
TEST(Drawing, PolylinesInSpaceMayBeFlat) {
  const auto triangle = [](const std::string& z) {
    return "0\nPOLYLINE\n66\n1\n70\n9\n30\n0\n0\nVERTEX\n70\n32\n10\n0\n20\n0\n30\n5\n"
           "0\nVERTEX\n70\n32\n10\n4\n20\n0\n30\n5\n0\nVERTEX\n70\n32\n10\n4\n20\n3\n30\n" +
           z + "\n0\nSEQEND\n";
  };
  EXPECT_NEAR(areaOfOne(triangle("5")), 6.0, 1e-9);
  EXPECT_EQ(readDrawing(file(triangle("5")), "a.dxf", rules())->height, 5.0);
  EXPECT_EQ(uselessIn(triangle("6")), "1 POLYLINE that is not parallel to the xy plane");
}
TEST(Chained, AnEndThatLeadsBackIntoTheLoopIsRefused) {
  std::vector<Curve> curves(3);
  curves[0].points = {{-5, 0}, {0, 0}};
  curves[1].points = {{0.0009, 0}, {5, 5}};
  curves[2].points = {{5, 5},
                      {0.0018, 0}};  // near the start of the second, not the end of the first
  const auto loops = chained(std::move(curves), "a.dxf", 1e-3);
  ASSERT_FALSE(loops);
  EXPECT_EQ(loops.failure().row->code, "E0371");
}
TEST(Drawing, PolylinesWithoutVerticesAreRefused) {
  EXPECT_NE(errorOf(file("0\nLWPOLYLINE\n90\n0\n")).find("has no vertices"), std::string::npos);
  EXPECT_NE(errorOf(file("0\nPOLYLINE\n66\n1\n0\nSEQEND\n")).find("has no vertices"),
            std::string::npos);
}
TEST(Drawing, PaperSpaceIsNotTheWork) {
  const Result<Drawing> drawing =
      readDrawing(file("0\nCIRCLE\n67\n1\n10\n5\n20\n6\n40\n10\n"), "a.dxf", rules());
  ASSERT_TRUE(drawing);
  EXPECT_TRUE(drawing->curves.empty());
  EXPECT_TRUE(drawing->useless.empty());
  EXPECT_EQ(drawing->hidden.at("CIRCLE in paper space").count, 1U);
}
TEST(Drawing, OldPolylinesWithVertices) {
  EXPECT_NEAR(
      areaOfOne(
          "0\nPOLYLINE\n8\n0\n66\n1\n70\n1\n0\nVERTEX\n10\n0\n20\n0\n0\nVERTEX\n10\n4\n20\n0\n"
          "0\nVERTEX\n10\n4\n20\n3\n0\nSEQEND\n"),
      6.0, 1e-9);
}
TEST(Drawing, EllipseAndItsBack) {
  const std::string ellipse =
      "0\nELLIPSE\n10\n1\n20\n2\n11\n8\n21\n0\n40\n0.5\n41\n0\n42\n6.283185307179586\n";
  EXPECT_NEAR(areaOfOne(ellipse), M_PI * 8 * 4, 0.05);
  EXPECT_NEAR(areaOfOne(ellipse + "230\n-1\n"), M_PI * 8 * 4, 0.05);
}
TEST(Drawing, RationalSplineIsACircle) {
  // A full circle of radius 3 as four rational quadratics.
  std::string s = "0\nSPLINE\n70\n8\n71\n2\n72\n12\n73\n9\n";
  for (const double k : {0., 0., 0., 1., 1., 2., 2., 3., 3., 4., 4., 4.}) {
    s += "40\n" + std::to_string(k) + "\n";
  }
  const double w = std::sqrt(0.5);
  const double x[] = {3, 3, 0, -3, -3, -3, 0, 3, 3};
  const double y[] = {0, 3, 3, 3, 0, -3, -3, -3, 0};
  for (int i = 0; i < 9; ++i) {
    s += "10\n" + std::to_string(x[i]) + "\n20\n" + std::to_string(y[i]) + "\n41\n" +
         fmt::format("{:.17g}", i % 2 == 1 ? w : 1.0) + "\n";
  }
  EXPECT_NEAR(areaOfOne(s), 9.0 * M_PI, 0.02);
}
TEST(Drawing, LinesAndArcsJoinInAnyOrderAndDirection) {
  EXPECT_NEAR(
      areaOfOne(
          "0\nARC\n10\n0\n20\n0\n40\n5\n50\n0\n51\n180\n0\nLINE\n10\n5\n20\n0\n11\n-5\n21\n0\n"),
      12.5 * M_PI, 0.02);
}
TEST(Drawing, UnitsAreConverted) {
  const std::string header = "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n1\n0\nENDSEC\n";
  DrawingRules r = rules();
  r.unit = 1.0;
  const Result<Drawing> drawing =
      readDrawing(file("0\nLINE\n10\n0\n20\n0\n11\n1\n21\n0\n", header), "a.dxf", r);
  EXPECT_DOUBLE_EQ(drawing->curves[0].points[1].x(), 25.4);
}
TEST(Drawing, LayersAndUnusableEntitiesAreListed) {
  DrawingRules r = rules();
  const std::string text =
      file("0\nTEXT\n8\nnotes\n0\nTEXT\n8\nnotes\n0\nLINE\n8\ncut\n10\n0\n20\n0\n11\n1\n21\n0\n");
  const Result<Drawing> all = readDrawing(text, "a.dxf", r);
  EXPECT_EQ(all->useless.at("TEXT").count, 2U);
  EXPECT_EQ(all->layers, (std::vector<std::string>{"cut", "notes"}));
  r.layer = "cut";
  EXPECT_TRUE(readDrawing(text, "a.dxf", r)->useless.empty());
}

TEST(Drawing, HostileFilesAreRefusedWithTheLine) {
  EXPECT_NE(errorOf("").find("EOF"), std::string::npos);
  EXPECT_NE(errorOf("AutoCAD Binary DXF\r\n\x1a").find("binary"), std::string::npos);
  EXPECT_NE(errorOf("hello\nworld\n").find("line 1"), std::string::npos);
  EXPECT_NE(errorOf("0\nSECTION\n2\n").find("E0367"), std::string::npos);
  EXPECT_NE(errorOf("0\nSECTION\n2\nENTITIES\n0\nLINE\n").find("cut off"), std::string::npos);
  EXPECT_NE(errorOf(file("0\nLINE\n10\n0\n20\n0\n11\nten\n21\n0\n")).find("`ten`"),
            std::string::npos);
  EXPECT_NE(errorOf(file("0\nLINE\n10\n0\n20\n0\n11\n1e999\n21\n0\n")).find("E0367"),
            std::string::npos);
  EXPECT_NE(errorOf(file("0\nLINE\n10\n0\n20\n0\n11\nnan\n21\n0\n")).find("E0367"),
            std::string::npos);
  EXPECT_NE(errorOf(file("0\nLINE\n10\n0\n20\n0\n")).find("without group 11"), std::string::npos);
  EXPECT_EQ(uselessIn("0\nCIRCLE\n10\n0\n20\n0\n40\n-1\n"), "1 CIRCLE without a radius");
  EXPECT_EQ(uselessIn("0\nCIRCLE\n10\n0\n20\n0\n40\n1\n230\n0.5\n"),
            "1 CIRCLE that is not parallel to the xy plane");
  EXPECT_NE(
      errorOf(file("0\nLWPOLYLINE\n90\n3\n10\n0\n20\n0\n10\n1\n20\n0\n")).find("says 3 vertices"),
      std::string::npos);
  EXPECT_NE(errorOf(file("0\nLWPOLYLINE\n90\n1\n20\n0\n10\n0\n")).find("before its first vertex"),
            std::string::npos);
  EXPECT_NE(errorOf(file("0\nSPLINE\n71\n3\n72\n4\n40\n0\n")).find("says 4 knots"),
            std::string::npos);
  EXPECT_EQ(uselessIn("0\nSPLINE\n71\n3\n72\n0\n73\n0\n74\n2\n11\n0\n21\n0\n11\n9\n21\n5\n"),
            "1 SPLINE by fit points");
  EXPECT_NE(errorOf(file("0\nSPLINE\n71\n900\n40\n0\n10\n0\n20\n0\n")).find("degree"),
            std::string::npos);
  EXPECT_EQ(uselessIn("0\nELLIPSE\n10\n0\n20\n0\n11\n0\n21\n0\n40\n1\n"),
            "1 ELLIPSE with an axis of no length");
}

TEST(Drawing, ManyPointsHaveALimit) {
  DrawingRules r = rules(1e-9);
  r.mostPoints = 1000;
  const Result<Drawing> drawing =
      readDrawing(file("0\nCIRCLE\n10\n0\n20\n0\n40\n1000\n"), "a.dxf", r);
  ASSERT_FALSE(drawing.ok());
}

TEST(Drawing, PointsAreCountedBeforeTheyAreMade) {
  // 10 000 arcs that look up to 100 000 chords each: all of them would take 16 gigabytes.
  std::string arcs = "0\nLWPOLYLINE\n90\n10000\n";
  for (int i = 0; i < 10'000; ++i) {
    arcs += fmt::format("10\n{}\n20\n0\n42\n1\n", 1000 * (i % 2));
  }
  DrawingRules r = rules(1e-9);
  r.mostPoints = 200'000;
  const Result<Drawing> drawing = readDrawing(file(arcs), "a.dxf", r);
  ASSERT_FALSE(drawing.ok());
  EXPECT_NE(drawing.failure().message.find("more than 200000 corners"), std::string::npos);
}

TEST(Drawing, CurvesBeyondAllNumbersAreRefused) {
  EXPECT_NE(errorOf(file("0\nLWPOLYLINE\n70\n1\n90\n2\n10\n0\n20\n0\n42\n1e300\n10\n9\n20\n0\n"))
                .find("leads farther than numbers go"),
            std::string::npos);
}

TEST(Drawing, FlagsOfAnySizeAreRead) {
  EXPECT_NE(errorOf(file("0\nLWPOLYLINE\n70\n1e300\n90\n3\n10\n0\n20\n0\n")).find("says 3"),
            std::string::npos);
  EXPECT_NE(errorOf(file("0\nSPLINE\n71\n-1e300\n40\n0\n10\n0\n20\n0\n")).find("degree"),
            std::string::npos);
}

std::string chainError(std::vector<Curve> curves) {
  const auto loops = chained(std::move(curves), "a.dxf", 1e-3);
  return loops ? "" : std::string(loops.failure().row->code);
}

TEST(Chains, OpenAndBranchingBoundariesAreRefused) {
  const Curve a{{{0, 0}, {10, 0}}, false};
  const Curve b{{{10, 0}, {10, 10}}, false};
  const Curve c{{{10, 10}, {0, 0}}, false};
  EXPECT_EQ(chainError({a, b, c}), "");
  EXPECT_EQ(chainError({a, b}), "E0369");
  EXPECT_EQ(chainError({a, b, c, a}), "E0371");
  EXPECT_EQ(chainError({a, b, c, {{{10, 0}, {20, 0}}, false}}), "E0371");
  EXPECT_EQ(chainError({a, b, {{{10, 10}, {0, 0.002}}, false}}), "E0369");
  EXPECT_EQ(chainError({a, b, {{{10, 10}, {0, 0.0005}}, false}}), "");
}

}  // namespace
}  // namespace arelem::region
