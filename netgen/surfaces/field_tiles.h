#pragma once

#include <string>
#include <vector>

#include "certify/net/document.h"
#include "certify/numbers/field_number.h"
#include "triangulation/surface/surface.h"

/// Surfaces whose tiles have corners over a real number field (docs/format.md, "Surfaces over a number field").
namespace epsnet {

/// The tiles, exactly.
struct FieldTiles {
  certify::SurfaceDocument::Field document;
  certify::NumberField field;
  ById<SideId, certify::Isometry<certify::FieldNumber>> crossing;

  /// Requires: a document as files have it, with an interval that isolates the root; indices of sides that there are.
  FieldTiles(certify::SurfaceDocument::Field tiles, const std::vector<Gluing>& gluing);
  /// α.
  [[nodiscard]] Mp1024 root() const;
  FieldTiles(const FieldTiles&) = delete;
  FieldTiles& operator=(const FieldTiles&) = delete;
};

/// Returns the surface of such tiles. Corners and crossings are examined as numbers of 4,096 bits: that crossings take
/// sides to their partners, and that the tiles around every vertex close up, once around; `certify` proves it. Throws
/// SurfaceError, which says what is wrong. Quasi-linear in the number of digits.
[[nodiscard]] Surface surface_over_field(certify::SurfaceDocument::Field tiles, std::vector<Gluing> gluing);

/// The isometry scaled to determinant 1, rounded to T (Mp1024, Mp4096). Requires: a positive determinant.
template <class T>
[[nodiscard]] Isometry<T> rounded_isometry(const certify::Isometry<certify::FieldNumber>& f);

/// The isometry of a word, as integer_isometry has it. Requires: a surface over a field,
/// which must outlive the numbers.
[[nodiscard]] certify::Isometry<certify::FieldNumber> field_isometry(const Surface& surface, const Word& word);

/// The coefficients of a real number.
[[nodiscard]] std::vector<mpz_class> coefficients_of(const certify::FieldNumber& x);

// Numbers as texts that NumberFieldReader reads.

/// "root(f,r)": α, for a decimal r that is nearer to α than the ends of the interval, beyond which other roots are.
[[nodiscard]] std::string root_text(const FieldTiles& tiles);

/// Real numbers of a field as polynomials in the number of this name, up to a common positive integer factor.
[[nodiscard]] std::vector<std::string> number_texts(const std::vector<certify::FieldNumber>& numbers,
                                                    const std::string& name);

}  // namespace epsnet
