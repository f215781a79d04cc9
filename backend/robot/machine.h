#pragma once
#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "backend/ngc/control.h"
#include "backend/robot/turning.h"
#include "ir/diag/result.h"
#include "ir/space/vector.h"

namespace arelem::robot {

/// Lengths in mm, angles in degrees, times in s.

using Matrix3 = Eigen::Matrix3d;

/// Where the coordinates of the part program lie, seen from the base of the robot.
struct Frame {
  Vec3 shift = Vec3::Zero();
  std::array<double, 3> angles{};  ///< ZYZ moving axes: yaw, pitch, roll
};
struct Range {
  double low = 0.0;
  double high = 0.0;
  [[nodiscard]] bool has(double value) const { return value >= low && value <= high; }
};

/// Two turning links, a quill and its turn (Adept Three, kinematics of Rehiara 2011). Joint 4 is
/// the heading of the tool less joints 1 and 2.
struct Scara {
  double link1 = 559.0;
  double link2 = 508.0;
  Range joint1{-150.0, 150.0};
  Range joint2{-150.0, 150.0};
  Range joint4{-270.0, 270.0};
  Range height{0.0, 305.0};  ///< of the tool point over the base
  double stretch = 0.99;  ///< largest share of the reach: at 1 the elbow is straight and singular
  bool lefty = false;
};

/// A turning pantograph that enlarges the way of its actuator (Blank 2.25, 2.26).
struct Pantograph {
  double ratio = 25.0 / 3.0;
  Range actuator{0.0, 1000.0};
  Range turn{-180.0, 180.0};
  std::array<double, 2> speed{200.0, 90.0};           ///< of actuator (mm/s) and turn (deg/s)
  std::array<double, 2> acceleration{2000.0, 360.0};  ///< mm/s2, deg/s2
  double countsPerMillimeter = 0.0;                   ///< of the actuator's encoder; 0: not stated
  double countsPerTurn = 0.0;
};
/// Two links of one length, read out by encoders (listing of pathS.c, corrected).
struct Elbow {
  double link = 2794.0;            ///< 110 in
  double countsPerTurn = 88000.0;  ///< of both encoders
  Range elbow{0.0, 90.0};          ///< half the angle at the elbow: acos(reach / 2 links)
  Range turn{-180.0, 180.0};
  std::array<double, 2> speed{30.0, 90.0};           ///< deg/s
  std::array<double, 2> acceleration{360.0, 360.0};  ///< deg/s2
};

/// An axis of the end effector that tilts the gun, driven by an eight bit word.
struct TiltAxis {
  double most = 25.4;
  double step = 0.2;
  int firstOutput = 33;
  bool signMagnitude = true;  ///< as Blank's table 2.2; else two's complement, as his text
};
/// The word for an angle, and the angle of a word.
[[nodiscard]] int tiltWord(const TiltAxis& axis, double degrees);
[[nodiscard]] double tiltAngle(const TiltAxis& axis, int word);

/// How V+ programs are written.
struct VplusStyle {
  enum class Format : std::uint8_t {
    program,  ///< a complete program
    pathS,    ///< the lines of Blank's pathS.c: the angle of the tool in the roll slot
    pathB     ///< those of pathB.c: in the yaw slot, which turns the other way
  };
  Format format = Format::program;
  bool onTheFly = false;  ///< SIGNAL without BREAK
  bool crlf = true;
  bool controlZ = false;  ///< a form feed behind .END and SUB at the end, as the controller stores
  int columns = 80;
  /// Rapid moves leave their place and come to the next one straight along the tool, by DEPARTS and
  /// APPROS of this many mm; 0: they go straight from place to place.
  double approach = 0.0;
  /// From the flange to the tool point, x, y, z, yaw, pitch, roll: TOOL; none: as the robot has it.
  std::optional<std::array<double, 6>> tool;
};

/// Where the tool point may stand, seen from the base of the robot.
struct Envelope {
  std::array<Range, 3> sides{Range{-1e6, 1e6}, Range{-1e6, 1e6}, Range{-1e6, 1e6}};  ///< x, y, z
  Vec3 center = Vec3::Zero();  ///< of the reach
  Range reach{0.0, 1e6};       ///< distance from the center
  double lean = 180.0;         ///< largest angle of the tool axis from the vertical, degrees
};

/// How G97 programs of Fanuc R-G2 controllers are written.
struct G97Style {
  int program = 1;  ///< number of the first program
  bool programLine = true;
  int blocks = 9999;  ///< most of one program
  bool flipped = false, back = false;
  std::vector<int> turns{0, 0, 0};  ///< of gamma, beta, alpha: -1, 0, 1
  bool fixedAxes = false;    ///< P, Q, R about the axes of the work, not those turned already
  bool uprightRoll = false;  ///< R keeps the tool's x over the direction that the tool leans to
  bool inBase = false;       ///< coordinates of the base, not of the work frame
  Vec3 tool = Vec3::Zero();  ///< from the taught tool point to the nozzle, in the taught tool frame
  std::vector<int> outputs;  ///< the controller's output for OUTPUT 1, 2, ...; none: the same
  std::string s63;           ///< sequence code of the first block
  std::map<std::string, std::string> words;  ///< sequence codes of words, {1} is their number
  bool robopaint = false;                    ///< P and Q by Sen's equations (11) and (12)
};

/// What the time law (`arelem time`) may use: mm/s, mm/s2, mm/s3, mm by which corners may be
/// rounded, seconds of a tool change.
struct TimeLimits {
  double velocity = 400.0;
  double acceleration = 4000.0;
  double jerk = 20000.0;
  double corner = 0.01;
  double toolChange = 10.0;
};

/// What there is of a machine: a robot, or a machine tool with its control. Parts that the file
/// does not name are absent.
struct Machine {
  std::string file;
  std::string name;
  Frame frame;
  double speed = 0.0;            ///< largest of the tool point, mm/s; 0: not checked
  double rapid = 500.0;          ///< of RAPID moves, mm/s
  double acceleration = 2000.0;  ///< along the path of joint tables, mm/s2
  double interval = 0.032;       ///< of joint tables, s
  double blend = 0.128;          ///< over which a joint table takes the mean of the path, s
  std::optional<Scara> scara;
  std::optional<Pantograph> pantograph;
  std::optional<Elbow> elbow;
  std::optional<TiltAxis> tilt;
  VplusStyle vplus;
  std::optional<Envelope> envelope;
  G97Style g97;
  std::optional<backend::ngc::Control> control;  ///< how it reads RS-274
  std::optional<Turning> turning;                ///< axes A, B, C of a machine tool
  std::optional<TimeLimits> time;
};

/// Reads a machine file (TOML; docs/manual/machines.md). Errors: E0650 no TOML, E0651 an unknown
/// key, E0652 a value of the wrong kind or outside its range; all with file and line.
[[nodiscard]] Result<Machine> readMachine(std::string_view text, std::string_view file);

}  // namespace arelem::robot
