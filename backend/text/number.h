#pragma once
#include <string>

namespace arelem::backend {

/// Decimals of a number in text: `shortest` is the shortest fixed notation that reads back to the
/// same double.
inline constexpr int shortest = -1;
inline constexpr int maxDecimals = 15;

/// Largest magnitude that CL text may hold. Beyond it a double has no decimals left, so no tool
/// stands there.
inline constexpr double textNumberLimit = 1e15;
/// Magnitudes below this are written as 0: they are rounding residues far under any length or
/// direction cosine.
inline constexpr double textNumberFloor = 1e-15;
[[nodiscard]] bool isWritable(double value);

/// Room that one number of CL text needs at most.
inline constexpr int numberRoom = 64;

/// Writes a writable number in fixed notation and returns its end: never scientific, never "-0",
/// always a decimal point with at least one digit after it, independent of the locale. `first` has
/// numberRoom bytes.
char* writeFixed(char* first, double value, int decimals);

/// The same, but a whole number has no decimal point: for the parameters of post words.
char* writeParameter(char* first, double value, int decimals);

/// Appends the shortest text that reads back to the same double (scientific where shorter), for
/// JSON. A value that is not finite becomes null.
void appendJsonNumber(std::string& out, double value);

}  // namespace arelem::backend
