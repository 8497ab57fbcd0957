// A first net: a random surface of genus 2, a 0.25-net of it with its proof, a file and a picture.
//
//   first_net [FOLDER]     writes net.json and net.svg to FOLDER, or to where you are
//
// Prints:
//   143 points, 435 edges, 290 triangles
//   every point of the surface is within 0.248683 of one of them
//   different points are at least 0.250263 apart
//   VERIFIED

#include <epsnet/epsnet.h>
#include <filesystem>
#include <fstream>
#include <iostream>

int main(int argc, char** argv) {
  const std::filesystem::path folder = argc > 1 ? argv[1] : ".";

  // Surfaces are exact and immutable. fenchel_nielsen_surface makes one of any genus, load_surface reads a file.
  const epsnet::Surface surface = epsnet::random_octagon(123);

  // A net is returned only if the checker has verified it; otherwise there is an epsnet::NetError that says why.
  // The length 0.25 is exact, too: 1/4.
  const epsnet::CertifiedNet result = epsnet::certified_net(surface, epsnet::Length("0.25"));

  // The certificate has what was proved. Numbers are intervals that contain the true values: take the safe end, and
  // print it with six digits so that it is a bound still.
  const epsnet::certify::Certificate& certificate = result.certificate;
  std::cout << certificate.counts.vertices << " points, " << certificate.counts.edges << " edges, "
            << certificate.counts.triangles << " triangles\n"
            << "every point of the surface is within "
            << epsnet::certify::decimal_above(certificate.enclosures->largest_circumradius.upper, 6)
            << " of one of them\n"
            << "different points are at least "
            << epsnet::certify::decimal_below(certificate.enclosures->shortest_edge->lower, 6) << " apart\n"
            << epsnet::certify::name(certificate.verdict) << '\n';

  // The file can be checked by anybody: certify net.json
  std::ofstream file(folder / "net.json");
  epsnet::certify::write_file(result.document, file);

  std::ofstream picture(folder / "net.svg");
  picture << epsnet::draw_svg(result.document, {.dirichlet = true, .colouring = epsnet::Colouring::circumradius});
  return file.flush() && picture.flush() ? 0 : 1;
}
