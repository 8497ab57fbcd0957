#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>

#include "certify/document/cover_document.h"
#include "certify/document/distance_document.h"
#include "certify/document/document.h"
#include "certify/document/geodesics_document.h"

/// The strict reader of net files, surface files, geodesics files, distance files and cover files, version 1
/// (docs/format.md is the law).
///
/// Everything that the format does not allow is an error: an unknown, missing or repeated member, a wrong type, an
/// index written as 1.0, a binary64 that overflows, text after the document, an index that points nowhere, a word that
/// does not compose. No input crashes the reader; time and memory are bounded by a multiple of the size of the file.
namespace epsnet::certify {

/// The file is not a net (or surface) file. what() is "NAME: PLACE: what was wrong, what was expected", one line.
class MalformedError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The file cannot be opened or read at all; nothing is said about its contents. what() is "NAME: why", one line.
class FileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// How messages call a file: its path as given, in quotation marks, or `standard input` for "-".
[[nodiscard]] std::string display_name(const std::filesystem::path& path);

/// The bytes of a file, a pipe or a terminal, at most 4 GiB, read once; "-" is standard input here and below. Throws
/// FileError, or MalformedError if there are more.
[[nodiscard]] std::string load(const std::filesystem::path& path);

/// Files of at most so many bytes are not read in pieces.
inline constexpr std::uint64_t kMaxBytesAtOnce = 4'000'000;

/// What a file that can be checked holds.
using ClaimDocument = std::variant<NetDocument, GeodesicsDocument, DistanceDocument, CoverDocument>;

/// Reads a large file that can be checked without all of its bytes in memory; `witness` gets them, in order. Nothing if
/// path is none, or if anything is wrong with it: then `load` and `parse_claim_in_place` read it, or say what it is.
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

/// Reads a cover file. Throws FileError or MalformedError.
[[nodiscard]] CoverDocument read_cover(const std::filesystem::path& path);

/// Reads a cover file from memory; `name` stands for the file in messages. Throws MalformedError.
[[nodiscard]] CoverDocument parse_cover(std::string_view text, std::string_view name);

/// Reads a file that can be checked, of the kind that its member `format` says; any other is taken for a net file.
/// Throws FileError or MalformedError.
[[nodiscard]] ClaimDocument read_claim(const std::filesystem::path& path);

/// The same from memory; `name` stands for the file in messages. Throws MalformedError.
[[nodiscard]] ClaimDocument parse_claim(std::string_view text, std::string_view name);

/// The same without a copy of the bytes. They stay as they are; their capacity may grow.
[[nodiscard]] ClaimDocument parse_claim_in_place(std::string& bytes, std::string_view name);

}  // namespace epsnet::certify
