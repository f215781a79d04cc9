#include "runtime/path/arc_start.h"

#include <optional>
#include <utility>

#include "ir/cl/post_word.h"

namespace arelem::path {

namespace {
class ArcStart : public cl::RecordSink {
 public:
  explicit ArcStart(cl::RecordSink& next) : next_(next) {}

  void accept(const cl::Record& record) override {
    if (const auto* post = std::get_if<cl::Post>(&record.body)) {
      moves_ = moves_ || cl::is(*post, Word::TRACUT) || cl::is(*post, Word::INDEX) ||
               cl::is(*post, Word::COPY);
    }
    if (moves_ && std::holds_alternative<cl::Surface>(record.body)) {
      release();
      held_ = record;  // until the motion behind it tells whether it is an arc
      return;
    }
    const auto* motion = std::get_if<cl::Motion>(&record.body);
    if (motion != nullptr && motion->points() > 0) {
      if (moves_ && motion->isArc() && last_) {
        begin(record);
      }
      moves_ = false;
      release();
      remember(*motion);
    } else {
      release();
    }
    next_.accept(record);
  }

 private:
  void begin(const cl::Record& arc) {
    cl::Record start = arc;
    start.body = *last_;
    next_.accept(start);
  }
  void release() {
    if (held_) {
      next_.accept(*std::exchange(held_, std::nullopt));
    }
  }
  void remember(const cl::Motion& motion) {
    if (!last_) {
      last_.emplace();
    }
    last_->withAxis = motion.withAxis;
    last_->withSide = motion.withSide;
    last_->coordinates.assign(
        motion.coordinates.end() - static_cast<std::ptrdiff_t>(motion.stride()),
        motion.coordinates.end());
  }

  cl::RecordSink& next_;
  bool moves_ = false;  ///< such a statement came, and no location since
  std::optional<cl::Motion> last_;
  std::optional<cl::Record> held_;
};
}  // namespace

std::unique_ptr<cl::RecordSink> makeArcStart(cl::RecordSink& next) {
  return std::make_unique<ArcStart>(next);
}

}  // namespace arelem::path
