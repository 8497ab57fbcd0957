#pragma once

#include <concepts>
#include <cstddef>
#include <variant>

#include "certify/claims/bound/document.h"
#include "certify/claims/comparison/document.h"
#include "certify/claims/curves/document.h"
#include "certify/claims/distance/document.h"
#include "certify/claims/eigenvalues/document.h"
#include "certify/claims/geodesics/document.h"
#include "certify/claims/isometries/document.h"
#include "certify/claims/pants/document.h"
#include "certify/net/document.h"

/// The one list of the claims that files can make.
namespace epsnet::certify {

/// The contents of a file that can be checked. What is needed for each kind of claim follows from this list.
using ClaimDocument = std::variant<NetDocument, GeodesicsDocument, DistanceDocument, BoundDocument, EigenvaluesDocument,
                                   IsometriesDocument, PantsDocument, ComparisonDocument, CurvesDocument>;

/// Pointers to the documents of that list.
template <class Documents = ClaimDocument>
struct Pointers;
/// @cond
template <class... Documents>
struct Pointers<std::variant<Documents...>> {
  using ToConst = std::variant<const Documents*...>;
  template <class... More>
  using And = std::variant<More*..., Documents*...>;
};
/// @endcond

template <class Document>
concept IsDocument = std::constructible_from < Pointers<>::ToConst,
const Document* > ;

/// A reference to the document of a claim, for functions that serve all claims. Converts from each of these documents
/// and from ClaimDocument.
class AnyClaim {
 public:
  // Meant to convert. NOLINTBEGIN(google-explicit-constructor)
  /// Refers to a document, which must live as long.
  template <IsDocument Document>
  AnyClaim(const Document& document) : document_(&document) {}
  /// Refers to whichever it is, likewise.
  AnyClaim(const ClaimDocument& document)
      : AnyClaim(std::visit([](const auto& one) { return AnyClaim(one); }, document)) {}
  // NOLINTEND(google-explicit-constructor)

  /// The number of its alternative of ClaimDocument.
  [[nodiscard]] std::size_t index() const { return document_.index(); }

  /// Returns what `use` makes of the document.
  template <class Use>
  decltype(auto) visit(const Use& use) const {
    return std::visit([&](const auto* document) -> decltype(auto) { return use(*document); }, document_);
  }

  /// Returns its net.
  [[nodiscard]] const NetDocument& net() const {
    return visit([]<class Document>(const Document& document) -> const NetDocument& {
      if constexpr (std::same_as<Document, NetDocument>) {
        return document;
      } else {
        return document.net;
      }
    });
  }

 private:
  Pointers<>::ToConst document_;
};

}  // namespace epsnet::certify
