#pragma once
#include <iosfwd>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ir/cl/record.h"
#include "ir/diag/diagnostic.h"
#include "ir/program/program.h"
#include "ir/text/source_map.h"

namespace arelem::robot {
struct Machine;
}

namespace arelem::backend {
namespace tape {
class Codes;
}

/// One printed value or title, as the listing shows it.
struct ListingItem {
  int isn = 0;
  int mode = 3;
  std::string title;
  std::string name;
  int subscript = 0;
  EntityPtr entity;  ///< null for a scalar
  double scalar = 0.0;
  bool undefined = false;
};

/// What a target may use beside the records.
/// Polylines in space.
using Curves = std::vector<std::vector<Vec3>>;

struct Context {
  const SourceMap* sources = nullptr;
  const ir::Program* program = nullptr;  ///< null when the records were read from a file
  std::vector<EntityPtr> entities;       ///< in order of definition
  std::vector<Curves> curves;  ///< of the entity of the same index, where only they can be drawn
  std::vector<ListingItem> printed;
  std::string_view deck;                    ///< what PUNCH wrote
  const robot::Machine* machine = nullptr;  ///< of --machine; null without
  const tape::Codes* codes = nullptr;       ///< of --codes; null without
  int decimals =
      -1;  ///< of lengths in text targets, 1 to 15; -1: as many as read back to the same double
};

/// Writes one output format. `finish` is called once after the last record.
class Writer : public cl::RecordSink {
 public:
  virtual void finish() = 0;
};

struct Target {
  std::string_view name;  ///< of --to
  std::string_view summary;
  std::vector<std::string_view> suffixes;  ///< with the dot; the first is the default
  bool binary = false;
  bool readsBack = false;     ///< there is a reader for it
  bool needsMotion = true;    ///< false: made from program and context alone
  bool needsProgram = false;  ///< records alone do not make it
  bool takesCurves = false;   ///< arcs and splines as they are; else cut vectors in their place
  std::unique_ptr<Writer> (*make)(std::ostream& out,
                                  const Context& context,
                                  DiagnosticSink& sink) = nullptr;
};

/// THE list of targets.
[[nodiscard]] std::span<const Target> targets();
[[nodiscard]] const Target* findTarget(std::string_view name);
[[nodiscard]] const Target* targetForFile(std::string_view path);

}  // namespace arelem::backend
