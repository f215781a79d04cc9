#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "tests/random/motion.h"
#include "tests/random/scene.h"

namespace arelem::scenes {

/// What is wrong: a path (it is not proven, or another one when the scene is moved), or a refusal
/// (for no cause that is known, of a motion that exists, or otherwise when the scene is moved).
enum class Concern : std::uint8_t { path, refusal };
struct Fault {
  Concern concern;
  std::string text;
};

/// What a scene showed.
struct Finding {
  SceneId id;
  std::string outcome;       ///< "computed", or the code with which it was refused
  std::vector<Fault> wrong;  ///< none: the scene is as it should be
  bool confirmed = false;    ///< a refusal that an independent search agrees with
  /// Of the processor: the whole scene, and of it the motion, its proof, and the motion once more.
  double seconds = 0.0, computing = 0.0, proving = 0.0, moved = 0.0;

  /// The first fault, of a path if there is one; null: none.
  [[nodiscard]] const Fault* worst() const;
};

/// A folder for data files, which goes with the object.
class Folder {
 public:
  Folder();
  ~Folder();
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  [[nodiscard]] const std::string& path() const { return path_; }  ///< with a slash at its end

 private:
  std::string path_;
};

/// Writes the data files of a scene moved.
void writeFiles(const Scene& scene, const Similarity& to, const std::string& folder);

/// Codes of motion that name why a scene has no motion. All others are failures.
[[nodiscard]] bool isExplained(std::string_view code);

/// Computes the scene, proves it, and compares it with itself moved.
[[nodiscard]] Finding tryScene(const Scene& scene, const Folder& folder);

}  // namespace arelem::scenes
