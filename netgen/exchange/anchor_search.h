#pragma once

#include <string_view>

#include "netgen/exchange/triangulation_stream.h"

namespace epsnet {

/// A lift of one triangle of a triangulation without an anchor to the unit disk, exactly; all others are its images
/// under isometries of the disk.
///
/// Cross-ratios place the triangles in the complex plane up to Möbius maps of it. The group of the surface then keeps
/// one circle, the boundary of the disk, which two loops without a common fixed point determine: the Hermitian forms H
/// with g*Hg = |det g|H are the solutions of linear equations. A Möbius map over Q(i) takes it to the unit circle if
/// and only if tanh²(d/2), d the length of any edge, is a sum of two squares of rational numbers; then the edge can go
/// from 0 to any κ with |κ|² = tanh²(d/2). For streams that were made from rational points that is so, and κ is found
/// by greatest common divisors in Z[i], as all cross-ratios have been made with it (docs/exchange-formats.md).
///
/// Requires the combinatorics that read_triangulation_stream checks. Throws ExchangeError if there is no
/// such circle, if there is no such κ, or if none was found, and then says what to write into the text.
[[nodiscard]] TriangulationStream::Anchor find_anchor(const TriangulationStream& stream, std::string_view name);

}  // namespace epsnet
