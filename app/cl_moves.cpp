#include "app/cl_moves.h"

#include "ir/cl/post_word.h"
#include "ir/words/units.h"

namespace arelem::app {

void ClMoves::accept(const cl::Record& record) {
  if (const auto* units = std::get_if<cl::Units>(&record.body)) {
    millimeters = millimetersOf(units->unit);
    hasUnit = true;
  } else if (const auto* surface = std::get_if<cl::Surface>(&record.body)) {
    center_ = surface->surface.canon.size() == 7
                  ? std::optional(Vec3(surface->surface.canon.data()))
                  : std::nullopt;
  } else if (const auto* post = std::get_if<cl::Post>(&record.body)) {
    if (cl::is(*post, Word::RAPID)) {
      rapid_ = true;
    } else if (cl::is(*post, Word::FEDRAT)) {
      for (const cl::Value& value : post->arguments) {
        if (const double* number = std::get_if<double>(&value)) {
          feed_ = *number;
          break;
        }
      }
    }
  }
  const auto* motion = std::get_if<cl::Motion>(&record.body);
  if (motion == nullptr) {
    return;
  }
  for (std::size_t i = 0; i + motion->stride() <= motion->coordinates.size();
       i += motion->stride()) {
    const double* c = motion->coordinates.data() + i;
    ClMove move;
    move.end = Vec3(c);
    move.axis = motion->withAxis ? Vec3(c + 3) : Vec3(Vec3::UnitZ());
    move.center = motion->isArc() ? center_ : std::nullopt;
    move.feed = feed_;
    move.rapid = rapid_;
    move.way = motion->way;
    move.origin = record.origin;
    move.isn = record.isn;
    moves.push_back(move);
  }
  rapid_ = false;
}

}  // namespace arelem::app
