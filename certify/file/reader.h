#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>

#include "certify/claims/bound/document.h"
#include "certify/claims/distance/document.h"
#include "certify/claims/geodesics/document.h"
#include "certify/net/document.h"

/// The strict reader of net, surface, geodesics, distance and bound files, version 1. docs/format.md is the
/// specification.
///
/// Everything that the format does not allow is an error: an unknown, missing or repeated member, a wrong type, an
/// index written as 1.0, a binary64 that overflows, text after the document, an index out of range, a word whose sides
/// do not compose. No input crashes the reader; time and memory are bounded by a multiple of the size of the file.
namespace epsnet::certify {

/// The contents are not a file of the requested kind. what() is "NAME: PLACE: what was wrong, what was expected", one
/// line.
class MalformedError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The file cannot be opened or read; its contents are unknown. what() is "NAME: why", one line.
class FileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Returns the name of a file in messages: its path as given, in quotation marks, or `standard input` for "-".
[[nodiscard]] std::string display_name(const std::filesystem::path& path);

/// Returns the bytes of a file, a pipe or a terminal, which is read once. "-" is standard input, here and below. Throws
/// FileError, or MalformedError beyond 4 GiB.
[[nodiscard]] std::string load(const std::filesystem::path& path);

/// Files of at most this many bytes are not read in chunks.
inline constexpr std::uint64_t kMaxBytesAtOnce = 4'000'000;

/// The contents of a file that can be checked.
using ClaimDocument = std::variant<NetDocument, GeodesicsDocument, DistanceDocument, BoundDocument>;

/// Reads a large file in chunks, without holding it in memory. Passes its bytes to `witness` in order. Returns nullopt
/// if the path is not a large file that can be checked, or if anything is wrong with it; then `load` and
/// `parse_claim_in_place` read the file or report the error.
[[nodiscard]] std::optional<ClaimDocument> read_claim_in_pieces(
    const std::filesystem::path& path, const std::function<void(std::string_view)>& witness = {});

/// Reads a net file, compact or not. Throws FileError or MalformedError.
[[nodiscard]] NetDocument read_net(const std::filesystem::path& path);

/// Reads a net file from memory; `name` stands for the file in messages. Throws MalformedError.
[[nodiscard]] NetDocument parse_net(std::string_view text, std::string_view name);

/// Reads a surface file. Throws FileError or MalformedError.
[[nodiscard]] SurfaceDocument read_surface(const std::filesystem::path& path);

/// Reads a surface file from memory; `name` stands for the file in messages. Throws MalformedError.
[[nodiscard]] SurfaceDocument parse_surface(std::string_view text, std::string_view name);

/// Reads a geodesics file. Throws FileError or MalformedError.
[[nodiscard]] GeodesicsDocument read_geodesics(const std::filesystem::path& path);

/// Reads a geodesics file from memory; `name` stands for the file in messages. Throws MalformedError.
[[nodiscard]] GeodesicsDocument parse_geodesics(std::string_view text, std::string_view name);

/// Reads a distance file. Throws FileError or MalformedError.
[[nodiscard]] DistanceDocument read_distance(const std::filesystem::path& path);

/// Reads a distance file from memory; `name` stands for the file in messages. Throws MalformedError.
[[nodiscard]] DistanceDocument parse_distance(std::string_view text, std::string_view name);

/// Reads a bound file. Throws FileError or MalformedError.
[[nodiscard]] BoundDocument read_bound(const std::filesystem::path& path);

/// Reads a bound file from memory; `name` stands for the file in messages. Throws MalformedError.
[[nodiscard]] BoundDocument parse_bound(std::string_view text, std::string_view name);

/// Reads a file that can be checked. Its member `format` names its kind; a file with any other format is read as a net
/// file. Throws FileError or MalformedError.
[[nodiscard]] ClaimDocument read_claim(const std::filesystem::path& path);

/// Like `read_claim`, from memory; `name` stands for the file in messages. Throws MalformedError.
[[nodiscard]] ClaimDocument parse_claim(std::string_view text, std::string_view name);

/// Like `parse_claim`, without copying the bytes. The bytes are unchanged, but their capacity may grow. Throws
/// MalformedError.
[[nodiscard]] ClaimDocument parse_claim_in_place(std::string& bytes, std::string_view name);

}  // namespace epsnet::certify
