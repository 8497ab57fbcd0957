#include <epsnet/certify/check.h>
#include <epsnet/certify/reader.h>
#include <epsnet/certify/writer.h>
#include <epsnet/netgen/certified_net.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

namespace {

using epsnet::Complex;
using epsnet::Rational;

void require(bool condition) {
  if (!condition) std::abort();
}

/// The next two bytes of the input as an integer in [−2¹⁵, 2¹⁵); 0 after the end.
class Bytes {
 public:
  Bytes(const std::uint8_t* data, std::size_t size) : next_(data), end_(data + size) {}

  std::int16_t integer() {
    const unsigned low = byte();
    return static_cast<std::int16_t>(low | byte() << 8U);
  }
  unsigned byte() { return next_ == end_ ? 0U : *next_++; }
  Rational coordinate() { return Rational(integer(), 32768); }

 private:
  const std::uint8_t* next_;
  const std::uint8_t* end_;
};

/// The symmetric octagon z0, …, z3, −z0, …, −z3, opposite sides glued, z0 > 0, where z3 is moved along a hyperbolic
/// line through −z0 until the area is 4π: in the frame f(z) = (z + z0)/(1 + z0 z) the condition Im[(1 − z0 z̄1)(1 − z1
/// z̄2)(1 − z2 z̄3)(1 + z3 z̄0)] = 0 is linear in the factor of f(z3). Nothing if that has no solution, or the octagon is
/// not a fundamental polygon.
std::optional<epsnet::Surface> octagon(Bytes& bytes) {
  const Complex<Rational> one{1, 0};
  const Complex<Rational> z0{bytes.coordinate(), 0};
  const Complex<Rational> z1{bytes.coordinate(), bytes.coordinate()};
  const Complex<Rational> z2{bytes.coordinate(), bytes.coordinate()};
  const Complex<Rational> start{bytes.coordinate(), bytes.coordinate()};
  for (const auto& z : {z0, z1, z2, start}) {
    if (norm(z) >= 1) return std::nullopt;
  }
  const Complex<Rational> w = (start + z0) / (one + z0 * start);
  const Complex<Rational> k = (one - z0 * conj(z1)) * (one - z1 * conj(z2));
  const Rational slope = (k * conj(w) * (z0 + z2)).y;
  if (slope == 0) return std::nullopt;
  const Rational factor = (k * (one + z0 * z2)).y / slope;
  const Complex<Rational> moved = factor * w;
  if (norm(moved) >= 1) return std::nullopt;
  const Complex<Rational> z3 = (moved - z0) / (one - z0 * moved);
  try {
    return epsnet::Surface({{z0, z1, z2, z3, -z0, -z1, -z2, -z3}},
                           {{0, 0, 0, 4}, {0, 1, 0, 5}, {0, 2, 0, 6}, {0, 3, 0, 7}});
  } catch (const epsnet::SurfaceError&) {
    return std::nullopt;
  }
}

}  // namespace

/// Every octagon and every ε have a net that is proved, also when it is written and read again, with at least as many
/// points as the area demands.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Bytes bytes(data, size);
  const auto surface = octagon(bytes);
  if (!surface) return 0;
  const unsigned choice = bytes.byte();
  const double epsilon = 0.2 + std::ldexp(static_cast<std::uint16_t>(bytes.integer()), -14);  // Up to 4.2.
  epsnet::NetOptions options;
  options.insertion = (choice & 1U) != 0 ? epsnet::Insertion::flips : epsnet::Insertion::cavity;
  options.walk = (choice & 2U) != 0 ? epsnet::Walk::straight : epsnet::Walk::visibility;
  options.check.threads = 1;

  const epsnet::CertifiedNet result = epsnet::certified_net(*surface, epsilon, options);  // An exception is a finding.
  require(result.certificate.verdict == epsnet::certify::Verdict::verified);
  require(result.certificate.counts.genus == 2);
  const double sinh_half = std::sinh(epsilon / 2);
  require(static_cast<double>(result.net.vertices.size()) * sinh_half * sinh_half >= 1 - 1e-9);

  std::ostringstream out;
  epsnet::certify::write_net(result.net, out);
  const auto read = epsnet::certify::parse_net(out.str(), "written");
  require(read == result.net);
  require(epsnet::certify::check(read, options.check).verdict == epsnet::certify::Verdict::verified);
  return 0;
}
