#pragma once
#include "runtime/geometry/kinds/mesh.h"
#include "runtime/tool/profile.h"
#include "runtime/tool/section_contact.h"

namespace arelem::tool {

/// The ring of CUTTER/OPTION has no body: what counts is the least signed distance of its places to
/// the mesh, as with other surfaces. It is 1-Lipschitz along the ring, which shows where no lower
/// one can be; of what is left each valley is searched. `hint`: of the last foot.
[[nodiscard]] Contact ringContact(const surface::Mesh& mesh,
                                  double side,
                                  const Profile& ring,
                                  const Vec3& te,
                                  const Vec3& axis,
                                  surface::Mesh::Hint& hint);

}  // namespace arelem::tool
