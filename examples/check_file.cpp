// Checking a file that somebody else has made, without the generator: a program that is linked with epsnet::certify.
//
//   check_file FILE        exit status 0 if and only if the file is verified
//
// Prints, for the file that first_net writes:
//   surface: VERIFIED
//   map: VERIFIED
//   gluing: VERIFIED
//   orientation: VERIFIED
//   delaunay: VERIFIED
//   covering: VERIFIED
//   packing: VERIFIED
//   VERIFIED: an epsilon-net

#include <epsnet/certify/check.h>
#include <epsnet/certify/file/file.h>
#include <exception>
#include <iostream>

namespace certify = epsnet::certify;

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: check_file FILE\n";
    return 64;
  }
  try {
    // A net file, a pants file or any other file that makes a claim, whichever it is. The reader is strict: what
    // docs/format.md does not allow throws.
    const certify::ClaimDocument document = certify::read_file<certify::ClaimDocument>(argv[1]);

    // A document of whatever content gives a certificate.
    const certify::Certificate certificate = certify::check(document);

    for (const certify::RuleReport& rule : certificate.rules) {
      std::cout << rule.rule << ": " << certify::name(rule.verdict) << '\n';
    }
    // There are four verdicts, and only one of them is success: compare with it.
    std::cout << certify::name(certificate.verdict) << ": "
              << (certificate.verdict == certify::Verdict::verified ? certificate.claim : certificate.message) << '\n';
    return certificate.verdict == certify::Verdict::verified ? 0 : 1;
  } catch (const certify::FileError& error) {  // The file cannot be read.
    std::cerr << error.what() << '\n';
  } catch (const certify::MalformedError& error) {  // The file is not one of ours.
    std::cerr << error.what() << '\n';
  }
  return 1;
}
