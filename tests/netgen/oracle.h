#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "certify/net/document.h"
#include "kernel/plane.h"
#include "netgen/base/options.h"
#include "netgen/surfaces/surfaces.h"
#include "tests/support/in_circle.h"
#include "triangulation/mesh/triangulation.h"

/// A second opinion on net files, for the tests of `certify`: docs/format.md and the rules of docs/proof.md, written
/// down once more with the kernel's formulas at 1024 bits, simple and slow, nothing shared with the certifier.
namespace epsnet::test {

class Oracle {
 public:
  /// What is smaller than this, and not larger than other terms by more than 600 bits of conditioning, is 0. Ties hold.
  Oracle() : zero_(boost::multiprecision::ldexp(Mp1024(1), -300)) {}

  /// The first rule that the document breaks, in the order structure, surface, map, gluing, orientation, delaunay,
  /// covering, packing; empty if it breaks none.
  [[nodiscard]] std::string broken_rule(const certify::NetDocument& document) {
    net_ = &document;
    if (!structure()) return "structure";
    if (!surface_ || !(document.surface == known_)) {
      surface_.reset();
      try {
        surface_.emplace(from_document(document.surface));
        known_ = document.surface;
      } catch (const SurfaceError&) {
        return "surface";
      }
    }
    if (!map()) return "map";
    evaluate_labels();
    if (!gluing()) return "gluing";
    if (!orientation()) return "orientation";
    if (!delaunay()) return "delaunay";
    if (!covering()) return "covering";
    return packing() ? "" : "packing";
  }

 private:
  using Map = Isometry<Mp1024>;
  using Point = Complex<Mp1024>;

  [[nodiscard]] static Rational rational(const mpq_class& q) { return Rational(q.get_mpq_t()); }
  [[nodiscard]] static Complex<Rational> rational(const certify::RationalPoint& z) {
    return {rational(z.x), rational(z.y)};
  }

  [[nodiscard]] std::uint32_t darts() const { return static_cast<std::uint32_t>(3 * net_->triangles.size()); }
  [[nodiscard]] std::uint32_t vertex(std::uint32_t dart) const { return net_->triangles[dart / 3].vertex[dart % 3]; }
  [[nodiscard]] std::uint32_t across(std::uint32_t dart) const { return net_->triangles[dart / 3].opposite[dart % 3]; }
  [[nodiscard]] static std::uint32_t following(std::uint32_t dart) { return dart / 3 * 3 + (dart + 1) % 3; }
  [[nodiscard]] static std::uint32_t preceding(std::uint32_t dart) { return dart / 3 * 3 + (dart + 2) % 3; }

  [[nodiscard]] bool structure() const {
    const certify::NetDocument& net = *net_;
    try {
      static_cast<void>(Length(net.epsilon));
    } catch (const std::invalid_argument&) {
      return false;
    }
    // Every side of every tile in one pair.
    std::vector<std::pair<std::uint32_t, std::uint32_t>> sides;
    for (std::uint32_t t = 0; t < net.surface.tiles.size(); ++t) {
      if (net.surface.tiles[t].size() < 3) return false;
      for (std::uint32_t k = 0; k < net.surface.tiles[t].size(); ++k) sides.emplace_back(t, k);
    }
    std::vector<std::pair<std::uint32_t, std::uint32_t>> glued;
    for (const certify::SurfaceDocument::Gluing& g : net.surface.gluing) {
      glued.emplace_back(g.tile, g.side);
      glued.emplace_back(g.other_tile, g.other_side);
    }
    auto sorted = glued;
    std::sort(sorted.begin(), sorted.end());
    if (sides.empty() || sorted != sides) return false;
    for (const certify::NetDocument::Chart& c : net.charts) {
      if (c.tile >= net.surface.tiles.size() || norm(rational(c.centre)) >= 1) return false;
    }
    const auto number = [&](std::uint32_t s) { return sides[s]; };
    for (const certify::NetDocument::Label& l : net.labels) {
      if (l.from >= net.charts.size() || l.to >= net.charts.size()) return false;
      std::uint32_t tile = net.charts[l.from].tile;
      for (const std::uint32_t s : l.word) {
        if (s >= sides.size() || number(s).first != tile) return false;
        const auto i = static_cast<std::size_t>(std::find(glued.begin(), glued.end(), number(s)) - glued.begin());
        tile = glued[i ^ 1].first;
      }
      if (tile != net.charts[l.to].tile) return false;
    }
    for (const certify::NetDocument::Vertex& v : net.vertices) {
      if (v.chart >= net.charts.size() || !std::isfinite(v.x) || !std::isfinite(v.y)) return false;
      if (norm(Complex<Rational>{Rational(v.x), Rational(v.y)}) >= 1) return false;
    }
    for (const certify::NetDocument::Triangle& t : net.triangles) {
      for (const std::uint32_t v : t.vertex) {
        if (v >= net.vertices.size()) return false;
      }
      for (const std::uint32_t d : t.opposite) {
        if (d >= darts()) return false;
      }
      for (std::size_t i = 1; i < 3; ++i) {
        const std::uint32_t l = t.label[i - 1];
        if (l > net.labels.size()) return false;
        const std::uint32_t to = net.vertices[t.vertex[0]].chart;
        const std::uint32_t from = net.vertices[t.vertex[i]].chart;
        if (l == 0 ? from != to : net.labels[l - 1].from != from || net.labels[l - 1].to != to) return false;
      }
    }
    return true;
  }

  [[nodiscard]] bool map() const {
    if (net_->triangles.empty()) return false;
    for (std::uint32_t d = 0; d < darts(); ++d) {
      const std::uint32_t e = across(d);
      if (e == d || across(e) != d || vertex(d) != vertex(following(e)) || vertex(following(d)) != vertex(e)) {
        return false;
      }
    }
    // The cycles of darts around vertices: one for each vertex. The triangles reached from the first: all.
    std::vector<int> cycles(net_->vertices.size());
    std::vector<bool> turned(darts());
    for (std::uint32_t first = 0; first < darts(); ++first) {
      if (!turned[first]) ++cycles[vertex(first)];
      for (std::uint32_t d = first; !turned[d]; d = across(preceding(d))) turned[d] = true;
    }
    if (std::any_of(cycles.begin(), cycles.end(), [](int count) { return count != 1; })) return false;
    std::vector<std::uint32_t> reached{0};
    for (std::size_t i = 0; i < reached.size(); ++i) {
      for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t t = across(3 * reached[i] + k) / 3;
        if (std::find(reached.begin(), reached.end(), t) == reached.end()) reached.push_back(t);
      }
    }
    const auto euler = static_cast<long>(net_->vertices.size()) - static_cast<long>(net_->triangles.size()) / 2;
    return reached.size() == net_->triangles.size() && euler == 2 - 2 * static_cast<long>(surface_->genus());
  }

  void evaluate_labels() {
    labels_.assign(1, Map{});
    const auto frame = [&](std::uint32_t c) {
      return Map::translation(convert<Mp1024>(rational(net_->charts[c].centre)));
    };
    for (const certify::NetDocument::Label& l : net_->labels) {
      Map g = frame(l.from);
      for (const SideId s : word_of_letters(l.word)) g = convert<Mp1024>(surface_->crossing(s)) * g;
      labels_.push_back(normalized(inverse(frame(l.to)) * g));
    }
  }
  /// The label of the corner a dart leaves.
  [[nodiscard]] const Map& label(std::uint32_t dart) const {
    return labels_[dart % 3 == 0 ? 0 : net_->triangles[dart / 3].label[dart % 3 - 1]];
  }
  /// The corner a dart leaves, in the chart of its triangle.
  [[nodiscard]] Point corner(std::uint32_t dart) const {
    const certify::NetDocument::Vertex& v = net_->vertices[vertex(dart)];
    return label(dart)(Point{Mp1024(v.x), Mp1024(v.y)});
  }
  /// From the chart of the triangle across a dart to the chart of the dart's triangle.
  [[nodiscard]] Map step(std::uint32_t dart) const { return label(dart) * inverse(label(following(across(dart)))); }

  [[nodiscard]] bool equal(const Map& f, const Map& g) const {
    const auto close = [&](const Complex<Mp1024>& u, const Complex<Mp1024>& v) { return norm(u - v) < zero_; };
    const Map p = normalized(f);
    const Map q = normalized(g);
    return (close(p.a, q.a) && close(p.b, q.b)) || (close(p.a, -q.a) && close(p.b, -q.b));
  }

  /// `holds(d)` for all darts.
  template <class Rule>
  [[nodiscard]] bool every_dart(const Rule& holds) const {
    for (std::uint32_t d = 0; d < darts(); ++d) {
      if (!holds(d)) return false;
    }
    return true;
  }
  [[nodiscard]] bool gluing() const {
    return every_dart([&](std::uint32_t d) { return equal(step(d), label(following(d)) * inverse(label(across(d)))); });
  }
  [[nodiscard]] bool orientation() const {
    return every_dart([&](std::uint32_t d) {
      return orientation_determinant(corner(d), corner(following(d)), corner(preceding(d))) > zero_;
    });
  }
  [[nodiscard]] bool delaunay() const {
    return every_dart([&](std::uint32_t d) {
      return in_circle_determinant(corner(d), corner(following(d)), corner(preceding(d)),
                                   step(d)(corner(preceding(across(d))))) <= zero_;
    });
  }
  [[nodiscard]] bool covering() const {
    const Mp1024 bound = Threshold(Length(net_->epsilon).value()).at<Mp1024>()[1];
    return every_dart([&](std::uint32_t d) {
      const auto r = sinh2_circumradius(corner(d), corner(following(d)), corner(preceding(d)));
      return r.denominator > 0 && r.numerator <= bound * r.denominator + zero_;
    });
  }
  [[nodiscard]] bool packing() const {
    const Mp1024 bound = Threshold(Rational(Length(net_->epsilon).value() / 2)).at<Mp1024>()[0];
    return every_dart([&](std::uint32_t d) {
      return vertex(d) == vertex(following(d)) || sinh2_half_distance(corner(d), corner(following(d))) >= bound - zero_;
    });
  }

  Mp1024 zero_;
  const certify::NetDocument* net_ = nullptr;
  certify::SurfaceDocument known_;
  std::optional<Surface> surface_;
  std::vector<Map> labels_;
};

}  // namespace epsnet::test
