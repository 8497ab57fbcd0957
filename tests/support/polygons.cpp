#include "tests/support/polygons.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "netgen/exchange/exchange.h"

namespace epsnet::test {

std::string file_text(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  if (!in) throw std::runtime_error(path.string() + " cannot be read");
  return text.str();
}

std::vector<std::filesystem::path> data_files(const std::string& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(std::string(EPSNET_TEST_DATA) + "/" + folder)) {
    files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

Surface imported(const std::filesystem::path& path) { return import_surface(file_text(path), path.string()); }

PairedPolygon paired_polygon(const Surface& surface) {
  PairedPolygon polygon{surface.tiles().at(0), {}};
  for (const SideId s : surface.side_ids()) polygon.partner.push_back(surface.partner(s).number());
  return polygon;
}

std::string domain_text(const PairedPolygon& polygon) {
  std::ostringstream text;
  text << polygon.partner.size() << '\n';
  for (const std::uint32_t s : polygon.partner) text << s << '\n';
  for (const auto& [x, y] : polygon.vertices) text << x << ' ' << y << '\n';
  return text.str();
}

PairedPolygon rotated(const PairedPolygon& polygon, std::uint32_t first) {
  const auto n = static_cast<std::uint32_t>(polygon.partner.size());
  PairedPolygon result;
  for (std::uint32_t s = 0; s < n; ++s) {
    result.vertices.push_back(polygon.vertices[(s + first) % n]);
    result.partner.push_back((polygon.partner[(s + first) % n] + n - first) % n);
  }
  return result;
}

Tile moved(const Isometry<Rational>& isometry, const Tile& tile) {
  Tile result;
  for (const auto& z : tile) result.push_back(isometry(z));
  return result;
}

rc::Gen<Isometry<Rational>> isometries() {
  return rc::gen::map(
      rc::gen::container<std::array<int, 4>>(rc::gen::inRange(-20, 21)), [](const std::array<int, 4>& k) {
        const Isometry<Rational> rotation{{Rational(k[0]), Rational(k[0] == 0 && k[1] == 0 ? 1 : k[1])}, {}};
        // |centre| ≤ 20√2/29 < 1.
        return Isometry<Rational>::translation({Rational(k[2], 29), Rational(k[3], 29)}) * rotation;
      });
}

PairedPolygon cut_and_pasted(const PairedPolygon& polygon, std::uint32_t k) {
  const PairedPolygon p = rotated(polygon, k);
  const auto n = static_cast<std::uint32_t>(p.partner.size());
  const std::uint32_t end = p.partner[0];
  const auto& v = p.vertices;
  const auto crossing = segment_to_segment(v[0], v[1], v[(end + 1) % n], v[end]);
  // Side names: 0 the diagonal from vertex 0 to vertex 2; 1 the copy of side 1 at the partner of side 0, which takes
  // the place of side `end` together with the copy of the diagonal, n.
  std::vector<std::uint32_t> names;
  PairedPolygon result;
  const auto add = [&](std::uint32_t name, const Complex<Rational>& start) {
    names.push_back(name);
    result.vertices.push_back(start);
  };
  add(0, v[0]);
  for (std::uint32_t s = 2; s < n; ++s) {
    if (s == end) {
      add(1, v[s]);
      add(n, crossing(v[2]));
    } else {
      add(s, v[s]);
    }
  }
  for (const std::uint32_t name : names) {
    const std::uint32_t other = name == 0 ? n : name == n ? 0 : p.partner[name];
    result.partner.push_back(static_cast<std::uint32_t>(std::find(names.begin(), names.end(), other) - names.begin()));
  }
  return result;
}

PairedPolygon with_vertex_on_side(const PairedPolygon& polygon, std::uint32_t k, const Rational& share) {
  const auto n = static_cast<std::uint32_t>(polygon.partner.size());
  const std::uint32_t other = polygon.partner[k];
  const auto& v = polygon.vertices;
  const auto frame = Isometry<Rational>::translation(v[k]);
  const Complex<Rational> point = frame(share * inverse(frame)(v[(k + 1) % n]));
  const auto crossing = segment_to_segment(v[k], v[(k + 1) % n], v[(other + 1) % n], v[other]);
  PairedPolygon result;
  // Side s becomes side s plus the number of new vertices before it; halves are swapped by the pairing.
  const auto number = [&](std::uint32_t s) { return s + (s > k ? 1U : 0U) + (s > other ? 1U : 0U); };
  for (std::uint32_t s = 0; s < n; ++s) {
    result.vertices.push_back(v[s]);
    if (s == k || s == other) {
      result.vertices.push_back(s == k ? point : crossing(point));
      result.partner.push_back(number(polygon.partner[s]) + 1);
      result.partner.push_back(number(polygon.partner[s]));
    } else {
      result.partner.push_back(number(polygon.partner[s]));
    }
  }
  return result;
}

}  // namespace epsnet::test
