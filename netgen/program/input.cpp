#include "netgen/program/input.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <sstream>
#include <system_error>
#include <utility>

#include "certify/base/text.h"
#include "certify/claims.h"
#include "certify/file/compact.h"
#include "certify/file/document_reader.h"
#include "certify/file/reader.h"
#include "netgen/exchange/text_formats.h"
#include "netgen/program/output.h"
#include "netgen/surfaces/surfaces.h"

namespace epsnet::program {
namespace {

bool is_json(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return first != std::string::npos && (text[first] == '{' || text[first] == '[');
}

std::optional<std::string> format_in(const std::string& text) {
  certify::ByteStream bytes(text);
  return certify::format_of(bytes);
}

/// Returns the name of a file for readers of texts, which add the line: "NAME:LINE: ".
std::string text_name(const std::string& path) { return path == "-" ? "standard input" : path; }

}  // namespace

TextInput read_text_input(const std::string& path) { return {text_name(path), certify::load(path)}; }

namespace {

Surface surface_of_text(const std::string& text, const std::string& name) {
  if (!is_json(text) && !certify::is_compact(text)) {
    throw JobError(name +
                   ": neither JSON nor compact, expected a surface file, or one about a surface; 'epsnet surface "
                   "import' makes one of a text");
  }
  return parse_surface_file(text, name);
}

}  // namespace

Surface read_surface_input(const std::string& path) {
  return surface_of_text(certify::load(path), certify::display_name(path));
}

certify::NetDocument read_net_input(const std::string& path) {
  const std::string text = certify::load(path);
  const std::string name = certify::display_name(path);
  if (!is_json(text) && !certify::is_compact(text))
    throw JobError(name + ": neither JSON nor compact, expected a net file, made by 'epsnet net'");
  return certify::parse_file<certify::NetDocument>(text, name);
}

Contents read_any_input(const std::string& path) {
  const std::string text = certify::load(path);
  if (certify::is_compact(text)) return certify::parse_file<certify::NetDocument>(text, certify::display_name(path));
  if (!is_json(text)) {
    const ExchangeFormat format =
        is_triangulation_stream(text) ? ExchangeFormat::triangulation : ExchangeFormat::domain;
    return ImportedSurface{format, import_surface(text, text_name(path))};
  }
  const std::string name = certify::display_name(path);
  const std::optional<std::string> named = format_in(text);
  const std::string format = named.value_or("");
  if (format == "epsnet-surface") return parse_surface_file(text, name);
  std::string formats = "epsnet-surface, ";
  for (const certify::ClaimKind& kind : certify::kClaimKinds) {
    if (format == kind.format) return certify::parse_file<certify::ClaimDocument>(text, name);
    formats.append(kind.format).append(", ");
  }
  if (format == "epsnet-dirichlet") return parse_dirichlet_json(text, name);
  throw JobError(name + ": " +
                 (named ? "the member \"format\" is " + certify::in_quotes(format) : "no member \"format\"") +
                 ", expected " + formats + "or epsnet-dirichlet");
}

const certify::NetDocument* net_in(const Contents& contents) {
  const auto* claim = std::get_if<certify::ClaimDocument>(&contents);
  return claim == nullptr ? nullptr : std::get_if<certify::NetDocument>(claim);
}

SurfaceOrNet read_surface_or_net(const std::string& path) {
  const std::string text = certify::load(path);
  const std::string name = certify::display_name(path);
  if (certify::is_compact(text) || (is_json(text) && format_in(text) == "epsnet-net")) {
    certify::NetDocument net = certify::parse_file<certify::NetDocument>(text, name);
    const Surface surface = from_document(net.surface, name);
    return {surface, std::move(net)};
  }
  return {surface_of_text(text, name), std::nullopt};
}

std::vector<LineText> read_lines(const std::string& path, const std::string& expected) {
  std::vector<LineText> result;
  std::istringstream lines(certify::load(path));
  std::size_t number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    line.resize(std::min(line.find('#'), line.size()));
    const std::size_t begin = line.find_first_not_of(" \t\r");
    if (begin == std::string::npos) continue;
    const std::size_t end = line.find_last_not_of(" \t\r");
    result.push_back({text_name(path) + ":" + std::to_string(number), line.substr(begin, end - begin + 1)});
  }
  if (result.empty()) throw JobError(text_name(path) + ": no " + expected);
  return result;
}

Word parse_word(const std::string& name, const std::string& text) {
  constexpr const char* kSeparators = " \t,";
  Word result;
  for (std::size_t begin = text.find_first_not_of(kSeparators); begin != std::string::npos;) {
    const std::size_t end = std::min(text.find_first_of(kSeparators, begin), text.size());
    std::uint32_t side = 0;
    const auto [last, error] = std::from_chars(text.data() + begin, text.data() + end, side);
    if (error != std::errc() || last != text.data() + end) {
      throw JobError(name + ": expected numbers of sides, as in 0 3 5, not " +
                     certify::in_quotes(text.substr(begin, end - begin)));
    }
    result.emplace_back(side);
    begin = text.find_first_not_of(kSeparators, end);
  }
  return result;
}

}  // namespace epsnet::program
