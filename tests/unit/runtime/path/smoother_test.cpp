// SMOOTH over records: properties that hold for all paths.
#include "runtime/path/smoother.h"

#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "runtime/spline/bezier.h"
#include "runtime/spline/cubic.h"
#include "runtime/timing/cut_timer.h"

namespace arelem::path {
namespace {

cl::Record post(Word word, std::vector<cl::Value> arguments) {
  cl::Record record;
  record.body = cl::Post{word, "", std::move(arguments)};
  return record;
}
cl::Record location(const Vec3& p, bool from = false) {
  cl::Record record;
  cl::Motion motion;
  motion.kind = from ? cl::Motion::Kind::from : cl::Motion::Kind::go;
  motion.coordinates = {p.x(), p.y(), p.z()};
  record.body = motion;
  return record;
}

struct Smoothing {
  std::vector<Vec3> path;
  std::vector<cl::Surface> curves;
  std::vector<SmoothFact> facts;
  CollectingSink sink;
};

void smoothInto(Smoothing& result,
                const std::vector<Vec3>& points,
                std::vector<cl::Value> arguments,
                double feed = 0.0) {
  cl::Recording records;
  const auto smoother = makeSmoother(records, result.sink);
  if (feed > 0.0) {
    smoother->accept(post(Word::FEDRAT, {feed}));
  }
  smoother->accept(location(points[0], true));
  smoother->accept(post(Word::SMOOTH, std::move(arguments)));
  for (std::size_t i = 1; i < points.size(); ++i) {
    smoother->accept(location(points[i]));
  }
  smoother->accept(post(Word::SMOOTH, {Word::NOMORE}));
  smoother->finish();
  result.facts = smoother->facts();
  for (const cl::Record& record : records.records) {
    if (const auto* surface = std::get_if<cl::Surface>(&record.body)) {
      result.curves.push_back(*surface);
    }
    const auto* motion = std::get_if<cl::Motion>(&record.body);
    for (std::size_t i = 0; motion != nullptr && i < motion->coordinates.size(); i += 3) {
      result.path.emplace_back(&motion->coordinates[i]);
    }
  }
}

/// Largest distance of places along `a`, ends and in between, from the polyline b.
double farthest(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double most = 0.0;
  for (std::size_t i = 1; i < a.size(); ++i) {
    for (const double s : {0.0, 0.3, 0.7, 1.0}) {
      const Vec3 p = a[i - 1] + s * (a[i] - a[i - 1]);
      double least = 1e300;
      for (std::size_t k = 1; k < b.size(); ++k) {
        least = std::min(least, spline::distanceToSegment(p, b[k - 1], b[k]));
      }
      most = std::max(most, least);
    }
  }
  return most;
}

double sharpestCorner(const std::vector<Vec3>& path) {
  double most = 0.0;
  for (std::size_t i = 2; i < path.size(); ++i) {
    const Vec3 a = path[i - 1] - path[i - 2];
    const Vec3 b = path[i] - path[i - 1];
    most = std::max(most, std::atan2(a.cross(b).norm(), a.dot(b)));
  }
  return most;
}

/// A random walk in space that turns, with noise; some steps are tiny, some turn back.
std::vector<Vec3> randomPath(std::mt19937& random, bool closed) {
  std::uniform_real_distribution<double> step(0.05, 8.0);
  std::normal_distribution<double> turn(0.0, 0.7);
  std::vector<Vec3> points{Vec3::Zero()};
  double heading = 0.0;
  for (int i = 0; i < 14; ++i) {
    heading += turn(random);
    points.push_back(points.back() +
                     step(random) * Vec3(std::cos(heading), std::sin(heading), 0.3 * turn(random)));
  }
  if (closed) {
    points.push_back(points.front());
  }
  return points;
}

TEST(Smoother, NeverLeavesTheTube) {
  std::mt19937 random(1);
  for (const double tolerance : {0.001, 0.05, 1.0}) {
    for (const double method : {1.0, 2.0, 3.0}) {
      for (const bool closed : {false, true}) {
        for (int i = 0; i < 4; ++i) {
          const std::vector<Vec3> points = randomPath(random, closed);
          std::vector<cl::Value> order{tolerance, Word::METHOD, method};
          if (closed) {
            order.emplace_back(Word::CLOSED);
          }
          Smoothing now;
          smoothInto(now, points, order);
          ASSERT_EQ(now.sink.errors(), 0U);  // METHOD 3 may leave a path as it is, and tells
          // Both ways: the new path keeps to the old one, and leaves no part of it out.
          std::vector<Vec3> cut(now.path.begin() + 1, now.path.end());
          if ((cut.front() - now.path.front()).norm() > tolerance) {
            cut.insert(cut.begin(), now.path.front());
          }
          EXPECT_LE(farthest(cut, points), tolerance * (1 + 1e-9)) << method << closed;
          EXPECT_LE(farthest(points, now.path), tolerance * (1 + 1e-9)) << method << closed;
        }
      }
    }
  }
}

TEST(Smoother, EndsStay) {
  std::mt19937 random(2);
  const std::vector<Vec3> points = randomPath(random, false);
  for (const double method : {2.0, 3.0}) {
    Smoothing now;
    smoothInto(now, points, {0.1, Word::METHOD, method});
    EXPECT_LT((now.path.back() - points.back()).norm(), 1e-6);
    EXPECT_LT((now.path.front() - points.front()).norm(), 1e-12);
  }
}

TEST(Smoother, CornersBecomeRound) {
  Smoothing now;
  smoothInto(now, {{0, 0, 0}, {20, 0, 0}, {20, 20, 0}, {40, 20, 0}}, {0.5});
  EXPECT_LT(sharpestCorner(now.path), 0.25 * std::numbers::pi);  // half a right angle at most
}

TEST(Smoother, HairpinsAreOpenedAsFarAsTheTubeGoes) {
  // A turn by 180 degrees in a tube of radius R needs a curvature of 1/R at least; R is half of the
  // tolerance, as the fit has 40 percent of it and the chords 10.
  for (const double width : {0.01, 0.5, 2.0}) {
    const std::vector<Vec3> hairpin{{0, 0, 0}, {20, 0, 0}, {0, width, 0}};
    for (const double method : {2.0, 3.0}) {
      Smoothing now;
      smoothInto(now, hairpin, {0.1, Word::METHOD, method});
      ASSERT_EQ(now.facts.size(), 1U);
      EXPECT_LT(now.facts[0].mostAfter, 1.25 / 0.05) << width;
      EXPECT_LE(farthest(now.path, hairpin), 0.1);
      EXPECT_LE(farthest(hairpin, now.path), 0.1);
    }
  }
}

TEST(Smoother, CornersOfLinesInManyStepsAreAsRoundAsOfLongOnes) {
  std::vector<Vec3> steps;
  for (int i = 0; i <= 10; ++i) {
    steps.emplace_back(2.4 * i, 0, 0);
  }
  for (int i = 1; i <= 10; ++i) {
    steps.emplace_back(24, 2.4 * i, 0);
  }
  Smoothing fine;
  Smoothing coarse;
  smoothInto(fine, steps, {0.1});
  smoothInto(coarse, {{0, 0, 0}, {24, 0, 0}, {24, 24, 0}}, {0.1});
  ASSERT_EQ(fine.facts.size(), 1U);
  EXPECT_LT(fine.facts[0].mostBefore, 1.2 * coarse.facts[0].mostBefore);
  EXPECT_LT(fine.facts[0].mostAfter, 1.2 * coarse.facts[0].mostAfter);
}

/// Seconds along a path at a feed, from rest to rest.
double secondsAlong(const std::vector<Vec3>& path, double feed) {
  CollectingSink sink;
  timing::CutTimer timer({}, sink);
  timer.accept(post(Word::FEDRAT, {feed}));
  for (std::size_t i = 0; i < path.size(); ++i) {
    timer.accept(location(path[i], i == 0));
  }
  return timer.finish().total();
}

TEST(Smoother, LeastTimeIsNeverMoreThanBefore) {
  std::mt19937 random(7);
  std::size_t kept = 0;
  for (const double feed : {60.0, 2000.0, 24000.0}) {
    for (const double tolerance : {0.001, 0.02, 0.2}) {
      for (int i = 0; i < 4; ++i) {
        const std::vector<Vec3> points = randomPath(random, false);
        Smoothing now;
        smoothInto(now, points, {tolerance, Word::METHOD, 3.0}, feed);
        EXPECT_EQ(now.sink.errors(), 0U);
        EXPECT_LE(secondsAlong(now.path, feed), secondsAlong(points, feed) * (1.0 + 1e-12));
        // A path that was left as it is was told to be.
        EXPECT_EQ(now.facts.size() + now.sink.all().size(), 1U);
        if (now.facts.empty()) {
          ++kept;
          EXPECT_EQ(now.path, points);
        }
      }
    }
  }
  EXPECT_GT(kept, 0U);
  EXPECT_LT(kept, 36U);
}

TEST(Smoother, KeepsTheCurveWhereAsked) {
  std::mt19937 random(3);
  Smoothing now;
  smoothInto(now, randomPath(random, false), {0.1, Word::SPLINE});
  ASSERT_EQ(now.curves.size(), 1U);
  const auto curve = spline::CubicSpline::of(now.curves[0].surface.canon);
  ASSERT_TRUE(curve.ok());
  for (const Vec3& p : now.path) {
    EXPECT_LT(curve->nearest(p).distance, 1e-7);
  }
}

TEST(Smoother, OnePointAndCoincidentPointsPass) {
  Smoothing one;
  smoothInto(one, {{0, 0, 0}, {5, 0, 0}}, {0.1});
  EXPECT_EQ(one.path.size(), 2U);
  Smoothing same;
  smoothInto(same, {{0, 0, 0}, {5, 0, 0}, {5, 0, 0}, {5, 5, 0}, {5, 5, 0}}, {0.1});
  EXPECT_EQ(same.sink.errors(), 0U);
  EXPECT_LT((same.path.back() - Vec3(5, 5, 0)).norm(), 1e-6);
}

TEST(Smoother, WrongOrders) {
  const std::vector<Vec3> points{{0, 0, 0}, {5, 0, 0}, {5, 5, 0}};
  const auto code = [&](std::vector<cl::Value> order) {
    Smoothing now;
    smoothInto(now, points, std::move(order));
    return now.sink.all().empty() ? std::string() : std::string(now.sink.all()[0].row->code);
  };
  EXPECT_EQ(code({0.0}), "E0390");
  EXPECT_EQ(code({-1.0}), "E0390");
  EXPECT_EQ(code({}), "E0392");
  EXPECT_EQ(code({0.1, Word::METHOD, 7.0}), "E0392");
  EXPECT_EQ(code({0.1, Word::METHOD}), "E0392");
  EXPECT_EQ(code({0.1, Word::PRECIS, 0.0}), "E0391");
  EXPECT_EQ(code({0.1, Word::ACCUR, 100.0}), "E0391");
  EXPECT_EQ(code({0.1, Word::SHARE, 80.0}), "E0392");
  EXPECT_EQ(code({0.1, Word::CLOSED}), "E0397");
}

TEST(Smoother, WrongPlaces) {
  const auto code = [](const std::vector<cl::Record>& records) {
    cl::Recording out;
    CollectingSink sink;
    const auto smoother = makeSmoother(out, sink);
    for (const cl::Record& record : records) {
      smoother->accept(record);
    }
    smoother->finish();
    return sink.all().empty() ? std::string() : std::string(sink.all()[0].row->code);
  };
  const cl::Record on = post(Word::SMOOTH, {0.1});
  const cl::Record off = post(Word::SMOOTH, {Word::NOMORE});
  const cl::Record start = location({0, 0, 0}, true);
  const std::vector<cl::Record> moves{location({5, 0, 0}), location({5, 5, 0})};
  EXPECT_EQ(code({start, on, moves[0], moves[1], off}), "");
  EXPECT_EQ(code({start, moves[0], off}), "E0593");
  EXPECT_EQ(code({start, on, moves[0], moves[1], on, off}), "E0592");
  EXPECT_EQ(code({start, on, moves[0], location({2, 0, 0}), off}), "E0591");
  EXPECT_EQ(code({start, on, moves[0], off}), "E0399");
  EXPECT_EQ(code({start, on, off}), "E0399");
  const cl::Record inverse = post(Word::FEDRAT, {4.0, Word::INVERS});
  EXPECT_EQ(code({inverse, start, on, moves[0], moves[1], off}), "E0596");
  EXPECT_EQ(code({start, on, inverse, moves[0], moves[1], off}), "E0596");
  // A wrong order is told once, and not again where it ends.
  EXPECT_EQ(code({start, post(Word::SMOOTH, {0.0}), moves[0], moves[1], off}), "E0390");
}

}  // namespace
}  // namespace arelem::path
