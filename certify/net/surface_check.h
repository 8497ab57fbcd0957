#pragma once

#include "certify/net/document.h"
#include "certify/net/labels.h"
#include "certify/verdict/report.h"

namespace epsnet::certify {

/// A surface that passed, and the isometries made from it.
struct SurfaceOutcome {
  RuleReport report;
  std::uint64_t genus = 0;
  Crossings crossings = {};  ///< Complete if the report is verified.
};

/// Rule `surface`: the tiles and their gluing are a closed hyperbolic surface of genus ≥ 2 (Poincaré's polygon theorem,
/// docs/proof.md, section 2). Everything is exact but the angle sums, where balls tell an integer from its neighbours.
/// Regular tiles are one by theorem (section 9) if q corners meet at every vertex: nothing else is left to compute.
/// Needs a document without structure problem. Quasi-linear in the number of digits; undecided, if that is more work
/// than the budget allows.
[[nodiscard]] SurfaceOutcome check_surface(const SurfaceDocument& surface, unsigned threads = 1,
                                           const Budget& budget = {});

/// A disk of radius ≥ arsinh(sinh_radius) about `centre`, inside a tile.
struct InscribedDisk {
  ExactPoint centre;
  Ball sinh_radius;
};

/// From 0 to the centre of a disk, in the coordinates of a chart of its tile that has this frame.
[[nodiscard]] BallIsometry base_of(const InscribedDisk& disk, const ExactIsometry& frame, slong precision);

/// A disk inside a strictly convex tile, to be used as a neighbourhood that no isometry of the group but 1 moves less
/// than twice its radius. Any tile has one; it is found with more and more bits. `cap` bounds the bits: nothing then.
[[nodiscard]] std::optional<InscribedDisk> inscribed_disk(const SurfaceDocument::Tile& tile, long cap,
                                                          const Budget& budget = {});

/// The same for tile number `tile` of a surface that passed check_surface. A regular tile has its inscribed circle.
[[nodiscard]] std::optional<InscribedDisk> inscribed_disk(const SurfaceDocument& surface, std::uint32_t tile, long cap,
                                                          const Budget& budget = {});

}  // namespace epsnet::certify
