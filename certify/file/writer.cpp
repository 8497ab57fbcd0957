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
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "certify/claims.h"
#include "certify/file/compact.h"
#include "certify/file/file.h"
#include "certify/net/numbering.h"

namespace epsnet::certify {
namespace {

/// Collects text and hands it to the stream in large pieces: one stream call per number would dominate the time.
class Buffer {
 public:
  explicit Buffer(std::ostream& out) : out_(out) {}

  void mark(char c) {
    make_room(1);
    bytes_[size_++] = c;
  }

  void text(std::string_view piece) {
    make_room(piece.size());
    if (piece.size() > bytes_.size()) bytes_.resize(piece.size());
    std::copy(piece.begin(), piece.end(), bytes_.data() + size_);
    size_ += piece.size();
  }

  template <class Number>
  void number(Number value) {
    constexpr std::size_t kLongest = 32;
    make_room(kLongest);
    char* const first = bytes_.data() + size_;
    size_ += static_cast<std::size_t>(std::to_chars(first, first + kLongest, value).ptr - first);
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
    out_.write(bytes_.data(), static_cast<std::streamsize>(size_));
    size_ = 0;
  }

 private:
  void make_room(std::size_t size) {
    if (bytes_.size() - size_ < size) flush();
  }

  std::ostream& out_;
  std::vector<char> bytes_ = std::vector<char>(1 << 20);
  std::size_t size_ = 0;
};

/// Writes values as their types and fields.h say.
class Writer {
 public:
  explicit Writer(std::ostream& out) : buffer_(out) {}

  template <class Root>
  void write_all(const Root& root) {
    write(root);
    buffer_.text("\n");
    buffer_.flush();
  }

 private:
  void write(std::uint32_t index) { buffer_.number(index); }
  void write(std::uint64_t integer) { buffer_.number(integer); }
  void write(std::int64_t integer) { buffer_.number(integer); }
  void write(double number) { buffer_.number(number); }
  void write(bool truth) { buffer_.text(truth ? "true" : "false"); }
  void write(const mpq_class& rational) { buffer_.string(rational.get_str()); }
  void write(const std::vector<mpz_class>& integers) {
    char separator = '[';
    for (const mpz_class& integer : integers) {
      buffer_.mark(separator);
      separator = ',';
      buffer_.string(integer.get_str());
    }
    buffer_.text(integers.empty() ? "[]" : "]");
  }
  void write(const std::string& text) { buffer_.escaped_string(text); }
  void write(Format format) { buffer_.string(format.name); }
  void write(Version version) { write(version.number); }
  template <Enumeration T>
  void write(T value) {
    buffer_.string(Fields<T>::kNames[static_cast<std::size_t>(value)]);
  }
  template <class T>
  void write(const std::optional<T>& value) {
    write(*value);
  }
  template <class Indices>
  void write(List<Indices> list) {
    write(list.indices);
  }
  void write(List<const std::vector<std::uint32_t>> list) {
    const bool is_part = std::exchange(is_part_, true);  // On one line.
    write(list.indices);
    is_part_ = is_part;
  }

  template <class T>
  void write(const std::vector<T>& list) {
    const bool is_part = std::exchange(is_part_, true);
    std::string_view separator = is_part ? "[" : "[\n";
    for (const T& element : list) {
      buffer_.text(separator);
      separator = is_part ? "," : ",\n";
      write(element);
    }
    buffer_.text(list.empty() ? "[]" : is_part ? "]" : "\n]");
    is_part_ = is_part;
  }

  template <Array T>
  void write(const T& array) {
    char separator = '[';
    const auto write_element = [&](const auto& element) {
      buffer_.mark(separator);
      separator = ',';
      write(element);
    };
    const auto write_elements = [&]<class Element>(const Element& element) {
      if constexpr (requires { element.indices; }) {
        std::for_each(element.indices.begin(), element.indices.end(), write_element);
      } else {
        write_element(element);
      }
    };
    std::apply([&](const auto&... element) { (write_elements(element), ...); }, Fields<T>::elements(array));
    buffer_.mark(']');
  }

  template <Object T>
  void write(const T& object) {
    bool is_first = true;
    const auto write_member = [&]<class Value>(const Member<Value>& member) {
      if (member.presence == Presence::forbidden) return;
      if (member.presence == Presence::optional && is_empty(member.value)) return;
      // A number stands on the line of the member before it.
      using Plain = std::remove_cvref_t<Value>;
      constexpr bool kIsNumber = std::is_same_v<Plain, std::uint32_t> || std::is_same_v<Plain, Version>;
      buffer_.text(is_first ? "{" : is_part_ || kIsNumber ? "," : ",\n");
      is_first = false;
      buffer_.string(member.name);
      buffer_.text(":");
      write(member.value);
    };
    std::apply([&](const auto&... member) { (write_member(member), ...); }, Fields<T>::members(object));
    buffer_.text("}");
  }

  void write(const SurfaceDocument& surface) {
    const SurfaceKind kind = is_over_field(surface)       ? SurfaceKind::field
                             : surface.map_tile.p != 0    ? SurfaceKind::map
                             : surface.regular_genus != 0 ? SurfaceKind::regular
                                                          : SurfaceKind::tiles;
    write(SurfaceObject<const SurfaceDocument>{surface, kind});
  }

  static bool is_empty(const std::string& text) { return text.empty(); }
  template <class Indices>
  static bool is_empty(const List<Indices>& list) {
    return list.indices.empty();
  }
  template <class T>
  static bool is_empty(const std::vector<T>& list) {
    return list.empty();
  }
  template <class T>
  static bool is_empty(const std::optional<T>& value) {
    return !value.has_value();
  }
  template <class T>
  static bool is_empty(const T&) {
    return false;
  }

  Buffer buffer_;
  bool is_part_ = false;  ///< Of an array, whose elements have a line each.
};

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

}  // namespace

void write_compact_net(const NetDocument& document, std::ostream& out) {
  check_pairs(document);
  std::ostringstream head;
  write_file(
      NetDocument{document.surface, document.epsilon, document.charts, document.labels, {}, {}, document.collars},
      head);
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

void write_file(const AnyClaim& document, std::ostream& out) {
  document.visit([&](const auto& one) { Writer(out).write_all(one); });
}

void write_file(const SurfaceDocument& surface, std::ostream& out) {
  Writer(out).write_all(SurfaceFile<const SurfaceDocument>{surface});
}

}  // namespace epsnet::certify
