#include "certify/file/compact.h"

#include <bit>
#include <cstring>
#include <limits>
#include <new>
#include <string>

#define XXH_INLINE_ALL
#include <xxhash.h>

#include "certify/file/reader.h"

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

[[noreturn]] void fail(const char* place, const std::string& problem) {
  throw MalformedError(std::string(place) + ": " + problem);
}
[[noreturn]] void fail(const char* place, std::size_t row, const std::string& problem) {
  fail((std::string(place) + "[" + std::to_string(row) + "]").c_str(), problem);
}

/// The little-endian number in some bytes.
std::uint64_t number(std::string_view bytes) {
  std::uint64_t result = 0;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    result |= std::uint64_t{static_cast<unsigned char>(bytes[i])} << (8 * i);
  }
  return result;
}

/// A part of the file, `width` bytes for each element.
class Array {
 public:
  Array(std::string_view bytes, std::size_t width) : bytes_(bytes), width_(width) {}

  [[nodiscard]] std::uint32_t index(std::size_t i) const { return static_cast<std::uint32_t>(at(i)); }
  [[nodiscard]] double binary64(std::size_t i) const { return std::bit_cast<double>(at(i)); }

 private:
  [[nodiscard]] std::uint64_t at(std::size_t i) const { return number(bytes_.substr(i * width_, width_)); }

  std::string_view bytes_;
  std::size_t width_;
};

/// The file from front to back.
class Parts {
 public:
  explicit Parts(std::string_view bytes) : rest_(bytes) {}

  std::string_view take(std::uint64_t size, const char* place) {
    if (size > rest_.size()) {
      fail(place, "has " + std::to_string(size) + " bytes, of which " + std::to_string(rest_.size()) + " are there");
    }
    const std::string_view part = rest_.substr(0, size);
    rest_.remove_prefix(size);
    return part;
  }
  std::uint32_t word(const char* place) { return static_cast<std::uint32_t>(number(take(4, place))); }
  Array array(std::uint64_t count, std::size_t width, const char* place) {
    return {take(count * width, place), width};  // Of at most 2³² and 8.
  }
  [[nodiscard]] std::size_t left() const { return rest_.size(); }

 private:
  std::string_view rest_;
};

std::size_t width_of(std::uint32_t written, const char* place) {
  if (written != 1 && written != 2 && written != 4) {
    fail(place, "a width of " + std::to_string(written) + " bytes, expected 1, 2 or 4");
  }
  return written;
}

void check_sum(std::string_view bytes) {
  if (bytes.size() < kCompactMagic.size() + 8) fail("checksum", "the file ends before it");
  CompactChecksum sum;
  sum.add(bytes.substr(0, bytes.size() - 8));
  if (sum.value() != number(bytes.substr(bytes.size() - 8))) {
    fail("checksum", "the file was damaged, or is not complete: its checksum is another");
  }
}

void read_vertices(Parts& parts, std::uint32_t count, std::size_t chart_width, NetDocument& document) {
  const Array x = parts.array(count, 8, "vertices");
  const Array y = parts.array(count, 8, "vertices");
  const Array chart = parts.array(count, chart_width, "vertices");
  document.vertices.resize(count);
  for (std::size_t v = 0; v < count; ++v) document.vertices[v] = {x.binary64(v), y.binary64(v), chart.index(v)};
}

void read_triangles(Parts& parts, std::uint32_t count, std::size_t label_width, NetDocument& document) {
  const std::size_t darts = std::size_t{3} * count;
  if (darts % 2 != 0) fail("triangles", "an odd number of darts, which cannot be paired");
  const Array vertex = parts.array(darts, 4, "triangles");
  const Array opposite = parts.array(darts / 2, 4, "opposites");
  const std::string_view labelled = parts.take((2 * std::size_t{count} + 7) / 8, "labelled corners");
  document.triangles.resize(count);
  for (NetDocument::Triangle& triangle : document.triangles) triangle.opposite = {kNone, kNone, kNone};
  const auto opposite_of = [&](std::size_t dart) -> std::uint32_t& {
    return document.triangles[dart / 3].opposite[dart % 3];
  };
  std::size_t pair = 0;
  std::size_t labels = 0;
  for (std::size_t dart = 0; dart < darts; ++dart) {
    document.triangles[dart / 3].vertex[dart % 3] = vertex.index(dart);
    if (opposite_of(dart) != kNone) continue;
    // Of the darts not yet paired each one names its partner, which comes later.
    const std::uint32_t other = opposite.index(pair);
    if (other <= dart || other >= darts || opposite_of(other) != kNone) {
      fail("opposites", pair,
           "the opposite of dart " + std::to_string(dart) + " is " + std::to_string(other) +
               ", expected a later dart that has none");
    }
    opposite_of(dart) = other;
    opposite_of(other) = static_cast<std::uint32_t>(dart);
    ++pair;
  }
  const auto is_labelled = [&](std::size_t corner) {
    return ((static_cast<unsigned char>(labelled[corner / 8]) >> (corner % 8)) & 1U) != 0;
  };
  const std::size_t corners = 2 * std::size_t{count};
  for (std::size_t corner = 0; corner < corners; ++corner) labels += is_labelled(corner) ? 1 : 0;
  for (std::size_t bit = corners; bit < 8 * labelled.size(); ++bit) {
    if (is_labelled(bit)) fail("labelled corners", "a bit beyond the last corner is set");
  }
  const Array label = parts.array(labels, label_width, "labels of corners");
  std::size_t next = 0;
  for (std::size_t corner = 0; corner < corners; ++corner) {
    if (!is_labelled(corner)) continue;
    const std::uint32_t value = label.index(next);
    if (value == 0) fail("labels of corners", next, "0, expected another, as the corner is said to have one");
    document.triangles[corner / 2].label[corner % 2] = value;
    ++next;
  }
}

}  // namespace

NetDocument parse_compact(std::string_view bytes, const std::function<NetDocument(std::string_view)>& read_head) {
  check_sum(bytes);
  Parts parts(bytes.substr(0, bytes.size() - 8));
  parts.take(kCompactMagic.size(), "header");
  const std::uint32_t version = parts.word("header");
  if (version != 1) {
    fail("header", "version " + std::to_string(version) + " is not a version this program reads, expected 1");
  }
  const std::uint32_t head_size = parts.word("header");
  const std::uint32_t vertices = parts.word("header");
  const std::uint32_t triangles = parts.word("header");
  const std::size_t chart_width = width_of(parts.word("header"), "header: charts of vertices");
  const std::size_t label_width = width_of(parts.word("header"), "header: labels of corners");
  if (triangles > (1U << 30)) fail("header", "more than the limit of 1073741824 triangles");
  NetDocument document = read_head(parts.take(head_size, "head"));
  if (!document.vertices.empty() || !document.triangles.empty()) {
    fail("head", "vertices or triangles in the JSON text, expected none");
  }
  read_vertices(parts, vertices, chart_width, document);
  read_triangles(parts, triangles, label_width, document);
  if (parts.left() != 0) fail("checksum", std::to_string(parts.left()) + " bytes too many before it");
  return document;
}

}  // namespace epsnet::certify
