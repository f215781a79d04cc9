#pragma once
#include <optional>
#include <string>
#include <vector>

#include "backend/vplus/expression.h"
#include "backend/vplus/reader.h"

namespace arelem::vplus {

/// Reads the instructions of a program one by one and keeps what they leave behind: the speed, the
/// tilt, the blocks that are open. What is wrong is told to the scope.
class Instructions {
 public:
  Instructions(Scope& scope, ProgramText& program, const robot::TiltAxis* tilt)
      : scope_(scope), program_(program), tilt_(tilt) {}

  /// The instruction at the next token of the scope, on this line of the file.
  void one(std::size_t line);
  /// At the end of the program: an approach without its move.
  void finish();
  /// IF, FOR and WHILE that no END has closed.
  [[nodiscard]] const std::vector<std::string>& openBlocks() const { return blocks_; }

 private:
  bool motionWord(const std::string& word);
  bool settingWord(const std::string& word);
  bool outputWord(const std::string& word);
  bool blockWord(const std::string& word);
  void move(bool straight);
  void approach();
  void depart();
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
  double speed_ = 0.0;
  std::optional<double> nextSpeed_;  // of the next motion only
  double tiltDegrees_ = 0.0;
};

}  // namespace arelem::vplus
