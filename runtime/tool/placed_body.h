#pragma once
#include "ir/space/vector.h"
#include "runtime/tool/body.h"

namespace arelem::tool {

/// The body of a cutter in one position.
class PlacedBody {
 public:
  /// The signed distance of a place to the body, and its gradient.
  struct Away {
    double distance = 0.0;
    Vec3 gradient = Vec3::Zero();
    Vec3 onCutter = Vec3::Zero();
  };

  PlacedBody(const Body& body, const Vec3& te, const Vec3& axis)
      : body_(body), te_(te), axis_(axis) {}

  [[nodiscard]] const Profile& cutter() const { return body_.cutter(); }
  [[nodiscard]] bool isConvex() const { return body_.isConvex(); }
  [[nodiscard]] bool isPlain() const { return body_.isPlain(); }
  [[nodiscard]] const Vec3& te() const { return te_; }
  [[nodiscard]] const Vec3& axis() const { return axis_; }

  [[nodiscard]] double distance(const Vec3& place) const {
    const Vec3 w = place - te_;
    const double z = w.dot(axis_);
    return body_.away((w - z * axis_).norm(), z).distance;
  }
  [[nodiscard]] Away away(const Vec3& place) const {
    const Vec3 w = place - te_;
    const double z = w.dot(axis_);
    const Vec3 across = w - z * axis_;
    const double rho = across.norm();
    const Vec3 out = rho > 0.0 ? Vec3(across / rho) : Vec3(axis_.unitOrthogonal());
    const Body::Away a = body_.away(rho, z);
    return {a.distance, a.byRho * out + a.byZ * axis_, te_ + a.onRho * out + a.onZ * axis_};
  }

 private:
  Body body_;
  Vec3 te_, axis_;
};

}  // namespace arelem::tool
