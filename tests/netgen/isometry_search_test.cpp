#include <gtest/gtest.h>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "netgen/geodesics/geodesics.h"
#include "netgen/isometries/invariants.h"
#include "netgen/isometries/isometries.h"
#include "netgen/isometries/matches.h"
#include "netgen/surfaces/group.h"
#include "netgen/surfaces/surfaces.h"

/// What the search for isometries is made of.
namespace epsnet::isometry_search_test {
namespace {

/// The number of products of automorphisms of a map, by where they take side 0 and the one after it.
std::size_t order(const Surface& surface, const std::vector<MapAutomorphism>& automorphisms) {
  using Place = std::pair<SideId, SideId>;
  std::set<Place> known{{SideId(0), surface.next_side(SideId(0))}};
  std::vector<Place> found(known.begin(), known.end());
  for (std::size_t i = 0; i < found.size(); ++i) {
    for (const MapAutomorphism& f : automorphisms) {
      const Place image{f.image[found[i].first], f.image[found[i].second]};
      if (known.insert(image).second) found.push_back(image);
    }
  }
  return found.size();
}

TEST(MapAutomorphisms, AreThoseOfTheLiterature) {
  const std::map<std::string, std::size_t> expected{
      {"klein", 336}, {"bring", 240}, {"fermat-quartic", 192}, {"fricke-macbeath", 1008}, {"wiman-5", 44}};
  for (const auto& [name, count] : expected) {
    const Surface surface = named_surface(name);
    EXPECT_EQ(order(surface, map_automorphisms(surface)), count) << name;
  }
  // Those that keep the 4g-gon; as many others exchange its middle with its vertex.
  EXPECT_EQ(order(Surface::regular(5), map_automorphisms(Surface::regular(5))), 40U);
}

TEST(MapAutomorphisms, KeepWhatSidesAreTo) {
  const Surface surface = named_surface("bring");
  bool reverses = false;
  for (const MapAutomorphism& f : map_automorphisms(surface)) {
    reverses = reverses || !f.preserves_orientation;
    for (const SideId s : surface.side_ids()) {
      EXPECT_EQ(f.image[surface.partner(s)], surface.partner(f.image[s]));
      const SideId next = f.image[surface.next_side(s)];
      EXPECT_EQ(next, f.preserves_orientation ? surface.next_side(f.image[s]) : surface.previous_side(f.image[s]));
    }
  }
  EXPECT_TRUE(reverses);
}

TEST(MapAutomorphisms, OfTilesThatAreNotRegularAreNotAsked) {
  EXPECT_TRUE(map_automorphisms(random_octagon(1)).empty());
}

TEST(MapAutomorphisms, OfARandomCoverAreFew) {
  const Surface base = named_surface("bolza");
  const Surface surface = cover(base, random_sheets(base, 5, 1));
  // Those of a cover divide the number of flags.
  const std::size_t count = order(surface, map_automorphisms(surface));
  EXPECT_EQ(2 * surface.side_count() % count, 0U);
  EXPECT_LT(count, 2 * surface.side_count());
}

TEST(LinePlaces, AreTakenToEachOtherByTheGroup) {
  for (const std::string name : {"klein", "fermat-quartic", "wiman-4"}) {
    const Surface surface = named_surface(name);
    const certify::GeodesicsDocument spectrum = unproved::systole(surface);
    const Source source(surface, unproved::spectrum(surface, Length(spectrum.geodesics.front().length.upper * 1.0001)));
    const std::vector<Line> all =
        lines(source.tiles(), unproved::spectrum(surface, Length(spectrum.geodesics.front().length.upper * 1.0001)));
    const LinePlaces places(source.tiles(), all);
    std::vector<std::uint32_t> identity(all.size());
    std::iota(identity.begin(), identity.end(), 0U);
    for (const std::uint32_t i : identity) EXPECT_EQ(places.image(Motion<LiftedTiles::Number>(), i), i) << name;
    // An element of the group of the surface takes each line to itself, too.
    const auto element = motion(source.tiles().value(generator_words(surface).front()));
    for (const std::uint32_t i : identity) EXPECT_EQ(places.image(element, i), i) << name;
    for (const MapAutomorphism& f : map_automorphisms(surface)) {
      const Word x = image_of(f, source.pair.x.word);
      const Word y = image_of(f, source.pair.y_word);
      const Match match{image_of(surface, f, source.pair.x.tile), normalized(source.tiles().value(x)),
                        normalized(source.tiles().value(y)), x, y};
      const Motion<LiftedTiles::Number> moves = source.motion_of(match, source.tiles());
      std::set<std::uint32_t> images;
      for (const std::uint32_t i : identity) {
        const auto image = places.image(moves, i);
        ASSERT_TRUE(image) << name;
        images.insert(*image);
      }
      EXPECT_EQ(images.size(), all.size()) << name;
    }
  }
}

TEST(Homology, OfASurfaceHasTwiceItsGenusAsDimension) {
  for (const std::string name : {"bolza", "klein", "bring", "wiman-7", "fricke-macbeath"}) {
    const Surface surface = named_surface(name);
    const Homology homology(surface);
    EXPECT_EQ(homology.dimension(), 2 * surface.genus()) << name;
    const std::vector<Word> words = generator_words(surface);
    const HomologyMap identity(homology, words, words);
    EXPECT_EQ(identity.trace(), 2 * static_cast<std::int64_t>(surface.genus())) << name;
  }
}

TEST(Homology, OfAPathAroundAVertexIsNothing) {
  const Surface surface = named_surface("klein");
  const Homology homology(surface);
  const ById<TileId, Word> paths = polygon_paths(surface);
  for (const SideId s : surface.side_ids()) {
    Word word = paths[surface.tile_of_side(s)];
    const Word turn = surface.corner_cycle(s);
    const Word back = reversed(surface, word);
    word.insert(word.end(), turn.begin(), turn.end());
    word.insert(word.end(), back.begin(), back.end());
    EXPECT_EQ(homology.class_of(word), Homology::Vector(homology.dimension()));
  }
}

TEST(HomologyMap, OfLargeNumbersIsReduced) {
  const Surface surface = named_surface("fricke-macbeath");
  const Homology homology(surface);
  const IsometryGroup group = isometries(surface);
  const std::vector<Word> words = generator_words(surface);
  const HomologyMap f(homology, words, group.isometry(1).images);
  Homology::Vector vector(homology.dimension(), Homology::kPrime - 1);
  const Homology::Vector start = vector;
  for (std::uint32_t i = 0; i < group.order(1); ++i) {
    vector = f(vector);
    for (const std::uint64_t x : vector) EXPECT_LT(x, Homology::kPrime);
  }
  EXPECT_EQ(vector, start);
}

}  // namespace
}  // namespace epsnet::isometry_search_test
