#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <numbers>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "certify/check.h"
#include "certify/file/file.h"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);

namespace {

using namespace epsnet::certify;

void require(bool condition) {
  if (!condition) std::abort();
}

std::string to_text(const NetDocument& document) {
  std::ostringstream out;
  write_file(document, out);
  return out.str();
}

/// The random choices of one mutation.
class Chooser {
 public:
  explicit Chooser(unsigned seed) : engine_(seed) {}

  std::uint32_t below(std::size_t bound) {
    return static_cast<std::uint32_t>(engine_() % std::max<std::size_t>(bound, 1));
  }

  template <class Element>
  Element& of(std::vector<Element>& elements) {
    return elements[below(elements.size())];
  }

 private:
  std::mt19937 engine_;
};

/// Moves a number to a neighbouring double, by a small or a large amount, or changes its sign.
void mutate_number(double& x, Chooser& choose) {
  switch (choose.below(5)) {
    case 0:
      x = std::nextafter(x, 2);
      break;
    case 1:
      x = std::nextafter(x, -2);
      break;
    case 2:
      x += std::ldexp(1, -1 - static_cast<int>(choose.below(60)));
      break;
    case 3:
      x -= std::ldexp(1, -1 - static_cast<int>(choose.below(60)));
      break;
    default:
      x = -x;
  }
}

void mutate_number(mpq_class& x, Chooser& choose) {
  const mpq_class step(1, mpz_class(1) << choose.below(80));
  switch (choose.below(4)) {
    case 0:
      x += step;
      break;
    case 1:
      x -= step;
      break;
    case 2:
      x = -x;
      break;
    default:
      x = mpq_class(mpz_class(x.get_num() / 3), x.get_den());
      x.canonicalize();
  }
}

template <class Point>
void mutate_point(Point& point, Chooser& choose) {
  mutate_number(choose.below(2) == 0 ? point.x : point.y, choose);
}

void mutate_word(std::vector<std::uint32_t>& word, std::size_t sides, Chooser& choose) {
  const auto at = word.begin() + choose.below(word.size() + 1);
  if (at == word.end() || choose.below(3) == 0) {
    word.insert(at, choose.below(sides));
  } else if (choose.below(2) == 0) {
    word.erase(at);
  } else {
    *at = choose.below(sides);
  }
}

void mutate_triangle(NetDocument::Triangle& triangle, const NetDocument& document, Chooser& choose) {
  const std::uint32_t i = choose.below(3);
  switch (choose.below(4)) {
    case 0:
      triangle.vertex[i] = choose.below(document.vertices.size());
      break;
    case 1:
      triangle.opposite[i] = choose.below(3 * document.triangles.size());
      break;
    case 2:
      triangle.label[i % 2] = choose.below(document.labels.size() + 1);
      break;
    default:
      std::swap(triangle.vertex[i], triangle.vertex[(i + 1) % 3]);
  }
}

/// Pairs the sides of a surface differently.
void mutate_gluing(SurfaceDocument& surface, Chooser& choose) {
  SurfaceDocument::Gluing& one = choose.of(surface.gluing);
  SurfaceDocument::Gluing& other = choose.of(surface.gluing);
  std::swap(one.other_tile, other.other_tile);
  std::swap(one.other_side, other.other_side);
}

/// Removes or doubles a collar, or changes one of its members. A net without collars gets one, and so becomes a pseudo
/// net.
void mutate_collars(NetDocument& document, std::size_t sides, Chooser& choose) {
  const auto any_vertex = [&] { return choose.below(document.vertices.size()); };
  const auto any_triangle = [&] { return choose.below(document.triangles.size()); };
  if (!document.collars) document.collars.emplace();
  std::vector<NetDocument::Collar>& collars = *document.collars;
  if (collars.empty()) {
    collars.push_back({{}, {0, 1}, {any_vertex(), any_vertex()}, {any_triangle(), any_triangle()}});
    return;
  }
  const std::uint32_t c = choose.below(collars.size());
  NetDocument::Collar& collar = collars[c];
  const std::uint32_t i = choose.below(2);
  switch (choose.below(7)) {
    case 0:
      collars.erase(collars.begin() + c);
      break;
    case 1:
      collars.push_back(NetDocument::Collar(collar));
      break;
    case 2:
      collar.vertices[i] = any_vertex();
      break;
    case 3:
      collar.triangles[i] = any_triangle();
      break;
    case 4:
      mutate_word(collar.core, sides, choose);
      break;
    case 5:
      mutate_number(collar.length[i], choose);
      break;
    default:  // Swaps the two sides, which gives the same collar only if the word of the core fits there as well.
      std::swap(collar.vertices[0], collar.vertices[1]);
      std::swap(collar.triangles[0], collar.triangles[1]);
  }
}

/// Changes a number of a field, its polynomial or its interval by little.
void mutate_field(SurfaceDocument::Field& field, Chooser& choose) {
  std::vector<mpz_class>* const numbers[] = {&choose.of(choose.of(field.polygons))[choose.below(3)],
                                             &choose.of(field.crossings)[choose.below(4)], &field.polynomial};
  const unsigned which = choose.below(4);
  if (which == 3) {
    field.root[choose.below(2)] += mpq_class(1, 1 + choose.below(8)) * (choose.below(2) == 0 ? 1 : -1);
  } else {
    choose.of(*numbers[which]) += static_cast<int>(choose.below(3)) - 1;
  }
}

/// Makes one change after which the document is still well-formed, though usually not a net.
void mutate(NetDocument& document, Chooser& choose) {
  const bool regular = document.surface.regular_genus != 0;
  std::size_t sides = std::size_t{4} * document.surface.regular_genus;
  for (const SurfaceDocument::Tile& tile : document.surface.tiles) sides += tile.size();
  for (const auto& polygon : document.surface.field.polygons) sides += polygon.size();
  // Half of the changes to a pseudo net concern its collars.
  switch (choose.below(document.collars ? 20 : 10)) {
    case 0:
      mutate_point(choose.of(document.vertices), choose);
      break;
    case 1:
      mutate_triangle(choose.of(document.triangles), document, choose);
      break;
    case 2:
      if (regular) {
        document.surface.regular_genus = 2 + choose.below(4);
      } else if (!document.surface.field.polynomial.empty()) {
        mutate_field(document.surface.field, choose);
      } else if (!document.surface.tiles.empty()) {
        mutate_point(choose.of(choose.of(document.surface.tiles)), choose);
      }
      break;
    case 3:
      mutate_point(choose.of(document.charts).centre, choose);
      break;
    case 4:
      if (!document.labels.empty()) mutate_word(choose.of(document.labels).word, sides, choose);
      break;
    case 5:
      document.epsilon = std::to_string(1 + choose.below(1000)) + "e-" + std::to_string(1 + choose.below(3));
      break;
    case 6:
      if (!regular) mutate_gluing(document.surface, choose);
      break;
    case 7:
      std::swap(choose.of(document.triangles), choose.of(document.triangles));
      break;
    case 8:
      std::swap(choose.of(document.vertices), choose.of(document.vertices));
      break;
    default:
      mutate_collars(document, sides, choose);
  }
}

/// Checks facts about every ε-net and pseudo ε-net in another way, without the geometry of single triangles.
void require_plausible(const NetDocument& document, const Certificate& certificate) {
  const std::size_t vertices = document.vertices.size();
  const std::size_t triangles = document.triangles.size();
  require(certificate.message.empty() && certificate.rules.size() == (document.collars ? 9U : 7U) &&
          certificate.enclosures.has_value());
  require(certificate.counts.vertices == vertices && certificate.counts.triangles == triangles);
  const auto genus = static_cast<double>(certificate.counts.genus);
  require(genus >= 2 && triangles == 2 * vertices + 4 * certificate.counts.genus - 4);
  // The cores of collars are disjoint simple closed geodesics.
  const std::size_t collars = document.collars ? document.collars->size() : 0;
  require(certificate.counts.collars.value_or(0) == collars && collars <= 3 * certificate.counts.genus - 3);
  // Disks of radius ε around the V vertices cover everything except the points within d of one of the C cores. For a
  // core of length l, sinh(l/2) cosh d = sinh(ε/2), so these points have the area 2l sinh d <= 4 sinh(ε/2). Hence
  // V · 4π sinh²(ε/2) >= 4π (g − 1) − C · 4 sinh(ε/2); the factor leaves room for rounding.
  const double sinh_half = std::sinh(certificate.enclosures->epsilon.upper / 2);
  require(static_cast<double>(vertices) * sinh_half * sinh_half >=
          (genus - 1) * (1 - 1e-9) - static_cast<double>(collars) * sinh_half / std::numbers::pi);
}

}  // namespace

/// Any bytes lead to a verdict, the same for any number of threads, and nothing implausible is verified.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  NetDocument document;
  try {
    document = parse_file<NetDocument>({reinterpret_cast<const char*>(data), size}, "input");
  } catch (const MalformedError&) {
    return 0;
  }
  CheckOptions options{.threads = 1, .max_precision = 512, .progress = {}};
  const Certificate certificate = check(document, options);
  if (certificate.verdict == Verdict::verified) require_plausible(document, certificate);
  options.threads = 3;
  const Certificate again = check(document, options);
  require(again.verdict == certificate.verdict && again.message == certificate.message);
  return 0;
}

/// Changes single numbers, indices, words and pairings of a net file. For bytes that are not a net file, and sometimes
/// for others, calls libFuzzer's own mutator.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size,
                                               unsigned int seed) {
  Chooser choose(seed);
  if (choose.below(50) == 0) return LLVMFuzzerMutate(data, size, max_size);
  try {
    NetDocument document = parse_file<NetDocument>({reinterpret_cast<const char*>(data), size}, "input");
    if (document.vertices.empty() || document.triangles.empty()) return LLVMFuzzerMutate(data, size, max_size);
    for (unsigned changes = 1 + choose.below(2); changes > 0; --changes) mutate(document, choose);
    const std::string text = to_text(document);
    if (text.size() > max_size) return LLVMFuzzerMutate(data, size, max_size);
    std::copy(text.begin(), text.end(), data);
    return text.size();
  } catch (const MalformedError&) {
    return LLVMFuzzerMutate(data, size, max_size);
  }
}
