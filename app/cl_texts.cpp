#include "app/cl_texts.h"

#include <utility>

namespace arelem::app {

BufferId ClTexts::add(const std::string& name, std::string text, PieceStart start) {
  if (live_.size() == most) {
    live_.pop_front();
  }
  auto map = std::make_unique<SourceMap>();
  for (std::size_t i = 0; i < starts_.size(); ++i) {
    map->add("", "");  // the pieces before it, so that it has its number
  }
  starts_.push_back(start);
  const BufferId buffer = map->add(name, std::move(text));
  live_.push_back(std::move(map));
  return buffer;
}

std::uint32_t ClTexts::line(const Span& span) const {
  const std::size_t first = starts_.size() - live_.size();
  const std::size_t piece = span.buffer.index;
  if (piece < first || piece >= starts_.size()) {
    return 0;
  }
  return starts_[piece].lines + live_[piece - first]->locate(span.buffer, span.begin).line;
}

Span ClTexts::inWhole(Span span) const {
  if (span.buffer.index >= starts_.size()) {
    return span;
  }
  span.begin += static_cast<std::uint32_t>(starts_[span.buffer.index].bytes);
  span.buffer = {};
  return span;
}

Diagnostic ClTexts::inWhole(Diagnostic diagnostic) const {
  diagnostic.at = inWhole(diagnostic.at);
  for (Label& label : diagnostic.labels) {
    label.span = inWhole(label.span);
  }
  for (Span& call : diagnostic.calledFrom) {
    call = inWhole(call);
  }
  return diagnostic;
}

}  // namespace arelem::app
