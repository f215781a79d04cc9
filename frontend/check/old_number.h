#pragma once
#include <string_view>
#include <utility>

#include "ir/diag/diagnostic.h"
#include "ir/diag/frontend.h"

/// Diagnostics whose causes the old system told apart: a row under the number of one cause. Code
/// and text stay those of the row.
namespace arelem::frontend::old_number {

constexpr DiagRow under(std::string_view number, DiagRow row) {
  row.legacy = number;
  return row;
}

inline constexpr DiagRow arrayClass = under("106", diag::RedefinedClassRow);
inline constexpr DiagRow macroClass = under("211", diag::RedefinedClassRow);
inline constexpr DiagRow noSurfaceType = under("1006", diag::ArgumentTypeRow);
inline constexpr DiagRow numberForSurface = under("132", diag::SurfaceExpectedRow);
inline constexpr DiagRow obtainWithoutType = under("153", diag::ObtainFormatRow);
inline constexpr DiagRow pocketHead = under("376", diag::ParameterExpectedRow);
inline constexpr DiagRow pocketPoints = under("377", diag::ParameterExpectedRow);
inline constexpr DiagRow partSurfaceType = under("1006", diag::ZsurfFormatRow);
inline constexpr DiagRow readFormat = under("2000", diag::PrintFormatRow);
inline constexpr DiagRow reservedNumber = under("254", diag::ReservFormatRow);
inline constexpr DiagRow reservedSize = under("255", diag::ReservFormatRow);
inline constexpr DiagRow synonymAlone = under("351", diag::SynonymFormatRow);
inline constexpr DiagRow synonymOfNoWord = under("356", diag::SynonymFormatRow);
inline constexpr DiagRow undefinedArray = under("108", diag::UndefinedSymbolRow);
inline constexpr DiagRow unnamedType = under("76", diag::MisplacedRow);
inline constexpr DiagRow valueMissing = under("132", diag::ParameterExpectedRow);
inline constexpr DiagRow zsurfPlane = under("26", diag::ZsurfFormatRow);

inline Diagnostic as(const DiagRow& row, Diagnostic diagnostic) {
  diagnostic.row = &row;
  return diagnostic;
}

}  // namespace arelem::frontend::old_number
