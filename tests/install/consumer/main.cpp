#include <epsnet/certify/check.h>
#include <epsnet/certify/reader.h>

#include <iostream>

/// Checks the net file named.
int main(int, char** argv) {
  const auto certificate = epsnet::certify::check(epsnet::certify::read_net(argv[1]));
  std::cout << epsnet::certify::name(certificate.verdict) << '\n';
  return certificate.verdict == epsnet::certify::Verdict::verified ? 0 : 1;
}
