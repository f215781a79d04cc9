#include "runtime/motion/field.h"

namespace arelem::motion {

namespace {
template <surface::Surface S>
constexpr bool isFlat = std::is_same_v<S, surface::Plane>;

template <surface::Surface S>
class OnField final : public Field {
 public:
  OnField(S s, double side) : Field(isFlat<S>), surface_(std::move(s)), side_(side) {}
  tool::Contact at(const Vec3& toolEnd, const Vec3&) override {
    return tool::pointContact(surface_, side_, toolEnd, hint_);
  }

 private:
  S surface_;
  double side_;
  typename S::Hint hint_{};
};

template <surface::Surface S>
class CutterField final : public Field {
 public:
  CutterField(S s, double side, const tool::Profile& cutter, double thick)
      : Field(isFlat<S>), surface_(std::move(s)), side_(side), cutter_(cutter), thick_(thick) {}
  tool::Contact at(const Vec3& toolEnd, const Vec3& axis) override {
    tool::Contact c = tool::contact(surface_, side_, cutter_, toolEnd, axis, search_);
    c.gap -= thick_;
    return c;
  }

 private:
  S surface_;
  double side_;
  tool::Profile cutter_;
  double thick_;
  tool::Search<S> search_;
};
}  // namespace

std::unique_ptr<Field> makeField(const surface::AnySurface& any, double side, Tool tool) {
  return std::visit(
      [&]<class S>(const S& s) -> std::unique_ptr<Field> {
        if (tool.cutter == nullptr) {
          return std::make_unique<OnField<S>>(s, side);
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

}  // namespace arelem::motion
