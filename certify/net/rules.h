#pragma once

#include <optional>
#include <vector>

#include "certify/net/document.h"
#include "certify/net/labels.h"
#include "certify/verdict/report.h"

/// The rules that every net is asked, in their order (docs/proof.md, sections 2 to 7).
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

/// Rule `map`: the triangles and their opposite darts are a connected closed oriented combinatorial surface of the
/// given genus whose vertices are the vertices of the document, each with one cycle of darts (docs/proof.md, section
/// 3). Exact, O(n). Needs a document without structure problem. The report does not depend on the number of threads.
[[nodiscard]] RuleReport check_map(const NetDocument& document, std::uint64_t genus, unsigned threads = 1);

struct GluingOutcome {
  RuleReport report;
  std::uint64_t identities = 0;      ///< Different group equations that had to be decided.
  std::uint64_t max_precision = 64;  ///< Bits.
};

/// Whether an element of the group of the surface is 1, given as an isometry of the disk with the centre of a disk
/// inside of a tile, whose radius has this sinh, at 0 (docs/proof.md, Lemma 2).
[[nodiscard]] Tri is_identity(const BallIsometry& element, const Ball& sinh_radius, slong precision);

/// Rule `gluing`: across every edge the two triangles fit, L_{t,i} L_{t',j+1}⁻¹ = L_{t,i+1} L_{t',j}⁻¹ in the group of
/// the surface (corner i of t is corner j + 1 of t', corner i + 1 is corner j).
///
/// An element of the group that moves the centre of a disk inside a tile by less than twice the radius is 1, so balls
/// decide equality (docs/proof.md, section 4). Needs rules `surface` and `map`. O(n log n) for look-ups and one
/// evaluation for each different equation.
[[nodiscard]] GluingOutcome check_gluing(const NetDocument& document, const LabelEvaluator& evaluator,
                                         const LabelParts& parts, long max_precision, unsigned threads);

struct GeometryOutcome {
  std::vector<RuleReport> reports;  ///< orientation, delaunay, covering, packing; thick, if it is a pseudo net.
  std::vector<std::uint32_t> ties;  ///< The smaller darts of the edges that are exact ties, in order.
  std::uint64_t triangles_beyond_64_bits = 0;
  std::uint64_t max_precision = 64;
  Enclosures enclosures;  ///< But for the area and the cores.
};

/// Rules `orientation`, `delaunay`, `covering` and `packing`: every lifted triangle is strictly counterclockwise, no
/// edge has a cross-ratio with positive imaginary part, every circumradius is at most ε, every edge between different
/// vertices is at least ε long (docs/proof.md, sections 5 to 7). In a pseudo net triangles of collars need a
/// circumcircle only, the edges between the two vertices of a collar may have any length, and rule `thick` says that
/// loops at other vertices are at least ε long (section 10).
///
/// Balls of 64 bits first, then twice as many for what they left open, and so on up to max_precision; exact ties of the
/// first two rules are decided exactly, in file order. What cannot change the first refuted rule, or the triangle that
/// refutes it, is left undecided, and so is what the budget does not allow. Needs rules `surface` and `map`. O(n) time;
/// the result does not depend on the number of threads. `progress` as in CheckOptions.
[[nodiscard]] GeometryOutcome check_geometry(const NetDocument& document, const LabelEvaluator& evaluator,
                                             const CheckOptions& options, unsigned threads);

}  // namespace epsnet::certify
