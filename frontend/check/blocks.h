#pragma once
#include <map>
#include <string>
#include <vector>

#include "frontend/check/context.h"
#include "frontend/parse/tree.h"

namespace arelem::frontend {

/// Place and label of the statement that is being lowered.
struct Origin {
  Span span;
  std::uint32_t isn = 0;
  std::string_view cardId;
};

/// A jump whose target is not known yet: statement index and which of its labels.
struct Jump {
  std::uint32_t statement = 0;
  std::uint32_t slot = 0;
};

/// Appends statements to one block (main program or macro instance) and resolves its labels.
class BlockWriter {
 public:
  enum class Area : std::uint8_t { program, loop, macro };

  BlockWriter(Context& context, ir::BlockId block, Area area)
      : context_(context), block_(block), area_(area) {}

  void setOrigin(const Origin& origin) { origin_ = origin; }
  [[nodiscard]] const Origin& origin() const { return origin_; }
  /// Appends a statement; the first one after setLabel carries the label.
  std::uint32_t emit(ir::Body body);
  /// Declares a label at the place of the next statement.
  void setLabel(std::string_view label, const Span& span);
  /// The label in `slot` of `statement` is resolved when the area ends.
  void refer(std::uint32_t statement, std::uint32_t slot, std::string_view label, const Span& span);
  [[nodiscard]] std::uint32_t next() const {
    return static_cast<std::uint32_t>(statements().size());
  }
  /// Makes the jumps go to statement `to`.
  void patch(const std::vector<Jump>& jumps, std::uint32_t to);

  [[nodiscard]] Area area() const { return area_; }
  [[nodiscard]] bool inArea() const { return area_ != Area::program; }
  [[nodiscard]] std::string_view areaName() const;
  void beginLoop(const Span& at);
  void endLoop();
  /// Ends the block: unresolved labels and an open loop are errors.
  void finish();
  [[nodiscard]] Span loopStart() const { return loopStart_; }

 private:
  struct Reference {
    Jump jump;
    std::string name;
    Span span;
  };
  struct Labels {
    std::map<std::string, std::pair<std::uint32_t, Span>, std::less<>> places;
    std::vector<Reference> references;
  };
  [[nodiscard]] std::vector<ir::Statement>& statements() const {
    return context_.program.blocks[block_.index].statements;
  }
  [[nodiscard]] ir::LabelRef* slotOf(const Jump& jump) const;
  void resolve(Labels& labels);

  Context& context_;
  ir::BlockId block_;
  Area area_;
  Origin origin_;
  std::string pendingLabel_;
  Labels labels_;                                        // of the program or macro
  Labels loopLabels_;                                    // of the loop that is open
  std::map<std::string, Span, std::less<>> outOfReach_;  // labels of the loops that are closed
  Span loopStart_;
};

}  // namespace arelem::frontend
