#include "runtime/path/frame_stage.h"

#include <optional>

#include "ir/diag/curves.h"
#include "ir/space/tolerance.h"
#include "runtime/path/frame.h"

namespace arelem::path {

namespace {
bool isSame(const Affine& a, const Affine& b) {
  return (a.linear - b.linear).cwiseAbs().maxCoeff() <= tolerance::symmetric &&
         (a.shift - b.shift).cwiseAbs().maxCoeff() <= tolerance::coincidence;
}

bool isMeantAsFrame(const cl::Post& post) {
  return post.foreign == "MSYS" || post.foreign == "CATIA0" || post.foreign == "LOCAL_ORIGIN" ||
         (post.foreign.empty() && post.word == Word::ROTABL);
}

/// Locations of three numbers get the axis z behind them.
void addAxes(cl::Motion& motion) {
  if (motion.withAxis) {
    return;
  }
  std::vector<double> six;
  six.reserve(2 * motion.coordinates.size());
  for (std::size_t i = 0; i + 3 <= motion.coordinates.size(); i += 3) {
    const double* p = motion.coordinates.data() + i;
    six.insert(six.end(), {p[0], p[1], p[2], 0.0, 0.0, 1.0});
  }
  motion.coordinates = std::move(six);
  motion.withAxis = true;
}

class FrameStage : public cl::RecordSink {
 public:
  FrameStage(cl::RecordSink& next, Frames frames, DiagnosticSink& sink)
      : next_(next), sink_(sink), applies_(frames == Frames::part) {}

  void accept(const cl::Record& record) override {
    const auto* post = std::get_if<cl::Post>(&record.body);
    if (post != nullptr && isMeantAsFrame(*post)) {
      return take(record, *post);
    }
    if (post != nullptr && endsTurns(*post)) {
      frame_.take(*post);
      look();
    }
    const bool motion = std::holds_alternative<cl::Motion>(record.body);
    if (motion && !applies_) {
      watch(record);
    }
    if (!applies_ || (!moves_ && !axes_)) {
      return next_.accept(record);
    }
    moved_ = record;
    if (motion) {
      showAxes();
    } else if (auto* multax = std::get_if<cl::Multax>(&moved_.body)) {
      multax->on = multax->on || axes_;
    }
    path::move(moved_, toPart_);
    next_.accept(moved_);
  }

 private:
  void take(const cl::Record& record, const cl::Post& post) {
    const bool named = frame_.take(post);
    if (!named && applies_) {
      sink_.accept(at(record.origin, fail(diag::FrameForm,
                                          post.foreign.empty() ? spell(post.word) : post.foreign)));
    }
    look();
    if (!named || !applies_) {
      return next_.accept(record);
    }
    moved_ = record;
    moved_.body = withoutFrame(post);
    next_.accept(moved_);
  }

  void look() {
    toPart_ = frame_.toPart();
    moves_ = !isSame(toPart_, Affine());
  }

  /// Where a frame turns z, all locations from there on have axes.
  void showAxes() {
    auto& motion = std::get<cl::Motion>(moved_.body);
    const bool turns = (toPart_.linear.col(2) - Vec3::UnitZ()).norm() > tolerance::symmetric;
    if (turns && !axes_ && !motion.withAxis) {
      cl::Record multax = moved_;
      multax.body = cl::Multax{true};
      next_.accept(multax);
    }
    axes_ = axes_ || turns;
    if (axes_) {
      addAxes(motion);
    }
  }

  /// Tells once where the path goes on in another frame than it began in.
  void watch(const cl::Record& record) {
    if (!used_) {
      used_ = toPart_;
    } else if (!told_ && !isSame(*used_, toPart_)) {
      sink_.accept(at(record.origin, fail(diag::FramesDiffer)));
      told_ = true;
    }
  }

  cl::RecordSink& next_;
  DiagnosticSink& sink_;
  bool applies_;
  FrameOfPlaces frame_;
  Affine toPart_;
  bool moves_ = false;
  bool axes_ = false;  ///< locations get axes
  bool told_ = false;
  std::optional<Affine> used_;  ///< of the first motion
  cl::Record moved_;
};
}  // namespace

std::unique_ptr<cl::RecordSink> makeFrameStage(cl::RecordSink& next,
                                               Frames frames,
                                               DiagnosticSink& sink) {
  return std::make_unique<FrameStage>(next, frames, sink);
}

}  // namespace arelem::path
