#pragma once

#include <string>
#include <string_view>

#include "tests/assurance/file_mutants/reference_document.h"

/// The rules of docs/format.md in exact arithmetic, written once more for every kind of surface, pseudo nets and
/// geodesics: as short as can be, with no line of certify/, and for small files alone.
///
/// Integers for rational tiles; for regular surfaces of genus 2, 3 and 4 towers of square roots. sinh² of lengths are
/// enclosed by rationals; closed geodesics are compared by the sides that they cross.
namespace epsnet::attack {

struct Answer {
  enum class Verdict { valid, invalid, malformed, unknown };
  Verdict verdict = Verdict::unknown;
  std::string rule;  ///< Of an invalid file the first rule that is broken; else why, in a few words.
};

/// All primitive closed geodesics of the surface of a geodesics file up to some length, and the pieces that those of
/// length at most 2 arsinh 1 cut it into: what mutants of the file are compared with.
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

/// From a true geodesics file. Its list is believed, and on surfaces without very short curves it is first found again
/// by running through all copies of the tiles that can be reached; throws std::runtime_error if it is another one.
[[nodiscard]] KnownGeodesics learn(std::string_view text);

/// What the reference says of a file; of geodesics files on the surface that is known.
[[nodiscard]] Answer ask(std::string_view text, const KnownGeodesics* known = nullptr);

}  // namespace epsnet::attack
