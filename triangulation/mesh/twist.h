#pragma once

#include "triangulation/mesh/journal.h"
#include "triangulation/mesh/triangulation.h"

namespace epsnet {

/// A Dehn twist, where it saves flips: if the two triangles beside d make an annulus around a short closed curve and
/// the edges across turn around it many times more than a Delaunay triangulation lets them, undoes all of these turns,
/// which would take as many flips. False, with nothing changed, elsewhere. The darts stay where they are. Throws
/// LimitError if there are so many turns that the words of labels become too long.
[[nodiscard]] bool untwist(Triangulation& triangulation, Dart d, Journal* journal);

}  // namespace epsnet
