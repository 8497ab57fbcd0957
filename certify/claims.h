#pragma once

#include <array>
#include <variant>

#include "certify/claims/bound/fields.h"
#include "certify/claims/comparison/fields.h"
#include "certify/claims/curves/fields.h"
#include "certify/claims/distance/fields.h"
#include "certify/claims/eigenvalues/fields.h"
#include "certify/claims/geodesics/fields.h"
#include "certify/claims/isometries/fields.h"
#include "certify/claims/net/fields.h"
#include "certify/claims/pants/fields.h"
#include "certify/documents.h"
#include "certify/net/structure.h"

/// What the folders of all claims say of their files: the fields, the functions of documents, and the table of claims.
namespace epsnet::certify {

template <class... Documents>
constexpr std::array<ClaimKind, sizeof...(Documents)> kinds_of(const std::variant<Documents...>* /*list*/) {
  return {Fields<Documents>::kKind...};
}

/// In the order of the alternatives of ClaimDocument.
inline constexpr auto kClaimKinds = kinds_of(static_cast<const ClaimDocument*>(nullptr));

[[nodiscard]] inline const ClaimKind& kind_of(const AnyClaim& claim) { return kClaimKinds[claim.index()]; }

}  // namespace epsnet::certify
