#include "runtime/certify/output_order.h"

#include <cmath>

#include <Eigen/Dense>

#include "ir/space/tolerance.h"

namespace arelem::certify {

namespace {
const double* numberAt(const std::vector<cl::Value>& values, std::size_t i) {
  return i < values.size() ? std::get_if<double>(&values[i]) : nullptr;
}
double valueAt(const std::vector<cl::Value>& values, std::size_t i) {
  const double* number = numberAt(values, i);
  return number != nullptr ? *number : 0.0;
}
const cl::SurfaceValue* matrixAt(const std::vector<cl::Value>& values, std::size_t i) {
  const auto* matrix = i < values.size() ? std::get_if<cl::SurfaceValue>(&values[i]) : nullptr;
  return matrix != nullptr && matrix->canon.size() == 12 ? matrix : nullptr;
}

Location moved(const Location& l, const path::Affine& by) {
  return {by.point(l.toolEnd), by.direction(l.axis)};
}

/// The matrix of the k-th copy, from that of the one before it.
path::Affine stepOf(const std::vector<cl::Value>& v, std::uint64_t k, const path::Affine& before) {
  const Word mode = std::get<Word>(v[1]);
  const auto times = static_cast<double>(k);
  if (mode == Word::TRANSL) {
    return path::Affine::translation(times * Vec3(valueAt(v, 2), valueAt(v, 3), valueAt(v, 4)));
  }
  if (mode == Word::XYROT) {
    return path::Affine::rotation(times * valueAt(v, 2));
  }
  const cl::SurfaceValue* matrix = matrixAt(v, 2);
  return matrix != nullptr ? path::Affine::fromRows(matrix->canon).after(before) : before;
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

void OutputOrder::index(const cl::Post& post) {
  const double* number = numberAt(post.arguments, 0);
  if (number == nullptr) {
    return;
  }
  if (post.arguments.size() == 1) {
    open_.push_back({*number, {}});
  } else if (!open_.empty() && open_.back().index == *number) {
    closed_.insert_or_assign(*number, std::move(open_.back()));
    open_.pop_back();
  }
}

void OutputOrder::copy(const cl::Post& post, std::string& objection) {
  const std::vector<cl::Value>& v = post.arguments;
  const double* number = numberAt(v, 0);
  const Word* mode = v.size() > 1 ? std::get_if<Word>(&v[1]) : nullptr;
  if (number == nullptr || mode == nullptr || numberAt(v, v.size() - 1) == nullptr) {
    objection = "a COPY that cannot be read";
    return;
  }
  if (!open_.empty() && open_.back().index == *number) {
    closed_.insert_or_assign(*number, std::move(open_.back()));
    open_.pop_back();
  }
  const auto range = closed_.find(*number);
  if (range == closed_.end()) {
    return;
  }
  pending_ = {range->second.runs, v, 0, 1, 0, {}};
  pending_.times = static_cast<std::uint64_t>(std::max(0.0, valueAt(v, v.size() - 1)));
  pending_.by = stepOf(v, 1, {});
}

OutputOrder::Copy OutputOrder::takeCopy() {
  Copy copy{pending_.runs[pending_.run], pending_.number};
  for (Location& l : copy.run.locations) {
    l = moved(l, pending_.by);
  }
  if (++pending_.run == pending_.runs.size()) {
    pending_.run = 0;
    pending_.by = stepOf(pending_.plan, ++pending_.number, pending_.by);
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

void OutputOrder::keep(const Run& run) {
  for (Range& range : open_) {
    range.runs.push_back(run);
  }
}

}  // namespace arelem::certify
