#pragma once
#include <unordered_map>

#include "runtime/certify/motion_check.h"
#include "runtime/certify/output_order.h"

namespace arelem::certify {

/// Goes through the actions of a program as the records of its CL file say it went, and hands each
/// motion with its locations to the checks.
class Association {
 public:
  using Run = OutputOrder::Run;

  Association(const std::vector<runtime::Action>& actions,
              const Options& options,
              DiagnosticSink& sink);

  /// One run of locations: all that one statement put out. `isn` is the number of that statement.
  void take(int isn, const Run& run);
  /// Locations of a file without statement numbers: where a motion ends is found by its check
  /// surface.
  void takeAll(const Run& all);
  /// After the last run: what is left of the program must put out nothing.
  void finish();

  [[nodiscard]] const std::vector<StatementResult>& results() const { return results_; }
  [[nodiscard]] const Summary& summary() const { return summary_; }

 private:
  /// Brings the modal state up to the next action that puts out locations; none at the end.
  [[nodiscard]] const runtime::Action* advance();
  [[nodiscard]] bool putsOut(const runtime::Action& action) const;
  /// A motion whose output is off: the tool goes on to a place that the file does not tell.
  void unseen(const runtime::Action& action);
  void judge(const runtime::Action& action, const Run& run);
  void judgeLocate(const runtime::Action& action, const runtime::Locate& locate, const Run& run);
  void judgeStartup(const runtime::Action& action, const runtime::Startup& startup, const Run& run);
  void judgeFollow(const runtime::Action& action, const runtime::Follow& follow, const Run& run);
  [[nodiscard]] std::size_t lengthAlong(const runtime::FollowSpline& along,
                                        const Run& all,
                                        std::size_t used) const;
  void judgeAlong(const runtime::Action& action,
                  const runtime::FollowSpline& along,
                  const Run& run);
  void judgeCopy(const Run& run);
  [[nodiscard]] std::vector<Location> pathOf(const Run& run,
                                             const surface::AnySurface* drive) const;
  [[nodiscard]] std::vector<Goal> goalsOf(const runtime::Follow& follow) const;
  [[nodiscard]] std::optional<Goal> impliedGoal() const;
  [[nodiscard]] std::size_t metOf(const runtime::Follow& follow,
                                  std::span<const Goal> goals,
                                  std::span<const Location> path) const;
  [[nodiscard]] std::size_t lengthOf(const runtime::Action& action,
                                     const Run& all,
                                     std::size_t used);
  void miss(const runtime::Action& action);
  void jump(std::uint64_t label);
  void moveTo(const Location& l);
  void add(StatementResult result);
  void report(const runtime::Action& action, Failure failure);
  [[nodiscard]] bool numberAhead(int isn) const;
  void surplus(std::span<const Location> rest);

  const std::vector<runtime::Action>& actions_;
  const Options& options_;
  DiagnosticSink& sink_;
  MotionCheck check_;
  OutputOrder order_;
  Modal modal_;
  std::unordered_multimap<std::uint64_t, std::size_t> labels_;
  std::size_t index_ = 0;  ///< of the next action
  std::uint64_t steps_ = 0;
  bool ended_ = false;
  bool gaveUp_ = false;  ///< what comes cannot be judged, and that was said
  std::uint64_t surplus_ = 0;
  Vec3 firstSurplus_ = Vec3::Zero();
  std::vector<StatementResult> results_;
  Summary summary_;
};

}  // namespace arelem::certify
