#include "certify/exact/loops.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace epsnet::exact {

void give_up(const std::string& why) { throw TooLarge{why}; }
void leave_loops_out() { throw LeftOut{"so many loops of such lengths"}; }

bool decided(Answer answer, const char* what) {
  if (answer == Answer::unknown) give_up(std::string(what) + " is not decided by the digits used");
  return answer == Answer::yes;
}

Place image(const Motion& g, const Place& z) {
  return {g.a * z.n + g.b * z.d, conjugate(g.b) * z.n + conjugate(g.a) * z.d};
}

namespace {

/// Comparisons of points that differ, of which some squares may have many, as in very thin collars: some seconds.
constexpr std::size_t kMostDifferent = 3'000'000;
constexpr double kSquares = 1L << 30;
constexpr double kError = 1.0 / (1L << 8);  ///< Of a place, in squares.

/// Where a point is in the table, wrong by less than kError: the quotients of numbers that are known to 2⁻⁴⁵ of |d|.
std::array<double, 2> in_squares(const Place& place) {
  const std::array<const Interval*, 4> ends{&place.n.re, &place.n.im, &place.d.re, &place.d.im};
  std::array<double, 4> x{};
  double width = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    x.at(i) = ends.at(i)->lower();
    width = std::max(width, ends.at(i)->upper() - x.at(i));
  }
  const double d = x[2] * x[2] + x[3] * x[3];
  if (!(width < std::ldexp(std::sqrt(d), -45))) give_up("a point is not known well enough");
  return {kSquares * (x[0] * x[2] + x[1] * x[3]) / d, kSquares * (x[1] * x[2] - x[0] * x[3]) / d};
}

}  // namespace

void PointTable::insert(Index vertex, const Place& place, std::size_t number) {
  const auto [x, y] = in_squares(place);
  numbers_[{vertex, std::lround(x), std::lround(y)}].push_back(number);
}

std::optional<std::size_t> PointTable::find(Index vertex, const Place& place,
                                            const std::function<Answer(std::size_t)>& is_same) const {
  const auto [x, y] = in_squares(place);
  for (long i = std::lround(x - 2 * kError); i <= std::lround(x + 2 * kError); ++i) {
    for (long j = std::lround(y - 2 * kError); j <= std::lround(y + 2 * kError); ++j) {
      const auto found = numbers_.find({vertex, i, j});
      if (found == numbers_.end()) continue;
      for (const std::size_t number : found->second) {
        if (decided(is_same(number), "whether two lifts of a vertex are the same")) return number;
        if (++different_ > kMostDifferent) leave_loops_out();
      }
    }
  }
  return std::nullopt;
}

template <class R>
Loops<R>::Loops(NetRules<R>& net, const Interval& bound, long most_lifts)
    : net_(net),
      bound_(bound),
      thick_(1 + square(sinh(Interval(net.net().epsilon)))),
      reach_(bound * thick_),
      lifts_left_(most_lifts) {
  prepare();
  for (Index v = 0; v < origin_.size(); ++v) find_at(v);
  join_all();
}

template <class R>
void Loops<R>::prepare() {
  const Net& net = net_.net();
  // As many lifts as fit into so many disks by area: 2π(cosh D − 1), cosh D = 1 + 2 sinh²(D/2), of −2πχ each V.
  const auto vertices = static_cast<long>(net.vertices.size());
  const auto minus_euler = static_cast<long>(net.triangles.size() / 2) - vertices;
  if (is_less(Interval(lifts_left_), 2 * reach_ * vertices * vertices / minus_euler) == Answer::yes) leave_loops_out();
  leaving_.resize(net.vertices.size());
  for (const Vertex& vertex : net.vertices) {
    const auto m = enclosure(vertex.z.m);
    origin_.push_back({enclosure(vertex.z.n.re) / m, enclosure(vertex.z.n.im) / m});
    gap_.push_back(enclosure(gap(vertex.z)) / square(m));
  }
  std::optional<std::array<R, 2>> shortest;
  for (Index dart = 0; dart < net_.darts(); ++dart) {
    const Index end = net_.start(next(dart));
    leaving_[net_.start(dart)].push_back(dart);
    const Motion motion = enclose(net_.element(dart));
    steps_.push_back({end, motion, image(motion, self(end))});
    const Point<R> p = net_.corner(dart);
    const Point<R> q = net_.corner(next(dart));
    std::array<R, 2> half{squared_difference(p, q), R(gap(p) * gap(q))};
    if (!shortest || sgn(R(half[0] * (*shortest)[1] - (*shortest)[0] * half[1])) < 0) shortest = std::move(half);
  }
  for (const Interval& gap : gap_) {
    apart_.push_back(enclosure((*shortest)[0]) / enclosure((*shortest)[1]) * square(gap));
  }
}

template <class R>
std::vector<typename Loops<R>::Lift> Loops<R>::lifts(Index first, const Interval& reach) {
  std::vector<Interval> farthest;
  for (const Interval& gap : gap_) farthest.push_back(reach * gap * gap_[first]);
  std::vector<Lift> lifts{{first, {}, self(first), 0, 0}};
  PointTable table;
  table.insert(first, lifts[0].place, 0);
  for (std::size_t i = 0; i < lifts.size(); ++i) {
    for (const Index dart : leaving_[lifts[i].vertex]) {
      const Step& step = steps_[dart];
      const Place place = image(lifts[i].frame, step.place);
      if (is_less(farthest[step.end], moved(first, place)) == Answer::yes) continue;
      if (table.find(step.end, place, [&](std::size_t k) { return are_same(lifts[k].place, place, step.end); }))
        continue;
      if (--lifts_left_ < 0) leave_loops_out();
      table.insert(step.end, place, lifts.size());
      lifts.push_back({step.end, compose(lifts[i].frame, step.motion), place, i, dart});
    }
  }
  return lifts;
}

template <class R>
void Loops<R>::find_at(Index first) {
  const std::vector<Lift> lifts = this->lifts(first, reach_);
  for (std::size_t i = 1; i < lifts.size(); ++i) {
    const Lift& lift = lifts[i];
    if (lift.vertex != first ||
        !decided(is_less(squared_half_length(lift.frame), bound_), "whether a loop is too long"))
      continue;
    Loop loop{first, lift.frame, lift.place, {}};
    for (std::size_t k = i; k != 0; k = lifts[k].parent) loop.darts.push_back(lifts[k].dart);
    table_.insert(first, lift.place, loops_.size());
    loops_.push_back(std::move(loop));
  }
}

/// Joins inverse elements, and those that an edge takes to each other.
template <class R>
void Loops<R>::join_all() {
  parent_.resize(loops_.size());
  std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  const auto join = [&](std::size_t i, std::size_t j) {
    i = representative(i);
    j = representative(j);
    parent_[std::max(i, j)] = std::min(i, j);
  };
  for (std::size_t i = 0; i < loops_.size(); ++i) {
    Loop& loop = loops_[i];
    loop.inverse = at(loop.vertex, image(inverse(loop.g), self(loop.vertex)));
    join(i, loop.inverse);
    for (const Index dart : leaving_[loop.vertex]) {
      if (const auto other = along(i, dart)) join(i, *other);
    }
  }
  members_.resize(loops_.size());
  for (std::size_t i = 0; i < loops_.size(); ++i) members_[representative(i)].push_back(i);
}

template <class R>
std::size_t Loops<R>::representative(std::size_t i) const {
  for (; parent_[i] != i; i = parent_[i]) parent_[i] = parent_[parent_[i]];
  return i;
}

template <class R>
std::optional<std::size_t> Loops<R>::along(std::size_t i, Index dart) const {
  const Step& step = steps_[dart];
  const Place place = image(inverse(step.motion), image(loops_[i].g, step.place));
  return is_reached(step.end, place) ? std::optional(at(step.end, place)) : std::nullopt;
}

template <class R>
std::size_t Loops<R>::at(Index v, const Place& place) const {
  const auto found = table_.find(v, place, [&](std::size_t i) { return are_same(loops_[i].place, place, v); });
  if (!found) give_up("a loop at vertex " + number(v) + " is nearly as long as the longest that are looked for");
  return *found;
}

template <class R>
bool Loops<R>::is_near_axis(std::size_t i) const {
  const Loop& loop = loops_[i];
  const Interval least = squared_half_length(loop.g) * thick_;
  return is_less(least, half_distance(loop.vertex, loop.place, loop.vertex)) != Answer::yes;
}

template <class R>
Isometry<R> Loops<R>::exact(const Loop& loop) const {
  Isometry<R> result;
  for (const Index dart : loop.darts) result = net_.product(net_.element(dart), result);
  return result;
}

template class Loops<mpz_class>;
template class Loops<Algebraic>;
template class Loops<FieldNumber>;

}  // namespace epsnet::exact
