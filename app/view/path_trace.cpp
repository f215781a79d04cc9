#include "app/view/path_trace.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace arelem::app {

namespace {
constexpr float unknown = std::numeric_limits<float>::quiet_NaN();
constexpr double assumedSpeed = 50.0;  // units a second, where no time law holds

bool isPerSecond(const cl::Post& post) {
  return std::any_of(post.arguments.begin(), post.arguments.end(),
                     [](const cl::Value& v) { return v == cl::Value(Word::MMPS); });
}
}  // namespace

PathTrace::PathTrace(backend::Scene& scene, const SourceMap& sources)
    : scene_(scene), sources_(sources), timer_(timing::Machine(), complaints_) {
  timer_.tellPieces([this](std::uint64_t move, double seconds) {
    if (move < moves_.size()) {
      scene_.seconds[moves_[move]] += static_cast<float>(seconds);
    }
  });
}

void PathTrace::accept(const cl::Record& record) {
  if (const auto* motion = std::get_if<cl::Motion>(&record.body)) {
    move(*motion, record);
  } else if (const auto* post = std::get_if<cl::Post>(&record.body)) {
    command(*post);
  } else if (std::holds_alternative<cl::Surface>(record.body)) {
    arc_ = true;
  } else if (const auto* values = std::get_if<cl::Values>(&record.body)) {
    if (values->word == Word::CUTTER && !values->values.empty()) {
      scene_.cutters.push_back({static_cast<std::uint32_t>(scene_.kinds.size()),
                                std::abs(values->values[0]),
                                values->values.size() > 1 ? std::abs(values->values[1]) : 0.0});
    }
  } else if (const auto* text = std::get_if<cl::Text>(&record.body)) {
    if (text->word == Word::PARTNO && scene_.title.empty()) {
      scene_.title = text->text;
    }
  }
  timer_.accept(record);
}

void PathTrace::command(const cl::Post& post) {
  if (!post.foreign.empty()) {
    return;
  }
  const Word* word = post.arguments.empty() ? nullptr : std::get_if<Word>(&post.arguments[0]);
  const double* number = nullptr;
  for (const cl::Value& value : post.arguments) {
    number = number == nullptr ? std::get_if<double>(&value) : number;
  }
  changed_ = changed_ || post.word == Word::RAPID || post.word == Word::FEDRAT;
  if (post.word == Word::RAPID) {
    rapid_ = true;
  } else if (post.word == Word::FEDRAT && number != nullptr) {
    feed_ = static_cast<float>(*number * (isPerSecond(post) ? 60.0 : 1.0));
  } else if (post.word == Word::CYCLE) {
    cycle_ = word == nullptr || (*word != Word::OFF && *word != Word::NOMORE);
  } else if (post.word == Word::SPRAY) {
    gun_ = word != nullptr && *word == Word::ON;
  }
}

void PathTrace::beginStretch(const cl::Record& record) {
  backend::SceneStretch stretch;
  stretch.first = static_cast<std::uint32_t>(scene_.kinds.size());
  if (record.origin.buffer.index < sources_.size()) {
    stretch.file = record.origin.buffer.index;
    stretch.line = sources_.locate(record.origin.buffer, record.origin.begin).line;
  }
  stretch.feed = feed_;
  stretch.inner = stretch.outer = stretch.allowedInner = stretch.allowedOuter = unknown;
  scene_.stretches.push_back(stretch);
  isns_.push_back(record.isn);
}

void PathTrace::addAxis(const cl::Motion& motion, std::size_t at) {
  if (motion.withAxis && !multax_) {  // all before stood upright
    multax_ = true;
    scene_.axes.resize(3 * scene_.kinds.size());
    for (std::size_t i = 2; i < scene_.axes.size(); i += 3) {
      scene_.axes[i] = 1.0F;
    }
  }
  if (multax_) {
    for (std::size_t i = 0; i < 3; ++i) {
      scene_.axes.push_back(motion.withAxis ? static_cast<float>(motion.coordinates[at + 3 + i])
                            : i == 2        ? 1.0F
                                            : 0.0F);
    }
  }
}

void PathTrace::move(const cl::Motion& motion, const cl::Record& record) {
  using backend::SceneMove;
  const bool continues = motion.kind == cl::Motion::Kind::continuation && record.isn == isn_;
  const bool from = motion.kind == cl::Motion::Kind::from;
  isn_ = record.isn;
  if (!continues) {
    beginStretch(record);
  }
  if (!continues || changed_) {  // in a hole a statement has several kinds
    changed_ = false;
    scene_.stretches.back().feed = feed_;
    kind_ = rapid_ || cycle_ ? SceneMove::rapid : arc_ ? SceneMove::arc : SceneMove::feed;
    rapid_ = false;
    arc_ = false;
  }
  const bool first = from || scene_.kinds.empty();
  const std::size_t stride = motion.stride();
  for (std::size_t i = 0; i + stride <= motion.coordinates.size(); i += stride) {
    addAxis(motion, i);
    for (std::size_t k = 0; k < 3; ++k) {
      scene_.places.push_back(motion.coordinates[i + k]);
    }
    const bool start = from || scene_.kinds.empty();
    const auto code = static_cast<std::uint8_t>(start ? SceneMove::start : kind_);
    if (!first) {
      moves_.push_back(static_cast<std::uint32_t>(scene_.kinds.size()));
    }
    scene_.kinds.push_back(gun_ ? code | backend::sceneGunOn : code);
    scene_.seconds.push_back(0.0F);
  }
}

void PathTrace::finish() {
  static_cast<void>(timer_.finish());
  scene_.timed = complaints_.errors() == 0;
  if (scene_.timed) {
    return;
  }
  const auto& p = scene_.places;
  for (std::size_t i = 1; i < scene_.kinds.size(); ++i) {
    const double length = std::hypot(p[3 * i] - p[3 * i - 3], p[3 * i + 1] - p[3 * i - 2],
                                     p[3 * i + 2] - p[3 * i - 1]);
    scene_.seconds[i] = static_cast<float>(length / assumedSpeed);
  }
}

}  // namespace arelem::app
