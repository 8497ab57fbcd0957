#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <iosfwd>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>

#include "certify/base/error.h"
#include "certify/documents.h"

/// The strict reader of surface files and of the files of all claims, version 1, and their writer. docs/format.md is
/// the specification.
///
/// Everything that the format does not allow is an error: an unknown, missing or repeated member, a wrong type, an
/// index written as 1.0, a binary64 that overflows, text after the document, an index out of range, a word whose sides
/// do not compose. No input crashes the reader; time and memory are bounded by a multiple of the size of the file.
///
/// The writer is not trusted: the checker reads its output. Its text is canonical: one row per line, every number as
/// short as possible. So equal documents give equal bytes, and what is read from them equals the document. O(size),
/// buffered. Errors are reported by the state of the stream.
namespace epsnet::certify {

/// The contents are not a file of the requested kind.
class MalformedError : public LocatedError {
 public:
  /// Like a LocatedError.
  using LocatedError::LocatedError;
};

/// The file cannot be opened or read; its contents are unknown.
class FileError : public LocatedError {
 public:
  /// Like a LocatedError.
  using LocatedError::LocatedError;
};

/// Returns the name of a file in messages: its path as given, in quotation marks, or `standard input` for "-".
[[nodiscard]] std::string display_name(const std::filesystem::path& path);

/// Returns the bytes of a file, a pipe or a terminal, which is read once. "-" is standard input, here and below. Throws
/// FileError, or MalformedError beyond 4 GiB.
[[nodiscard]] std::string load(const std::filesystem::path& path);

/// Files of at most this many bytes are not read in chunks.
inline constexpr std::uint64_t kMaxBytesAtOnce = 4'000'000;

/// Is shown all bytes of a file, piece by piece in their order.
using Witness = std::function<void(std::string_view)>;

/// Whether a reader checks the structure of what it read (that indices are in range, and so on), or leaves that to
/// `check`, which always does.
enum class Structure { checked, unchecked };

/// Where to put the contents of a file: a document of the kind that is expected, or of the kind that the file names.
using ContentsPointer = Pointers<>::And<ClaimDocument, SurfaceDocument>;
/// What read_file calls.
void read_file_into(ContentsPointer contents, const std::filesystem::path& path, const Witness& witness,
                    Structure structure);
/// What parse_file calls.
void parse_file_into(ContentsPointer contents, std::string_view bytes, std::string_view name);

/// Reads a file, a large one in chunks, without holding it in memory. `Contents` says what is expected:
/// SurfaceDocument, NetDocument, of a net file that is compact or not, the document of another claim, or ClaimDocument.
/// Then the member `format` names the kind, and a file with any other format is read as a net file. Throws FileError,
/// or MalformedError, after the witness has seen all of a file that is not too large.
template <class Contents>
[[nodiscard]] Contents read_file(const std::filesystem::path& path, const Witness& witness = {},
                                 Structure structure = Structure::checked) {
  Contents contents;
  read_file_into(&contents, path, witness, structure);
  return contents;
}

/// Like `read_file`, from memory; `name` stands for the file in messages. Throws MalformedError.
template <class Contents>
[[nodiscard]] Contents parse_file(std::string_view bytes, std::string_view name) {
  Contents contents;
  parse_file_into(&contents, bytes, name);
  return contents;
}

// The writer.

/// Writes a file, of a geodesics document the members that its claim has.
void write_file(const AnyClaim& document, std::ostream& out);
/// Writes a surface file.
void write_file(const SurfaceDocument& surface, std::ostream& out);

/// Writes a compact net file, about 55 bytes per vertex. Requires: `opposite` is an involution without fixed points.
/// Otherwise throws std::invalid_argument before anything is written, and only write_file can write the document.
void write_compact_net(const NetDocument& document, std::ostream& out);

}  // namespace epsnet::certify
