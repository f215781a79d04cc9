#pragma once
#include <optional>
#include <string>
#include <vector>

#include "backend/vplus/expression.h"
#include "backend/vplus/reader.h"

namespace arelem::vplus {

/// Whether both are one place, but for the rounding of sums.
[[nodiscard]] bool isSame(const Place& a, const Place& b);

/// Reads the instructions of a program one by one and keeps what they leave behind: the speed, the
/// tilt, the blocks that are open. What is wrong is told to the scope.
class Instructions {
 public:
  Instructions(Scope& scope, ProgramText& program, const robot::TiltAxis* tilt)
      : scope_(scope), program_(program), tilt_(tilt) {}

  /// The instruction at the next token of the scope, on this line of the file.
  void one(std::size_t line);
  /// At the end of the program: an approach without its move, RETURN.
  void finish();
  /// IF, FOR and WHILE that no END has closed.
  [[nodiscard]] const std::vector<std::string>& openBlocks() const { return blocks_; }

 private:
  bool motionWord(const std::string& word);
  bool settingWord(const std::string& word);
  bool outputWord(const std::string& word);
  bool blockWord(const std::string& word);
  void move(bool straight);
  void approach(const std::string& word);
  void endOfApproach();
  void depart(const std::string& word);
  void event(std::string what, std::vector<std::optional<double>> numbers = {});
  void motionEvent(std::string what, std::vector<std::optional<double>> numbers = {});
  bool blendingWord(const std::string& word);
  bool armWord(const std::string& word);
  std::optional<double> positive(const char* name);
  void setAcceleration();
  void stray(std::string what);
  [[nodiscard]] robot::Pose leaning(robot::Pose pose) const;
  void setSpeed();
  void setTool();
  void setBase();
  void delay();
  std::optional<double> time();
  void signal();
  void bits();
  void open(const std::string& word);
  void assignment(const std::string& word);

  Scope& scope_;
  ProgramText& program_;
  const robot::TiltAxis* tilt_;
  std::vector<std::string> blocks_;
  std::size_t line_ = 0;
  std::optional<Place> frame_;  // the location that is set first
  std::optional<Place> over_;   // what an APPRO goes to, until the move to it
  std::size_t overLine_ = 0;
  std::optional<robot::Pose> underWay_;  // upright pose of a move that has begun
  Settings settings_;
  double tiltDegrees_ = 0.0;
};

}  // namespace arelem::vplus
