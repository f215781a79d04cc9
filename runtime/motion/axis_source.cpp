#include "runtime/motion/axis_source.h"

#include "ir/diag/motion.h"
#include "runtime/geometry/ruling.h"

namespace arelem::motion {

namespace {
class NormalAxis final : public AxisSource {
 public:
  NormalAxis(const surface::AnySurface& surface, double side)
      : field_(makeField(surface, side, {})) {}
  Vec3 at(const Vec3& toolEnd) override { return field_->at(toolEnd, Vec3::UnitZ()).normal; }

 private:
  std::unique_ptr<Field> field_;
};

class RulingAxis final : public AxisSource {
 public:
  RulingAxis(const surface::AnySurface& surface, const Vec3& start)
      : surface_(surface), last_(start) {}
  Vec3 at(const Vec3& toolEnd) override {
    if (const auto line = surface::rulingAt(surface_, toolEnd)) {
      last_ = line->dot(last_) < 0.0 ? Vec3(-*line) : *line;
    }
    return last_;
  }

 private:
  surface::AnySurface surface_;
  Vec3 last_;
};
}  // namespace

std::unique_ptr<AxisSource> normalTo(const surface::AnySurface& surface, double side) {
  return std::make_unique<NormalAxis>(surface, side);
}

Result<std::unique_ptr<AxisSource>> alongRulings(const surface::AnySurface& surface,
                                                 const std::string& name,
                                                 const Vec3& toolEnd,
                                                 const Vec3& start) {
  if (!surface::rulingAt(surface, toolEnd)) {
    return fail(diag::NoRulings, name);
  }
  return std::unique_ptr<AxisSource>(std::make_unique<RulingAxis>(surface, start));
}

}  // namespace arelem::motion
