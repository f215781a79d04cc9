#include "runtime/path/feed_override.h"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include "ir/space/tolerance.h"
#include "runtime/interpret/passed_post.h"

namespace arelem::path {

namespace {
/// The last `distance` of a path with its own feed.
struct Override {
  double distance = 0.0;  ///< part unit
  double feed = 0.0;
};

/// A FEDRAT of numbers alone.
struct Feed {
  std::optional<double> basic;
  std::optional<Override> near;
  bool once = false;  ///< for the next sequence only
};

std::optional<Feed> feedOf(const cl::Post& post) {
  if (!cl::is(post, Word::FEDRAT) || post.arguments.empty() || post.arguments.size() > 3) {
    return std::nullopt;
  }
  std::vector<double> numbers;
  for (const cl::Value& value : post.arguments) {
    const double* number = std::get_if<double>(&value);
    if (number == nullptr || !(*number > 0.0)) {
      return std::nullopt;
    }
    numbers.push_back(*number);
  }
  switch (numbers.size()) {
    case 1:
      return Feed{numbers[0], std::nullopt, false};
    case 2:
      return Feed{std::nullopt, Override{numbers[0], numbers[1]}, true};
    default:
      return Feed{numbers[0], Override{numbers[1], numbers[2]}, false};
  }
}

Vec3 pointAt(const std::vector<double>& numbers, std::size_t at) {
  return {numbers[at], numbers[at + 1], numbers[at + 2]};
}

class Stage : public FeedOverride {
 public:
  Stage(cl::RecordSink& next, const std::vector<runtime::Action>& actions) : next_(next) {
    for (const runtime::Action& action : actions) {
      if (std::holds_alternative<runtime::Follow>(action.body)) {
        sequences_.insert(action.isn);
      }
    }
  }

  void accept(const cl::Record& record) override {
    const auto* motion = std::get_if<cl::Motion>(&record.body);
    const bool continues = motion != nullptr && motion->kind == cl::Motion::Kind::continuation &&
                           !held_.empty() && held_.back().isn == record.isn;
    if (!continues) {
      endSequence();
    }
    const auto* post = std::get_if<cl::Post>(&record.body);
    const auto feed = post != nullptr ? feedOf(*post) : std::nullopt;
    if (feed) {
      return take(record, *feed);
    }
    if (cl::postOf(record.body, Word::FEDRAT) != nullptr) {
      basic_ = record;
      near_.reset();
    }
    if (motion == nullptr) {
      next_.accept(record);
    } else if (near_ && (continues || sequences_.contains(record.isn))) {
      held_.push_back(record);
    } else {
      pass(record);
    }
  }

  void finish() override { endSequence(); }

 private:
  void take(const cl::Record& record, const Feed& feed) {
    near_ = feed.near;
    once_ = feed.once;
    if (feed.basic) {
      basic_ = record;
      std::get<cl::Post>(basic_->body).arguments = {*feed.basic};
      next_.accept(*basic_);
    }
  }
  void pass(const cl::Record& record) {
    const auto& motion = std::get<cl::Motion>(record.body);
    if (!motion.coordinates.empty()) {
      at_.assign(motion.coordinates.end() - static_cast<std::ptrdiff_t>(motion.stride()),
                 motion.coordinates.end());
    }
    next_.accept(record);
  }

  /// How much path of the held records lies behind each of their locations, from the last one on,
  /// until it is more than `distance`.
  struct Split {
    std::size_t record = 0;    ///< the move into this location
    std::size_t location = 0;  ///< of the record
    double share = 0.0;        ///< of that move that comes before the change
  };
  [[nodiscard]] std::optional<Split> split(double distance) const {
    double behind = 0.0;
    for (std::size_t r = held_.size(); r-- > 0;) {
      const auto& motion = std::get<cl::Motion>(held_[r].body);
      for (std::size_t k = motion.points(); k-- > 0;) {
        const std::vector<double> from = before(r, k);
        if (from.empty()) {
          return std::nullopt;
        }
        const double move =
            (pointAt(motion.coordinates, k * motion.stride()) - pointAt(from, 0)).norm();
        if (behind + move > distance) {
          return Split{r, k, (behind + move - distance) / move};
        }
        behind += move;
      }
    }
    return std::nullopt;
  }
  /// The location before one of a held record; empty where the path begins.
  [[nodiscard]] std::vector<double> before(std::size_t r, std::size_t k) const {
    if (k == 0 && r == 0) {
      return at_;
    }
    const auto& motion = std::get<cl::Motion>(held_[k == 0 ? r - 1 : r].body);
    const auto stride = static_cast<std::ptrdiff_t>(motion.stride());
    const auto end = k == 0 ? motion.coordinates.end()
                            : motion.coordinates.begin() + static_cast<std::ptrdiff_t>(k) * stride;
    return {end - stride, end};
  }

  void endSequence() {
    if (held_.empty()) {
      return;
    }
    const auto at = split(near_->distance);
    const std::vector<cl::Record> held = std::exchange(held_, {});
    if (!at) {
      putFeed(held.front());
    }
    for (std::size_t r = 0; r < held.size(); ++r) {
      at && at->record == r ? putSplit(held[r], *at) : pass(held[r]);
    }
    if (basic_) {
      cl::Record back = *basic_;
      back.isn = held.back().isn;
      back.origin = held.back().origin;
      next_.accept(back);
    }
    if (once_) {
      near_.reset();
    }
  }
  void putFeed(const cl::Record& like) {
    cl::Record feed = like;
    feed.body = cl::Post{Word::FEDRAT, "", {near_->feed}};
    if (basic_) {  // in the same unit
      const auto& arguments = std::get<cl::Post>(basic_->body).arguments;
      for (const cl::Value& value : arguments) {
        if (std::holds_alternative<Word>(value)) {
          std::get<cl::Post>(feed.body).arguments.push_back(value);
        }
      }
    }
    next_.accept(feed);
  }
  void putSplit(const cl::Record& record, const Split& at) {
    const auto& whole = std::get<cl::Motion>(record.body);
    const std::size_t stride = whole.stride();
    const auto cut = whole.coordinates.begin() + static_cast<std::ptrdiff_t>(at.location * stride);
    cl::Record first = record, second = record;
    auto& begin = std::get<cl::Motion>(first.body);
    auto& end = std::get<cl::Motion>(second.body);
    begin.coordinates.assign(whole.coordinates.begin(), cut);
    end.coordinates.assign(cut, whole.coordinates.end());
    const std::vector<double> from =
        at.location == 0 ? at_ : std::vector(cut - static_cast<std::ptrdiff_t>(stride), cut);
    const double length = (pointAt(end.coordinates, 0) - pointAt(from, 0)).norm();
    if (at.share * length > tolerance::coincidence) {
      for (std::size_t i = 0; i < stride; ++i) {
        begin.coordinates.push_back(from[i] + at.share * (end.coordinates[i] - from[i]));
      }
      if (stride > 3) {
        unitAxis(begin.coordinates, begin.coordinates.size() - stride + 3);
      }
    }
    if (!begin.coordinates.empty()) {
      end.kind = cl::Motion::Kind::continuation;
      pass(first);
    }
    putFeed(record);
    pass(second);
  }
  static void unitAxis(std::vector<double>& numbers, std::size_t at) {
    const Vec3 axis = pointAt(numbers, at).normalized();
    for (int i = 0; i < 3; ++i) {
      numbers[at + static_cast<std::size_t>(i)] = axis[i];
    }
  }

  cl::RecordSink& next_;
  std::set<int> sequences_;
  std::optional<cl::Record> basic_;  ///< the feed to go back to
  std::optional<Override> near_;
  bool once_ = false;
  std::vector<cl::Record> held_;  ///< of the sequence in work
  std::vector<double> at_;        ///< the location before it
};
}  // namespace

std::unique_ptr<FeedOverride> makeFeedOverride(cl::RecordSink& next,
                                               const std::vector<runtime::Action>& actions) {
  return std::make_unique<Stage>(next, actions);
}

bool overridesFeeds(const std::vector<runtime::Action>& actions) {
  return std::any_of(actions.begin(), actions.end(), [](const runtime::Action& action) {
    const cl::Post* post = runtime::passedPost(action);
    const auto feed = post != nullptr ? feedOf(*post) : std::nullopt;
    return feed && feed->near;
  });
}

}  // namespace arelem::path
