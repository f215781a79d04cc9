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
      close();
      return;
    }
    if (options_.numbered &&
        (motion->kind != cl::Motion::Kind::continuation || record.isn != isn_)) {
      close();
      isn_ = record.isn;
    }
    run_.withAxis = motion->withAxis;
    for (std::size_t i = 0; i + motion->stride() <= motion->coordinates.size();
         i += motion->stride()) {
      const double* c = motion->coordinates.data() + i;
      Location l{{c[0], c[1], c[2]}, Vec3::UnitZ()};
      if (motion->withAxis) {
        l.axis = Vec3(c[3], c[4], c[5]).normalized();
      }
      run_.locations.push_back(l);
    }
  }

  void finish() override {
    if (options_.numbered) {
      close();
    } else {
      association_.takeAll(run_);
    }
    association_.finish();
  }
  [[nodiscard]] const std::vector<StatementResult>& results() const override {
    return association_.results();
  }
  [[nodiscard]] const Summary& summary() const override { return association_.summary(); }

 private:
  void close() {
    if (options_.numbered && !run_.locations.empty()) {
      association_.take(isn_, run_);
      run_.locations.clear();
    }
  }

  Options options_;
  Association association_;
  int isn_ = 0;
  OutputOrder::Run run_;
};
}  // namespace

std::unique_ptr<Certificate> makeCertificate(const std::vector<runtime::Action>& actions,
                                             const Options& options,
                                             DiagnosticSink& sink) {
  return std::make_unique<PathCertificate>(actions, options, sink);
}

}  // namespace arelem::certify
