// MESH definitions: triangles from a data file.
#include "runtime/define/resolve.h"
#include "runtime/geometry/mesh_file.h"

namespace arelem::define {

Result<Resolved> meshOfFile(const Arguments& given) {
  using geometry::MeshFormat;
  const MeshFormat format = given.is(0, Word::STL)   ? MeshFormat::stl
                            : given.is(0, Word::OBJ) ? MeshFormat::obj
                            : given.is(0, Word::PLY) ? MeshFormat::ply
                                                     : MeshFormat::off;
  const std::string& name = given.text(1);
  Result<std::string> bytes = given.fileText(name);
  if (!bytes) {
    return bytes.takeFailure();
  }
  Result<geometry::TriangleMesh> mesh = geometry::readMesh(*bytes, format, name);
  if (!mesh) {
    return mesh.takeFailure();
  }
  return Resolved(*mesh);
}

}  // namespace arelem::define
