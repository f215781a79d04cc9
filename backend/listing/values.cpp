#include "backend/listing/values.h"

#include <bit>

#include <fmt/format.h>

#include "backend/listing/columns.h"
#include "backend/text/clean.h"

namespace arelem::backend {

namespace {
constexpr std::size_t valuesOfALine = 7;
constexpr int valueWidth = 14;
constexpr int valueDecimals = 6;
constexpr std::size_t hexOfALine = 4;

enum Mode { pageEject = 0, hexadecimal = 1, valuesOnly = 2 };

std::span<const double> valuesOf(const ListingItem& item) {
  return item.entity ? std::span<const double>(item.entity->canon)
                     : std::span<const double>(&item.scalar, 1);
}

void appendRows(std::string& text, std::span<const double> values, std::size_t indent) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i > 0 && i % valuesOfALine == 0) {
      text += '\n';
      text.append(indent, ' ');
    }
    appendColumn(text, values[i], valueWidth, valueDecimals);
  }
  text += '\n';
}

void appendHexadecimal(std::string& text, std::span<const double> values) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    text += i % hexOfALine == 0 && i > 0 ? "\n" : "";
    text += fmt::format("  {:016X}", std::bit_cast<std::uint64_t>(values[i]));
  }
  text += '\n';
}
}  // namespace

void appendPrinted(std::string& text, const ListingItem& item) {
  if (!item.title.empty()) {
    text += fmt::format(" {}\n", trimmedRight(printableAscii(item.title)));
    return;
  }
  if (item.mode == pageEject) {
    text += '\n';
    return;
  }
  const std::string name = item.name.empty() ? "NESTED" : printableAscii(item.name);
  const std::string label = fmt::format(" {:>6}({:>4})  ", name, item.subscript);
  if (item.undefined) {
    text += label + "UNDEFINED\n";
    return;
  }
  const std::span<const double> values = valuesOf(item);
  if (item.mode == hexadecimal) {
    appendHexadecimal(text += label + "\n", values);
  } else if (item.mode == valuesOnly) {
    appendRows(text, values, 0);
  } else {
    const std::string head = fmt::format(
        "{}{:<6} {:>4}", label, item.entity ? spell(item.entity->type) : "SCALAR", values.size());
    text += head;
    appendRows(text, values, head.size());
  }
}

}  // namespace arelem::backend
