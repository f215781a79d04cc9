#pragma once
#include <span>

#include "runtime/certify/certificate.h"

namespace arelem::certify {

/// A check surface with its condition; never `automatic`.
struct Goal {
  Named surface;
  ir::Condition condition = ir::Condition::to;
};

[[nodiscard]] std::string_view spell(ir::Condition condition);  ///< "TO", "ON", ...
[[nodiscard]] std::string_view spell(ir::Heading heading);      ///< "GOLFT", ...

/// Judges the motions of one statement each; faults go to the sink.
class MotionCheck {
 public:
  MotionCheck(const Options& options, DiagnosticSink& sink) : options_(options), sink_(sink) {}

  /// A motion along a drive surface. path[0] is where it begins. `goals` are its check surfaces;
  /// the one that was met is told by `met`.
  [[nodiscard]] StatementResult follow(const Modal& modal,
                                       const runtime::Action& action,
                                       const runtime::Follow& follow,
                                       std::span<const Goal> goals,
                                       std::size_t met,
                                       std::span<const Location> path);
  /// A startup from `before` to `after`.
  [[nodiscard]] StatementResult startup(const Modal& modal,
                                        const runtime::Action& action,
                                        const runtime::Startup& startup,
                                        const Location& before,
                                        const Location& after);

  /// How far the end of the path is from the position that the goal asks for: 0 within its
  /// tolerance.
  [[nodiscard]] double missed(const Modal& modal,
                              const Goal& goal,
                              std::size_t index,
                              std::span<const Location> path,
                              const surface::AnySurface& drive) const;
  /// Reports what the figures say against the tolerance.
  void judge(StatementResult& result, const runtime::Action& action, const GuideFigures& figures);

 private:
  /// A contact that a stop or startup asks for, measured.
  struct Contact {
    Touch touch;
    Allowed allowed;
    bool tangent = false;
    [[nodiscard]] double missed() const;
  };
  [[nodiscard]] Contact contactOf(const Modal& modal,
                                  const Goal& goal,
                                  std::size_t index,
                                  std::span<const Location> path,
                                  const surface::AnySurface& drive) const;
  [[nodiscard]] GuideTask taskOf(const Modal& modal, Role role, Named surface, bool on) const;
  [[nodiscard]] Allowed allowedFor(const Modal& modal, Role role) const;
  void judgeHand(const Modal& modal,
                 const runtime::Action& action,
                 const GuideFigures& drive,
                 std::span<const Location> path);
  void report(StatementResult& result, const runtime::Action& action, Failure failure);

  const Options& options_;
  DiagnosticSink& sink_;
};

}  // namespace arelem::certify
