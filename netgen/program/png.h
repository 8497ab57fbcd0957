#pragma once

#include <cstdint>
#include <string>

namespace epsnet::program {

/// Returns the PNG file of an SVG picture of of a width in pixels, and as high as the picture, on white (librsvg).
/// Throws JobError.
[[nodiscard]] std::string png_of_svg(const std::string& svg, std::uint32_t width);

}  // namespace epsnet::program
