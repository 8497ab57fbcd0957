#include <epsnet/certify/check.h>
#include <epsnet/certify/writer.h>
#include <epsnet/netgen/certified_net.h>
#include <epsnet/netgen/octagon.h>
#include <fstream>
#include <iostream>

/// Writes a proved net to the file named.
int main(int, char** argv) {
  const auto result = epsnet::certified_net(epsnet::random_octagon(123), 0.5);
  std::ofstream out(argv[1]);
  epsnet::certify::write_net(result.net, out);
  std::cout << epsnet::certify::name(result.certificate.verdict) << ", " << result.net.vertices.size() << " points\n";
  return out.flush() ? 0 : 1;
}
