#pragma once

#include <string>
#include <string_view>

#include "tests/assurance/file_mutants/reference_document.h"

/// A third implementation of the rules of docs/format.md, in exact arithmetic, for rational tiles, pseudo nets and
/// geodesics. It is as short as possible, shares no line with certify/, and is for small files only.
///
/// It uses integers. Rationals enclose sinh² of lengths; closed geodesics are compared by the sides that they cross.
namespace epsnet::attack {

struct Answer {
  enum class Verdict { valid, invalid, malformed, unknown };
  Verdict verdict = Verdict::unknown;
  std::string rule;  ///< For an invalid file the first rule that is broken; otherwise the reason, in a few words.
};

/// All primitive closed geodesics up to some length on the surface of a geodesics file, and the pieces into which the
/// small curves cut it. Mutants of the file are compared with these.
class KnownGeodesics {
 public:
  KnownGeodesics();
  KnownGeodesics(KnownGeodesics&&) noexcept;
  KnownGeodesics& operator=(KnownGeodesics&&) noexcept;
  ~KnownGeodesics();

  struct Surface;

 private:
  friend KnownGeodesics learn(std::string_view text);
  friend Answer ask(std::string_view text, const KnownGeodesics* known);
  Surface* surface_ = nullptr;
};

/// Takes the geodesics of a true geodesics file. On surfaces without very short curves the list is also found
/// independently, by running through all copies of the tiles within reach; throws std::runtime_error if it differs.
/// Elsewhere the list is trusted.
[[nodiscard]] KnownGeodesics learn(std::string_view text);

/// Returns the answer of the reference for a file. For a geodesics file `known` has to be that of its surface.
[[nodiscard]] Answer ask(std::string_view text, const KnownGeodesics* known = nullptr);

}  // namespace epsnet::attack
