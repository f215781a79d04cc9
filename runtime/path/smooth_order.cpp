#include "runtime/path/smooth_order.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "ir/diag/spline.h"

namespace arelem::path {

namespace {

constexpr double mostPrecision = 1000.0;
/// Of the tolerance for the fit: the rest is for the chords and the smoothing.
constexpr double mostShare = 0.8;

/// A word of the vocabulary or of none, as it is written; "" for a number.
std::string_view spelling(const cl::Value& value) {
  if (const Word* word = std::get_if<Word>(&value)) {
    return spell(*word);
  }
  const std::string* text = std::get_if<std::string>(&value);
  return text == nullptr ? std::string_view() : std::string_view(*text);
}

/// Reads SMOOTH/tol [,SPLINE] [,CLOSED] [,METHOD,n] [,PRECIS,n] [,ACCUR,percent] [,SHARE,percent].
class OrderReader {
 public:
  explicit OrderReader(const std::vector<cl::Value>& values) : values_(values) {}

  Result<SmoothOrder> read() {
    const double* tolerance = number(0);
    if (tolerance == nullptr) {
      return fail(diag::SmoothForm, std::string("no tolerance first"));
    }
    SmoothOrder order;
    order.tolerance = *tolerance;
    if (!(*tolerance > 0.0) || !std::isfinite(*tolerance)) {
      return fail(diag::SmoothTolerance, *tolerance);
    }
    for (std::size_t i = 1; i < values_.size(); ++i) {
      if (auto failure = modifier(order, i)) {
        return *std::move(failure);
      }
    }
    order.options.tolerance = (1.0 - order.share - SmoothOrder::chordShare) * order.tolerance;
    return order;
  }

 private:
  [[nodiscard]] const double* number(std::size_t i) const {
    return i < values_.size() ? std::get_if<double>(&values_[i]) : nullptr;
  }

  std::optional<Failure> modifier(SmoothOrder& order, std::size_t& i) {
    const std::string_view word = spelling(values_[i]);
    if (word == "SPLINE" || word == "CLOSED") {
      (word == "SPLINE" ? order.keepSpline : order.closed) = true;
      return std::nullopt;
    }
    const double* value = number(i + 1);
    if (word.empty() || value == nullptr) {
      return fail(diag::SmoothForm, fmt::format("parameter {} that fits no form", i + 1));
    }
    ++i;
    if (word == "METHOD") {
      if (*value != 1.0 && *value != 2.0 && *value != 3.0) {
        return fail(diag::SmoothForm,
                    fmt::format("METHOD {}; there are 1 (the source's), 2 (least of the largest "
                                "curvature in the tube) and 3 (least time)",
                                *value));
      }
      order.options.method = *value == 1.0   ? smooth::Method::source
                             : *value == 2.0 ? smooth::Method::tube
                                             : smooth::Method::time;
    } else if (word == "PRECIS") {
      order.options.precision = static_cast<int>(std::clamp(*value, 0.0, mostPrecision));
    } else if (word == "ACCUR") {
      order.options.accuracy = *value / 100.0;
    } else if (word == "SHARE") {
      order.share = *value / 100.0;
      if (!(order.share > 0.0 && order.share < mostShare)) {
        return fail(diag::SmoothForm,
                    fmt::format("SHARE {}; it is above 0 and below 80 percent", *value));
      }
    } else {
      return fail(diag::SmoothForm, fmt::format("`{}`", word));
    }
    if (order.options.precision < 1 ||
        !(order.options.accuracy > 0.0 && order.options.accuracy < 1.0)) {
      return fail(diag::SmoothSettings, order.options.precision, 100.0 * order.options.accuracy);
    }
    return std::nullopt;
  }

  const std::vector<cl::Value>& values_;
};

}  // namespace

bool endsSmoothing(const cl::Post& post) {
  return post.arguments.size() == 1 && spelling(post.arguments[0]) == "NOMORE";
}

Result<SmoothOrder> readSmoothOrder(const cl::Post& post) {
  return OrderReader(post.arguments).read();
}

}  // namespace arelem::path
