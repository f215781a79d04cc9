#include "app/view/film_frames.h"

namespace arelem::app {

path::Affine FilmFrames::next(const Span& origin) {
  while (at_ < actions_.size() && !(actions_[at_].origin == origin)) {
    pass(actions_[at_++]);
  }
  while (at_ < actions_.size() && actions_[at_].origin == origin) {
    ++at_;
  }
  return tracut_;
}

void FilmFrames::pass(const runtime::Action& action) {
  const auto* record = std::get_if<runtime::Pass>(&action.body);
  const auto* post = record == nullptr ? nullptr : std::get_if<cl::Post>(&record->body);
  if (post == nullptr || post->word != Word::TRACUT || post->arguments.size() != 1) {
    return;
  }
  const auto* matrix = std::get_if<cl::SurfaceValue>(post->arguments.data());
  const bool moves = matrix != nullptr && matrix->canon.size() == 12;
  tracut_ = moves ? path::Affine::fromRows(matrix->canon) : path::Affine();
}

}  // namespace arelem::app
