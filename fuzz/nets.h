#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <sstream>

#include "certify/check.h"
#include "certify/file/file.h"
#include "netgen/nets/certified_net.h"
#include "netgen/nets/refine.h"

/// Shared by the fuzz targets that make surfaces from bytes, and nets of these surfaces.
namespace fuzz {

inline void require(bool condition) {
  if (!condition) std::abort();
}

/// The bytes of an input; 0 after the end.
class Bytes {
 public:
  Bytes(const std::uint8_t* data, std::size_t size) : next_(data), end_(data + size) {}

  unsigned byte() { return next_ == end_ ? 0U : *next_++; }
  /// The next two bytes as an integer in [−2¹⁵, 2¹⁵).
  std::int16_t integer() {
    const unsigned low = byte();
    return static_cast<std::int16_t>(low | byte() << 8U);
  }

 private:
  const std::uint8_t* next_;
  const std::uint8_t* end_;
};

/// Takes an ε in [least, least + 4] and options from the bytes. Requires that a net of the surface is found and proved,
/// also after it is written and read again, and that it has at least as many points as the area demands.
inline void require_net(const epsnet::Surface& surface, double least, Bytes& bytes) {
  const unsigned choice = bytes.byte();
  const double epsilon = least + std::ldexp(static_cast<std::uint16_t>(bytes.integer()), -14);
  epsnet::Variant variant;
  variant.insertion = (choice & 1U) != 0 ? epsnet::Insertion::flips : epsnet::Insertion::cavity;
  variant.walk = (choice & 2U) != 0 ? epsnet::Walk::straight : epsnet::Walk::visibility;
  variant.list = static_cast<epsnet::TriangleList>((choice >> 3U) & 3U);
  epsnet::NetOptions options;
  options.pseudo = (choice & 4U) != 0 && epsnet::allows_pseudo_nets(epsnet::Length(epsilon));
  options.check.threads = 1;

  // An exception is a finding.
  const epsnet::VariantNet result = epsnet::compute_variant(surface, epsnet::Length(epsilon), variant, options);
  const epsnet::certify::Certificate certificate = epsnet::certify::check(result.document, options.check);
  require(certificate.verdict == epsnet::certify::Verdict::verified);
  require(certificate.counts.genus == surface.genus());
  const double sinh_half = std::sinh(epsilon / 2);
  if (!options.pseudo)
    require(static_cast<double>(result.document.vertices.size()) * sinh_half * sinh_half >= surface.genus() - 1 - 1e-9);

  std::ostringstream out;
  epsnet::certify::write_file(result.document, out);
  const auto read = epsnet::certify::parse_file<epsnet::certify::NetDocument>(out.str(), "written");
  require(read == result.document);
  require(epsnet::certify::check(read, options.check).verdict == epsnet::certify::Verdict::verified);
}

}  // namespace fuzz
