#include "certify/net/collar_members.h"

namespace epsnet::certify {

CollarMembers::CollarMembers(const NetDocument& document) : pseudo_(document.collars.has_value()) {
  if (!pseudo_ || document.collars->empty()) return;
  triangles_.resize(document.triangles.size());
  for (const NetDocument::Collar& collar : *document.collars) {
    for (const std::uint32_t t : collar.triangles) triangles_[t] = true;
    partners_[collar.vertices[0]] = collar.vertices[1];
    partners_[collar.vertices[1]] = collar.vertices[0];
  }
}

}  // namespace epsnet::certify
