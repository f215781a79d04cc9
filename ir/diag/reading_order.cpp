#include "ir/diag/reading_order.h"

#include <algorithm>
#include <map>
#include <tuple>

namespace arelem {

namespace {
struct Key {
  bool main = false;
  std::uint32_t buffer = 0;
  std::uint32_t offset = 0;
  auto operator<=>(const Key&) const = default;
};

Key keyOf(const Diagnostic& d, BufferId mainBuffer) {
  const Span& place = d.calledFrom.empty() ? d.at : d.calledFrom.back();
  return {place.buffer == mainBuffer, place.buffer.index, place.begin};
}

std::vector<Diagnostic> withoutRepetitions(std::vector<Diagnostic> all) {
  struct Seen {
    std::size_t index = 0;
    std::size_t repeated = 0;
  };
  std::map<std::tuple<const DiagRow*, Span, std::string>, Seen> seen;
  std::vector<Diagnostic> kept;
  for (Diagnostic& d : all) {
    const auto [entry, isNew] = seen.try_emplace({d.row, d.at, d.message}, Seen{kept.size(), 0});
    if (isNew) {
      kept.push_back(std::move(d));
    } else {
      ++entry->second.repeated;
    }
  }
  for (const auto& [key, entry] : seen) {
    if (entry.repeated > 0) {
      kept[entry.index].notes.push_back(fmt::format(
          "the same at this place {} more time{}", entry.repeated, entry.repeated == 1 ? "" : "s"));
    }
  }
  return kept;
}
}  // namespace

std::vector<Diagnostic> inReadingOrder(std::vector<Diagnostic> diagnostics, BufferId mainBuffer) {
  std::vector<Diagnostic> ordered = withoutRepetitions(std::move(diagnostics));
  std::stable_sort(ordered.begin(), ordered.end(), [&](const Diagnostic& a, const Diagnostic& b) {
    return keyOf(a, mainBuffer) < keyOf(b, mainBuffer);
  });
  return ordered;
}

}  // namespace arelem
