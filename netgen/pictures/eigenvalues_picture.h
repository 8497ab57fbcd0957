#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "certify/claims/eigenvalues/document.h"

/// The picture of an eigenvalues file: how many eigenvalues can be where. Nothing here is proved.
namespace epsnet {

/// What such a picture shows, over the axis of eigenvalues.
struct EigenvaluesPicture {
  struct Sample {
    double lambda;
    double bound;  ///< I(λ), of netgen/eigenvalues/eigenvalues.h.
  };
  std::string title{};
  double up_to = 0;               ///< What is claimed ends here.
  std::vector<Sample> samples{};  ///< By λ, from 0 to beyond up_to.
  std::vector<certify::EigenvaluesDocument::Window> windows{};
};

/// Returns the curve I(λ), with the windows of the file as bands. It is evaluated at some 500 places, and more near the
/// windows. Throws SurfaceError if the document has no surface, LimitError as eigenvalue_bounds. Time: some 0.1 ms for
/// each place, and that of trace_matrices.
[[nodiscard]] EigenvaluesPicture picture_of(const certify::EigenvaluesDocument& document);

/// Returns the picture as SVG, `size` pixels wide (50 to 20000) and 0.62 times as high. Above each band is its number
/// of eigenvalues; on the axis is where they are. Bands and marks are at least as wide as can be seen.
[[nodiscard]] std::string draw_svg(const EigenvaluesPicture& picture, std::uint32_t size = 1000);

}  // namespace epsnet
