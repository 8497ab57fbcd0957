// Closed geodesics: the systole of the Bolza surface and all its closed geodesics up to length 5, with proofs.
//
// Prints:
//   systole: [3.0571418389619959, 3.057141838961997], VERIFIED
//   12 geodesics of length in [3.0571418389619959, 3.057141838961997], exactly equal
//   12 geodesics of length in [4.89690489535615, 4.8969048953561521], exactly equal

#include <epsnet/epsnet.h>
#include <iostream>

int main() {
  const epsnet::Surface bolza = epsnet::Surface::regular(2);

  // The search is in floating point. The checker proves what it finds: that the geodesic exists, that its length lies
  // in the interval, and that there is no shorter one. If it cannot, there is an epsnet::NotCertifiedError.
  const auto [shortest, certificate] = epsnet::systole(bolza);
  const epsnet::certify::Interval length = shortest.geodesics[0].length;
  std::cout << "systole: " << to_string(length) << ", " << epsnet::certify::name(certificate.verdict) << '\n';

  // All primitive closed geodesics up to a length, up to orientation, in clusters of lengths that are not told apart.
  const epsnet::certify::GeodesicsDocument spectrum = epsnet::spectrum(bolza, epsnet::Length("5")).document;
  for (const epsnet::certify::GeodesicsDocument::Cluster& cluster : spectrum.clusters) {
    const epsnet::certify::GeodesicsDocument::ClosedGeodesic& first = spectrum.geodesics[cluster.first];
    std::cout << cluster.count << (cluster.count == 1 ? " geodesic" : " geodesics") << " of length in "
              << to_string(first.length) << (cluster.equal ? ", exactly equal\n" : "\n");
  }
}
