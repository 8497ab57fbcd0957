#include "certify/file/compact.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <new>
#include <string>

#define XXH_INLINE_ALL
#include <xxhash.h>

#include "certify/file/file.h"

namespace epsnet::certify {

CompactChecksum::CompactChecksum() : state_(XXH64_createState()) {
  if (state_ == nullptr) throw std::bad_alloc();
  XXH64_reset(static_cast<XXH64_state_t*>(state_), 0);
}
CompactChecksum::~CompactChecksum() { XXH64_freeState(static_cast<XXH64_state_t*>(state_)); }
void CompactChecksum::add(std::string_view bytes) {
  XXH64_update(static_cast<XXH64_state_t*>(state_), bytes.data(), bytes.size());
}
std::uint64_t CompactChecksum::value() const { return XXH64_digest(static_cast<const XXH64_state_t*>(state_)); }

namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
constexpr std::size_t kChecksumBytes = 8;
constexpr const char* kDamaged = "the file was damaged, or is not complete: its checksum is another";

[[noreturn]] void fail(const std::string& place, const std::string& problem, const std::string& expected = {}) {
  throw MalformedError(ErrorParts{.place = place, .problem = problem, .expected = expected});
}
[[noreturn]] void fail(const char* place, std::size_t row, const std::string& problem,
                       const std::string& expected = {}) {
  fail(std::string(place) + "[" + std::to_string(row) + "]", problem, expected);
}

/// The little-endian number in some bytes.
template <std::size_t kWidth>
std::uint64_t number(const char* bytes) {
  std::uint64_t result = 0;
  for (std::size_t i = 0; i < kWidth; ++i) {
    result |= std::uint64_t{static_cast<unsigned char>(bytes[i])} << (8 * i);
  }
  return result;
}

/// The file from front to back, up to the checksum at its end.
class Parts {
 public:
  explicit Parts(ByteStream& bytes) : bytes_(bytes) {}

  /// Says that so many bytes are to come next, behind those that are expected already.
  void expect(std::uint64_t size, const char* place) {
    const std::uint64_t there = left() - expected_;
    if (size > there) {
      fail(place, "has " + std::to_string(size) + " bytes, of which " + std::to_string(there) + " are there");
    }
    expected_ += size;
  }
  std::string_view take(std::size_t size) {
    const std::string_view part = bytes_.ahead(size).substr(0, size);
    bytes_.skip(size);
    expected_ -= size;
    sum_.add(part);
    return part;
  }
  /// use(number) for numbers of so many bytes each.
  template <std::size_t kWidth, class Use>
  void take_numbers(std::size_t count, const Use& use) {
    while (count > 0) {
      const std::size_t size = kWidth * std::min(count, bytes_.ahead(kWidth).size() / kWidth);
      const std::string_view part = take(size);
      for (std::size_t i = 0; i < size; i += kWidth) use(number<kWidth>(part.data() + i));
      count -= size / kWidth;
    }
  }
  template <class Use>
  void take_indices(std::size_t count, std::size_t width, const Use& use) {
    const auto use_index = [&](std::uint64_t index) { use(static_cast<std::uint32_t>(index)); };
    if (width == 1) take_numbers<1>(count, use_index);
    if (width == 2) take_numbers<2>(count, use_index);
    if (width == 4) take_numbers<4>(count, use_index);
  }
  std::uint32_t word(const char* place) {
    expect(4, place);
    return static_cast<std::uint32_t>(number<4>(take(4).data()));
  }
  [[nodiscard]] std::uint64_t left() const { return bytes_.left() - kChecksumBytes; }
  /// Whether the checksum at the end is that of the file. Takes all that is left before it.
  [[nodiscard]] bool is_intact() {
    while (left() > 0) take(std::min<std::uint64_t>(left(), bytes_.ahead(kChecksumBytes + 1).size() - kChecksumBytes));
    return sum_.value() == number<kChecksumBytes>(bytes_.ahead(kChecksumBytes).data());
  }

 private:
  ByteStream& bytes_;
  std::uint64_t expected_ = 0;
  CompactChecksum sum_;
};

std::size_t width_of(std::uint32_t written, const char* place) {
  if (written != 1 && written != 2 && written != 4) {
    fail(place, "a width of " + std::to_string(written) + " bytes", "1, 2 or 4");
  }
  return written;
}

void read_vertices(Parts& parts, std::uint32_t count, std::size_t chart_width, NetDocument& document) {
  for (const std::size_t width : {std::size_t{8}, std::size_t{8}, chart_width}) parts.expect(count * width, "vertices");
  std::vector<NetDocument::Vertex>& vertices = document.vertices;
  vertices.resize(count);
  auto v = vertices.begin();
  parts.take_numbers<8>(count, [&](std::uint64_t x) { (v++)->x = std::bit_cast<double>(x); });
  v = vertices.begin();
  parts.take_numbers<8>(count, [&](std::uint64_t y) { (v++)->y = std::bit_cast<double>(y); });
  v = vertices.begin();
  parts.take_indices(count, chart_width, [&](std::uint32_t chart) { (v++)->chart = chart; });
}

/// A dart, with the place of its triangle and its number there, so that going on divides nothing.
struct Dart {
  std::size_t number = 0;
  std::size_t triangle = 0;
  std::size_t edge = 0;
  void operator++() {
    ++number;
    if (++edge < 3) return;
    edge = 0;
    ++triangle;
  }
};

void read_triangles(Parts& parts, std::uint32_t count, std::size_t label_width, NetDocument& document) {
  const std::size_t darts = std::size_t{3} * count;
  if (darts % 2 != 0) fail("triangles", "an odd number of darts, which cannot be paired");
  const std::size_t corners = 2 * std::size_t{count};
  const std::size_t bytes_of_bits = (corners + 7) / 8;
  parts.expect(4 * darts, "triangles");
  parts.expect(2 * darts, "opposites");
  parts.expect(bytes_of_bits, "labelled corners");
  std::vector<NetDocument::Triangle>& triangles = document.triangles;
  triangles.resize(count, {.vertex = {}, .opposite = {kNone, kNone, kNone}, .label = {}});
  Dart corner;
  parts.take_numbers<4>(darts, [&](std::uint64_t vertex) {
    triangles[corner.triangle].vertex[corner.edge] = static_cast<std::uint32_t>(vertex);
    ++corner;
  });
  Dart dart;
  std::size_t pair = 0;
  parts.take_numbers<4>(darts / 2, [&](std::uint64_t other) {
    // Of the darts not yet paired each one names its partner, which comes later.
    while (triangles[dart.triangle].opposite[dart.edge] != kNone) ++dart;
    if (other <= dart.number || other >= darts || triangles[other / 3].opposite[other % 3] != kNone) {
      fail("opposites", pair, "the opposite of dart " + std::to_string(dart.number) + " is " + std::to_string(other),
           "a later dart that has none");
    }
    triangles[dart.triangle].opposite[dart.edge] = static_cast<std::uint32_t>(other);
    triangles[other / 3].opposite[other % 3] = static_cast<std::uint32_t>(dart.number);
    ++pair;
  });
  const std::string labelled(parts.take(bytes_of_bits));
  std::size_t labels = 0;
  for (const char byte : labelled) labels += static_cast<std::size_t>(std::popcount(static_cast<unsigned char>(byte)));
  const std::size_t beyond = 8 * labelled.size() - corners;
  if (beyond > 0 && (static_cast<unsigned char>(labelled.back()) >> (8 - beyond)) != 0) {
    fail("labelled corners", "a bit beyond the last corner is set");
  }
  parts.expect(labels * label_width, "labels of corners");
  std::size_t next = 0;
  std::size_t read = 0;
  parts.take_indices(labels, label_width, [&](std::uint32_t label) {
    while (((static_cast<unsigned char>(labelled[next / 8]) >> (next % 8)) & 1U) == 0) {
      next += next % 8 == 0 && labelled[next / 8] == 0 ? 8 : 1;
    }
    if (label == 0) fail("labels of corners", read, "0", "another, as the corner is said to have one");
    triangles[next / 2].label[next % 2] = label;
    ++next;
    ++read;
  });
}

/// The file up to its checksum.
NetDocument read_parts(Parts& parts, const ReadHead& read_head) {
  parts.expect(kCompactMagic.size(), "header");
  parts.take(kCompactMagic.size());
  const std::uint32_t version = parts.word("header");
  if (version != 1) {
    fail("header", "version " + std::to_string(version) + " is not a version this program reads", "1");
  }
  const std::uint32_t head_size = parts.word("header");
  const std::uint32_t vertices = parts.word("header");
  const std::uint32_t triangles = parts.word("header");
  const std::size_t chart_width = width_of(parts.word("header"), "header: charts of vertices");
  const std::size_t label_width = width_of(parts.word("header"), "header: labels of corners");
  if (triangles > (1U << 30)) fail("header", "more than the limit of 1073741824 triangles");
  parts.expect(head_size, "head");
  NetDocument document = read_head(parts.take(head_size));
  if (!document.vertices.empty() || !document.triangles.empty()) {
    fail("head", "vertices or triangles in the JSON text", "none");
  }
  read_vertices(parts, vertices, chart_width, document);
  read_triangles(parts, triangles, label_width, document);
  if (parts.left() != 0) fail("checksum", std::to_string(parts.left()) + " bytes too many before it");
  return document;
}

}  // namespace

NetDocument parse_compact(ByteStream& bytes, const ReadHead& read_head) {
  if (bytes.left() < kCompactMagic.size() + kChecksumBytes) fail("checksum", "the file ends before it");
  Parts parts(bytes);
  try {
    NetDocument document = read_parts(parts, read_head);
    if (!parts.is_intact()) fail("checksum", kDamaged);
    return document;
  } catch (const MalformedError&) {
    // Whatever else the bytes say: if they were damaged, that is what is wrong.
    if (!parts.is_intact()) fail("checksum", kDamaged);
    throw;
  }
}

}  // namespace epsnet::certify
