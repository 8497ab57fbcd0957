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

namespace {

/// Comparisons of points that differ, of which some squares may have many, as in very thin collars: some seconds.
constexpr std::size_t kMostDifferent = 3'000'000;
/// Darts that are followed, for each lift that may be found: many start at a vertex of a net with few vertices.
constexpr long kDartsOfALift = 24;
constexpr double kSquares = 1L << 30;
constexpr double kError = 1.0 / (1L << 8);  ///< Of a place, in squares.

/// Where a point is in the table, wrong by less than kError: the quotient of two numbers that are known to 2⁻⁴² of |d|,
/// part by part, is wrong by less than 2⁻⁴⁰. Nothing if they are not known as well.
template <class Number>
std::optional<std::array<double, 2>> in_squares(const PlaceOf<Number>& place) {
  const std::array<const Number*, 4> ends{&place.n.re, &place.n.im, &place.d.re, &place.d.im};
  std::array<double, 4> x{};
  double width = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    x.at(i) = ends.at(i)->lower();
    width = std::max(width, ends.at(i)->upper() - x.at(i));
  }
  const double d = x[2] * x[2] + x[3] * x[3];
  if (!(width < std::ldexp(std::sqrt(d), -42))) return std::nullopt;
  return std::array{kSquares * (x[0] * x[2] + x[1] * x[3]) / d, kSquares * (x[1] * x[2] - x[0] * x[3]) / d};
}

template <class Number>
std::array<double, 2> known_in_squares(const PlaceOf<Number>& place) {
  const auto result = in_squares(place);
  if (!result) give_up("a point is not known well enough");
  return *result;
}

}  // namespace

template <class Number>
void PointTable::insert(Index vertex, const PlaceOf<Number>& place, std::size_t number) {
  const auto [x, y] = known_in_squares(place);
  numbers_[{vertex, std::lround(x), std::lround(y)}].push_back(number);
}

void PointTable::for_each_near(Index vertex, const std::array<double, 2>& in_squares,
                               const std::function<bool(std::size_t)>& use) const {
  const auto& [x, y] = in_squares;
  for (long i = std::lround(x - 2 * kError); i <= std::lround(x + 2 * kError); ++i) {
    for (long j = std::lround(y - 2 * kError); j <= std::lround(y + 2 * kError); ++j) {
      const auto found = numbers_.find({vertex, i, j});
      if (found == numbers_.end()) continue;
      for (const std::size_t number : found->second) {
        if (!use(number)) return;
      }
    }
  }
}

void PointTable::count_different() const {
  if (++different_ > kMostDifferent) throw LeftOut{"so many lifts of vertices near each other"};
}

std::optional<std::size_t> PointTable::find(Index vertex, const Place& place,
                                            const std::function<Answer(std::size_t)>& is_same) const {
  std::optional<std::size_t> result;
  for_each_near(vertex, known_in_squares(place), [&](std::size_t number) {
    if (decided(is_same(number), "whether two lifts of a vertex are the same")) {
      result = number;
    } else {
      count_different();
    }
    return !result;
  });
  return result;
}

PointTable::Found PointTable::find_roughly(Index vertex, const RoughPlace& place,
                                           const std::function<Answer(std::size_t)>& is_same) const {
  const auto squares = in_squares(place);
  if (!squares) return {Answer::unknown, 0};
  Found result{Answer::no, 0};
  for_each_near(vertex, *squares, [&](std::size_t number) {
    result = {is_same(number), number};
    if (result.answer == Answer::no) count_different();
    return result.answer == Answer::no;
  });
  return result;
}

template <class R>
Loops<R>::Loops(NetRules<R>& net, const Interval& bound, long most_lifts)
    : net_(net),
      bound_(bound),
      thick_(1 + square(sinh(Interval(net.net().epsilon)))),
      reach_(bound * thick_),
      rough_reach_(reach_),
      lifts_left_(most_lifts),
      darts_left_(kDartsOfALift * most_lifts) {
  prepare();
  for (Index v = 0; v < origin_.size(); ++v) find_at(v);
  join_all();
}

template <class R>
void Loops<R>::prepare() {
  const Net& net = net_.net();
  // As many lifts as fit into so many disks by area: 2π(cosh D − 1), cosh D = 1 + 2 sinh²(D/2), of −2πχ each V. From
  // each lift of a vertex its darts lead on.
  const auto vertices = static_cast<long>(net.vertices.size());
  const auto minus_euler = static_cast<long>(net.triangles.size() / 2) - vertices;
  const Interval lifts_of_each = 2 * reach_ * vertices / minus_euler;
  if (is_less(Interval(lifts_left_), lifts_of_each * vertices) == Answer::yes ||
      is_less(Interval(darts_left_), lifts_of_each * static_cast<long>(net_.darts())) == Answer::yes)
    leave_loops_out();
  leaving_.resize(net.vertices.size());
  for (const Vertex& vertex : net.vertices) {
    const auto m = enclosure(vertex.z.m);
    origin_.push_back({enclosure(vertex.z.n.re) / m, enclosure(vertex.z.n.im) / m});
    rough_origin_.push_back(rounded(origin_.back()));
    gap_.push_back(enclosure(gap(vertex.z)) / square(m));
    rough_gap_.emplace_back(gap_.back());
  }
  std::optional<std::array<R, 2>> shortest;
  for (Index dart = 0; dart < net_.darts(); ++dart) {
    const Index end = net_.start(next(dart));
    leaving_[net_.start(dart)].push_back(dart);
    const Motion motion = enclose(net_.element(dart));
    const Place place = image(motion, self(end));
    steps_.push_back({end, motion, place, rounded(motion), rounded(place)});
    const Point<R> p = net_.corner(dart);
    const Point<R> q = net_.corner(next(dart));
    std::array<R, 2> half{squared_difference(p, q), R(gap(p) * gap(q))};
    if (!shortest || sgn(R(half[0] * (*shortest)[1] - (*shortest)[0] * half[1])) < 0) shortest = std::move(half);
  }
  for (const Interval& gap : gap_) {
    apart_.push_back(enclosure((*shortest)[0]) / enclosure((*shortest)[1]) * square(gap));
    rough_apart_.emplace_back(apart_.back());
  }
}

template <class R>
Answer Loops<R>::is_left_out(Index v, const RoughPlace& place, Index w, const RoughInterval& farthest,
                             const std::deque<Lift>& lifts, const PointTable& known) const {
  const Answer far = is_less(farthest, norm(place.n - rough_origin_[v] * place.d));
  if (far == Answer::yes) return far;
  const auto is_same = [&](std::size_t k) { return are_same(lifts[k].rough_place, place, w); };
  return either(far, known.find_roughly(w, place, is_same).answer);
}

template <class R>
std::deque<typename Loops<R>::Lift> Loops<R>::lifts(Index first, const Interval& reach) {
  std::vector<Interval> farthest;
  std::vector<RoughInterval> rough_farthest;
  for (const Interval& gap : gap_) {
    farthest.push_back(reach * gap * gap_[first]);
    rough_farthest.emplace_back(farthest.back());
  }
  std::deque<Lift> lifts;
  PointTable table;
  lifts.push_back({first, {}, 0, 0, {}, rounded(self(first))});
  table.insert(first, lifts[0].rough_place, 0);
  for (std::size_t i = 0; i < lifts.size(); ++i) {
    darts_left_ -= static_cast<long>(leaving_[lifts[i].vertex].size());
    if (darts_left_ < 0) leave_loops_out();
    for (const Index dart : leaving_[lifts[i].vertex]) {
      const Step& step = steps_[dart];
      const Index v = step.end;
      RoughPlace rough_place = image(lifts[i].rough_frame, step.rough_place);
      const Answer left_out = is_left_out(first, rough_place, v, rough_farthest[v], lifts, table);
      if (left_out == Answer::yes) continue;
      if (left_out == Answer::unknown) {
        const Place place = image(lifts[i].frame, step.place);
        if (is_less(farthest[v], moved(first, place)) == Answer::yes) continue;
        if (table.find(v, place, [&](std::size_t k) { return are_same(this->place(lifts[k]), place, v); })) continue;
        rough_place = rounded(place);
      }
      if (--lifts_left_ < 0) leave_loops_out();
      table.insert(v, rough_place, lifts.size());
      const Motion frame = compose(lifts[i].frame, step.motion);
      lifts.push_back({v, frame, i, dart, rounded(frame), rough_place});
    }
  }
  return lifts;
}

template <class R>
void Loops<R>::find_at(Index first) {
  const std::deque<Lift> lifts = this->lifts(first, reach_);
  const std::size_t empty = paths_.size();
  for (const Lift& lift : lifts) paths_.push_back({empty + lift.parent, lift.dart});
  for (std::size_t i = 1; i < lifts.size(); ++i) {
    const Lift& lift = lifts[i];
    if (lift.vertex != first ||
        !decided(is_less(squared_half_length(lift.frame), bound_), "whether a loop is too long"))
      continue;
    Loop loop{first, lift.frame, place(lift), empty + i, 0, lift.rough_frame, lift.rough_place};
    table_.insert(first, loop.place, loops_.size());
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
PointTable::Found Loops<R>::along_roughly(std::size_t i, Index dart) const {
  const Step& step = steps_[dart];
  const Index v = step.end;
  const RoughPlace place = image(inverse(step.rough_motion), image(loops_[i].rough_g, step.rough_place));
  const Answer far = is_less(rough_reach_ * rough_gap_[v] * rough_gap_[v], norm(place.n - rough_origin_[v] * place.d));
  if (far == Answer::yes) return {Answer::no, 0};
  // One of them, or none because the place is perhaps farther than those that are known.
  const auto found =
      table_.find_roughly(v, place, [&](std::size_t k) { return are_same(loops_[k].rough_place, place, v); });
  return found.answer == Answer::yes ? found : PointTable::Found{Answer::unknown, 0};
}

template <class R>
std::optional<std::size_t> Loops<R>::along(std::size_t i, Index dart) const {
  if (const auto found = along_roughly(i, dart); found.answer != Answer::unknown) {
    return found.answer == Answer::yes ? std::optional(found.number) : std::nullopt;
  }
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
  for (std::size_t k = loop.path; paths_[k].before != k; k = paths_[k].before)
    result = net_.product(net_.element(paths_[k].dart), result);
  return result;
}

template class Loops<mpz_class>;
template class Loops<Algebraic>;
template class Loops<FieldNumber>;

}  // namespace epsnet::exact
