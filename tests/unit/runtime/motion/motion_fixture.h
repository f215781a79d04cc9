#pragma once
#include <vector>

#include <gtest/gtest.h>

#include "runtime/run.h"

namespace arelem::test {

/// Builds actions by hand and runs them: motion without the front end.
class MotionProgram {
 public:
  static EntityPtr entity(EntityType type, std::vector<double> canon, std::string name = "") {
    auto e = std::make_shared<Entity>();
    e->type = type;
    e->canon = std::move(canon);
    e->name = std::move(name);
    return e;
  }
  /// The line through two points, as LINE/x1,y1,x2,y2 defines it.
  static EntityPtr line(double x1, double y1, double x2, double y2) {
    const double length = std::hypot(x2 - x1, y2 - y1);
    const double a = (y2 - y1) / length;
    const double b = (x1 - x2) / length;
    return entity(EntityType::line, {a, b, 0.0, a * x1 + b * y1}, "L");
  }
  static EntityPtr plane(double a, double b, double c, double d) {
    const double n = std::sqrt(a * a + b * b + c * c);
    return entity(EntityType::plane, {a / n, b / n, c / n, d / n}, "PL");
  }
  static EntityPtr circle(double x, double y, double r) {
    return entity(EntityType::circle, {x, y, 0.0, 0.0, 0.0, 1.0, r}, "C");
  }
  static EntityPtr sphere(double x, double y, double z, double r) {
    return entity(EntityType::sphere, {x, y, z, r}, "S");
  }

  MotionProgram& cutter(std::vector<double> values) {
    return add(runtime::Parameter{Word::CUTTER, values});
  }
  MotionProgram& tolerance(double in, double out) {
    return add(runtime::Parameter{Word::INTOL, {in}}).add(runtime::Parameter{Word::OUTTOL, {out}});
  }
  MotionProgram& from(double x, double y, double z) {
    runtime::Locate l;
    l.word = Word::FROM;
    l.point = {x, y, z};
    return add(l);
  }
  MotionProgram& go(std::vector<runtime::SurfaceUse> surfaces) {
    return add(runtime::Startup{false, surfaces, {}});
  }
  MotionProgram& relation(Word word) { return add(runtime::ToolRelation{word}); }
  MotionProgram& toward(double x, double y, double z) {
    runtime::Direction d;
    d.values[0] = Vec3(x, y, z);
    return add(d);
  }
  MotionProgram& follow(
      ir::Heading heading, EntityPtr drive, ir::Condition condition, EntityPtr check, int nth = 1) {
    runtime::Follow f;
    f.heading = heading;
    f.drive = drive;
    f.checks.push_back({{check, condition}, nth, std::nullopt});
    return add(f);
  }
  template <class Body>
  MotionProgram& add(Body body) {
    runtime::Action a;
    a.isn = static_cast<int>(actions_.size()) + 1;
    a.body = std::move(body);
    actions_.push_back(std::move(a));
    return *this;
  }

  /// The locations of every motion record, one list a statement.
  std::vector<std::vector<Vec3>> run() {
    cl::Recording recording;
    outcome = runtime::execute(actions_, {}, recording, diagnostics);
    std::vector<std::vector<Vec3>> paths;
    for (const cl::Record& r : recording.records) {
      if (const auto* m = std::get_if<cl::Motion>(&r.body)) {
        if (m->kind != cl::Motion::Kind::continuation) {
          paths.emplace_back();
        }
        for (std::size_t i = 0; i < m->coordinates.size(); i += m->stride()) {
          paths.back().emplace_back(m->coordinates[i], m->coordinates[i + 1],
                                    m->coordinates[i + 2]);
          if (m->withAxis) {
            axes.emplace_back(m->coordinates[i + 3], m->coordinates[i + 4], m->coordinates[i + 5]);
          }
        }
      }
    }
    return paths;
  }

  CollectingSink diagnostics;
  std::vector<Vec3> axes;  ///< of all locations that have one
  runtime::MotionOutcome outcome;

 private:
  std::vector<runtime::Action> actions_;
};

inline void expectNear(const Vec3& got, const Vec3& want, double tolerance) {
  EXPECT_LE((got - want).norm(), tolerance)
      << "got " << got.transpose() << " want " << want.transpose();
}

}  // namespace arelem::test
