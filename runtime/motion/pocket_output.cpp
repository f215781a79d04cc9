#include "runtime/motion/pocket.h"

namespace arelem::motion {

namespace {
class PocketOutput {
 public:
  PocketOutput(const Vec3& axis, bool output, bool withAxis, RecordWriter& writer)
      : axis_(axis), output_(output), withAxis_(withAxis), writer_(writer) {}

  /// What follows is cut at this feed.
  void feed(double value) {
    finish();
    writer_.putFeed(value);
  }

  void add(const Vec3& toolEnd) {
    if (totals_.cutVectors == 0) {
      totals_.first = toolEnd;
    } else {
      totals_.length += (toolEnd - totals_.last).norm();
    }
    totals_.beforeLast = totals_.last;
    totals_.last = toolEnd;
    ++totals_.cutVectors;
    if (!output_) {
      return;
    }
    if (!open_) {
      writer_.startPoints(cl::Motion::Kind::go, "POCKET", 0, withAxis_);
      open_ = true;
    }
    writer_.add(toolEnd, axis_);
  }

  PocketTotals finish() {
    if (open_) {
      writer_.finishPoints();
      open_ = false;
    }
    return totals_;
  }

 private:
  const Vec3& axis_;
  bool output_, withAxis_;
  RecordWriter& writer_;
  bool open_ = false;
  PocketTotals totals_;
};
}  // namespace

PocketTotals putPocket(
    const PocketPlan& plan, const Vec3& axis, bool output, bool withAxis, RecordWriter& writer) {
  PocketOutput out(axis, output, withAxis, writer);
  out.feed(plan.order.plungeFeed);
  out.add(plan.passes.front().front());
  out.feed(plan.order.generalFeed);
  for (std::size_t i = 0; i < plan.passes.size(); ++i) {
    const std::vector<Vec3>& pass = plan.passes[i];
    if (i + 1 == plan.passes.size()) {
      out.feed(plan.order.finishFeed);
    }
    if (i > 0) {
      out.add(pass.front());
    }
    for (std::size_t k = 1; k < pass.size(); ++k) {
      out.add(pass[k]);
    }
    out.add(pass.front());
  }
  return out.finish();
}

}  // namespace arelem::motion
