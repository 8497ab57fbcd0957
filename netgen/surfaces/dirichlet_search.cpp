#include "netgen/surfaces/dirichlet_search.h"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <utility>

#include "kernel/plane.h"

namespace epsnet {
namespace {

constexpr std::size_t kMostElements = 40'000;
constexpr int kTangents = 16;

/// v, up to scale, as a point of the Klein model (x, y, 1).
template <class T>
LorentzVector<T> in_klein(const LorentzVector<T>& v) {
  return {v.x / v.t, v.y / v.t, T(1)};
}

/// The corners of the convex hull of the poles, counterclockwise (A. M. Andrew 1979).
template <class Side>
std::vector<Side> convex_hull(std::vector<Side> sides) {
  std::sort(sides.begin(), sides.end(), [](const Side& p, const Side& q) {
    return p.pole.x < q.pole.x || (p.pole.x == q.pole.x && p.pole.y < q.pole.y);
  });
  std::vector<Side> corners;
  for (int half = 0; half < 2; ++half) {
    const std::size_t start = corners.size();
    for (const Side& side : sides) {
      while (corners.size() >= start + 2) {
        const auto& last = corners.back().pole;
        if (cross(last - corners[corners.size() - 2].pole, side.pole - last) > 0) break;
        corners.pop_back();
      }
      corners.push_back(side);
    }
    corners.pop_back();
    std::reverse(sides.begin(), sides.end());
  }
  return corners;
}

}  // namespace

DirichletSearch::DirichletSearch(MatrixProducts& products, double tolerance, std::function<void(Id)> examine)
    : products_(products), tolerance_(tolerance), examine_(std::move(examine)) {
  for (int k = 0; k < kTangents; ++k) {
    const Number angle = boost::math::constants::pi<Number>() * (2 * k + 1) / kTangents;
    tangents_.push_back({0, {}, {Number(cos(angle)), Number(sin(angle))}});
  }
  hull_ = tangents_;
}

bool DirichletSearch::is_identity(const Isometry<MatrixProducts::Number>& f) const {
  const auto small = [&](const MatrixProducts::Number& x) { return abs(Number(x)) <= tolerance_; };
  return small(f.a.y) && small(f.b.x) && small(f.b.y);
}

bool DirichletSearch::is_identity(Id x) const {
  const Isometry<MatrixProducts::Number> f = products_.value(x);
  if (is_identity(f)) return true;
  // No element of a group that anybody has in decimals is so near to 1.
  constexpr double kNear = 0.02;
  const double error = 4 * products_.error(x);
  const auto off = static_cast<double>(MatrixProducts::Number(abs(f.a.y) + sqrt(norm(f.b))));
  if (off > error) return false;
  if (error > kNear) throw CoarseNumbers{x, error};
  return true;
}

void DirichletSearch::add(Id x) {
  for (const Id id : {x, -x}) {
    const Isometry<Number> element = convert<Number>(products_.value(id));
    hull_.push_back({id, element, element.a / conj(element.b)});
  }
}

/// Keeps the elements of which the bisector meets the domain; others are pending again.
void DirichletSearch::make_hull() {
  const std::vector<Side> before = hull_;
  for (bool changed = true; changed;) {
    std::erase_if(hull_, [](const Side& side) { return side.id == 0; });
    hull_.insert(hull_.end(), tangents_.begin(), tangents_.end());
    hull_ = convex_hull(std::move(hull_));
    std::vector<Side> visible;
    for (std::size_t i = 0; i < hull_.size(); ++i) {
      if (hull_[i].id == 0 || !ends_of_side(i).empty()) visible.push_back(hull_[i]);
    }
    changed = visible.size() < hull_.size();
    hull_ = std::move(visible);
  }
  for (const Side& side : before) {
    const Id id = std::abs(side.id);
    const auto is_same = [&](const Side& other) { return std::abs(other.id) == id; };
    if (id == 0 || std::any_of(hull_.begin(), hull_.end(), is_same)) continue;
    if (std::find(pending_.begin(), pending_.end(), id) == pending_.end()) pending_.push_back(id);
  }
}

/// Returns the side beyond which a point lies farthest; nothing if it is in the domain.
std::optional<std::size_t> DirichletSearch::violated(const Vector& point) const {
  std::optional<std::size_t> worst;
  Number most = tolerance_;
  for (std::size_t i = 0; i < hull_.size(); ++i) {
    if (hull_[i].id == 0) continue;
    const Number excess = (point.x * hull_[i].pole.x + point.y * hull_[i].pole.y) / point.t - 1;
    if (excess <= most) continue;
    most = excess;
    worst = i;
  }
  return worst;
}

/// Elements that are not products of sides become sides.
void DirichletSearch::reduce_pending() {
  while (!pending_.empty()) {
    Id x = pending_.back();
    pending_.pop_back();
    const Vector origin{Number(0), Number(0), Number(1)};
    while (!is_identity(x)) {
      const auto i = violated(image(convert<Number>(products_.value(x)), origin));
      if (!i) {
        examine_(x);
        add(x);
        make_hull();
        // Where numbers are coarse, some sides may take each other's place for ever.
        constexpr int kMostInVain = 1000;
        in_vain_ = products_.size() == products_before_ ? in_vain_ + 1 : 0;
        products_before_ = products_.size();
        if (in_vain_ > kMostInVain) throw CoarseNumbers{x, products_.error(x)};
        break;
      }
      if (products_.size() > kMostElements) return;
      x = products_.product(-hull_[*i].id, x);
    }
  }
}

/// The common point of the lines of side i and the next one, perhaps outside of the disk.
DirichletSearch::Vector DirichletSearch::vertex(std::size_t i) const {
  const Complex<Number>& p = hull_[i].pole;
  const Complex<Number>& q = hull_[(i + 1) % hull_.size()].pole;
  const Number scale = 1 / cross(p, q);
  return {scale * (q.y - p.y), scale * (p.x - q.x), Number(1)};
}

/// The ends of a side, of those in the disk or on the circle; none if it lies outside.
std::vector<DirichletSearch::Vector> DirichletSearch::ends_of_side(std::size_t i) const {
  const Complex<Number>& pole = hull_[i].pole;
  const Number size = norm(pole);
  const Complex<Number> foot = Number(1 / size) * pole;
  const Number half_chord = sqrt(Number(1 - 1 / size));
  const Complex<Number> along = Number(1 / sqrt(size)) * Complex<Number>{Number(-pole.y), pole.x};
  const auto place = [&](const Vector& v) { return v.x * along.x + v.y * along.y; };
  const Number first = std::max(place(vertex(i == 0 ? hull_.size() - 1 : i - 1)), Number(-half_chord));
  const Number last = std::min(place(vertex(i)), half_chord);
  std::vector<Vector> result;
  if (first >= last) return result;
  for (const Number& end : {first, last}) {
    const Complex<Number> u = foot + end * along;
    result.push_back({u.x, u.y, Number(1)});
  }
  return result;
}

/// Elements whose bisectors cut off an end of a side, because the side that it is paired with ends elsewhere.
std::vector<DirichletSearch::Id> DirichletSearch::misfits() const {
  std::vector<Id> result;
  std::vector<Complex<Number>> poles;
  for (std::size_t i = 0; i < hull_.size(); ++i) {
    if (hull_[i].id == 0) continue;
    for (const Vector& end : ends_of_side(i)) {
      const auto other = violated(in_klein(image(inverse(hull_[i].element), end)));
      if (!other || hull_[*other].id == -hull_[i].id) continue;
      const Isometry<Number> f = hull_[i].element * hull_[*other].element;
      const Complex<Number> new_pole = f.a / conj(f.b);
      const bool known = std::any_of(poles.begin(), poles.end(), [&](const Complex<Number>& p) {
        return norm(p - new_pole) <= tolerance_ * tolerance_;
      });
      if (known) continue;
      poles.push_back(new_pole);
      const Isometry<Number> g = inverse(f);
      poles.push_back(g.a / conj(g.b));
      result.push_back(products_.product(hull_[i].id, hull_[*other].id));
    }
  }
  return result;
}

DirichletSearch::End DirichletSearch::run() {
  for (Id k = 1; k <= static_cast<Id>(products_.generators()); ++k) pending_.push_back(k);
  for (;;) {
    reduce_pending();
    if (products_.size() > kMostElements) return End::limit;
    const std::vector<Id> more = misfits();
    if (more.empty()) return classify();
    for (const Id x : more) {
      examine_(x);
      add(x);
    }
    make_hull();
  }
}

DirichletSearch::End DirichletSearch::classify() {
  ids_.clear();
  partner_.clear();
  const auto count = static_cast<std::uint32_t>(hull_.size());
  for (const Side& side : hull_) ids_.push_back(side.id);
  for (const Id id : ids_) {
    const auto place = std::find(ids_.begin(), ids_.end(), -id);
    partner_.push_back(static_cast<std::uint32_t>(place - ids_.begin()));
  }
  bool is_free = false;
  bool fits = true;
  std::optional<std::uint32_t> cusp;
  for (std::uint32_t i = 0; i < count; ++i) {
    const Vector v = vertex(i);
    const Number outside = v.x * v.x + v.y * v.y - 1;
    const bool real = ids_[i] != 0 && ids_[(i + 1) % count] != 0;
    if (real && abs(outside) <= tolerance_) {
      cusp = i;
    } else if (!real || outside > 0) {
      is_free = true;
    }
    fits = fits && ids_[i] != 0 && partner_[i] < count;
  }
  // What fixes vertex i: back across the side after it, until one is at vertex i again.
  const auto around = [&](std::uint32_t i) {
    std::pair<Id, std::uint32_t> result{0, 0};
    std::uint32_t j = i;
    do {
      const std::uint32_t next = (j + 1) % count;
      if (ids_[next] == 0 || partner_[next] >= count || result.second > count)
        return std::pair<Id, std::uint32_t>{0, 0};
      result.first = result.first == 0 ? -ids_[next] : products_.product(-ids_[next], result.first);
      ++result.second;
      j = partner_[next];
    } while (j != i);
    return result;
  };
  if (cusp) {
    element_ = around(*cusp).first;
    return End::cusp;
  }
  if (is_free) return End::free_side;
  if (!fits) return End::degenerate;
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto [element, lifts] = around(i);
    if (element == 0) return End::degenerate;
    if (!is_identity(element)) {
      element_ = element;
      return End::torsion;
    }
    if (lifts != 3) return End::degenerate;
  }
  return End::compact;
}

std::optional<std::vector<std::uint32_t>> DirichletSearch::factors(Id x) const {
  std::vector<std::uint32_t> result;
  for (Id rest = x; !is_identity(rest);) {
    const auto i = violated(image(convert<Number>(products_.value(rest)), Vector{Number(0), Number(0), Number(1)}));
    if (!i || result.size() > kMostElements) return std::nullopt;
    result.push_back(static_cast<std::uint32_t>(*i));
    rest = products_.product(-ids_[*i], rest);
  }
  return result;
}

}  // namespace epsnet
