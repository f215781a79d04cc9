#include "frontend/check/blocks.h"

#include <utility>

#include "ir/diag/frontend.h"

namespace arelem::frontend {

std::uint32_t BlockWriter::emit(ir::Body body) {
  ir::Statement s;
  s.span = origin_.span;
  s.isn = origin_.isn;
  s.cardId = origin_.cardId;
  s.label = std::exchange(pendingLabel_, {});
  s.body = std::move(body);
  statements().push_back(std::move(s));
  return static_cast<std::uint32_t>(statements().size() - 1);
}

void BlockWriter::setLabel(std::string_view label, const Span& span) {
  Labels& labels = area_ == Area::loop ? loopLabels_ : labels_;
  const NameFacts* facts = context_.names.find(label);
  if (facts != nullptr && facts->defined && !facts->poisoned) {
    context_.report(
        diagnose(span, diag::LabelIsName, label).label(facts->definition, "defined here"));
    return;
  }
  const auto [place, fresh] = labels.places.try_emplace(std::string(label), next(), span);
  if (!fresh) {
    context_.report(
        diagnose(span, diag::DuplicateLabel, label).label(place->second.second, "first used here"));
    return;
  }
  pendingLabel_ = label;
}

void BlockWriter::refer(std::uint32_t statement,
                        std::uint32_t slot,
                        std::string_view label,
                        const Span& span) {
  Labels& labels = area_ == Area::loop ? loopLabels_ : labels_;
  labels.references.push_back({{statement, slot}, std::string(label), span});
}

ir::LabelRef* BlockWriter::slotOf(const Jump& jump) const {
  ir::Body& body = statements()[jump.statement].body;
  if (auto* b = std::get_if<ir::Branch>(&body)) {
    return jump.slot == 0 ? &b->negative : jump.slot == 1 ? &b->zero : &b->positive;
  }
  if (auto* j = std::get_if<ir::Jump>(&body)) {
    return &j->label;
  }
  if (auto* t = std::get_if<ir::Transfer>(&body)) {
    return &t->label;
  }
  auto* follow = std::get_if<ir::Follow>(&body);
  if (follow != nullptr && jump.slot < follow->checks.size() && follow->checks[jump.slot].label) {
    return &*follow->checks[jump.slot].label;
  }
  return nullptr;
}

void BlockWriter::patch(const std::vector<Jump>& jumps, std::uint32_t to) {
  for (const Jump& jump : jumps) {
    if (ir::LabelRef* label = slotOf(jump)) {
      label->statement = to;
    }
  }
}

void BlockWriter::resolve(Labels& labels) {
  for (const Reference& r : labels.references) {
    const auto found = labels.places.find(r.name);
    if (found == labels.places.end()) {
      Diagnostic d = diagnose(r.span, diag::LabelNotFound, r.name, areaName());
      if (const auto hidden = outOfReach_.find(r.name); hidden != outOfReach_.end()) {
        d.labels.push_back({hidden->second, "it stands in a loop, and jumps do not enter loops"});
      } else if (const auto outer = labels_.places.find(r.name); outer != labels_.places.end()) {
        d.labels.push_back(
            {outer->second.second, "it stands outside, and jumps do not leave loops"});
      }
      context_.report(std::move(d));
      continue;
    }
    if (ir::LabelRef* label = slotOf(r.jump)) {
      label->statement = found->second.first;
      label->name = r.name;
      label->span = r.span;
    }
  }
  labels = {};
}

std::string_view BlockWriter::areaName() const {
  switch (area_) {
    case Area::program:
      return "program";
    case Area::loop:
      return "loop";
    case Area::macro:
      return "macro";
  }
  return {};
}

void BlockWriter::beginLoop(const Span& at) {
  area_ = Area::loop;
  loopStart_ = at;
  // A label on LOOPST may be the target of jumps inside the loop.
  const ir::Statement& start = statements().back();
  if (!start.label.empty()) {
    loopLabels_.places.emplace(start.label, std::pair(next() - 1, at));
  }
}

void BlockWriter::endLoop() {
  for (const auto& [name, place] : loopLabels_.places) {
    outOfReach_.emplace(name, place.second);
  }
  resolve(loopLabels_);
  area_ = Area::program;
}

void BlockWriter::finish() {
  if (area_ == Area::loop) {
    context_.report(diagnose(loopStart_, diag::LoopNotEnded));
    endLoop();
  }
  resolve(labels_);
}

}  // namespace arelem::frontend
