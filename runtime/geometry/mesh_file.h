#pragma once
#include <string_view>

#include "ir/diag/result.h"
#include "runtime/geometry/triangle_mesh.h"

namespace arelem::geometry {

enum class MeshFormat : std::uint8_t { stl, obj, ply, off };
[[nodiscard]] std::string_view spell(MeshFormat format);

/// The triangles of a file's bytes; polygons are cut into fans. STL as text or binary: binary if
/// its length fits its count, whatever its header begins with. Errors: E0344 with what is wrong
/// where, and those of `checkedMesh`.
[[nodiscard]] Result<TriangleMesh> readMesh(std::string_view bytes,
                                            MeshFormat format,
                                            std::string_view name);

/// OBJ, PLY and OFF; none where the bytes are not of that format: `polygonFault` says why.
[[nodiscard]] std::optional<TriangleMesh> readPolygons(std::string_view bytes, MeshFormat format);

/// Why bytes are no OBJ, PLY or OFF: the line and what is wrong there, of the texts; what is known
/// of a binary PLY.
[[nodiscard]] std::string polygonFault(std::string_view bytes, MeshFormat format);

}  // namespace arelem::geometry
