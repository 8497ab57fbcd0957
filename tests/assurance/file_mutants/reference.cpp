#include "tests/assurance/file_mutants/reference.h"

#include "tests/assurance/file_mutants/geodesic_rules.h"
#include "tests/assurance/file_mutants/net_rules.h"

namespace epsnet::attack {

struct KnownGeodesics::Surface {
  std::optional<GeodesicRules<mpz_class>> tiles;
};

KnownGeodesics::KnownGeodesics() : surface_(new Surface) {}
KnownGeodesics::KnownGeodesics(KnownGeodesics&& other) noexcept : surface_(std::exchange(other.surface_, nullptr)) {}
KnownGeodesics& KnownGeodesics::operator=(KnownGeodesics&& other) noexcept {
  std::swap(surface_, other.surface_);
  return *this;
}
KnownGeodesics::~KnownGeodesics() { delete surface_; }

namespace {

/// Throws Unknown for a surface that the reference does not know.
Tiling<mpz_class> tiling_of(const NetFile& net) {
  if (net.genus != 0) throw Unknown{"regular tiles"};
  return rational_tiling<mpz_class>(net);
}

}  // namespace

KnownGeodesics learn(std::string_view text) {
  const File file = read_file(text);
  if (!file.geodesics) throw std::runtime_error("no geodesics file");
  KnownGeodesics known;
  known.surface_->tiles.emplace(*file.geodesics, tiling_of(file.net));
  return known;
}

Answer ask(std::string_view text, const KnownGeodesics* known) {
  using enum Answer::Verdict;
  try {
    const File file = read_file(text);
    const Tiling<mpz_class> tiling = tiling_of(file.net);
    NetRules<mpz_class>(file.net, tiling).check();
    if (!file.geodesics) return {valid, ""};
    if (known == nullptr) return {unknown, "the geodesics of another surface"};
    const auto& rules = known->surface_->tiles;
    if (!rules || !rules->same_surface(file.net)) throw Unknown{"another surface"};
    rules->check(*file.geodesics);
    return {valid, ""};
  } catch (const Malformed& malformed_file) {
    return {malformed, malformed_file.why};
  } catch (const Broken& broken) {
    return {invalid, broken.rule};
  } catch (const Unknown& question) {
    return {unknown, question.why};
  }
}

}  // namespace epsnet::attack
