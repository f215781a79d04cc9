#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

namespace arelem::vplus {

/// What holds for a motion until it is set again, or for one motion only.
enum class Setting : std::uint8_t {
  toolSpeed,  ///< mm/s; 0: the speed is in percent
  percent,
  rotation,  ///< percent
  monitor,   ///< percent
  profile,
  acceleration,  ///< percent
  deceleration,  ///< percent
  duration,      ///< s
  coarse,        ///< percent; below 0: FINE
  nulling,       ///< 0: NONULL
  blending,      ///< 0: CPOFF
  arm,           ///< 1: RIGHTY, -1: LEFTY, 0: as it stands
  elbow,         ///< 1: ABOVE, -1: BELOW
  wrist,         ///< 1: FLIP, -1: NOFLIP
};
inline constexpr std::size_t settings = 14;

/// The settings of one motion; a value that only the robot knows is NaN.
using Manner = std::array<double, settings>;
/// Of a program at its start.
[[nodiscard]] Manner usualManner();

/// Keeps what is set, for all motions (ALWAYS) or for the next one.
class Settings {
 public:
  /// None: a value that only the robot knows.
  void set(Setting setting, std::optional<double> value, bool always);
  [[nodiscard]] double at(Setting setting) const;
  /// Of the motion that begins now; what was set for one motion is over then.
  [[nodiscard]] Manner take();

 private:
  Manner always_ = usualManner();
  Manner next_ = always_;
};

/// What a program does at one of its instructions, however that is spelled: its word, its numbers
/// (NaN: only the robot knows them) and, of a motion, the settings that it is made with. Places are
/// not kept here.
struct Event {
  std::size_t line = 0;
  std::string what;
  std::vector<double> numbers = {};
  std::optional<Manner> manner = std::nullopt;
};

/// The instruction as a program has it, "SIGNAL -1".
[[nodiscard]] std::string shown(const Event& event);

/// How two instructions differ, for messages: what was found and what was wanted.
struct EventDifference {
  std::string found;
  std::string wanted;
};
/// Within the rounding of three decimals.
[[nodiscard]] std::optional<EventDifference> difference(const Event& found, const Event& wanted);

}  // namespace arelem::vplus
