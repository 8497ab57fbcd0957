#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "triangulation/surface/atlas.h"

namespace epsnet {

/// Products and inverses of labels of an atlas, as far as it has them: several threads may have an object each
/// as long as nobody adds labels. The other way round, an object stays right when labels are added.
class KnownLabels {
 public:
  explicit KnownLabels(const Atlas& atlas) : atlas_(&atlas) {}

  /// f ∘ g; kUnknownLabel if it is not known or if f or g is not.
  [[nodiscard]] LabelId product(LabelId f, LabelId g) {
    if (f == kIdentity) return g;
    if (g == kIdentity) return f;
    Recent& recent = recent_[slot(f, g)];
    if (recent.f != f || recent.g != g) {
      if (f == kUnknownLabel || g == kUnknownLabel) return kUnknownLabel;
      const LabelId known = atlas_->known_product(f, g);
      if (known == kUnknownLabel) return kUnknownLabel;
      recent = {f, g, known};
    }
    return recent.product;
  }
  [[nodiscard]] LabelId inverse(LabelId f) const { return atlas_->known_inverse(f); }
  [[nodiscard]] const Atlas& atlas() const { return *atlas_; }

 private:
  struct Recent {
    LabelId f = kIdentity;
    LabelId g = kIdentity;
    LabelId product = kIdentity;
  };
  static constexpr unsigned kBits = 12;
  [[nodiscard]] static std::size_t slot(LabelId f, LabelId g) {
    constexpr std::uint64_t kGolden = 0x9e3779b97f4a7c15;  // Multiplicative hashing.
    return static_cast<std::size_t>((((std::uint64_t{f} << 32) | g) * kGolden) >> (64 - kBits));
  }

  const Atlas* atlas_;
  std::vector<Recent> recent_ = std::vector<Recent>(std::size_t{1} << kBits);
};

}  // namespace epsnet
