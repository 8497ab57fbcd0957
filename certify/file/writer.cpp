#include "certify/file/writer.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstring>
#include <ostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "certify/file/compact.h"
#include "certify/net/darts.h"

namespace epsnet::certify {
namespace {

/// Collects text and hands it to the stream in large pieces: one stream call per number would dominate the time.
class Buffer {
 public:
  explicit Buffer(std::ostream& out) : out_(out) { text_.reserve(kPiece + kPiece / 4); }

  void text(std::string_view piece) {
    text_ += piece;
    if (text_.size() >= kPiece) flush();
  }

  template <class Number>
  void number(Number value) {
    char digits[32];
    const auto [end, error] = std::to_chars(digits, digits + sizeof digits, value);
    text(std::string_view(digits, static_cast<std::size_t>(end - digits)));
  }

  void string(std::string_view value) {
    text("\"");
    text(value);
    text("\"");
  }

  /// Text of any content as a JSON string.
  void escaped_string(std::string_view value) {
    constexpr std::string_view kHexadecimal = "0123456789abcdef";
    text("\"");
    for (const char c : value) {
      if (c == '"' || c == '\\') text("\\");
      if (static_cast<unsigned char>(c) >= 0x20) {
        text({&c, 1});
      } else {
        text("\\u00");
        text(kHexadecimal.substr(static_cast<std::size_t>(c) / 16, 1));
        text(kHexadecimal.substr(static_cast<std::size_t>(c) % 16, 1));
      }
    }
    text("\"");
  }

  void flush() {
    out_.write(text_.data(), static_cast<std::streamsize>(text_.size()));
    text_.clear();
  }

 private:
  static constexpr std::size_t kPiece = 1 << 20;
  std::ostream& out_;
  std::string text_;
};

/// `[a,b,…]` with `write_element` for each.
template <class Range, class WriteElement>
void write_list(Buffer& buffer, const Range& range, const WriteElement& write_element) {
  const char* separator = "[";
  for (const auto& element : range) {
    buffer.text(separator);
    separator = ",";
    write_element(element);
  }
  buffer.text(range.empty() ? "[]" : "]");
}

/// As write_list, one element a line.
template <class Range, class WriteRow>
void write_rows(Buffer& buffer, const Range& range, const WriteRow& write_row) {
  const char* separator = "[\n";
  for (const auto& row : range) {
    buffer.text(separator);
    separator = ",\n";
    write_row(row);
  }
  buffer.text(range.empty() ? "[]" : "\n]");
}

void write_coordinates(Buffer& buffer, const RationalPoint& point) {
  buffer.string(point.x.get_str());
  buffer.text(",");
  buffer.string(point.y.get_str());
}

void write_numbers(Buffer& buffer, std::initializer_list<std::uint32_t> numbers) {
  write_list(buffer, std::vector<std::uint32_t>(numbers), [&](std::uint32_t n) { buffer.number(n); });
}

void write_tiles(Buffer& buffer, const SurfaceDocument& surface) {
  buffer.text("\"tiles\",\n\"tiles\":");
  write_rows(buffer, surface.tiles, [&](const SurfaceDocument::Tile& tile) {
    write_list(buffer, tile, [&](const RationalPoint& vertex) {
      buffer.text("[");
      write_coordinates(buffer, vertex);
      buffer.text("]");
    });
  });
  buffer.text(",\n\"gluing\":");
  write_rows(buffer, surface.gluing, [&](const SurfaceDocument::Gluing& g) {
    write_numbers(buffer, {g.tile, g.side, g.other_tile, g.other_side});
  });
}

void write_surface_object(Buffer& buffer, const SurfaceDocument& surface) {
  buffer.text("{\"kind\":");
  if (surface.regular_genus == 0) {
    write_tiles(buffer, surface);
  } else {
    buffer.text("\"regular\",\"genus\":");
    buffer.number(surface.regular_genus);
  }
  if (!surface.about.empty()) {
    buffer.text(",\n\"about\":");
    buffer.escaped_string(surface.about);
  }
  buffer.text("}");
}

void write_collars(Buffer& buffer, const std::vector<NetDocument::Collar>& collars) {
  const auto number = [&](auto n) { buffer.number(n); };
  buffer.text(",\n\"collars\":");
  write_rows(buffer, collars, [&](const NetDocument::Collar& collar) {
    buffer.text("{\"core\":");
    write_list(buffer, collar.core, number);
    buffer.text(",\"length\":");
    write_list(buffer, collar.length, number);
    buffer.text(",\"vertices\":");
    write_list(buffer, collar.vertices, number);
    buffer.text(",\"triangles\":");
    write_list(buffer, collar.triangles, number);
    buffer.text("}");
  });
}

void write_net_object(Buffer& buffer, const NetDocument& document) {
  buffer.text("{\"format\":\"epsnet-net\",\"version\":1,\n\"surface\":");
  write_surface_object(buffer, document.surface);
  buffer.text(",\n\"epsilon\":");
  buffer.string(document.epsilon);
  buffer.text(",\n\"charts\":");
  write_rows(buffer, document.charts, [&](const NetDocument::Chart& chart) {
    buffer.text("[");
    buffer.number(chart.tile);
    buffer.text(",");
    write_coordinates(buffer, chart.centre);
    buffer.text("]");
  });
  buffer.text(",\n\"labels\":");
  write_rows(buffer, document.labels, [&](const NetDocument::Label& label) {
    buffer.text("[");
    buffer.number(label.from);
    buffer.text(",");
    buffer.number(label.to);
    buffer.text(",");
    write_list(buffer, label.word, [&](std::uint32_t side) { buffer.number(side); });
    buffer.text("]");
  });
  buffer.text(",\n\"vertices\":");
  write_rows(buffer, document.vertices, [&](const NetDocument::Vertex& vertex) {
    buffer.text("[");
    buffer.number(vertex.chart);
    buffer.text(",");
    buffer.number(vertex.x);
    buffer.text(",");
    buffer.number(vertex.y);
    buffer.text("]");
  });
  buffer.text(",\n\"triangles\":");
  write_rows(buffer, document.triangles, [&](const NetDocument::Triangle& t) {
    buffer.text("[");
    for (const std::uint32_t n : t.vertex) {
      buffer.number(n);
      buffer.text(",");
    }
    for (const std::uint32_t n : t.opposite) {
      buffer.number(n);
      buffer.text(",");
    }
    buffer.number(t.label[0]);
    buffer.text(",");
    buffer.number(t.label[1]);
    buffer.text("]");
  });
  if (document.collars) write_collars(buffer, *document.collars);
  buffer.text("}");
}

/// Collects bytes, hands them to the stream in large pieces, and adds them to the checksum.
class CompactBuffer {
 public:
  explicit CompactBuffer(std::ostream& out) : out_(out) {}

  void text(std::string_view bytes) {
    flush();
    put(bytes);
  }

  void number(std::uint64_t value, std::size_t width) {
    // All eight bytes, of which the next number overwrites what is too much: one store, whatever the width.
    std::array<unsigned char, 8> little_endian{};
    for (std::size_t i = 0; i < 8; ++i) little_endian[i] = static_cast<unsigned char>(value >> (8 * i));
    std::memcpy(bytes_.data() + size_, little_endian.data(), 8);
    size_ += width;
    if (size_ >= kPiece) flush();
  }

  void checksum() {
    flush();
    number(sum_.value(), 8);
    flush();
  }

 private:
  void put(std::string_view bytes) {
    sum_.add(bytes);
    out_.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  }
  void flush() {
    put({bytes_.data(), size_});
    size_ = 0;
  }

  static constexpr std::size_t kPiece = 1 << 16;
  std::ostream& out_;
  std::vector<char> bytes_ = std::vector<char>(kPiece + 8);
  std::size_t size_ = 0;
  CompactChecksum sum_;
};

/// Bytes that numbers below `count` take.
std::uint32_t width_of(std::size_t count) { return count <= 1U << 8 ? 1 : count <= 1U << 16 ? 2 : 4; }

void check_pairs(const NetDocument& document) {
  const std::size_t darts = 3 * document.triangles.size();
  for (std::uint32_t dart = 0; dart < darts; ++dart) {
    const std::uint32_t other = opposite(document, dart);
    if (other == dart || other >= darts || opposite(document, other) != dart) {
      throw std::invalid_argument("the opposite of dart " + std::to_string(dart) + " is " + std::to_string(other) +
                                  ", which does not lead back: a compact file cannot say that");
    }
  }
}

const char* claim_text(GeodesicsDocument::Claim claim) {
  switch (claim) {
    case GeodesicsDocument::Claim::systole:
      return "systole";
    case GeodesicsDocument::Claim::spectrum:
      return "spectrum";
    case GeodesicsDocument::Claim::thick_thin:
      break;
  }
  return "thick-thin";
}

const char* truth_text(bool value) { return value ? "true" : "false"; }

void write_geodesic(Buffer& buffer, const GeodesicsDocument::ClosedGeodesic& geodesic) {
  buffer.text("{\"vertex\":");
  buffer.number(geodesic.vertex);
  buffer.text(",\"word\":");
  write_list(buffer, geodesic.word, [&](std::uint32_t side) { buffer.number(side); });
  buffer.text(",\"length\":[");
  buffer.number(geodesic.length.lower);
  buffer.text(",");
  buffer.number(geodesic.length.upper);
  buffer.text("],\"simple\":");
  buffer.text(truth_text(geodesic.simple));
  buffer.text("}");
}

void write_cluster(Buffer& buffer, const GeodesicsDocument::Cluster& cluster) {
  buffer.text("{\"first\":");
  buffer.number(cluster.first);
  buffer.text(",\"count\":");
  buffer.number(cluster.count);
  buffer.text(",\"equal\":");
  buffer.text(truth_text(cluster.equal));
  buffer.text("}");
}

void write_piece(Buffer& buffer, const GeodesicsDocument::Piece& piece) {
  buffer.text("{\"genus\":");
  buffer.number(piece.genus);
  buffer.text(",\"boundaries\":");
  write_list(buffer, piece.boundaries, [&](const auto& side) { write_numbers(buffer, {side.first, side.second}); });
  buffer.text("}");
}

}  // namespace

void write_compact_net(const NetDocument& document, std::ostream& out) {
  check_pairs(document);
  std::ostringstream head;
  write_net({document.surface, document.epsilon, document.charts, document.labels, {}, {}, document.collars}, head);
  const std::string text = head.str();
  const std::size_t chart_width = width_of(document.charts.size());
  const std::size_t label_width = width_of(document.labels.size() + 1);
  CompactBuffer buffer(out);
  buffer.text(kCompactMagic);
  for (const std::size_t n :
       {std::size_t{1}, text.size(), document.vertices.size(), document.triangles.size(), chart_width, label_width}) {
    buffer.number(n, 4);
  }
  buffer.text(text);
  for (const NetDocument::Vertex& v : document.vertices) buffer.number(std::bit_cast<std::uint64_t>(v.x), 8);
  for (const NetDocument::Vertex& v : document.vertices) buffer.number(std::bit_cast<std::uint64_t>(v.y), 8);
  for (const NetDocument::Vertex& v : document.vertices) buffer.number(v.chart, chart_width);
  for (const NetDocument::Triangle& t : document.triangles) {
    for (const std::uint32_t v : t.vertex) buffer.number(v, 4);
  }
  for (std::uint32_t dart = 0; dart < 3 * document.triangles.size(); ++dart) {
    if (dart < opposite(document, dart)) buffer.number(opposite(document, dart), 4);
  }
  for (std::size_t t = 0; t < document.triangles.size(); t += 4) {
    unsigned labelled = 0;
    for (std::size_t corner = 0; corner < 8 && t + corner / 2 < document.triangles.size(); ++corner) {
      if (document.triangles[t + corner / 2].label[corner % 2] != 0) labelled |= 1U << corner;
    }
    buffer.number(labelled, 1);
  }
  for (const NetDocument::Triangle& t : document.triangles) {
    for (const std::uint32_t label : t.label) {
      if (label != 0) buffer.number(label, label_width);
    }
  }
  buffer.checksum();
}

void write_surface(const SurfaceDocument& surface, std::ostream& out) {
  Buffer buffer(out);
  buffer.text("{\"format\":\"epsnet-surface\",\"version\":1,\n\"surface\":");
  write_surface_object(buffer, surface);
  buffer.text("}\n");
  buffer.flush();
}

void write_net(const NetDocument& document, std::ostream& out) {
  Buffer buffer(out);
  write_net_object(buffer, document);
  buffer.text("\n");
  buffer.flush();
}

void write_geodesics(const GeodesicsDocument& document, std::ostream& out) {
  Buffer buffer(out);
  buffer.text("{\"format\":\"epsnet-geodesics\",\"version\":1,\n\"claim\":");
  buffer.string(claim_text(document.claim));
  buffer.text(",\n\"net\":");
  write_net_object(buffer, document.net);
  if (document.claim == GeodesicsDocument::Claim::spectrum) {
    buffer.text(",\n\"up_to\":");
    buffer.string(document.up_to);
  }
  buffer.text(",\n\"geodesics\":");
  write_rows(buffer, document.geodesics,
             [&](const GeodesicsDocument::ClosedGeodesic& row) { write_geodesic(buffer, row); });
  if (document.claim != GeodesicsDocument::Claim::systole) {
    buffer.text(",\n\"clusters\":");
    write_rows(buffer, document.clusters, [&](const GeodesicsDocument::Cluster& row) { write_cluster(buffer, row); });
  }
  if (document.claim == GeodesicsDocument::Claim::thick_thin) {
    buffer.text(",\n\"pieces\":");
    write_rows(buffer, document.pieces, [&](const GeodesicsDocument::Piece& row) { write_piece(buffer, row); });
  }
  buffer.text("}\n");
  buffer.flush();
}

void write_distance(const DistanceDocument& document, std::ostream& out) {
  Buffer buffer(out);
  buffer.text("{\"format\":\"epsnet-distance\",\"version\":1,\n\"net\":");
  write_net_object(buffer, document.net);
  buffer.text(",\n\"point\":[");
  buffer.number(document.point.tile);
  buffer.text(",");
  write_coordinates(buffer, document.point.z);
  buffer.text("],\n\"distance\":[");
  buffer.number(document.distance.lower);
  buffer.text(",");
  buffer.number(document.distance.upper);
  buffer.text("],\n\"paths\":");
  write_rows(buffer, document.paths, [&](const std::vector<std::uint32_t>& path) {
    write_list(buffer, path, [&](std::uint32_t side) { buffer.number(side); });
  });
  buffer.text(",\n\"equal\":");
  buffer.text(truth_text(document.equal));
  buffer.text("}\n");
  buffer.flush();
}

void write_bound(const BoundDocument& document, std::ostream& out) {
  const auto number = [](Buffer& buffer) { return [&](std::uint32_t n) { buffer.number(n); }; };
  Buffer buffer(out);
  buffer.text("{\"format\":\"epsnet-cover\",\"version\":1,\n\"claim\":");
  buffer.string(document.claim == BoundDocument::Claim::diameter ? "diameter"
                : document.claim == BoundDocument::Claim::radius ? "radius"
                                                                 : "embedded-disk");
  buffer.text(",\n\"net\":");
  write_net_object(buffer, document.net);
  buffer.text(",\n\"value\":[");
  buffer.number(document.value.lower);
  buffer.text(",");
  buffer.number(document.value.upper);
  buffer.text("],\n\"triangulations\":");
  write_rows(buffer, document.triangulations, [&](const BoundDocument::Triangulation& row) {
    std::vector<std::uint32_t> numbers{row.parent};
    numbers.insert(numbers.end(), row.flips.begin(), row.flips.end());
    write_list(buffer, numbers, number(buffer));
  });
  buffer.text(",\n\"cells\":");
  write_rows(buffer, document.cells,
             [&](const std::vector<std::uint32_t>& row) { write_list(buffer, row, number(buffer)); });
  buffer.text("}\n");
  buffer.flush();
}

}  // namespace epsnet::certify
