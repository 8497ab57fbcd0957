#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "certify/net/document.h"

namespace epsnet::certify {

/// Which triangles and vertices the collars of a pseudo net name; nothing in any other net.
class CollarMembers {
 public:
  /// Needs a document without structure problem. O(number of triangles) if there is a collar.
  explicit CollarMembers(const NetDocument& document) : pseudo_(document.collars.has_value()) {
    if (!pseudo_ || document.collars->empty()) return;
    triangles_.resize(document.triangles.size());
    for (const NetDocument::Collar& collar : *document.collars) {
      for (const std::uint32_t t : collar.triangles) triangles_[t] = true;
      partners_[collar.vertices[0]] = collar.vertices[1];
      partners_[collar.vertices[1]] = collar.vertices[0];
    }
  }

  /// Whether the net is a pseudo net.
  [[nodiscard]] bool pseudo() const { return pseudo_; }
  [[nodiscard]] bool has_triangle(std::uint32_t t) const { return !triangles_.empty() && triangles_[t]; }
  [[nodiscard]] bool has_vertex(std::uint32_t v) const { return partners_.contains(v); }
  /// Whether two vertices are those of one collar.
  [[nodiscard]] bool are_partners(std::uint32_t u, std::uint32_t v) const {
    const auto found = partners_.find(u);
    return found != partners_.end() && found->second == v;
  }

 private:
  bool pseudo_;
  std::vector<bool> triangles_;
  std::unordered_map<std::uint32_t, std::uint32_t> partners_;
};

}  // namespace epsnet::certify
