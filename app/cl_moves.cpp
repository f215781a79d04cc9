#include "app/cl_moves.h"

#include <utility>

#include <fmt/format.h>

#include "ir/cl/post_word.h"
#include "ir/words/units.h"

namespace arelem::app {

namespace {
std::string textOf(const cl::Post& post) {
  std::string text(cl::nameOf(post));
  for (std::size_t i = 0; i < post.arguments.size(); ++i) {
    text += i == 0 ? "/" : ",";
    const cl::Value& value = post.arguments[i];
    if (const double* number = std::get_if<double>(&value)) {
      text += fmt::format("{:.9g}", *number);
    } else if (const Word* word = std::get_if<Word>(&value)) {
      text += spell(*word);
    } else if (const auto* string = std::get_if<std::string>(&value)) {
      text += *string;
    }
  }
  return text;
}
}  // namespace

void ClMoves::accept(const cl::Record& record) {
  if (const auto* motion = std::get_if<cl::Motion>(&record.body)) {
    takeMotion(record, *motion);
  } else if (const auto* units = std::get_if<cl::Units>(&record.body)) {
    const bool first = std::exchange(millimeters_, millimetersOf(units->unit)) == 0.0;
    for (ClMove& move : moves_) {
      move.millimeters = first ? millimeters_ : move.millimeters;
    }
  } else if (const auto* surface = std::get_if<cl::Surface>(&record.body)) {
    const std::vector<double>& canon = surface->surface.canon;
    center_.reset();
    if (canon.size() == 7) {
      center_ = Vec3(canon.data());
      normal_ = Vec3(canon.data() + 3);
    }
  } else if (const auto* post = std::get_if<cl::Post>(&record.body)) {
    takePost(*post);
  }
}

void ClMoves::takePost(const cl::Post& post) {
  if (cl::is(post, Word::RAPID)) {
    rapid_ = true;
  } else if (cl::is(post, Word::FEDRAT)) {
    const std::vector<double> numbers = cl::numbersOf(post);
    feed_ = numbers.empty() ? feed_ : numbers.front();
  } else if (withWords_) {
    words_ += (words_.empty() ? "" : " ") + textOf(post);
  }
}

void ClMoves::takeMotion(const cl::Record& record, const cl::Motion& motion) {
  ClMove move;
  move.feed = feed_;
  move.millimeters = millimeters_;
  move.rapid = rapid_;
  move.way = motion.way;
  move.isn = record.isn;
  if (motion.isArc()) {
    move.center = center_;
    move.normal = motion.way == cl::Motion::Way::clockwise ? Vec3(-normal_) : normal_;
  }
  if (record.origin.length > 0) {
    move.text = record.origin.buffer.index;
    move.line = lineOf_(record.origin);
  }
  for (std::size_t i = 0; i + motion.stride() <= motion.coordinates.size(); i += motion.stride()) {
    const double* c = motion.coordinates.data() + i;
    move.start = std::exchange(place_, Vec3(c));
    move.end = place_;
    move.axis = motion.withAxis ? Vec3(c + 3) : Vec3(Vec3::UnitZ());
    move.words = std::exchange(words_, {});
    moves_.push_back(move);
  }
  rapid_ = false;
}

std::vector<ClMove> ClMoves::take() {
  return std::exchange(moves_, {});
}

}  // namespace arelem::app
