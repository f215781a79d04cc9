#include "tests/random/trial.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include <fmt/format.h>
#include <stdlib.h>

#include "runtime/geometry/kinds.h"
#include "tests/random/refusal.h"
#include "tests/random/stand.h"

namespace arelem::scenes {

namespace {
/// Why a motion may be refused: the scene has no such motion. The message says what and where.
constexpr std::array<std::string_view, 15> explained{
    "E0504",  // the startup's contact with the part surface is not the one that the motion follows
    "E0505",  // the same for the drive surface
    "E0508",  // the check surface is not on the way
    "E0509",  // the surfaces of a tangent stop do not touch
    "E0510",  // no position touches all three surfaces
    "E0511",  // the tool stands on the surface to which it shall go
    "E0512",  // the contact is lost
    "E0513",  // more cut vectors than NUMPTS
    "E0521",  // the cutter does not fit
    "E0540",  // the angles leave no axis
    "E0541",  // the axis does not settle: the contact jumps
    "E0544",  // two of the surfaces are parallel
    "E0545",  // the straight end of a tabulated cylinder ends before the check surface
    "E0507",  // the direction is square to the path
    "E0546",  // N,INTOF: the path meets the check surface more seldom than N times
};
/// Stops of moved scenes may lie apart by this share of the band over the sine at which they are
/// met, and farther where the gap to the check surface changes by no more than this share between
/// them: where the path bends along the check surface the sine at one place says little.
constexpr double stopShare = 0.5;
/// How far apart places and axes of a startup are that count as one.
constexpr double sameStartup = 1e-6;

/// What is said of a startup that has no position depends on where the search for it ended.
std::vector<std::string> reasons(std::vector<std::string> codes) {
  for (std::string& code : codes) {
    if (code == "E0510" || code == "E0521" || code == "E0544") {
      code = "no position";
    }
  }
  return codes;
}

std::string listed(const Motion& motion) {
  return motion.codes.empty() ? "computed" : fmt::format("{}", fmt::join(motion.codes, " "));
}

/// Sine of the angle at which the end of a run meets a surface, seen from the tool end. `before` is
/// where the run began.
double meetingSine(const Work& work, std::string_view name, const Run& run, const Vec3& before) {
  const EntityPtr entity = work.entity(name);
  if (!entity) {
    return 1.0;
  }
  const auto found = surface::surfaceOf(*entity);
  const Vec3& end = run.places.back();
  const Vec3 step = end - (run.places.size() < 2 ? before : run.places[run.places.size() - 2]);
  const double length = step.norm();
  if (!found || length == 0.0) {
    return 1.0;
  }
  return std::abs(step.dot(std::visit(
             [&](const auto& s) {
               typename std::decay_t<decltype(s)>::Hint hint{};
               return s.foot(end, hint).normal;
             },
             *found))) /
         length;
}

/// Compares the motion of a scene with that of the scene moved.
class Comparison {
 public:
  Comparison(const Scene& scene, const Work& work, std::vector<Fault>& wrong)
      : scene_(scene), work_(work), wrong_(wrong) {}

  void compare(const Motion& drawn, const Motion& moved) {
    const std::size_t before = wrong_.size();
    compareResults(drawn, moved);
    if (wrong_.size() > before && drawn.runs.size() >= startups && moved.runs.size() >= startups) {
      compareStartups(drawn.runs[startups - 1], moved.runs[startups - 1], wrong_[before].concern);
    }
  }

 private:
  static constexpr std::size_t startups = 2;  // FROM and GO meet no check surface

  void compareResults(const Motion& drawn, const Motion& moved) {
    if (reasons(drawn.codes) != reasons(moved.codes)) {
      wrong_.push_back(
          {Concern::refusal, fmt::format("moved: {} instead of {}", listed(moved), listed(drawn))});
      return;
    }
    if (!drawn.codes.empty()) {
      return;
    }
    if (drawn.runs.size() != moved.runs.size()) {
      wrong_.push_back(
          {Concern::path, fmt::format("moved: {} statements put out locations instead of {}",
                                      moved.runs.size(), drawn.runs.size())});
      return;
    }
    for (std::size_t i = 0; i < drawn.runs.size(); ++i) {
      compareRun(i, drawn.runs[i], moved.runs[i], drawn.runs[i == 0 ? 0 : i - 1].places.back());
    }
  }

  /// A startup may have several positions and axes: what follows from another one differs.
  void compareStartups(const Run& drawn, const Run& moved, Concern concern) {
    const double apart = (scene_.move.before(moved.places.back()) - drawn.places.back()).norm();
    const double turned =
        (scene_.move.turn.transpose() * moved.axes.back() - drawn.axes.back()).norm();
    if (apart > sameStartup || turned > sameStartup) {
      wrong_.push_back(
          {concern, fmt::format("moved: the startup is {:.3g} from where it should be, its axis "
                                "turned by {:.3g}",
                                apart, turned)});
    }
  }

  void compareRun(std::size_t index, const Run& drawn, const Run& moved, const Vec3& before) {
    const double sine = index < startups
                            ? 1.0
                            : std::max(std::min(meetingSine(work_, "CS1", drawn, before),
                                                meetingSine(work_, "CS2", drawn, before)),
                                       std::sqrt(scene_.band()));
    // What one stop is off, the next run begins with.
    carried_ = std::max(carried_, stopShare * scene_.band() / sine);
    const double allowed = carried_ + 1e-8;
    const double apart = (scene_.move.before(moved.places.back()) - drawn.places.back()).norm();
    if (apart > allowed) {
      const Stand stop{drawn.places.back(), drawn.axes.back()};
      const Stand other{scene_.move.before(moved.places.back()),
                        scene_.move.turn.transpose() * moved.axes.back()};
      const bool behindImplied = index > startups && scene_.extra == Extra::implied;
      if (index >= startups &&
          isOneStop(scene_, work_, behindImplied ? "CS2" : "CS", stopShare, stop, other)) {
        carried_ = apart;
        return;
      }
      wrong_.push_back(
          {Concern::path, fmt::format("moved: the stop of statement {} is {:.3g} from where it "
                                      "should be; {:.3g} is allowed",
                                      drawn.isn, apart, allowed)});
    }
  }

  const Scene& scene_;
  const Work& work_;
  std::vector<Fault>& wrong_;
  double carried_ = 0.0;
};
}  // namespace

Folder::Folder() {
  std::string name = std::filesystem::temp_directory_path() / "scenes_XXXXXX";
  if (::mkdtemp(name.data()) == nullptr) {
    throw std::runtime_error("no temporary folder " + name);
  }
  path_ = name + "/";
}

Folder::~Folder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

void writeFiles(const Scene& scene, const Similarity& to, const std::string& folder) {
  for (const auto& [name, text] : scene.files(to)) {
    std::ofstream(folder + name) << text;
  }
}

bool isExplained(std::string_view code) {
  return std::ranges::find(explained, code) != explained.end();
}

const Fault* Finding::worst() const {
  const auto found = std::ranges::find(wrong, Concern::path, &Fault::concern);
  return found != wrong.end() ? &*found : wrong.empty() ? nullptr : &wrong.front();
}

Finding tryScene(const Scene& scene, const Folder& folder) {
  Finding finding;
  finding.id = scene.id;
  writeFiles(scene, {}, folder.path());
  Work drawnWork(scene.program({}), folder.path());
  const Motion drawn = drawnWork.run(true);
  finding.outcome = drawn.outcome();
  if (std::ranges::any_of(drawn.codes, [](const std::string& c) { return !isExplained(c); })) {
    finding.wrong.push_back({Concern::refusal, drawn.message});
  }
  if (drawn.codes.empty()) {
    for (const std::string& text : drawn.unproven) {
      finding.wrong.push_back({Concern::path, text});
    }
  }
  // Every fourth refusal is looked into: that takes as long as a motion.
  constexpr std::uint64_t reviewed = 4;
  if (!drawn.codes.empty() && scene.id.number % reviewed == 0) {
    const Review independent = review(scene, drawnWork, drawn);
    finding.confirmed = independent.confirmed;
    if (!independent.objection.empty()) {
      finding.wrong.push_back({Concern::refusal, drawn.message + "; but " + independent.objection});
    }
  }
  writeFiles(scene, scene.move, folder.path());
  Work movedWork(scene.program(scene.move), folder.path());
  const Motion moved = movedWork.run(false);
  Comparison(scene, drawnWork, finding.wrong).compare(drawn, moved);
  finding.computing = drawn.computing;
  finding.proving = drawn.proving;
  finding.moved = moved.computing;
  return finding;
}

}  // namespace arelem::scenes
