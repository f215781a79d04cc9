#include "runtime/motion/field.h"

#include <algorithm>
#include <cmath>

#include "ir/space/tolerance.h"
#include "runtime/certify/mesh_point_probe.h"
#include "runtime/certify/mesh_probe.h"
#include "runtime/certify/prove.h"
#include "runtime/motion/effort.h"
#include "runtime/tool/rounded.h"

namespace arelem::motion {

namespace {
template <surface::Surface S>
constexpr bool isFlat = std::is_same_v<S, surface::Plane>;

/// The faces of a mesh change the gap between any few places that one looks at: its chords are
/// proven.
template <surface::Surface S>
constexpr bool hasFaces = std::is_same_v<S, surface::Mesh>;

/// True for the surfaces of convex solids.
template <surface::Surface S>
bool bendsOneWay(const S& s) {
  if constexpr (requires { s.isConvex(); }) {
    return s.isConvex();
  }
  return isFlat<S> || std::is_same_v<S, surface::Sphere> || std::is_same_v<S, surface::Cylinder> ||
         std::is_same_v<S, surface::Cone>;
}

thread_local std::uint64_t measured = 0;

/// Cut vectors along a mesh are proven to keep their band within this: half of what the certificate
/// allows for rounding. Part unit.
double facetedSlack(double band) {
  return 0.5 * certify::slackOf(band);
}

constexpr double shortest = 0.5;
constexpr double longest = 0.95;

Judgement judged(certify::Probe& probe, const certify::Chord& chord, double inner, double outer) {
  probe.take(chord);
  certify::Node first = probe.at(0.0);
  const certify::Verdict v =
      certify::prove(probe, {inner, outer, facetedSlack(inner + outer), false}, first);
  measured += v.nodes;
  if (v.good()) {
    return {tolerance::farAway, 0};
  }
  const double near = -inner - v.least.measured;
  const double far = v.greatest.measured - outer;
  Judgement result = judgeGap(near >= far ? v.least.measured : v.greatest.measured, inner, outer);
  result.factor = std::clamp(result.factor, shortest, longest);
  result.miss = near >= far ? -1 : 1;
  return result;
}

template <surface::Surface S>
class OnField final : public Field {
 public:
  /// `thick`: of a tool without size.
  OnField(S s, double side, double thick)
      : Field(isFlat<S>, hasFaces<S>, bendsOneWay(s)),
        surface_(std::move(s)),
        side_(side),
        thick_(thick) {}
  tool::Contact at(const Vec3& toolEnd, const Vec3&) override {
    ++measured;
    tool::Contact c = tool::pointContact(surface_, side_, toolEnd, hint_);
    c.gap -= thick_;
    return c;
  }
  Judgement judge(const certify::Chord& chord, double inner, double outer) override {
    if constexpr (hasFaces<S>) {
      if (!probe_) {
        probe_ = std::make_unique<certify::MeshPointProbe>(surface_, side_, thick_);
      }
      return judged(*probe_, chord, inner, outer);
    }
    return Field::judge(chord, inner, outer);
  }
  std::optional<Bulge> bulge(const certify::Chord& chord, double outer) override {
    if (!probe_) {
      probe_ = certify::makeProbe(surface_, {nullptr, side_, 0.0});
    }
    return bulgeOver(*probe_, chord, outer + thick_);
  }

 private:
  S surface_;
  double side_, thick_;
  typename S::Hint hint_{};
  std::unique_ptr<certify::Probe> probe_;
};

template <surface::Surface S>
class CutterField final : public Field {
 public:
  CutterField(S s, double side, const tool::Profile& cutter, double thick)
      : Field(isFlat<S>, hasFaces<S>, bendsOneWay(s)),
        surface_(std::move(s)),
        side_(side),
        cutter_(cutter),
        thick_(thick) {}
  tool::Contact at(const Vec3& toolEnd, const Vec3& axis) override {
    ++measured;
    if constexpr (hasFaces<S>) {
      // A motion is planned by looks at one place, which take long.
      if (!last_ || toolEnd != last_->toolEnd || axis != last_->axis) {
        last_ = Looked{toolEnd, axis, contact(toolEnd, axis)};
      }
      return last_->contact;
    }
    return contact(toolEnd, axis);
  }
  Judgement judge(const certify::Chord& chord, double inner, double outer) override {
    if constexpr (hasFaces<S>) {
      const certify::Relation relation{&cutter_, side_, thick_};
      if (!probe_ && tool::isConvex(cutter_)) {
        probe_ = std::make_unique<certify::MeshProbe>(surface_, relation, search_);
      } else if (!probe_) {
        probe_ = certify::makeProbe(surface_, relation);
      }
      return judged(*probe_, chord, inner, outer);
    }
    return Field::judge(chord, inner, outer);
  }
  std::optional<Bulge> bulge(const certify::Chord& chord, double outer) override {
    if (!probe_) {
      probe_ = certify::makeProbe(surface_, {&cutter_, side_, thick_});
    }
    return bulgeOver(*probe_, chord, outer);
  }
  [[nodiscard]] std::optional<Facets> facets() const override {
    if constexpr (hasFaces<S>) {
      if (tool::isConvex(cutter_)) {
        return Facets{&surface_, &cutter_, thick_};
      }
    }
    return std::nullopt;
  }

 private:
  tool::Contact contact(const Vec3& toolEnd, const Vec3& axis) {
    tool::Contact c = tool::contact(surface_, side_, cutter_, toolEnd, axis, search_);
    c.gap -= thick_;
    return c;
  }

  struct Looked {
    Vec3 toolEnd, axis;
    tool::Contact contact;
  };
  std::optional<Looked> last_;
  S surface_;
  double side_;
  tool::Profile cutter_;
  double thick_;
  tool::Search<S> search_;
  std::unique_ptr<certify::Probe> probe_;
};
}  // namespace

std::uint64_t gapsMeasured() {
  return measured;
}

Judgement judgeGap(double gap, double inner, double outer) {
  const double beyond = std::max(-inner - gap, gap - outer);
  const double band = inner + outer;
  if (beyond <= facetedSlack(band)) {
    return {tolerance::farAway, 0};
  }
  return {std::sqrt(band / (band + beyond)), gap < -inner ? -1 : 1};
}

Judgement Field::judge(const certify::Chord&, double, double) {
  return {tolerance::farAway, 0};
}

std::unique_ptr<Field> makeField(const surface::AnySurface& any, double side, Tool tool) {
  return std::visit(
      [&]<class S>(const S& s) -> std::unique_ptr<Field> {
        if (tool.cutter == nullptr) {
          return std::make_unique<OnField<S>>(s, side, 0.0);
        }
        // A line has no depth in a mesh: of a tool without size the end counts.
        if (hasFaces<S> && tool.cutter->isPoint()) {
          return std::make_unique<OnField<S>>(s, side, tool.thick);
        }
        return std::make_unique<CutterField<S>>(s, side, *tool.cutter, tool.thick);
      },
      any);
}

surface::Foot footOn(const surface::AnySurface& any, const Vec3& point) {
  return std::visit(
      [&]<class S>(const S& s) {
        typename S::Hint hint{};
        return s.foot(point, hint);
      },
      any);
}

double hollowRadius(const surface::AnySurface& any, double side, const Vec3& point) {
  return std::visit(
      [&]<class S>(const S& s) {
        typename S::Hint hint{};
        const Vec3 n = s.foot(point, hint).normal;
        const Vec3 at = point - s.foot(point, hint).distance * n;
        const surface::Foot there = s.foot(at, hint);
        const Vec3 e1 = n.unitOrthogonal();
        const Vec3 e2 = n.cross(e1);
        const double a = side * s.bend(at, there, e1, hint);
        const double c = side * s.bend(at, there, e2, hint);
        const double b = 0.5 * (side * s.bend(at, there, e1 + e2, hint) - a - c);
        const double least = 0.5 * (a + c) - std::hypot(0.5 * (a - c), b);
        return least < 0.0 ? -1.0 / least : tolerance::farAway;
      },
      any);
}

}  // namespace arelem::motion
