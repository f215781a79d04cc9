#pragma once

namespace arelem::app {

struct Compilation;

/// Warns of SPRAY statements whose lines run together on a surface, or lie too far apart: W0352. A
/// region has its edges only.
void warnOfFilms(Compilation& job);

}  // namespace arelem::app
