#include "app/view/scene_builder.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/view/curves.h"
#include "app/view/faults.h"
#include "app/view/path_trace.h"
#include "app/view/scene_surfaces.h"

#include "ir/hole/drilled.h"
#include "runtime/certify/certificate.h"
#include "runtime/path/chords.h"

namespace arelem::app {

namespace {
constexpr std::uint64_t mostProven = 300'000;  // cut vectors; proofs of longer paths take minutes
constexpr std::size_t mostMessages = 500;

/// The unit of the first UNITS/.
void findUnit(const Compilation& job, backend::Scene& scene) {
  scene.unit = "units";
  for (const runtime::Action& action : job.evaluation.actions) {
    const auto* pass = std::get_if<runtime::Pass>(&action.body);
    const auto* units = pass == nullptr ? nullptr : std::get_if<cl::Units>(&pass->body);
    if (units != nullptr) {
      scene.unitWord = units->unit;
      scene.unit = spell(units->unit);
      std::transform(scene.unit.begin(), scene.unit.end(), scene.unit.begin(),
                     [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
      return;
    }
  }
}

void addSources(const Compilation& job, backend::Scene& scene) {
  for (std::uint32_t i = 0; i < job.sources.size(); ++i) {
    const BufferId buffer{i};
    scene.sources.push_back(
        {std::string(job.sources.name(buffer)), std::string(job.sources.text(buffer))});
  }
}

void addMessages(const Compilation& job, backend::Scene& scene) {
  for (const Diagnostic& d : job.log.all()) {
    if (scene.messages.size() >= mostMessages) {
      return;
    }
    backend::SceneMessage message;
    message.error = d.severity() == Severity::error;
    message.code = d.kind().code;
    message.text = d.message;
    const Span at = d.at;
    if (at.buffer.index < job.sources.size()) {
      message.file = at.buffer.index;
      message.line = job.sources.locate(at.buffer, at.begin).line;
    }
    scene.messages.push_back(std::move(message));
  }
}

/// The bounds that were proven, for the stretch of the same execution of each statement.
void addBounds(const certify::Certificate& certificate,
               const std::vector<int>& isns,
               backend::Scene& scene) {
  const auto& results = certificate.results();
  std::size_t next = 0;
  for (std::size_t i = 0; i < isns.size(); ++i) {
    std::size_t found = next;
    while (found < results.size() && results[found].isn != isns[i]) {
      ++found;
    }
    if (found == results.size()) {
      continue;
    }
    next = found + 1;
    backend::SceneStretch& stretch = scene.stretches[i];
    for (const auto& guide : {results[found].drive, results[found].part}) {
      if (!guide) {
        continue;
      }
      const auto low = static_cast<float>(guide->result.verdict.least.proven);
      const auto high = static_cast<float>(guide->result.verdict.greatest.proven);
      const bool first = std::isnan(stretch.inner);
      stretch.inner = first ? low : std::min(stretch.inner, low);
      stretch.outer = first ? high : std::max(stretch.outer, high);
      stretch.allowedInner = static_cast<float>(guide->allowed.inner);
      stretch.allowedOuter = static_cast<float>(guide->allowed.outer);
    }
  }
}

/// Hands records to all that look at them; of a path that is too long to be proven, not all to the
/// certificate.
class Fan : public cl::RecordSink {
 public:
  Fan(cl::RecordSink& path, FaultTrace& faults, certify::Certificate& certificate)
      : path_(path), faults_(faults), certificate_(certificate) {}
  void accept(const cl::Record& record) override {
    path_.accept(record);  // with the moves of holes
    faults_.accept(record);
    const auto* motion = std::get_if<cl::Motion>(&record.body);
    vectors_ += motion == nullptr ? 0 : motion->points();
    if (isShort()) {
      certificate_.accept(record);
    }
  }
  [[nodiscard]] bool isShort() const { return vectors_ <= mostProven; }

 private:
  cl::RecordSink& path_;
  FaultTrace& faults_;
  certify::Certificate& certificate_;
  std::uint64_t vectors_ = 0;
};

/// The way over motions that are missing is none of the program's: it counts neither as length nor
/// as time, as the way to FROM does not.
void breakAtFaults(const Compilation& job, backend::Scene& scene) {
  auto stretch = scene.stretches.cbegin();
  for (const backend::FaultMark& mark : scene.faults) {
    stretch = std::find_if(stretch, scene.stretches.cend(), [&](const backend::SceneStretch& s) {
      return s.file == job.main.index && s.line > mark.line;
    });
    if (stretch == scene.stretches.cend()) {
      return;
    }
    const std::size_t i = stretch->first;
    if (mark.next && i > 0 && Vec3(&scene.places[3 * (i - 1)]) == mark.place) {
      scene.kinds[i] = static_cast<std::uint8_t>(backend::SceneMove::start);
      scene.seconds[i] = 0.0F;
    }
  }
}
}  // namespace

backend::Scene buildScene(Compilation& job, const InterruptFlag& interrupted) {
  backend::Scene scene;
  findUnit(job, scene);
  addSources(job, scene);
  PathTrace trace(scene, job.sources);
  certify::Options options;
  options.file = std::string(job.sources.name(job.main));
  options.limits = job.settings.limits;
  options.interrupted = &interrupted;
  CollectingSink faults;  // what the certificate finds is shown as bounds, not as an error
  const auto certificate = certify::makeCertificate(job.evaluation.actions, options, faults);
  FaultTrace missing(job);
  hole::Drilled drilled(trace);
  Fan all(drilled, missing, *certificate);
  static_cast<void>(execute(job, *path::makeChordStage(all, faults), interrupted));
  trace.finish();
  scene.faults = missing.marks();
  breakAtFaults(job, scene);
  if (all.isShort() && job.motion.complete && !interrupted) {
    certificate->finish();
    addBounds(*certificate, trace.isns(), scene);
  } else if (!all.isShort()) {
    addNote(scene, fmt::format("deviations of more than {} cut vectors are not proven here: use "
                               "arelem verify",
                               mostProven));
  }
  addMeshes(job, scene, interrupted);
  addFilms(job, scene);
  addStencilFilms(job, scene);
  for (const runtime::Defined& defined : job.evaluation.defined) {
    if (defined.entity && !defined.name.empty()) {
      scene.entities.push_back(defined.entity);
      scene.curves.push_back(curvesOf(*defined.entity));
    }
  }
  if (scene.title.empty()) {
    scene.title = std::string(job.sources.name(job.main));
  }
  addMessages(job, scene);
  return scene;
}

}  // namespace arelem::app
