#pragma once
#include <memory>
#include <string>
#include <vector>

#include "app/pipeline.h"

#include "ir/limits.h"

/// The way from a part program to its certified motion, within this process.
namespace arelem::scenes {

/// The locations of one statement.
struct Run {
  int isn = 0;
  std::vector<Vec3> places, axes;
};

/// What became of a program.
struct Motion {
  std::vector<std::string> codes;         ///< of the errors, each once, in order
  std::string message;                    ///< of the first error
  std::vector<Run> runs;                  ///< long motions fill several records: they are one run
  std::vector<std::string> unproven;      ///< what the certificate says against the motion
  double computing = 0.0, proving = 0.0;  ///< processor seconds; computing includes reading

  /// "computed", or the code of the first error in the order in which they were found.
  [[nodiscard]] std::string outcome() const {
    return codes.empty() ? "computed" : message.substr(0, message.find(' '));
  }
};

/// A part program in work: what it defined can be asked for afterwards.
class Work {
 public:
  /// Data files lie in `folder`, with a slash at its end.
  Work(std::string text, const std::string& folder);
  ~Work();
  Work(const Work&) = delete;
  Work& operator=(const Work&) = delete;

  /// Sections 1 to 3; with `proven`, every cut vector goes through the certificate too.
  [[nodiscard]] Motion run(bool proven);
  /// The surface or other entity of a name; null if it has none.
  [[nodiscard]] EntityPtr entity(std::string_view name) const;
  [[nodiscard]] const std::vector<runtime::Action>& actions() const;

 private:
  app::Settings settings_;
  const InterruptFlag never_{false};  ///< interrupted
  std::unique_ptr<app::Compilation> job_;
  double reading_ = 0.0;  ///< processor seconds of Section 1
  bool evaluated_ = false;
};

}  // namespace arelem::scenes
