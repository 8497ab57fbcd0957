#pragma once

#include <algorithm>
#include <cstdint>
#include <gtest/gtest.h>
#include <sstream>
#include <string>
#include <vector>

#include "certify/check.h"
#include "certify/file/file.h"
#include "certify/net/numbering.h"

/// What the tests of all claims ask of a document, and of the text of its file.
namespace epsnet::certify {

inline Certificate checked(const AnyClaim& document) { return check(document, {.threads = 2}); }

/// "VERDICT", or "VERDICT: rule".
inline std::string outcome(const AnyClaim& document) {
  const Certificate certificate = checked(document);
  return std::string(name(certificate.verdict)) + (certificate.rule.empty() ? "" : ": " + certificate.rule);
}

/// The verdict of one rule; "" if it was not asked.
inline std::string verdict_of(const std::string& rule, const AnyClaim& document) {
  for (const RuleReport& report : checked(document).rules) {
    if (report.rule == rule) return std::string(name(report.verdict));
  }
  return "";
}

/// A list in order, with clusters that claim little.
inline GeodesicsDocument in_order(GeodesicsDocument document) {
  std::stable_sort(document.geodesics.begin(), document.geodesics.end(),
                   [](const auto& x, const auto& y) { return x.length.lower < y.length.lower; });
  document.clusters.clear();
  double reach = 0;
  for (std::uint32_t k = 0; k < document.geodesics.size(); ++k) {
    const Interval length = document.geodesics[k].length;
    if (k == 0 || length.lower > reach) document.clusters.push_back({k, 0, true});
    reach = std::max(reach, length.upper);
    GeodesicsDocument::Cluster& last = document.clusters.back();
    if (++last.count > 1) last.equal = false;
  }
  return document;
}

/// The same net with its triangles in another order: number k is that which was number order[k].
inline NetDocument with_triangles_in_order(const NetDocument& document, const std::vector<std::uint32_t>& order) {
  std::vector<std::uint32_t> place(order.size());
  for (std::uint32_t k = 0; k < order.size(); ++k) place[order[k]] = k;
  NetDocument result = document;
  for (std::uint32_t k = 0; k < order.size(); ++k) {
    result.triangles[k] = document.triangles[order[k]];
    for (std::uint32_t& dart : result.triangles[k].opposite) dart = 3 * place[dart / 3] + dart % 3;
  }
  if (result.collars) {
    for (NetDocument::Collar& collar : *result.collars) {
      for (std::uint32_t& t : collar.triangles) t = place[t];
    }
  }
  return result;
}

/// The path back on the surface of a document.
inline std::vector<std::uint32_t> reversed(const AnyClaim& document, std::vector<std::uint32_t> word) {
  const SurfaceSides sides(document.net().surface);
  std::reverse(word.begin(), word.end());
  for (std::uint32_t& s : word) s = sides.partner[s];
  return word;
}

/// One path after the other.
inline std::vector<std::uint32_t> joined(std::vector<std::uint32_t> first, const std::vector<std::uint32_t>& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

/// A name for the vertex of the surface that a side begins at: the least of the sides that do.
inline std::uint32_t vertex_of(const SurfaceSides& sides, std::uint32_t side) {
  std::uint32_t least = side;
  for (std::uint32_t s = sides.next_around(side); s != side; s = sides.next_around(s)) least = std::min(least, s);
  return least;
}

inline std::string written(const AnyClaim& document) {
  std::ostringstream out;
  write_file(document, out);
  return out.str();
}

/// What the reader says of a text; "" if it reads it.
template <class Document>
std::string reading_complaint(const std::string& text) {
  try {
    (void)parse_file<Document>(text, "test");
  } catch (const MalformedError& error) {
    return error.what();
  }
  return "";
}

/// Expects that a document without structure is malformed, and that the reader refuses what is written of it with the
/// same words, which are returned.
template <class Document>
std::string structure_complaint(const Document& document) {
  const Certificate certificate = checked(document);
  EXPECT_EQ(certificate.verdict, Verdict::malformed);
  EXPECT_EQ(certificate.rule, "structure");
  EXPECT_EQ(reading_complaint<Document>(written(document)), "test: " + certificate.message);
  return certificate.message;
}

}  // namespace epsnet::certify
