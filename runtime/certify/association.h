#pragma once
#include <unordered_map>

#include "runtime/certify/follow_proof.h"
#include "runtime/certify/output_order.h"
#include "runtime/certify/pocket_proof.h"
#include "runtime/certify/spline_guide.h"

namespace arelem::certify {

/// Goes through the actions of a program as the records of its CL file say it went, and hands each
/// motion with its locations to the checks.
class Association {
 public:
  using Run = OutputOrder::Run;

  Association(const std::vector<runtime::Action>& actions,
              const Options& options,
              DiagnosticSink& sink);

  /// A run of locations begins: all that one statement put out. `isn` is its number, none in a file
  /// without statement numbers: there a motion ends at its check surface, and runs need not begin.
  void begin(std::optional<int> isn, bool withAxis);
  /// The next location. Without axis the program's counts. Those of a motion along surfaces are
  /// judged at once, and kept only for the copies of an INDEX. `onCurve`: a place on an arc or
  /// spline of the file before its end, with which no statement ends.
  void add(const Location& location, bool withAxis, bool onCurve);
  /// The run is complete.
  void end();
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
  struct Held {
    Location location;
    bool withAxis = false, onCurve = false;
  };
  /// What the locations that come belong to.
  struct Taking {
    const runtime::Action* action = nullptr;  ///< null: the copies of a COPY, or no statement
    const runtime::Follow* follow = nullptr;
    bool copy = false;
    bool numbered = true;
    Run run;  ///< as the file has them
    std::optional<Named> drive;
    std::vector<Goal> goals;
    std::optional<FollowProof> proof;
    std::optional<Location> last;  ///< where there is no proof
    std::optional<spline::CubicSpline> curve;
    std::optional<SplineWalk> walk;  ///< along the curve
    std::vector<Held> held;          ///< locations that stray from the surfaces of the motion
    bool mayEnd = false;             ///< the last location is at a check surface

    [[nodiscard]] bool counts() const { return copy || action != nullptr; }
  };
  /// Of a file without statement numbers: a location that leaves drive or part surface is either
  /// displaced, and others come back to them, or the motion has ended before it, beside its check
  /// surface. Which it is those behind it tell; it is kept until then.
  [[nodiscard]] bool holdsBack(const Held& next);
  /// A last cut vector may be shorter than the tolerance of its check surface, and a path may come
  /// near that before its stop: true where a location behind one at the check surface still belongs
  /// to the motion.
  [[nodiscard]] bool goesOn(const Held& next);
  /// Whether a location is at a check surface, and how far it strays.
  struct Behind {
    PathEnd end;
    bool met = false, strays = false;
  };
  [[nodiscard]] Behind behind(const Held& next);
  /// True at any check surface of the motion that is taken.
  [[nodiscard]] bool isMet(const PathEnd& end) const;
  /// Whether the next statement is a startup, which may lead to where the tool is.
  [[nodiscard]] bool isStartupNext() const;
  /// False where the next statement is a motion along a surface that the tool is not at there.
  [[nodiscard]] bool suitsNext(const Location& place) const;
  /// True where the next statement, GOTO or GODLTA, leads there.
  [[nodiscard]] bool isNext(const Vec3& place) const;
  /// True where the next output from an action on is a GOTO or GODLTA from a location to a place.
  [[nodiscard]] bool leadsTo(std::size_t way, const Location& from, const Vec3& place) const;
  void take(const Held& next);
  /// The motion ended before the locations that are held back.
  void release();
  void close();
  [[nodiscard]] Location placed(const Location& location);
  void beginFollow(const runtime::Follow& follow);
  void prove(const Location& first);
  void addFollow(const Location& location);
  void endFollow();
  /// Of a file without statement numbers: whether the last location was the last of its statement.
  [[nodiscard]] bool complete();
  void judgeAlong(const runtime::Action& action,
                  const runtime::FollowSpline& along,
                  const Run& run);
  /// POCKET comes in several runs, one for each feed: they are kept until its outline is complete.
  void takePocket(const runtime::Action& action, const Run& run);
  void judgePocket();
  void judgeCopy(const Run& run);
  [[nodiscard]] std::vector<Location> pathOf(const Run& run) const;
  [[nodiscard]] std::vector<Goal> goalsOf(const runtime::Follow& follow) const;
  [[nodiscard]] std::optional<Goal> impliedGoal() const;
  [[nodiscard]] std::vector<std::size_t> metOf(const Taking& t) const;
  /// Where GOTO or GODLTA leads from a location.
  [[nodiscard]] static Vec3 wantedBy(const runtime::Locate& locate, const Location& from);
  [[nodiscard]] Location here() const { return {modal_.toolEnd, modal_.axis}; }
  void miss(const runtime::Action& action);
  [[nodiscard]] std::size_t placeOf(std::uint64_t label) const;
  /// Of check surfaces that the end of a motion is at, which label it goes on with, what follows
  /// tells: the number of its statement, or its place.
  void choose(std::optional<int> isn, const Location* next);
  /// The next action from there on that puts out locations; none at the end.
  [[nodiscard]] const runtime::Action* outputFrom(std::size_t index) const;
  void moveTo(const Location& l);
  void add(StatementResult result);
  void report(const runtime::Action& action, Failure failure);
  [[nodiscard]] bool numberAhead(int isn) const;

  const std::vector<runtime::Action>& actions_;
  const Options& options_;
  DiagnosticSink& sink_;
  MotionCheck check_;
  OutputOrder order_;
  Modal modal_;
  std::unordered_multimap<std::uint64_t, std::size_t> labels_;
  std::size_t index_ = 0;          ///< of the next action
  std::vector<std::size_t> ways_;  ///< where it may be, while that is open; the likeliest first
  std::uint64_t steps_ = 0;
  std::optional<Taking> taking_;
  /// A POCKET whose outline is not complete yet.
  struct OpenPocket {
    const runtime::Action* action = nullptr;
    Result<PocketTask> task;
    std::vector<Vec3> path;
  };
  std::optional<OpenPocket> pocket_;
  bool ended_ = false;
  bool gaveUp_ = false;  ///< what comes cannot be judged, and that was said
  std::uint64_t surplus_ = 0;
  Vec3 firstSurplus_ = Vec3::Zero();
  std::vector<StatementResult> results_;
  Summary summary_;
};

}  // namespace arelem::certify
