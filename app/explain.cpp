#include <algorithm>
#include <iostream>

#include "app/command.h"
#include "app/manual_pages.h"
#include "app/messages.h"
#include "app/nearest.h"
#include "app/options.h"

namespace arelem::app {

namespace {
std::string upper(std::string text) {
  for (char& c : text) {
    c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  }
  return text;
}

/// An old number without sign and leading zeros; "" of what is none. Listings print warnings as
/// -1601, and CL files every number in columns.
std::string_view bareNumber(std::string_view text) {
  text.remove_prefix(!text.empty() && (text[0] == '-' || text[0] == '+') ? 1 : 0);
  text.remove_prefix(std::min(text.find_first_not_of('0'), text.size()));
  return text.find_first_not_of("0123456789") == text.npos ? text : std::string_view();
}

/// Rows with this code or name, or all rows that carry it as the number of the old system, however
/// it is spelled; those with its sign where there are such.
std::vector<const DiagRow*> rowsFor(const std::string& word) {
  if (const DiagRow* row = findDiagnostic(word)) {
    return {row};
  }
  std::vector<const DiagRow*> rows;
  for (const DiagRow& row : diagnosticTable()) {
    if (!word.empty() && row.legacy == word) {
      rows.push_back(&row);
    }
  }
  const std::string_view number = bareNumber(word);
  for (const DiagRow& row : diagnosticTable()) {
    if (rows.empty() && !number.empty() && bareNumber(row.legacy) == number) {
      return rowsFor(std::string(row.legacy));
    }
  }
  return rows;
}

void printRow(const DiagRow& row) {
  for (const ManualPage& page : manualPages()) {
    if (page.code == row.code) {
      std::cout << page.text;
      return;
    }
  }
  std::cout << "# " << row.code << ' ' << row.name << "\n\n" << row.text << '\n';
}

void printList() {
  for (const DiagRow& row : diagnosticTable()) {
    std::cout << fmt::format(
        "{:6} {:28} {}\n", row.code, row.name,
        row.legacy.empty() ? "" : fmt::format("(old APT number {})", row.legacy));
  }
}

/// What stands behind the code on the first line of a page, or the name of a row without one.
std::string titleOf(const DiagRow& row) {
  for (const ManualPage& page : manualPages()) {
    const std::string_view line = page.text.substr(0, page.text.find('\n'));
    if (const std::size_t colon = line.find(": "); page.code == row.code && colon != line.npos) {
      return std::string(line.substr(colon + 2));
    }
  }
  return std::string(row.name);
}

/// An old number stands for several diagnostics: a line each.
void printChoice(const std::string& number, const std::vector<const DiagRow*>& rows) {
  std::cout << fmt::format("The old number {} stands for {} diagnostics here:\n\n", number,
                           rows.size());
  for (const DiagRow* row : rows) {
    std::cout << fmt::format("{}  {}\n", row->code, titleOf(*row));
  }
  std::cout << fmt::format("\n`arelem explain {}` shows the page of the first.\n",
                           rows.front()->code);
}

std::string guess(const std::string& word) {
  std::vector<std::string> known;
  for (const DiagRow& row : diagnosticTable()) {
    known.emplace_back(row.code);
    known.emplace_back(row.name);
  }
  const std::string found = nearest(upper(word), known);
  return found.empty() ? "" : "; did you mean `" + found + "`?";
}
}  // namespace

int runExplain(const Invocation& invocation) {
  CLI::App app(
      "Explains a diagnostic: what it means, a wrong and a right example.\n"
      "CODE is a code (E0312), a name (UndefinedSymbol) or a number of the old system (1005).",
      "explain");
  std::string word;
  bool list = false;
  app.add_option("CODE", word, "what to explain");
  app.add_flag("--list", list, "every code with its name and old number");
  if (const auto code = parse(app, invocation.words)) {
    return *code;
  }
  if (list) {
    printList();
    return static_cast<int>(ExitCode::ok);
  }
  const auto rows = rowsFor(word);
  if (rows.empty()) {
    printUsageError("explain", word.empty()
                                   ? "a CODE is missing; --list shows all"
                                   : "there is no diagnostic `" + word + "`" + guess(word));
    return static_cast<int>(ExitCode::wrongUse);
  }
  if (rows.size() == 1) {
    printRow(*rows.front());
  } else {
    printChoice(word, rows);
  }
  return static_cast<int>(ExitCode::ok);
}

}  // namespace arelem::app
