#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ir/cl/record.h"
#include "ir/space/vector.h"

namespace arelem::app {

/// A move of a CL file: where the tool goes and how.
struct ClMove {
  Vec3 start = Vec3::Zero();  ///< end of the move before, part unit of the file
  Vec3 end = Vec3::Zero();
  Vec3 axis = Vec3::UnitZ();
  std::optional<Vec3> center;   ///< of an arc
  Vec3 normal = Vec3::UnitZ();  ///< of an arc: it turns counter-clockwise about it
  double feed = 0.0;            ///< of the last FEDRAT; 0 before any
  double millimeters = 0.0;     ///< of the part unit; 0 without UNITS
  bool rapid = false;
  cl::Motion::Way way = cl::Motion::Way::straight;
  std::string words;       ///< of the machine between the move before and this one; where asked for
  std::uint32_t text = 0;  ///< buffer of `line`
  std::uint32_t line = 0;  ///< 0 in a file without lines
  int isn = 0;
  [[nodiscard]] bool isArc() const {
    return center && way != cl::Motion::Way::straight && way != cl::Motion::Way::spline;
  }
};

/// Makes moves of a stream of records and hands them on in batches.
class ClMoves : public cl::RecordSink {
 public:
  /// Moves of a batch. UNITS behind the first moves, but within the first batch, hold for them too.
  static constexpr std::size_t batch = 4096;

  /// Where a statement begins: its line, 0 where there is none.
  using LineOf = std::function<std::uint32_t(const Span&)>;
  ClMoves(LineOf lineOf, bool withWords) : lineOf_(std::move(lineOf)), withWords_(withWords) {}
  void accept(const cl::Record& record) override;

  /// The moves of an ended batch; none while it grows.
  [[nodiscard]] bool ended() const { return moves_.size() >= batch; }
  [[nodiscard]] std::vector<ClMove> take();
  /// The words behind the last move.
  [[nodiscard]] const std::string& wordsBehind() const { return words_; }

 private:
  void takeMotion(const cl::Record& record, const cl::Motion& motion);
  void takePost(const cl::Post& post);

  LineOf lineOf_;
  bool withWords_;
  std::vector<ClMove> moves_;
  std::string words_;
  bool rapid_ = false;
  double feed_ = 0.0;
  double millimeters_ = 0.0;
  Vec3 place_ = Vec3::Zero();
  std::optional<Vec3> center_;
  Vec3 normal_ = Vec3::UnitZ();
};

}  // namespace arelem::app
