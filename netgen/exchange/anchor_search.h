#pragma once

#include <string_view>

#include "netgen/exchange/text_formats.h"

namespace epsnet {

/// Returns an exact lift of one triangle to the unit disk, for a triangulation without an anchor; every other such lift
/// is an image of it under an isometry of the disk.
///
/// Cross-ratios place the triangles in the complex plane up to Möbius maps. The group of the surface then preserves one
/// circle, the boundary of the disk. Two elements without a common fixed point determine it: the Hermitian forms H with
/// g*Hg = |det g|H are the solutions of linear equations. A Möbius map over Q(i) takes it to the unit circle if and
/// only if tanh²(d/2), d the length of any edge, is a sum of two squares of rational numbers; then the edge can lead
/// from 0 to any κ with |κ|² = tanh²(d/2). Streams made from rational points have such a κ, and greatest common
/// divisors in Z[i] find it, since all their cross-ratios contain its factors (docs/exchange-formats.md).
///
/// Requires: the combinatorics that read_triangulation_stream checks. Throws ExchangeError if there is no such circle,
/// if there is no such κ, or if none was found; the message then says what to write into the text.
[[nodiscard]] TriangulationStream::Anchor find_anchor(const TriangulationStream& stream, std::string_view name);

}  // namespace epsnet
