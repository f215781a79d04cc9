#include "app/repl/session.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <set>

#include "frontend/outline.h"

namespace arelem::app::repl {

namespace {
bool isNameCharacter(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0;
}

std::string upperCase(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

/// Replaces a name in statements, but not in texts and comments.
std::string replaceName(const std::string& text, const std::string& name, const std::string& with) {
  std::string result;
  bool quoted = false;
  bool comment = false;
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    comment = c == '\n' ? false : comment || (c == '$' && !quoted);
    quoted = c == '\n' ? false : (c == '\'' && !comment) != quoted;
    std::size_t end = i;
    while (end < text.size() && isNameCharacter(text[end])) {
      ++end;
    }
    if (end > i && !quoted && !comment && upperCase(text.substr(i, end - i)) == name) {
      result += with;
    } else {
      end = std::max(end, i + 1);
      result += text.substr(i, end - i);
    }
    i = end;
  }
  return result;
}

std::vector<frontend::OutlinedStatement> statementsOf(const std::string& text,
                                                      const Settings& settings) {
  auto all = frontend::outline(text, settings.dialect, settings.limits);
  std::erase_if(all, [](const frontend::OutlinedStatement& s) { return s.text.empty(); });
  return all;
}

/// What stands before FINI.
std::string beforeFini(const std::string& text, const Settings& settings) {
  for (const auto& statement : statementsOf(text, settings)) {
    if (statement.head == Word::FINI) {
      return text.substr(0, statement.begin);
    }
  }
  return text;
}

bool isText(const frontend::OutlinedStatement& statement) {
  constexpr std::array words = {Word::PARTNO, Word::PPRINT, Word::INSERT, Word::TITLES,
                                Word::REMARK};
  return std::find(words.begin(), words.end(), statement.head) != words.end();
}

std::string withoutStatementAt(const std::string& text,
                               std::uint32_t offset,
                               const Settings& settings) {
  std::string kept;
  for (const auto& s : frontend::outline(text, settings.dialect, settings.limits)) {
    if (offset < s.begin || offset >= s.end) {
      kept += text.substr(s.begin, s.end - s.begin);
    }
  }
  return kept;
}

std::string withLineEnd(std::string text) {
  if (!text.empty() && text.back() != '\n') {
    text += '\n';
  }
  return text;
}
}  // namespace

std::string withoutErrors(const std::string& text,
                          const std::vector<Diagnostic>& found,
                          BufferId buffer,
                          const Settings& settings) {
  std::set<std::uint32_t> wrong;
  for (const Diagnostic& d : found) {
    const Span at = d.calledFrom.empty() ? d.at : d.calledFrom.back();
    if (d.severity() == Severity::error && at.buffer == buffer) {
      wrong.insert(at.begin);
    }
  }
  std::string kept;
  for (const auto& s : frontend::outline(text, settings.dialect, settings.limits)) {
    const auto first = wrong.lower_bound(s.begin);
    const bool last = s.end >= text.size();
    if (first == wrong.end() || (last ? false : *first >= s.end)) {
      kept += text.substr(s.begin, s.end - s.begin);
    }
  }
  return kept;
}

Session::Session(const Settings& settings)
    : settings_(settings), run_(std::make_shared<Run>(settings)) {}

bool Session::isName(const std::string& text) const {
  const auto& symbols = run_->job.program.symbols;
  return std::any_of(symbols.begin(), symbols.end(),
                     [&](const ir::Symbol& s) { return s.name == text; });
}

/// Whether ANS in these statements is not the last result: in a text, or a name of the program's
/// own.
bool Session::isOwnAnswer(const std::string& entry) const {
  const auto statements = statementsOf(entry, settings_);
  return isName("ANS") || std::any_of(statements.begin(), statements.end(),
                                      [](const frontend::OutlinedStatement& s) {
                                        return isText(s) || s.text.starts_with("ANS=") ||
                                               s.text.starts_with("ANS)") ||
                                               s.text.starts_with("RESERV/");
                                      });
}

std::string Session::withAnswer(const std::string& text) const {
  return answer_.empty() || isOwnAnswer(text) ? text : replaceName(text, "ANS", answer_);
}

Session::Answer Session::submit(const std::string& text, const InterruptFlag& interrupted) {
  Answer answer;
  answer.before = run_;
  std::string entry = withLineEnd(withAnswer(text));
  const auto statements = statementsOf(entry, settings_);
  if (statements.empty()) {
    answer.verdict.state = entry.find('$') == std::string::npos || entry.find("$$") != entry.npos
                               ? Verdict::State::good
                               : Verdict::State::open;
    return answer;
  }
  if (answer_.empty() && !isOwnAnswer(entry) && replaceName(entry, "ANS", "X") != entry) {
    answer.objection = "ANS is the last unnamed result, and there is none yet: try 3*SINF(30)";
    return answer;
  }
  const auto& first = statements.front();
  if (statements.size() == 1 && first.head == Word::FINI) {
    answer.ended = true;
    return answer;
  }
  bool unnamed = statements.size() == 1 && (first.definition || first.expression);
  if (unnamed && isName(first.text)) {
    answer.shown = answer_ = first.text;
    return answer;
  }
  unnamed = unnamed && !(first.expression &&
                         first.text.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789") ==
                             std::string::npos &&
                         std::isalpha(static_cast<unsigned char>(first.text.front())) != 0);
  std::string name = answer_;
  if (unnamed) {
    do {
      name = "ANS" + std::to_string(++unnamed_);
    } while (isName(name));
    entry.insert(first.begin, name + "=");
  }
  auto run = std::make_shared<Run>(settings_);
  const std::string before = this->text();
  answer.verdict = carryOut(*run, run_.get(), name_, before + entry, interrupted);
  answer.run = run;
  if (unnamed) {
    const auto begin = static_cast<std::uint32_t>(before.size() + first.begin);
    answer.inserted = Span{run->job.main, begin, static_cast<std::uint32_t>(name.size()) + 1};
  }
  if (answer.verdict.state == Verdict::State::good) {
    entries_.push_back({entry, name, unnamed});
    undone_.clear();
    answer_ = name;
    run_ = std::move(run);
  } else if (unnamed) {
    --unnamed_;
  }
  return answer;
}

Session::Answer Session::load(const std::string& name,
                              const std::string& text,
                              const InterruptFlag& interrupted) {
  Answer answer;
  answer.before = std::make_shared<Run>(settings_);
  std::string program = withLineEnd(beforeFini(text, settings_));
  constexpr int rounds = 100;  // statements that go take others with them that use their names
  Verdict first;
  for (int round = 0; round < rounds; ++round) {
    auto run = std::make_shared<Run>(settings_);
    Verdict verdict = carryOut(*run, nullptr, name, program, interrupted);
    if (round == 0) {
      first = verdict;
      answer.run = run;
    }
    if (verdict.state == Verdict::State::interrupted) {
      answer.verdict = verdict;
      return answer;
    }
    if (verdict.state == Verdict::State::good) {
      answer.verdict = first;
      name_ = name;
      entries_.assign(1, {program, "", false});
      undone_.clear();
      answer_.clear();
      run_ = std::move(run);
      return answer;
    }
    std::string rest = withoutErrors(program, verdict.found, run->job.main, settings_);
    if (rest.size() == program.size()) {
      break;
    }
    program = std::move(rest);
  }
  answer.verdict = first;
  return answer;
}

void Session::rebuild(const InterruptFlag& interrupted) {
  auto run = std::make_shared<Run>(settings_);
  if (!entries_.empty()) {
    static_cast<void>(carryOut(*run, nullptr, name_, text(), interrupted));
  }
  answer_ = entries_.empty() ? "" : entries_.back().answer;
  run_ = std::move(run);
}

std::size_t Session::undo(std::size_t n, const InterruptFlag& interrupted) {
  n = std::min(n, entries_.size());
  for (std::size_t i = 0; i < n; ++i) {
    undone_.push_back(std::move(entries_.back()));
    entries_.pop_back();
  }
  rebuild(interrupted);
  return n;
}

std::size_t Session::redo(std::size_t n, const InterruptFlag& interrupted) {
  n = std::min(n, undone_.size());
  for (std::size_t i = 0; i < n; ++i) {
    entries_.push_back(std::move(undone_.back()));
    undone_.pop_back();
  }
  rebuild(interrupted);
  return n;
}

std::string Session::text() const {
  std::string all;
  for (const Entry& entry : entries_) {
    all += entry.text;
  }
  return all;
}

std::string Session::waiting() const {
  if (!run_->waiting) {
    return "";
  }
  for (const auto& s : statementsOf(text(), settings_)) {
    if (s.begin <= run_->waiting->begin && run_->waiting->begin < s.end) {
      return s.text;
    }
  }
  return "";
}

std::string Session::program() const {
  const std::uint32_t waits = run_->waiting ? run_->waiting->begin : UINT32_MAX;
  std::uint32_t begin = static_cast<std::uint32_t>(text().size());  // of the entry
  std::vector<std::string> kept;
  std::string later;
  for (auto entry = entries_.rbegin(); entry != entries_.rend(); ++entry) {
    begin -= static_cast<std::uint32_t>(entry->text.size());
    const std::string name = entry->answer;
    std::string text = waits >= begin && waits - begin < entry->text.size()
                           ? withoutStatementAt(entry->text, waits - begin, settings_)
                           : entry->text;
    const bool unused = entry->unnamed && replaceName(later, name, name + "X") == later;
    if (!unused) {
      later += text;
      kept.push_back(std::move(text));
    }
  }
  std::string all;
  for (auto text = kept.rbegin(); text != kept.rend(); ++text) {
    all += *text;
  }
  return all + "FINI\n";
}

std::vector<frontend::KnownName> Session::names() const {
  using Kind = frontend::KnownName::Kind;
  std::vector<frontend::KnownName> names;
  const ir::Program& program = run_->job.program;
  for (const ir::Symbol& s : program.symbols) {
    const bool scalar = s.kind == ir::Symbol::Kind::scalar;
    names.push_back({s.name, scalar ? Kind::scalar : Kind::entity, s.type});
  }
  const auto statements = statementsOf(text(), settings_);
  for (const auto& s : statements) {
    const std::size_t macro = s.text.find("=MACRO/");
    const std::size_t label = s.text.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789");
    if (macro != std::string::npos) {
      names.push_back({s.text.substr(0, macro), Kind::macro, {}});
    } else if (label != std::string::npos && label > 0 && s.text[label] == ')') {
      names.push_back({s.text.substr(0, label), Kind::label, {}});
    }
  }
  if (!answer_.empty() && !isName("ANS")) {
    const auto known =
        std::find_if(names.begin(), names.end(), [&](const auto& n) { return n.name == answer_; });
    if (known != names.end()) {
      names.push_back({"ANS", known->kind, known->type});
    }
  }
  return names;
}

}  // namespace arelem::app::repl
