#pragma once
#include "frontend/check/blocks.h"
#include "frontend/check/values.h"

namespace arelem::frontend {

/// Parameters of motion statements to their roles: drive, part and check surfaces, conditions,
/// labels, feed.
class Motion {
 public:
  Motion(Context& context, Values& values, BlockWriter& block)
      : context_(context), values_(values), block_(block) {}

  void locate(Word word, const Span& wordSpan, NodeId first);   // FROM, GOTO, GODLTA
  void startup(Word word, const Span& wordSpan, NodeId first);  // GO, OFFSET
  void follow(Word word, const Span& wordSpan, NodeId first);   // GOLFT ... GODOWN

 private:
  struct CheckLabel {
    std::size_t check;
    std::string_view text;
    Span span;
  };
  bool checkLocate(Word word, const Span& at, const std::vector<ir::Argument>& list);
  bool plainNumbers(Word word, const std::vector<ir::Argument>& list);
  std::optional<ir::Argument> item(NodeId id, Word word);
  bool surface(Word word, const ir::Argument& argument);
  bool followChecks(Word word, NodeId id, ir::Follow& motion, std::vector<CheckLabel>& labels);
  bool isStrayLabel(const Node& node, const ir::Follow& motion, bool pending);
  bool wordItem(Word motion, const Node& node, ir::SurfaceUse& use, bool& pending);
  [[nodiscard]] std::size_t countSurfaces(NodeId id) const;
  [[nodiscard]] bool isSurfaceNode(const Node& node) const;

  Context& context_;
  Values& values_;
  BlockWriter& block_;
};

}  // namespace arelem::frontend
