#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "ir/cl/record.h"
#include "ir/space/vector.h"

namespace arelem::backend::svg {

/// `gun`: a feed with the spray gun on.
enum class MoveKind : std::uint8_t { start, rapid, feed, arc, gun };

/// A location and how the tool came there; `start` begins a new piece of path.
struct Vertex {
  Vec3 place = Vec3::Zero();
  MoveKind kind = MoveKind::feed;
  int about =
      -1;  ///< the coordinate axis of the circle that the tool ran along; -1: no such circle
  Vec3 center = Vec3::Zero();  ///< of that circle
};

/// Smallest box round everything added.
struct Bounds {
  Vec3 low = Vec3::Zero();
  Vec3 high = Vec3::Zero();
  bool empty = true;

  void add(const Vec3& place);
  [[nodiscard]] Vec3 size() const { return empty ? Vec3(Vec3::Zero()) : Vec3(high - low); }
};

/// Collects the tool path from the records in bounded memory: when there are too many locations,
/// those that lie within a small distance of the line through their neighbors go, and the distance
/// grows as needed.
class PathCollector : public cl::RecordSink {
 public:
  explicit PathCollector(std::size_t mostVertices) : most_(mostVertices) {}

  void accept(const cl::Record& record) override;
  /// After the last record.
  void finish() { addStop(); }

  /// Thins the path to the given tolerance, and further if it is still too long for the picture.
  void thin(double tolerance);

  [[nodiscard]] const std::vector<Vertex>& vertices() const { return vertices_; }
  /// Ends of motion statements with the tool axis along z, at most `mostStops`, evenly thinned.
  [[nodiscard]] const std::vector<Vec3>& stops() const { return stops_; }
  [[nodiscard]] const Bounds& bounds() const { return bounds_; }
  [[nodiscard]] std::uint64_t locations() const { return locations_; }
  [[nodiscard]] std::uint64_t stopCount() const { return stopCount_; }  ///< before the thinning
  [[nodiscard]] double length(MoveKind kind) const {
    return lengths_[static_cast<std::size_t>(kind)];
  }
  /// Largest distance by which the thinned path may miss a location; 0 when nothing was left out.
  [[nodiscard]] double deviation() const { return deviation_; }
  [[nodiscard]] double cutterDiameter() const { return diameter_; }
  [[nodiscard]] const std::string& partName() const { return partName_; }
  /// In small letters; "" without UNITS.
  [[nodiscard]] const std::string& unit() const { return unit_; }
  /// What the moves of kind `arc` run along.
  [[nodiscard]] bool hasCircles() const { return circles_; }
  [[nodiscard]] bool hasSplines() const { return splines_; }

  static constexpr std::size_t mostStops = 256;

 private:
  void command(const cl::Post& post);
  void surface(const cl::SurfaceValue& surface);
  void move(const cl::Motion& motion, int isn);
  void add(const Vec3& place, MoveKind kind);
  void addStop();
  void compress();
  void raise(double tolerance);
  void shrinkTo(std::size_t most);
  void simplify(std::size_t first);
  void halve();
  void keepOnly(const std::vector<bool>& keep);

  std::size_t most_;
  std::vector<Vertex> vertices_;
  std::vector<Vec3> stops_;
  Bounds bounds_;
  std::uint64_t locations_ = 0;
  std::uint64_t stopCount_ = 0;
  std::uint64_t stopStride_ = 1;
  std::array<double, 5> lengths_{};
  double tolerance_ = 0.0;   ///< of the thinning at present
  double deviation_ = 0.0;   ///< sum of the tolerances used one after another
  std::size_t thinned_ = 0;  ///< vertices that were thinned with the present tolerance
  double diameter_ = 0.0;
  std::string partName_;
  std::string unit_;
  int isn_ = 0;
  bool changed_ = false;  ///< RAPID or FEDRAT came since the last motion
  bool rapid_ = false;    ///< RAPID was read and not used yet
  bool cycle_ = false;    ///< a drilling cycle is on: the tool goes from place to place at rapid
  bool gun_ = false;      ///< SPRAY/ON was read, and no SPRAY/OFF since
  bool arc_ = false;      ///< a circle or a path spline was read for the next motion
  bool circles_ = false, splines_ = false;
  int about_ = -1;  ///< of the circle that was read, see Vertex
  int along_ = -1;  ///< of the motion at present
  Vec3 center_ = Vec3::Zero();
  bool pending_ = false;  ///< the last vertex ends a motion unless a continuation follows
  bool upright_ = true;   ///< the tool axis there is along z
  MoveKind kind_ = MoveKind::feed;
};

}  // namespace arelem::backend::svg
