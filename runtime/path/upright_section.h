#pragma once
#include <optional>
#include <vector>

#include "runtime/path/swarf_section.h"

namespace arelem::path {

/// A swarf section of a CL file: its tilted locations are taken back to the upright ones that they
/// were made of, and these are tilted once more, to see whether they were.
class UprightSection {
 public:
  using End = SwarfSection::End;

  /// `slack`: what rounding in the file may do to a place (part unit) and to a number of an axis.
  UprightSection(const cl::Post& on, double slack);

  [[nodiscard]] std::optional<Failure> begin(const cl::Record& record);
  [[nodiscard]] std::optional<Failure> begin(const End& end);
  [[nodiscard]] std::optional<Failure> add(const cl::Record& record);
  [[nodiscard]] std::optional<Failure> corner(const cl::Record& record);
  [[nodiscard]] std::optional<Failure> finish(const cl::Post& off);

  /// With upright locations, behind `finish`.
  [[nodiscard]] const std::vector<cl::Record>& records() const { return records_; }
  [[nodiscard]] const Vec3& last() const { return upright_.back(); }

 private:
  [[nodiscard]] std::vector<Vec3> level() const;
  std::optional<Failure> take(const cl::Record& record, std::size_t from);
  void makeUpright();
  std::optional<Failure> compare(const SwarfSection& again) const;
  void write();

  cl::Post on_;
  SwarfTool tool_;
  double slack_;
  std::vector<cl::Record> records_;
  std::size_t before_ = 0;  ///< numbers of the first record that stand before the section
  std::optional<End> from_;
  std::vector<SwarfPose> poses_;  ///< of the file
  std::vector<Vec3> upright_;
};

}  // namespace arelem::path
