#pragma once
#include <optional>
#include <vector>

#include "ir/cl/record.h"
#include "ir/diag/result.h"
#include "runtime/path/swarf_pose.h"

namespace arelem::path {

/// Side and degrees of a VTLAXS or WCORN statement from parameter `i` on: radians, positive to the
/// left. The form was checked where the statement was read.
[[nodiscard]] double swarfTilt(const cl::Post& post, std::size_t i);

/// Whether a VTLAXS or WCORN statement has the parameters of its form: those of a CL file may not.
[[nodiscard]] bool hasSwarfForm(const cl::Post& post);

/// The tool of VTLAXS/ON.
[[nodiscard]] SwarfTool swarfTool(const cl::Post& on);

/// One swarf section while its records are read, and then tilted.
class SwarfSection {
 public:
  /// Where a section ended that came right before.
  struct End {
    Vec3 upright = Vec3::Zero();
    double tilt = 0.0;
  };

  /// `on` is VTLAXS/ON.
  explicit SwarfSection(const cl::Post& on);

  /// The last location of `record` is the first of the section.
  [[nodiscard]] std::optional<Failure> begin(const cl::Record& record);
  /// The section goes on from another one, whose last location is its first.
  [[nodiscard]] std::optional<Failure> begin(const End& end);
  [[nodiscard]] std::optional<Failure> add(const cl::Record& record);
  /// WCORN: the last location is a corner.
  [[nodiscard]] std::optional<Failure> corner(const cl::Record& record);
  /// VTLAXS/OFF: tilts the locations.
  [[nodiscard]] std::optional<Failure> finish(const cl::Post& off);

  [[nodiscard]] const std::vector<cl::Record>& records() const { return records_; }
  /// The last location as it was upright.
  [[nodiscard]] const Vec3& last() const { return points_.back(); }

 private:
  /// A location of the records. Several in one place are one point of the path.
  struct Location {
    std::size_t record;
    std::size_t point;
  };

  std::optional<Failure> take(std::size_t from);
  std::optional<Failure> findDirections();
  /// Direction of the move from point i.
  [[nodiscard]] Vec3 step(std::size_t i) const {
    return (points_[i + 1] - points_[i]).normalized();
  }
  void tilt(std::size_t from, std::size_t to, double first, double last);
  std::optional<Failure> turn();
  void put(std::size_t record, const SwarfPose& pose);
  /// Fills the records anew. Of the points from `first` to `last` only the turn is left: its first
  /// part in the record of the corner, its second in that of the location behind it.
  void write(std::size_t first, std::size_t last, const SwarfTurn& turn);

  SwarfTool tool_;
  double begin_;
  std::vector<cl::Record> records_;
  std::size_t before_ = 0;  ///< numbers of the first record that stand before the section
  std::vector<Vec3> points_, forward_;
  std::vector<Location> locations_;
  std::vector<SwarfPose> poses_;
  std::optional<SwarfCorner> corner_;
  std::size_t at_ = 0;  ///< the point of the corner
};

}  // namespace arelem::path
