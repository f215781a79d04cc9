#include "app/word_counts.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "app/statement_word.h"

#include "ir/words/post_forms.h"

namespace arelem::app {

namespace {
/// Words of CAM systems that outputs, times or the reading of places act on.
constexpr std::array<std::string_view, 16> stateOfSystems = {
    "CIRCLE", "MOVARC", "NURBS", "KNOT",   "CNTRL", "CSYS",   "TRNTYP",       "TLDATA",
    "SMOOTH", "MACHLM", "LOAD",  "SELECT", "MSYS",  "CATIA0", "LOCAL_ORIGIN", "MOVNRB"};

struct Count {
  std::uint64_t understood = 0, passed = 0, reported = 0;
};

bool isPost(Word word) {
  const WordClass c = row(word).wordClass;
  return c == WordClass::postWithParameters || c == WordClass::postWithoutParameters ||
         c == WordClass::transformation || c == WordClass::modifier;
}

bool isUnderstood(const ir::Body& body) {
  if (const auto* command = std::get_if<ir::Command>(&body)) {
    const PostForm* form = postForm(command->word);
    return !isPost(command->word) || (form != nullptr && form->acts);
  }
  if (const auto* foreign = std::get_if<ir::ForeignCommand>(&body)) {
    return std::find(stateOfSystems.begin(), stateOfSystems.end(), foreign->word) !=
           stateOfSystems.end();
  }
  return !std::holds_alternative<ir::Text>(body);
}

/// Places of diagnostics, to find out whether a statement has one.
class Reported {
 public:
  explicit Reported(const std::vector<Span>& told) {
    for (const Span& at : told) {
      if (at.length > 0) {
        places_.insert({at.buffer.index, at.begin});
      }
    }
  }
  /// Also forgets them: what is left belongs to no statement that was understood.
  bool take(const Span& statement) {
    auto first = places_.lower_bound({statement.buffer.index, statement.begin});
    bool any = false;
    while (first != places_.end() && first->first == statement.buffer.index &&
           first->second < statement.begin + statement.length) {
      first = places_.erase(first);
      any = true;
    }
    return any;
  }
  [[nodiscard]] const std::set<std::pair<std::uint32_t, std::uint32_t>>& rest() const {
    return places_;
  }

 private:
  std::set<std::pair<std::uint32_t, std::uint32_t>> places_;
};

/// The first word of the line on which an offset lies.
std::string wordAt(std::string_view text, std::size_t offset) {
  const std::size_t before = text.substr(0, offset).find_last_of("\r\n");
  const std::size_t begin =
      text.find_first_not_of(" \t", before == std::string_view::npos ? 0 : before + 1);
  if (begin == std::string_view::npos) {
    return "";
  }
  std::string word(text.substr(begin, text.find_first_of("/,=( \t\r\n$", begin) - begin));
  std::transform(word.begin(), word.end(), word.begin(),
                 [](unsigned char c) { return std::toupper(c); });
  return word;
}

std::uint64_t commentsOf(std::string_view text) {
  std::uint64_t comments = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::size_t first = text.find_first_not_of(" \t", at);
    comments += first < end && text.substr(first, 2) == "$$" ? 1 : 0;
    at = end + 1;
  }
  return comments;
}

void printCount(std::ostream& out,
                const std::string& word,
                std::uint64_t count,
                std::string_view what) {
  if (count > 0) {
    out << fmt::format("{:<24} {:>10}  {}\n", word, count, what);
  }
}
}  // namespace

struct WordCounts::Counts {
  std::map<std::string, Count> words;
  std::uint64_t comments = 0;
};

WordCounts::WordCounts() : counts_(std::make_unique<Counts>()) {}
WordCounts::~WordCounts() = default;

void WordCounts::add(const ir::Program& program,
                     const SourceMap& sources,
                     std::string_view text,
                     const std::vector<Span>& told) {
  Reported reported(told);
  for (const ir::Block& block : program.blocks) {
    for (const ir::Statement& statement : block.statements) {
      if (statement.span.length == 0) {
        continue;  // the FINI of a program without one
      }
      Count& count = counts_->words[statementWord(statement.body)];
      const bool isTold = reported.take(statement.span);
      ++(isTold ? count.reported : isUnderstood(statement.body) ? count.understood : count.passed);
    }
  }
  for (const auto& [buffer, offset] : reported.rest()) {
    ++counts_->words[wordAt(sources.text(BufferId{buffer}), offset)].reported;
  }
  counts_->comments += commentsOf(text);
}

void WordCounts::print(std::ostream& out) const {
  for (const auto& [word, count] : counts_->words) {
    printCount(out, word, count.understood, "understood");
    printCount(out, word, count.passed, "passed on");
    printCount(out, word, count.reported, "reported");
  }
  printCount(out, "$$", counts_->comments, "comments, not in the CL data");
}

}  // namespace arelem::app
