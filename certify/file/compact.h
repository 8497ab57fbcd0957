#pragma once

#include <functional>
#include <string_view>

#include "certify/file/json.h"
#include "certify/net/document.h"

/// Compact net files: what a net file says of its surface as JSON, and the vertices and triangles as arrays
/// (docs/format.md, "Compact net file").
namespace epsnet::certify {

/// What a compact file begins with; no text does.
inline constexpr std::string_view kCompactMagic = "\211EPSNET\n";

/// Whether the bytes begin as a compact file.
[[nodiscard]] inline bool is_compact(std::string_view bytes) { return bytes.starts_with(kCompactMagic); }

/// Makes of the JSON text of a compact file a document without vertices and triangles, to which they are added.
using ReadHead = std::function<NetDocument(std::string_view)>;

/// Reads a compact file. Throws MalformedError without the file's name. Indices may be out of range as in a document of
/// any other file (structure_problem). O(size); no more memory than the document takes, however the sizes lie.
[[nodiscard]] NetDocument parse_compact(ByteStream& bytes, const ReadHead& read_head);

/// The checksum at the end of a compact file: XXH64 with the seed 0.
class CompactChecksum {
 public:
  CompactChecksum();
  ~CompactChecksum();
  CompactChecksum(const CompactChecksum&) = delete;
  CompactChecksum& operator=(const CompactChecksum&) = delete;

  void add(std::string_view bytes);
  [[nodiscard]] std::uint64_t value() const;

 private:
  void* state_;
};

}  // namespace epsnet::certify
