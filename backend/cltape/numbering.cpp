#include "backend/cltape/numbering.h"

namespace arelem::backend {

bool Numbering::opensStatement(const cl::Record& record) {
  const bool same = any_ && record.isn == isn_ && record.cardId == cardId_;
  if (same && !std::holds_alternative<cl::Card>(record.body)) {
    return false;
  }
  if (!same) {
    any_ = true;
    isn_ = record.isn;
    cardId_ = record.cardId;
  }
  ++last_;
  return true;
}

}  // namespace arelem::backend
