#pragma once

#include <optional>
#include <string>
#include <vector>

#include "certify/file/pieces.h"
#include "certify/net/document.h"

namespace epsnet::certify {

/// A JSON text, taken apart: the rows that large files consist of, and the text without them.
struct PlainRows {
  /// The text with `[]` in place of the arrays that the rows were taken from: at most one behind the name `vertices`,
  /// and one behind `triangles`.
  std::string rest;
  std::vector<NetDocument::Vertex> vertices;
  std::vector<NetDocument::Triangle> triangles;
};

/// Takes out the first array of rows that a member `vertices` has, and the first that a member `triangles` has,
/// wherever they stand. Plain rows have the right number of JSON numbers each; indices fit in 32 bits, and coordinates
/// are finite as binary64. Returns nullopt if there are no rows, if one is not plain, or if the rest is longer than 64
/// MiB. The strict reader then reports the error.
///
/// If the strict reader takes `rest` for a net, with no vertices or no triangles where there were rows, it takes the
/// text for that net with these rows. For rows are JSON; brackets and quotes outside of rows are those of `rest`; and
/// a member of these names with an empty array is nothing that it accepts elsewhere or twice.
[[nodiscard]] std::optional<PlainRows> take_plain_rows(Pieces& text);

}  // namespace epsnet::certify
