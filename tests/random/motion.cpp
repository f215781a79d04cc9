#include "tests/random/motion.h"

#include <algorithm>

#include "runtime/certify/certificate.h"
#include "tests/random/cpu_clock.h"

namespace arelem::scenes {

namespace {
/// Keeps the locations, and hands the records on to the certificate if there is one.
class Tracks : public cl::RecordSink {
 public:
  Tracks(std::vector<Run>& runs, cl::RecordSink* next) : runs_(runs), next_(next) {}

  void accept(const cl::Record& record) override {
    if (const auto* motion = std::get_if<cl::Motion>(&record.body)) {
      keep(record.isn, *motion);
    }
    if (next_ != nullptr) {
      const double before = cpuSeconds();
      next_->accept(record);
      proving_ += cpuSeconds() - before;
    }
  }
  [[nodiscard]] double proving() const { return proving_; }

 private:
  void keep(int isn, const cl::Motion& motion) {
    if (runs_.empty() || runs_.back().isn != isn) {
      runs_.push_back({isn, {}, {}});
    }
    for (std::size_t i = 0; i < motion.coordinates.size(); i += motion.stride()) {
      const double* const c = &motion.coordinates[i];
      runs_.back().places.emplace_back(c[0], c[1], c[2]);
      runs_.back().axes.push_back(motion.withAxis ? Vec3(c[3], c[4], c[5]) : Vec3(Vec3::UnitZ()));
    }
  }

  std::vector<Run>& runs_;
  cl::RecordSink* next_;
  double proving_ = 0.0;
};

std::string told(const Diagnostic& d) {
  return std::string(d.kind().code) + " " + d.message;
}
}  // namespace

Work::Work(std::string text, const std::string& folder)
    : job_(std::make_unique<app::Compilation>(settings_)) {
  const double start = cpuSeconds();
  evaluated_ = app::load(*job_, folder + "scene.apt", std::move(text), never_) &&
               app::evaluate(*job_, never_);
  reading_ = cpuSeconds() - start;
}

Work::~Work() = default;

EntityPtr Work::entity(std::string_view name) const {
  for (const runtime::Defined& defined : job_->evaluation.defined) {
    if (defined.name == name) {
      return defined.entity;
    }
  }
  return nullptr;
}

const std::vector<runtime::Action>& Work::actions() const {
  return job_->evaluation.actions;
}

Motion Work::run(bool proven) {
  Motion motion;
  CollectingSink faults;
  const double start = cpuSeconds();
  if (evaluated_) {
    certify::Options options;
    options.limits = settings_.limits;
    options.interrupted = &never_;
    const auto certificate =
        proven ? certify::makeCertificate(job_->evaluation.actions, options, faults) : nullptr;
    Tracks tracks(motion.runs, certificate.get());
    const bool whole = app::execute(*job_, tracks, never_);
    motion.proving = tracks.proving();
    if (certificate && whole) {
      certificate->finish();
    }
  }
  motion.computing = reading_ + cpuSeconds() - start - motion.proving;
  for (const Diagnostic& d : job_->log.all()) {
    if (d.severity() != Severity::error) {
      continue;
    }
    if (motion.codes.empty()) {
      motion.message = told(d);
    }
    motion.codes.emplace_back(d.kind().code);
  }
  std::ranges::sort(motion.codes);
  motion.codes.erase(std::ranges::unique(motion.codes).begin(), motion.codes.end());
  for (const Diagnostic& d : faults.all()) {
    if (d.severity() == Severity::error) {
      motion.unproven.push_back(told(d));
    }
  }
  return motion;
}

}  // namespace arelem::scenes
