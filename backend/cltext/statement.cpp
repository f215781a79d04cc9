#include "backend/cltext/statement.h"

namespace arelem::backend {

namespace {
constexpr std::string_view commentStart = "$$-> ";
constexpr std::string_view continuation = ", $\n";
}  // namespace

void StatementWriter::begin(std::string_view word, bool comment) {
  comment_ = comment;
  first_ = true;
  column_ = word.size();
  if (comment) {
    out_.append(commentStart);
    column_ += commentStart.size();
  }
  out_.append(word);
}

void StatementWriter::item(const char* first, const char* last) {
  const auto size = static_cast<std::size_t>(last - first);
  constexpr std::size_t tail = continuation.size() - 1;  // without its newline
  const bool fits = column_ + 3 + size + tail <= columns;
  std::string_view before = first_ ? " / " : ", ";
  if (!first_ && !fits) {
    before = continuation;
    column_ = 0;
  }
  out_.append(before);
  if (column_ == 0 && comment_) {
    out_.append(commentStart);
    column_ = commentStart.size();
  } else if (column_ != 0) {
    column_ += before.size();
  }
  out_.append({first, size});
  column_ += size;
  first_ = false;
}

}  // namespace arelem::backend
