#pragma once
#include <iosfwd>

#include "app/pipeline.h"

#include "backend/film/cell_picture.h"
#include "runtime/stencil/film.h"
#include "runtime/stencil/stencil.h"

namespace arelem::app {

/// What a STENCL statement amounts to, for people; lengths mm whatever UNITS says.
void printStencil(std::ostream& out, const Compilation& job, const stencil::Painted& painted);
/// All statements as a JSON array.
void printStencilsJson(std::ostream& out, const Compilation& job);

/// The film over the mean film as a contour picture (figures 2.10 and 2.14 of Blank, 1997).
[[nodiscard]] backend::CellPicture filmPictureOf(const stencil::Painted& painted);
/// How the two halves of each cell share its area, in percent.
[[nodiscard]] backend::CellPicture sharePictureOf(const stencil::Painted& painted);
/// Every cell with its place, pose, speed, area, shares and film, one a line behind a heading.
void writeCellsCsv(std::ostream& out, const stencil::Painted& painted);

}  // namespace arelem::app
