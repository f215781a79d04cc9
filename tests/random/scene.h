#pragma once
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tests/random/surfaces.h"

namespace arelem::scenes {

/// Which scene: it is drawn from these numbers alone.
struct SceneId {
  std::uint64_t seed = 1;
  std::size_t pair = 0;  ///< part kind times kinds.size() plus drive kind
  std::uint64_t number = 0;

  [[nodiscard]] std::size_t part() const { return pair / kinds.size(); }
  [[nodiscard]] std::size_t drive() const { return pair % kinds.size(); }
};
/// "1:torus,cone,17", as --only takes it.
[[nodiscard]] std::string spell(const SceneId& id);

/// How the tool is against the drive surface, and the way of GO that brings it there.
enum class Hand : std::uint8_t { on, left, right };
/// What a scene has beside one motion to one check surface.
enum class Extra : std::uint8_t { none, secondCheck, tangentDrive, tangentPart, implied, counted };
/// Rules of the tool axis.
enum class AxisWord : std::uint8_t { fixed, normalPart, normalDrive, angle, lead, fourAxis };

/// A tool along two surfaces to a third one, and the similarity under which its motion is compared.
struct Scene {
  SceneId id;
  Shape part, drive, check, second;
  std::array<double, 7> cutter{};             ///< lengths but for the angles at 4 and 5
  std::optional<std::array<double, 3>> ring;  ///< CUTTER/OPTION: surface, radius, height
  double inner = 0.0, outer = 0.002;
  std::array<double, 3> thick{};  ///< part, drive, check surface
  double longest = 10.0;          ///< MAXDP
  Hand hand = Hand::on;
  bool onPart = false;  ///< TLONPS
  std::string stop = "TO", secondStop = "ON";
  Extra extra = Extra::none;
  bool turnsLeft = false;  ///< of the motion behind an implied stop
  AxisWord axis = AxisWord::fixed;
  int axisSurface = 1;
  double alpha = 0.0, beta = 0.0;
  bool multax = true;
  Similarity move;

  /// The part program, moved.
  [[nodiscard]] std::string program(const Similarity& to) const;
  /// Names and contents of the files that the program reads.
  [[nodiscard]] std::vector<std::pair<std::string, std::string>> files(const Similarity& to) const;
  [[nodiscard]] double band() const { return inner + outer; }
};

[[nodiscard]] Scene drawScene(const SceneId& id);

}  // namespace arelem::scenes
