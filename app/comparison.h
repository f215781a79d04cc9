#pragma once
#include <iosfwd>
#include <optional>
#include <string>

#include "app/diff_side.h"

namespace arelem::app {

/// What counts as the same in two CL files.
struct DiffAllowed {
  double distance = 1e-6;  ///< of ends and centers, part unit of the first file
  double degrees = 1e-4;   ///< between tool axes
  double chords = 0.0;     ///< straight moves of one file may leave an arc of the other by so much
  bool words = false;      ///< the words for the machine are compared too
};

/// Two moves that are not the same.
struct Difference {
  std::size_t a = 0, b = 0;  ///< their numbers, from 0
  ClMove left, right;
  double distance = 0.0;  ///< of their ends, part unit of the first file
  std::string what;
};

/// Compares two files move by move and steps over moves that only one of them has, where the files
/// agree again behind them.
class Comparison {
 public:
  Comparison(DiffSide& a, DiffSide& b, const DiffAllowed& allowed)
      : a_(a), b_(b), allowed_(allowed) {}

  void run();
  /// Behind the end of both sides: the words behind the last moves.
  void finish();
  [[nodiscard]] bool same() const { return differing_ + onlyA_ + onlyB_ == 0; }
  void print(std::ostream& out) const;
  void printJson(std::ostream& out) const;

 private:
  struct Missing {
    const DiffSide* side = nullptr;
    ClMove move;
  };
  void print(std::ostream& out, std::string_view title, const Difference& d) const;
  void note(Difference difference);
  [[nodiscard]] bool step();
  [[nodiscard]] bool stepChords();
  void only(DiffSide& side, std::size_t count);

  DiffSide& a_;
  DiffSide& b_;
  DiffAllowed allowed_;
  std::optional<Difference> first_, largest_;
  std::optional<Missing> missing_;
  std::size_t differing_ = 0, onlyA_ = 0, onlyB_ = 0;
  std::size_t arcs_ = 0;  ///< of one file, straight moves of the other
  std::string endWords_;
};

}  // namespace arelem::app
