#pragma once
#include <Eigen/Core>
#include <Eigen/Geometry>

namespace arelem {

/// Coordinates in the unit of the part program. Points and free vectors share the representation;
/// names say which is meant, and a unit vector is called a normal, an axis or a direction.
using Vec3 = Eigen::Vector3d;

}  // namespace arelem
