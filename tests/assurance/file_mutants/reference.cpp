#include "tests/assurance/file_mutants/reference.h"

#include "tests/assurance/file_mutants/geodesic_rules.h"
#include "tests/assurance/file_mutants/net_rules.h"

namespace epsnet::attack {

struct KnownGeodesics::Surface {
  std::optional<GeodesicRules<mpz_class>> tiles;
  std::optional<GeodesicRules<RegularNumber<2>>> octagon;
};

KnownGeodesics::KnownGeodesics() : surface_(new Surface) {}
KnownGeodesics::KnownGeodesics(KnownGeodesics&& other) noexcept : surface_(std::exchange(other.surface_, nullptr)) {}
KnownGeodesics& KnownGeodesics::operator=(KnownGeodesics&& other) noexcept {
  std::swap(surface_, other.surface_);
  return *this;
}
KnownGeodesics::~KnownGeodesics() { delete surface_; }

namespace {

template <class Rules>
void check(const std::optional<Rules>& rules, const GeodesicsFile& file) {
  if (!rules || !rules->same_surface(file.net)) throw Unknown{"another surface"};
  rules->check(file);
}

/// The rules of the net.
void check_net(const NetFile& net) {
  if (net.genus == 0) {
    const Tiling<mpz_class> tiling = rational_tiling<mpz_class>(net);
    NetRules<mpz_class>(net, tiling).check();
    return;
  }
  const auto regular = [&]<int Genus>() {
    static const Tiling<RegularNumber<Genus>> tiling = regular_tiling<Genus>();
    NetRules<RegularNumber<Genus>>(net, tiling).check();
  };
  if (net.genus == 2) return regular.operator()<2>();
  if (net.genus == 3) return regular.operator()<3>();
  if (net.genus == 4) return regular.operator()<4>();
  const Tiling<mpz_class> shape{{}, {}, 2 - 2 * static_cast<long>(net.genus)};
  NetRules<mpz_class>(net, shape).check();
}

}  // namespace

KnownGeodesics learn(std::string_view text) {
  const File file = read_file(text);
  if (!file.geodesics) throw std::runtime_error("no geodesics file");
  KnownGeodesics known;
  if (file.net.genus == 0) {
    known.surface_->tiles.emplace(*file.geodesics, rational_tiling<mpz_class>(file.net));
  } else if (file.net.genus == 2) {
    known.surface_->octagon.emplace(*file.geodesics, regular_tiling<2>());
  } else {
    throw std::runtime_error("geodesics of a regular surface that is not the octagon");
  }
  return known;
}

Answer ask(std::string_view text, const KnownGeodesics* known) {
  using enum Answer::Verdict;
  try {
    const File file = read_file(text);
    check_net(file.net);
    if (!file.geodesics) return {valid, ""};
    if (known == nullptr) return {unknown, "the geodesics of another surface"};
    if (file.net.genus == 0) {
      check(known->surface_->tiles, *file.geodesics);
    } else {
      check(known->surface_->octagon, *file.geodesics);
    }
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
