#include <algorithm>
#include <array>
#include <charconv>
#include <map>
#include <optional>
#include <sstream>
#include <utility>
#include <vector>

#include "certify/file/json.h"
#include "netgen/surfaces/coset_enumeration.h"
#include "netgen/surfaces/regular_map_table.h"
#include "netgen/surfaces/surfaces.h"

namespace epsnet {
namespace {

void require_permutation(const Permutation& images, const std::string& name) {
  const auto number = [](std::size_t i) { return std::to_string(i); };
  std::vector<std::optional<std::size_t>> origin(images.size());
  for (std::size_t dart = 0; dart < images.size(); ++dart) {
    const std::uint32_t image = images[dart];
    if (image >= images.size()) {
      throw MapError(name + ": the image of dart " + number(dart) + " is " + number(image) + ", there are only " +
                     number(images.size()) + " darts");
    }
    if (origin[image]) {
      throw MapError(name + ": darts " + number(*origin[image]) + " and " + number(dart) + " have the same image, " +
                     number(image));
    }
    origin[image] = dart;
  }
}

/// The cycles of a permutation, each from its least element, in their order.
std::vector<std::vector<std::uint32_t>> cycles(const Permutation& permutation) {
  std::vector<std::vector<std::uint32_t>> result;
  std::vector<bool> visited(permutation.size());
  for (std::uint32_t first = 0; first < permutation.size(); ++first) {
    if (visited[first]) continue;
    result.emplace_back();
    for (std::uint32_t i = first; !visited[i]; i = permutation[i]) {
      visited[i] = true;
      result.back().push_back(i);
    }
  }
  return result;
}

/// The length of all cycles. `of_cycle` says what a cycle has so many of.
std::uint32_t common_length(const std::vector<std::vector<std::uint32_t>>& cycles, const std::string& name,
                            const std::string& of_cycle) {
  const std::vector<std::uint32_t>& first = cycles.front();
  for (const std::vector<std::uint32_t>& cycle : cycles) {
    if (cycle.size() == first.size()) continue;
    throw MapError(name + ": " + of_cycle + " of dart " + std::to_string(first.front()) + " has " +
                   std::to_string(first.size()) + ", that of dart " + std::to_string(cycle.front()) + " has " +
                   std::to_string(cycle.size()) + ", expected as many");
  }
  return static_cast<std::uint32_t>(first.size());
}

class MapReader {
 public:
  explicit MapReader(const std::string& text) : text_(text), json_(text_) {}

  DartMap read() {
    std::optional<Permutation> rotation;
    std::optional<Permutation> edges;
    if (!json_.take('{')) fail("an object with the members rotation and edges");
    json_.members([&](std::string_view name) {
      const std::string member(name);
      if (member != "rotation" && member != "edges") {
        throw MapError("unknown member \"" + member + "\", expected rotation and edges");
      }
      std::optional<Permutation>& value = member == "rotation" ? rotation : edges;
      if (value) throw MapError("member \"" + member + "\" occurs twice");
      value = permutation(member);
    });
    if (!json_.at_end()) throw MapError("something follows the object");
    for (const auto& [name, value] : {std::pair("rotation", &rotation), std::pair("edges", &edges)}) {
      if (!*value) throw MapError(std::string("member \"") + name + "\" is missing");
    }
    return {std::move(*rotation), std::move(*edges)};
  }

 private:
  [[noreturn]] void fail(const std::string& expected) {
    throw MapError("expected " + expected + ", not " + json_.found());
  }

  Permutation permutation(const std::string& name) {
    Permutation result;
    if (!json_.take('[')) fail(name + ": an array of darts");
    json_.elements([&](std::size_t) {
      const std::string token(json_.token());
      std::uint32_t value = 0;
      const auto [last, error] = std::from_chars(token.data(), token.data() + token.size(), value);
      if (token.empty() || error != std::errc() || last != token.data() + token.size()) {
        throw MapError(name + ": expected the number of a dart, not " + (token.empty() ? json_.found() : token));
      }
      result.push_back(value);
    });
    return result;
  }

  certify::ByteStream text_;
  certify::Json json_;
};

/// Generators of the group of rotations: x turns a face, y an edge, and xy a vertex.
struct Generators {
  Permutation x;
  Permutation y;
};

Surface bolza() { return Surface::regular(2); }

Surface of_group(const Generators& group) { return surface_of_map(map_of_group(group.x, group.y)); }

/// PSL(2,7) on the projective line over F₇, whose point at infinity is 7: z ↦ z + 1 and z ↦ −1/z.
Surface klein() { return of_group({{1, 2, 3, 4, 5, 6, 0, 7}, {7, 6, 3, 2, 5, 4, 1, 0}}); }

/// S₅: a cycle of all five and a transposition.
Surface bring() { return of_group({{1, 2, 3, 4, 0}, {1, 0, 2, 3, 4}}); }

/// PSL(2,8) on the projective line over F₈ = F₂[t]/(t³ + t + 1), where c₀ + c₁t + c₂t² is c₀ + 2c₁ + 4c₂, and 8 is the
/// point at infinity: z ↦ tz and z ↦ (tz + 1 + t²)/(z + t).
Surface fricke_macbeath() { return of_group({{0, 2, 4, 6, 3, 1, 7, 5, 8}, {7, 4, 8, 3, 1, 6, 5, 0, 2}}); }

/// Monomial matrices of fourth roots of unity, on the flexes: number 4j + k is the point with z_j = 0 and
/// z_{j+2}/z_{j+1} = e^{iπ/4} iᵏ, indices modulo 3.
Surface fermat_quartic() {
  return of_group({{0, 3, 2, 1, 8, 11, 10, 9, 5, 4, 7, 6}, {4, 7, 6, 5, 0, 3, 2, 1, 9, 8, 11, 10}});
}

/// One (4g + 2)-gon, opposite sides glued.
Surface wiman(std::uint32_t genus) {
  const std::uint32_t half = 2 * genus + 1;
  std::vector<Gluing> gluing;
  for (std::uint32_t k = 0; k < half; ++k) gluing.push_back({0, k, 0, k + half});
  return Surface::map({2 * half, half}, std::move(gluing));
}

/// The group of s and r with s^(2g+2) = r⁴ = (rs)² = 1 and r² in the centre, so rs = s⁻¹r⁻¹; dart 4i + j is sⁱrʲ. A
/// face is turned by s⁻¹, an edge by rs, and a vertex by their product, which is conjugate to r.
Surface accola_maclachlan(std::uint32_t genus) {
  const std::uint32_t n = 2 * genus + 2;
  const auto dart = [n](std::uint32_t i, std::uint32_t j) { return 4 * (i % n) + j % 4; };
  DartMap map;
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t j = 0; j < 4; ++j) {
      const bool odd = j % 2 != 0;
      map.rotation.push_back(odd ? dart(i + 1, j + 2) : dart(i + n - 1, j));
      map.edges.push_back(odd ? dart(i + 1, j + 1) : dart(i + n - 1, j + 3));
    }
  }
  return surface_of_map(map);
}

struct Named {
  NamedSurface facts;
  Surface (*single)();
  Surface (*of_genus)(std::uint32_t genus);
};

constexpr std::array<Named, 7> kNamed{{
    {{"bolza",
      "The surface of genus 2 with the most symmetries (48, the rotations) and the longest systole: the regular "
      "octagon.",
      "O. Bolza, On binary sextics with linear transformations into themselves, Amer. J. Math. 10 (1887); P. Schmutz, "
      "Riemann surfaces with shortest geodesic of maximal length, GAFA 3 (1993)"},
     bolza,
     nullptr},
    {{"klein",
      "Klein's quartic, genus 3, with as many symmetries as there can be (168, PSL(2,7)): 24 regular heptagons, {7, "
      "3}.",
      "F. Klein, Ueber die Transformation siebenter Ordnung der elliptischen Functionen, Math. Ann. 14 (1878)"},
     klein,
     nullptr},
    {{"fermat-quartic", "The quartic x^4 + y^4 + z^4 = 0, genus 3, with 96 symmetries: 12 regular octagons, {8, 3}.",
      "M. Conder, P. Dobcsanyi, Determination of all regular maps of small genus, J. Combin. Theory B 81 (2001): the "
      "dual of R3.2"},
     fermat_quartic,
     nullptr},
    {{"bring",
      "Bring's curve, genus 4, with the most symmetries there (120, the permutations of 5): 24 regular pentagons, "
      "{5, 4}.",
      "M. Weber, Kepler's small stellated dodecahedron as a Riemann surface, Pacific J. Math. 220 (2005)"},
     bring,
     nullptr},
    {{"fricke-macbeath",
      "The curve of genus 7 with as many symmetries as there can be (504, PSL(2,8)): 72 regular heptagons, {7, 3}.",
      "R. Fricke, Ueber eine einfache Gruppe von 504 Operationen, Math. Ann. 52 (1899); A. M. Macbeath, On a curve of "
      "genus 7, Proc. London Math. Soc. 15 (1965)"},
     fricke_macbeath,
     nullptr},
    {{"wiman-G",
      "Wiman's curve y^2 = x^(2g+1) - 1 of genus G, with a symmetry of the greatest order 4g + 2: the regular "
      "(4g + 2)-gon, opposite sides glued.",
      "A. Wiman, Ueber die hyperelliptischen Curven und diejenigen vom Geschlechte p = 3, welche eindeutige "
      "Transformationen in sich zulassen, Bihang Svenska Vet.-Akad. Handl. 21, no. 1 (1895)"},
     nullptr,
     wiman},
    {{"accola-maclachlan-G",
      "The curve y^2 = x^(2g+2) - 1 of genus G, with 8g + 8 symmetries, the most that every genus has: four regular "
      "(2g + 2)-gons, {2g + 2, 4}.",
      "R. Accola, On the number of automorphisms of a closed Riemann surface, Trans. AMS 131 (1968); C. Maclachlan, A "
      "bound for the number of automorphisms of a compact Riemann surface, J. London Math. Soc. 44 (1969)"},
     nullptr,
     accola_maclachlan},
}};

/// The facts alone.
const std::vector<NamedSurface>& facts() {
  static const std::vector<NamedSurface> result = [] {
    std::vector<NamedSurface> all;
    all.reserve(std::size(kNamed));
    for (const Named& named : kNamed) all.push_back(named.facts);
    return all;
  }();
  return result;
}

/// The genus of a member of a family, such as 7 in "wiman-7"; nullopt if it is no member.
std::optional<std::uint32_t> genus_in(const std::string& name, std::string_view family) {
  const std::string_view stem = family.substr(0, family.size() - 1);
  if (!name.starts_with(stem)) return std::nullopt;
  const char* const first = name.data() + stem.size();
  const char* const end = name.data() + name.size();
  std::uint32_t genus = 0;
  const auto [last, error] = std::from_chars(first, end, genus);
  if (error != std::errc() || last != end) return std::nullopt;
  return genus;
}

/// Of families.
constexpr std::uint32_t kLargestGenus = 1000;

Surface member(const Named& family, std::uint32_t genus) {
  if (genus >= 2 && genus <= kLargestGenus) return family.of_genus(genus);
  throw SurfaceError("the genus of " + std::string(family.facts.name) + " must be at least 2 and at most " +
                     std::to_string(kLargestGenus) + ", not " + std::to_string(genus));
}

/// "wiman" for "wiman-G".
std::string without_genus(std::string_view name) { return std::string(name.substr(0, name.rfind('-'))); }

std::string all_names() {
  std::string names;
  for (const Named& named : kNamed) names += (names.empty() ? "" : ", ") + std::string(named.facts.name);
  return names;
}

}  // namespace

DartMap map_of_group(const Permutation& x, const Permutation& y) {
  Permutation one(x.size());
  for (std::uint32_t i = 0; i < one.size(); ++i) one[i] = i;
  std::map<Permutation, std::uint32_t> number{{one, 0}};
  std::vector<Permutation> elements{one};
  const auto number_of = [&](const Permutation& element) {
    const auto [place, is_new] = number.emplace(element, static_cast<std::uint32_t>(elements.size()));
    if (is_new) elements.push_back(element);
    return place->second;
  };
  DartMap map;
  for (std::size_t g = 0; g < elements.size(); ++g) {
    map.rotation.push_back(number_of(composed(x, elements[g])));
    map.edges.push_back(number_of(composed(y, elements[g])));
  }
  return map;
}

Surface surface_of_map(const DartMap& map) {
  const auto& [rotation, edges] = map;
  if (rotation.empty()) throw MapError("rotation: no dart, expected at least one");
  require_permutation(rotation, "rotation");
  if (edges.size() != rotation.size()) {
    throw MapError("edges: " + std::to_string(edges.size()) + " darts, but rotation has " +
                   std::to_string(rotation.size()));
  }
  require_permutation(edges, "edges");
  for (std::uint32_t dart = 0; dart < edges.size(); ++dart) {
    if (edges[dart] == dart) throw MapError("edges: dart " + std::to_string(dart) + " is its own image");
    if (edges[edges[dart]] != dart) {
      throw MapError("edges: dart " + std::to_string(dart) + " goes to dart " + std::to_string(edges[dart]) +
                     ", which does not go back");
    }
  }
  const auto faces = cycles(rotation);
  const std::uint32_t p = common_length(faces, "rotation", "the number of sides of the face");
  const std::uint32_t q =
      common_length(cycles(composed(edges, rotation)), "edges, then rotation", "the number of corners at the vertex");
  std::vector<Gluing> side(rotation.size());
  for (std::uint32_t t = 0; t < faces.size(); ++t) {
    for (std::uint32_t k = 0; k < p; ++k) side[faces[t][k]] = {t, k, 0, 0};
  }
  std::vector<Gluing> gluing;
  for (std::uint32_t dart = 0; dart < edges.size(); ++dart) {
    const std::uint32_t other = edges[dart];
    if (other > dart) gluing.push_back({side[dart].tile, side[dart].side, side[other].tile, side[other].side});
  }
  return Surface::map({p, q}, std::move(gluing));
}

DartMap parse_map(const std::string& text) {
  try {
    return MapReader(text).read();
  } catch (const certify::JsonError& error) {
    throw MapError(error.what());
  }
}

std::span<const NamedSurface> named_surfaces() { return facts(); }

Surface named_surface(const std::string& name, std::optional<std::uint32_t> genus) {
  const auto with_genus = [&](Surface surface, const std::string& about) {
    if (genus && *genus != surface.genus()) {
      throw SurfaceError(name + " has genus " + std::to_string(surface.genus()) + ", not " + std::to_string(*genus));
    }
    surface.set_about(name + ": " + about);
    return surface;
  };
  for (const Named& named : kNamed) {
    const std::string family = named.of_genus == nullptr ? "" : without_genus(named.facts.name);
    if (named.of_genus != nullptr && name == family) {
      if (!genus) {
        throw SurfaceError(name + " is a family, expected a genus as well, as in " + name + "-7");
      }
      return named_surface(name + "-" + std::to_string(*genus));
    }
    std::optional<Surface> surface;
    if (named.single != nullptr && name == named.facts.name) surface = named.single();
    if (named.of_genus != nullptr) {
      if (const auto number = genus_in(name, named.facts.name)) surface = member(named, *number);
    }
    if (surface) return with_genus(*std::move(surface), std::string(named.facts.description));
  }
  for (const RegularMap& map : regular_maps()) {
    if (map.name == name) return with_genus(surface_of_map(darts(map)), description(map));
  }
  throw SurfaceError("there is no surface \"" + name + "\", expected " + all_names() +
                     ", with a genus for G, or a regular map such as R2.1");
}

std::vector<std::string> names_of_genus(std::uint32_t genus) {
  std::vector<std::string> result;
  for (const Named& named : kNamed) {
    if (named.of_genus != nullptr && genus >= 2 && genus <= kLargestGenus) {
      result.push_back(without_genus(named.facts.name) + "-" + std::to_string(genus));
    } else if (named.single != nullptr && named.single().genus() == genus) {
      result.emplace_back(named.facts.name);
    }
  }
  return result;
}

std::span<const RegularMap> regular_maps() { return kRegularMaps; }

std::uint32_t rotations(const RegularMap& map) {
  // n/p faces, n/2 edges, n/q vertices.
  const auto [p, q] = map.type;
  return (4 * map.genus - 4) * p * q / (p * q - 2 * p - 2 * q);
}

bool is_reflexible(const RegularMap& map) { return map.name.starts_with('R'); }

std::string description(const RegularMap& map) {
  std::ostringstream out;
  out << (is_reflexible(map) ? "A regular map {" : "A chiral map {") << map.type.p << ", " << map.type.q
      << "} of genus " << map.genus << " with " << rotations(map) << " rotations"
      << (is_reflexible(map) ? " and as many reflections." : " and no reflection.");
  return out.str();
}

DartMap darts(const RegularMap& map) {
  std::vector<RotationWord> relators = triangle_relators(map.type);
  std::istringstream words{std::string(map.relators)};
  for (std::string word; words >> word;) relators.push_back(parse_rotations(word));
  return CosetTable(relators, 100UL * rotations(map)).map();
}

DartMap standard_form(const DartMap& map) {
  const auto count = static_cast<std::uint32_t>(map.rotation.size());
  const Permutation* const steps[] = {&map.rotation, &map.edges};
  Permutation number(count, count);
  Permutation order{0};
  number[0] = 0;
  DartMap result;
  for (std::size_t i = 0; i < order.size(); ++i) {
    for (const Permutation* step : steps) {
      const std::uint32_t image = (*step)[order[i]];
      if (number[image] == count) {
        number[image] = static_cast<std::uint32_t>(order.size());
        order.push_back(image);
      }
      (step == &map.rotation ? result.rotation : result.edges).push_back(number[image]);
    }
  }
  return result;
}

DartMap mirror_image(const DartMap& map) {
  DartMap result{Permutation(map.rotation.size()), map.edges};
  for (std::uint32_t dart = 0; dart < map.rotation.size(); ++dart) result.rotation[map.rotation[dart]] = dart;
  return result;
}

DartMap dual(const DartMap& map) { return {composed(map.edges, mirror_image(map).rotation), map.edges}; }

DartMap map_of_surface(const Surface& surface) {
  DartMap result;
  for (std::uint32_t s = 0; s < surface.side_count(); ++s) {
    result.rotation.push_back(surface.next_side(SideId(s)).number());
    result.edges.push_back(surface.partner(SideId(s)).number());
  }
  return result;
}

}  // namespace epsnet
