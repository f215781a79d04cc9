#include "runtime/certify/output_order.h"

#include <cmath>

#include <Eigen/Dense>

#include "ir/space/tolerance.h"

namespace arelem::certify {

namespace {
const double* numberAt(const std::vector<cl::Value>& values, std::size_t i) {
  return i < values.size() ? std::get_if<double>(&values[i]) : nullptr;
}
const cl::SurfaceValue* matrixAt(const std::vector<cl::Value>& values, std::size_t i) {
  const auto* matrix = i < values.size() ? std::get_if<cl::SurfaceValue>(&values[i]) : nullptr;
  return matrix != nullptr && matrix->canon.size() == 12 ? matrix : nullptr;
}

Location moved(const Location& l, const path::Affine& by) {
  return {by.point(l.toolEnd), by.direction(l.axis)};
}
}  // namespace

bool OutputOrder::apply(const cl::Body& body, std::string& objection) {
  const auto* post = std::get_if<cl::Post>(&body);
  if (post == nullptr || !post->foreign.empty()) {
    return false;
  }
  switch (post->word) {
    case Word::TRACUT:
      tracut(*post, objection);
      return true;
    case Word::INDEX:
      index(*post);
      return true;
    case Word::COPY:
      copy(*post, objection);
      return true;
    default:
      return false;
  }
}

void OutputOrder::tracut(const cl::Post& post, std::string& objection) {
  back_.reset();
  const cl::SurfaceValue* matrix = matrixAt(post.arguments, 0);
  if (matrix == nullptr) {
    return;
  }
  const path::Affine by = path::Affine::fromRows(matrix->canon);
  const double size = by.linear.norm();
  if (!(std::abs(by.linear.determinant()) > tolerance::singular * size * size * size)) {
    objection = "the matrix of TRACUT has no inverse";
    return;
  }
  path::Affine back;
  back.linear = by.linear.inverse();
  back.shift = -(back.linear * by.shift);
  back_ = back;
}

void OutputOrder::goOn() {
  while (!open_.empty() && open_.back().copied) {
    closeRange();
  }
}

void OutputOrder::closeRange() {
  closed_.insert_or_assign(open_.back().index, std::move(open_.back()));
  open_.pop_back();
}

void OutputOrder::index(const cl::Post& post) {
  goOn();
  const double* number = numberAt(post.arguments, 0);
  if (number == nullptr) {
    return;
  }
  if (post.arguments.size() == 1) {
    open_.push_back({*number, {}});
  } else if (!open_.empty() && open_.back().index == *number) {
    closeRange();
  }
}

void OutputOrder::copy(const cl::Post& post, std::string& objection) {
  auto plan = path::readCopy(post.arguments);
  if (!plan) {
    objection = "a COPY that cannot be read";
    return;
  }
  while (!open_.empty() && open_.back().copied && open_.back().index != plan->index) {
    closeRange();
  }
  const auto closed = closed_.find(plan->index);
  Range* range = closed != closed_.end()                               ? &closed->second
                 : !open_.empty() && open_.back().index == plan->index ? &open_.back()
                                                                       : nullptr;
  if (range != nullptr) {
    range->copied = true;
    pending_ = {range->runs, *std::move(plan), 1, 0, {}};
    pending_.by = pending_.plan.step(1, {});
  }
}

OutputOrder::Copy OutputOrder::takeCopy() {
  const Kept& original = pending_.runs[pending_.run];
  // The outer copy moves what the inner ones then move on.
  const Kept kept{original.run, original.copied.after(pending_.by)};
  Copy copy{kept.run, pending_.number};
  for (Location& l : copy.run.locations) {
    l = moved(l, kept.copied);
  }
  keep(kept);
  if (++pending_.run == pending_.runs.size()) {
    pending_.run = 0;
    pending_.by = pending_.plan.step(++pending_.number, pending_.by);
  }
  return copy;
}

Location OutputOrder::programmed(const Location& location) const {
  return back_ ? moved(location, *back_) : location;
}

OutputOrder::Run OutputOrder::programmed(const Run& run) const {
  Run result = run;
  for (Location& l : result.locations) {
    l = programmed(l);
  }
  return result;
}

void OutputOrder::keep(const Kept& kept) {
  for (Range& range : open_) {
    range.runs.push_back(kept);
  }
}

}  // namespace arelem::certify
