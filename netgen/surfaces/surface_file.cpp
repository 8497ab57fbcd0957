#include "netgen/surfaces/surface_file.h"

#include <algorithm>
#include <ostream>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "certify/claims.h"
#include "certify/file/compact.h"
#include "certify/file/document_reader.h"
#include "certify/file/reader.h"
#include "certify/file/writer.h"
#include "netgen/base/atomic_file.h"
#include "netgen/base/gmp.h"
#include "netgen/surfaces/field_tiles.h"

namespace epsnet {

certify::SurfaceDocument to_document(const Surface& surface) {
  certify::SurfaceDocument document;
  document.about = surface.about();
  if (surface.is_regular_polygon()) {
    document.regular_genus = surface.genus();
    return document;
  }
  if (const auto& regular = surface.regular_tile()) {
    document.map_tile = {regular->p, regular->q};
  } else if (surface.field_tiles()) {
    document.field = surface.field_tiles()->document;
  } else {
    for (const Tile& tile : surface.tiles()) {
      certify::SurfaceDocument::Tile& copy = document.tiles.emplace_back();
      for (const Complex<Rational>& z : tile) copy.push_back(to_gmp(z));
    }
  }
  for (const auto& [tile, side, other_tile, other_side] : surface.gluing()) {
    document.gluing.push_back({tile, side, other_tile, other_side});
  }
  return document;
}

Surface from_document(const certify::SurfaceDocument& surface) {
  if (surface.regular_genus != 0) {
    Surface regular = Surface::regular(surface.regular_genus);
    regular.set_about(surface.about);
    return regular;
  }
  std::vector<Tile> tiles;
  for (const certify::SurfaceDocument::Tile& tile : surface.tiles) {
    Tile& copy = tiles.emplace_back();
    for (const certify::RationalPoint& z : tile) copy.push_back(from_gmp(z));
  }
  std::vector<Gluing> gluing;
  for (const auto& [tile, side, other_tile, other_side] : surface.gluing) {
    gluing.push_back({tile, side, other_tile, other_side});
  }
  const auto [p, q] = surface.map_tile;
  Surface result = p != 0                              ? Surface::map({p, q}, std::move(gluing))
                   : !surface.field.polynomial.empty() ? surface_over_field(surface.field, std::move(gluing))
                                                       : Surface(std::move(tiles), std::move(gluing));
  result.set_about(surface.about);
  return result;
}

Surface from_document(const certify::SurfaceDocument& surface, const std::string& name) {
  try {
    return from_document(surface);
  } catch (const SurfaceError& error) {
    throw SurfaceError(certify::ErrorParts{.file = name, .problem = error.what()});
  }
}

namespace {

/// The surface that a file is about.
certify::SurfaceDocument surface_of(certify::ClaimDocument&& claim) {
  return std::visit(
      []<class Document>(Document& document) {
        if constexpr (std::is_same_v<Document, certify::NetDocument>) {
          return std::move(document.surface);
        } else {
          return std::move(document.net.surface);
        }
      },
      claim);
}

bool is_claim(const std::string& text) {
  if (certify::is_compact(text)) return true;
  certify::ByteStream bytes(text);
  const std::string format = certify::format_of(bytes).value_or("");
  return std::any_of(certify::kClaimKinds.begin(), certify::kClaimKinds.end(),
                     [&](const certify::ClaimKind& kind) { return kind.format == format; });
}

certify::SurfaceDocument surface_in(const std::string& text, const std::string& name) {
  return is_claim(text) ? surface_of(certify::parse_file<certify::ClaimDocument>(text, name))
                        : certify::parse_file<certify::SurfaceDocument>(text, name);
}

}  // namespace

Surface load_surface(const std::filesystem::path& path) {
  return from_document(surface_in(certify::load(path), certify::display_name(path)), path.string());
}

Surface parse_surface_file(const std::string& text, const std::string& name) {
  return from_document(surface_in(text, name), name);
}

void save_surface(const Surface& surface, const std::filesystem::path& path) {
  const certify::SurfaceDocument document = to_document(surface);
  write_file_atomically(path, [&](std::ostream& out) { certify::write_file(document, out); });
}

}  // namespace epsnet
