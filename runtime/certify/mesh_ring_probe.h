#pragma once
#include "runtime/certify/probe.h"

namespace arelem::certify {

/// The ring of CUTTER/OPTION against a mesh. Parts of it are searched over time and angle. A part
/// lies in the hull of its corners, thickened by what arcs bulge: the distance to one triangle is
/// convex, so none of its places is farther from the mesh than a corner from that triangle; and
/// where all triangles that may be the nearest have the part on the same side of their planes, it
/// is on that side of the mesh, no nearer than these planes.
[[nodiscard]] std::unique_ptr<Probe> makeMeshRingProbe(const surface::Mesh& mesh,
                                                       const Relation& relation);

}  // namespace arelem::certify
