#pragma once
#include <vector>

#include "runtime/certify/certificate.h"
#include "runtime/certify/path_end.h"
#include "runtime/certify/stop_count.h"

namespace arelem::certify {

/// A check surface with its condition; never `automatic`.
struct Goal {
  Named surface;
  ir::Condition condition = ir::Condition::to;
  int nth = 1;  ///< n, INTOF
};

[[nodiscard]] std::string_view spell(ir::Condition condition);  ///< "TO", "ON", ...
[[nodiscard]] std::string_view spell(ir::Heading heading);      ///< "GOLFT", ...

/// Judges the motions of one statement each; faults go to the sink.
class MotionCheck {
 public:
  MotionCheck(const Options& options, DiagnosticSink& sink) : options_(options), sink_(sink) {}

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
                              const PathEnd& end,
                              const surface::AnySurface& drive) const;
  /// What counts the positions at a check surface; none for tangencies.
  [[nodiscard]] std::optional<StopCount> countOf(const Modal& modal,
                                                 const Goal& goal,
                                                 std::size_t index,
                                                 double pathBand,
                                                 const Vec3& path,
                                                 const Location& first) const;
  /// Judges how often the path came to a check surface before its end.
  void judgeCount(StatementResult& result,
                  const runtime::Action& action,
                  const Goal& goal,
                  const StopCount& count,
                  bool endsThere);
  /// Judges the end of a motion by its goal.
  void judgeStop(StatementResult& result,
                 const Modal& modal,
                 const runtime::Action& action,
                 const Goal& goal,
                 std::size_t index,
                 const PathEnd& end,
                 const surface::AnySurface& drive);
  /// Warns where the tool is not on the side of the drive surface that TLLFT or TLRGT says.
  void judgeHand(const Modal& modal,
                 const runtime::Action& action,
                 const GuideFigures& drive,
                 const Vec3& step,
                 const Vec3& axis);
  /// Reports what the figures say against the tolerance.
  void judge(StatementResult& result, const runtime::Action& action, const GuideFigures& figures);
  void report(StatementResult& result, const runtime::Action& action, Failure failure);
  [[nodiscard]] GuideTask taskOf(const Modal& modal, Role role, Named surface, bool on) const;

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
                                  const PathEnd& end,
                                  const surface::AnySurface& drive) const;
  [[nodiscard]] Touch touchOf(const Modal& modal,
                              const surface::AnySurface& guide,
                              Role role,
                              const Location& end) const;
  /// `leaves`: the last cut vector leads back to where the tool came from, clear of the surface.
  [[nodiscard]] bool isTouch(const Modal& modal,
                             const surface::AnySurface& drive,
                             const PathEnd& at,
                             const surface::AnySurface& check,
                             const Relation& relation,
                             const Allowed& allowed,
                             const Touch& t,
                             bool leaves) const;
  /// Whether the tool came into the band of a check surface from where the condition, TO or PAST,
  /// lets it come, and never was beyond it since.
  [[nodiscard]] static bool cameFrom(const PathEnd& at,
                                     const surface::AnySurface& check,
                                     const Relation& relation,
                                     ir::Condition condition,
                                     const Allowed& allowed,
                                     const Touch& t);
  [[nodiscard]] static bool hasTurned(const PathEnd& at,
                                      const surface::AnySurface& check,
                                      const Relation& relation,
                                      ir::Condition condition,
                                      const Allowed& allowed,
                                      const Touch& t);
  /// By how much a gap is outside of its band.
  [[nodiscard]] static double excess(const Touch& t, const Allowed& a);
  /// Components of a contact normal along the path below this do not tell whether the tool
  /// approaches the surface or leaves it.
  static constexpr double glancing = 1e-3;
  [[nodiscard]] Allowed allowedFor(const Modal& modal, Role role) const;

  const Options& options_;
  DiagnosticSink& sink_;
};

}  // namespace arelem::certify
