#include <cstdint>
#include <random>
#include <utility>

#include "certify/check.h"
#include "netgen/geodesics/geodesics.h"
#include "netgen/isometries/isometries.h"
#include "netgen/isometries/matches.h"
#include "netgen/prove/certified.h"
#include "netgen/surfaces/group.h"

namespace epsnet {
namespace {

using certify::IsometriesDocument;

/// Translates words of a surface into images, by the images of the side pairings of its fundamental polygon.
class Substitution {
 public:
  /// The images are words of `target`.
  Substitution(const Surface& surface, const Surface& target) : target_(target), number_(surface.side_count()) {
    const PolygonSides polygon = polygon_sides(surface);
    std::int64_t count = 0;
    for (std::uint32_t k = 0; k < polygon.side.size(); ++k) {
      if (k > polygon.partner[k]) continue;
      // The pairing of a side crosses its partner.
      number_[polygon.side[polygon.partner[k]]] = ++count;
      number_[polygon.side[k]] = -count;
    }
  }

  /// The image of a word from tile 0 to itself.
  [[nodiscard]] Word operator()(const Word& word, const std::vector<Word>& images) const {
    Word result;
    for (const SideId s : word) {
      const std::int64_t number = number_[s];
      if (number == 0) continue;
      const Word& image = images[static_cast<std::size_t>(std::abs(number)) - 1];
      result = concatenated(target_, std::move(result), number > 0 ? image : reversed(target_, image));
    }
    return result;
  }

 private:
  const Surface& target_;
  ById<SideId, std::int64_t> number_;  ///< By letter: of a pairing, from 1 on; negative for its inverse; 0 for none.
};

/// Two elements of which the axes cross, by words from tile 0 to itself: generators, or what turns around pants.
std::vector<Word> crossing_pair(const Surface& surface) {
  std::vector<Word> generators;
  for (const FundamentalPolygon::Side& side : fundamental_polygon(surface).sides) generators.push_back(side.word);
  for (std::size_t j = 1; j < generators.size(); ++j) {
    for (std::size_t i = 0; i < j; ++i) {
      const Word& x = generators[i];
      const Word& y = generators[j];
      const Word y_back = reversed(surface, y);
      for (const auto& [first, second] : {std::pair{x, y},
                                          {concatenated(surface, x, y_back), concatenated(surface, y_back, x)},
                                          {concatenated(surface, x, y), concatenated(surface, y, x)}}) {
        if (axes_cross(surface, first, second).value_or(false)) return {first, second};
      }
    }
  }
  throw LimitError("no two elements were found of which the axes cross");
}

/// The values, by side that is less than its partner, of a function of words that is determined by random numbers: what
/// flows along edges, as much into a vertex as out of it.
std::vector<std::uint32_t> random_cocycle(const Surface& surface) {
  std::mt19937 random;
  ById<SideId, std::uint32_t> flow(surface.side_count());
  for (const SideId s : flow.ids()) {
    const SideId partner = surface.partner(s);
    flow[s] = s < partner ? static_cast<std::uint32_t>(random()) : 0 - flow[partner];
  }
  // Along a tree of edges to the vertex of side 0, by sides that leave vertices; a partner leaves the other end.
  std::vector<bool> reached(surface.vertex_class_count());
  reached[surface.vertex_class(SideId(0))] = true;
  std::vector<SideId> sides = surface.corner_cycle(SideId(0));
  std::vector<SideId> to_root;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const SideId back = surface.partner(sides[i]);
    if (reached[surface.vertex_class(back)]) continue;
    reached[surface.vertex_class(back)] = true;
    to_root.push_back(back);
    const Word more = surface.corner_cycle(back);
    sides.insert(sides.end(), more.begin(), more.end());
  }
  for (auto side = to_root.rbegin(); side != to_root.rend(); ++side) {
    std::uint32_t excess = 0;
    for (const SideId s : surface.corner_cycle(*side)) excess += flow[s];
    flow[*side] -= excess;
    flow[surface.partner(*side)] += excess;
  }
  std::vector<std::uint32_t> result;
  for (const SideId s : flow.ids()) {
    if (s < surface.partner(s)) result.push_back(flow[s]);
  }
  return result;
}

std::vector<std::vector<std::uint32_t>> letters_of_all(const std::vector<Word>& words) {
  std::vector<std::vector<std::uint32_t>> result;
  result.reserve(words.size());
  for (const Word& word : words) result.push_back(letters_of(word));
  return result;
}

/// The images of a pair of elements, and of the crossing of each side less than its partner, which is a generator: the
/// paths between the letters cross no sides of the polygon.
std::vector<std::vector<std::uint32_t>> images_of(const Surface& surface, const Substitution& image_of,
                                                  const std::vector<Word>& pair, const SurfaceIsometry& f) {
  std::vector<Word> result;
  result.reserve(pair.size() + surface.side_count() / 2);
  for (const Word& word : pair) result.push_back(image_of(word, f.images));
  for (const SideId s : surface.side_ids()) {
    if (s < surface.partner(s)) result.push_back(image_of({s}, f.images));
  }
  return letters_of_all(result);
}

}  // namespace

certify::IsometryRows isometry_rows(const Surface& surface, const std::vector<SurfaceIsometry>& isometries) {
  certify::IsometryRows result;
  result.paths = letters_of_all(polygon_paths(surface));
  const std::vector<Word> pair = crossing_pair(surface);
  result.pair = letters_of_all(pair);
  const Substitution image_of(surface, surface);
  for (const SurfaceIsometry& f : isometries) {
    result.isometries.push_back({f.preserves_orientation, images_of(surface, image_of, pair, f)});
  }
  return result;
}

namespace {

/// But for the spectrum.
IsometriesDocument document_of(const Surface& surface, const IsometryGroup& group) {
  IsometriesDocument result;
  result.order = static_cast<std::uint32_t>(group.size());
  std::vector<SurfaceIsometry> generators;
  for (const std::uint32_t g : group.generators()) generators.push_back(group.isometry(g));
  static_cast<certify::IsometryRows&>(result) = isometry_rows(surface, generators);
  result.cocycle = random_cocycle(surface);
  return result;
}

}  // namespace

certify::ComparisonDocument isometry_document(const Surface& first, const Surface& second,
                                              const SurfaceIsometry& isometry, certify::NetDocument net,
                                              certify::NetDocument other_net) {
  certify::ComparisonDocument result;
  result.relation = certify::ComparisonDocument::Relation::isometric;
  result.net = std::move(net);
  result.other.net = std::move(other_net);
  const std::vector<Word> pair = crossing_pair(first);
  result.isometry = {.preserves_orientation = isometry.preserves_orientation,
                     .paths = letters_of_all(polygon_paths(first)),
                     .pair = letters_of_all(pair),
                     .images = images_of(first, Substitution(first, second), pair, isometry)};
  return result;
}

Certified<IsometriesDocument> certified_isometries(const Surface& surface, const IsometryGroup& group,
                                                   const IsometryOptions& options) {
  // Only that there are no others depends on how many closed geodesics there are, so a short list may become longer:
  // that of a cover often does not join all parts of the surface. On thin surfaces no list joins them, so what longer
  // ones take is limited: some two seconds, together.
  constexpr const char* kNoOthers = "most";
  constexpr int kMostSteps = 8;
  constexpr double kStep = 0.5;
  constexpr long kFewBits = 256;
  constexpr long kMostBits = 1024;
  constexpr std::uint64_t kMostWork = 2'000'000'000;
  IsometriesDocument document = document_of(surface, group);
  auto& list = static_cast<certify::GeodesicsDocument&>(document);
  list = group.geodesics();
  certify::CheckOptions check = own_check(options.threads, options.progress);
  check.max_precision = kFewBits;
  certify::Certificate certificate = certify::check(document, check);
  if (certificate.verdict == certify::Verdict::undecided && certificate.rule != kNoOthers) {
    check.max_precision = kMostBits;
    certificate = certify::check(document, check);
  }
  std::uint64_t work = 0;
  for (int step = 0; step < kMostSteps && certificate.rule == kNoOthers && work < kMostWork; ++step) {
    GeodesicsOptions geodesics;
    geodesics.threads = options.threads;
    geodesics.progress = options.progress;
    const std::size_t size = list.geodesics.size();
    list = unproved::spectrum(surface, Length(static_cast<double>(Length(list.up_to).value()) + kStep), geodesics);
    if (list.geodesics.size() == size) continue;
    check.max_work = kMostWork - work;
    certify::Certificate longer = certify::check(document, check);
    work += longer.counts.work;
    // A list that takes all the work that is left says less than the one before.
    if (longer.verdict == certify::Verdict::verified || work < kMostWork) certificate = std::move(longer);
  }
  if (certificate.verdict != certify::Verdict::verified) throw NotCertifiedError(std::move(certificate));
  return {std::move(document), std::move(certificate)};
}

}  // namespace epsnet
