#include "runtime/certify/certificate.h"

#include "runtime/certify/association.h"

namespace arelem::certify {

namespace {
class PathCertificate final : public Certificate {
 public:
  PathCertificate(const std::vector<runtime::Action>& actions,
                  const Options& options,
                  DiagnosticSink& sink)
      : options_(options), association_(actions, options_, sink) {}

  void accept(const cl::Record& record) override {
    const auto* motion = std::get_if<cl::Motion>(&record.body);
    if (motion == nullptr) {
      return;
    }
    // A change of feed near a check surface interrupts a run: continuations go on with it.
    if (options_.numbered && !motion->coordinates.empty() &&
        (motion->kind != cl::Motion::Kind::continuation || record.isn != isn_)) {
      association_.end();
      association_.begin(record.isn, motion->withAxis);
      isn_ = record.isn;
    }
    const std::size_t stride = motion->stride();
    for (std::size_t i = 0; i + stride <= motion->coordinates.size(); i += stride) {
      const double* c = motion->coordinates.data() + i;
      Location l{{c[0], c[1], c[2]}, Vec3::UnitZ()};
      if (motion->withAxis) {
        l.axis = Vec3(c[3], c[4], c[5]).normalized();
      }
      association_.add(l, motion->withAxis, i + 2 * stride <= motion->coordinates.size());
    }
  }

  void finish() override {
    association_.end();
    association_.finish();
  }
  [[nodiscard]] const std::vector<StatementResult>& results() const override {
    return association_.results();
  }
  [[nodiscard]] const Summary& summary() const override { return association_.summary(); }

 private:
  Options options_;
  Association association_;
  std::optional<int> isn_;  ///< of the run that is open; it ends where another begins
};
}  // namespace

std::unique_ptr<Certificate> makeCertificate(const std::vector<runtime::Action>& actions,
                                             const Options& options,
                                             DiagnosticSink& sink) {
  return std::make_unique<PathCertificate>(actions, options, sink);
}

}  // namespace arelem::certify
