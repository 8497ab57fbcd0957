#include <algorithm>
#include <atomic>
#include <bit>
#include <cassert>
#include <cstddef>
#include <thread>
#include <utility>

#include "netgen/nets/refine.h"
#include "triangulation/mesh/insertion.h"
#include "triangulation/mesh/triangulation.h"
#include "triangulation/surface/atlas.h"

#ifdef EPSNET_ONE_THREAD
#include <functional>
#include <queue>
#include <utility>
#else
#include <oneapi/tbb/concurrent_queue.h>
#include <oneapi/tbb/enumerable_thread_specific.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_pipeline.h>
#include <oneapi/tbb/task_arena.h>
#endif

#ifdef EPSNET_THREAD_SANITIZER
#include <sanitizer/tsan_interface.h>
#endif

namespace epsnet {
namespace {

// The threads of a refinement in parts: those of oneTBB, or the calling one alone where there are no others
// (EPSNET_ONE_THREAD). The only place that knows the difference.

// The thread sanitizer does not see inside oneTBB and must be told the order of events: everything that a thread did
// before it passed an object on happens before what the receiving thread does.
#ifdef EPSNET_THREAD_SANITIZER
inline void receive(void* something) { __tsan_acquire(something); }
inline void hand_on(void* something) { __tsan_release(something); }
#else
inline void receive(void* /*something*/) {}
inline void hand_on(void* /*something*/) {}
#endif

#ifdef EPSNET_ONE_THREAD

/// An object for each thread, made when that thread first asks for it.
template <class T>
class ForEachThread {
 public:
  explicit ForEachThread(const std::function<T()>& make) : object_(make()) {}
  [[nodiscard]] T& local() { return object_; }

 private:
  T object_;
};

/// A queue that threads share.
template <class T>
class SharedQueue {
 public:
  void push(T item) { queue_.push(std::move(item)); }
  /// Returns whether there was an item.
  [[nodiscard]] bool try_pop(T& item) {
    if (queue_.empty()) return false;
    item = std::move(queue_.front());
    queue_.pop();
    return true;
  }

 private:
  std::queue<T> queue_;
};

/// Runs the function with this many threads.
template <class Function>
auto with_threads(unsigned /*threads*/, const Function& function) {
  return function();
}

/// The number of threads here.
[[nodiscard]] inline int threads_here() { return 1; }

/// For each k < count calls last(middle(first(k))): the middle calls one at a time, in the order of k, the others
/// concurrently. At most `tokens` numbers are on their way at once.
template <class Item, class First, class Middle, class Last>
void pipeline(std::uint32_t count, std::size_t /*tokens*/, const First& first, const Middle& middle, const Last& last) {
  for (std::uint32_t k = 0; k < count; ++k) last(middle(first(k)));
}

#else

template <class T>
using ForEachThread = oneapi::tbb::enumerable_thread_specific<T>;

template <class T>
using SharedQueue = oneapi::tbb::concurrent_queue<T>;

template <class Function>
auto with_threads(unsigned threads, const Function& function) {
  // As many threads as requested, even on fewer cores.
  const oneapi::tbb::global_control control(oneapi::tbb::global_control::max_allowed_parallelism, threads);
  oneapi::tbb::task_arena arena(static_cast<int>(threads));
  return arena.execute(function);
}

[[nodiscard]] inline int threads_here() { return oneapi::tbb::this_task_arena::max_concurrency(); }

template <class Item, class First, class Middle, class Last>
void pipeline(std::uint32_t count, std::size_t tokens, const First& first, const Middle& middle, const Last& last) {
  namespace tbb = oneapi::tbb;
  std::uint32_t next = 0;
  hand_on(&next);
  const auto choose = [&](tbb::flow_control& flow) {
    receive(&next);
    if (next == count) flow.stop();
    const std::uint32_t k = next++;
    hand_on(&next);
    return k;
  };
  tbb::parallel_pipeline(tokens, tbb::make_filter<void, std::uint32_t>(tbb::filter_mode::serial_in_order, choose) &
                                     tbb::make_filter<std::uint32_t, Item>(tbb::filter_mode::parallel, first) &
                                     tbb::make_filter<Item, Item>(tbb::filter_mode::serial_in_order, middle) &
                                     tbb::make_filter<Item, void>(tbb::filter_mode::parallel, last));
}

#endif

constexpr std::uint32_t kNone = ~std::uint32_t{0};

/// The number of new vertices planned for a part: its memory then fits into the cache of a core.
constexpr double kVerticesOfPart = 1 << 15;
/// The number of pending triangles planned for a part along the boundaries of earlier ones. Such a part gets fewer
/// vertices; with this number it is much longer than wide, so that little is left at its ends.
constexpr double kPendingOfPart = 1 << 12;
/// The number of steps by which parts reach beyond their pending triangles.
constexpr unsigned kMargin = 2;
/// The second round processes the boundaries of the first round's parts. A third would find little.
constexpr unsigned kRounds = 2;

/// Triangles, each in one part or none.
struct Partition {
  struct Place {
    std::uint32_t part = kNone;
    TriangleId number{0};  ///< Its number in the part.
  };
  ById<TriangleId, Place> place;
  std::vector<ById<TriangleId, TriangleId>> members;  ///< By part: its triangles, by their numbers in the part.
};

/// Returns which triangles are within `kMargin` steps of the given ones.
ById<TriangleId, bool> zone_around(const Mesh& mesh, std::span<const TriangleId> triangles) {
  ById<TriangleId, bool> in_zone(mesh.triangles.size());
  std::vector<TriangleId> ring(triangles.begin(), triangles.end());
  for (const TriangleId t : ring) in_zone[t] = true;
  for (unsigned step = 0; step < kMargin; ++step) {
    std::vector<TriangleId> beyond;
    for (const TriangleId t : ring) {
      for (const Dart d : mesh.triangles[t].opposite) {
        const TriangleId s = triangle_of(d);
        if (!in_zone[s]) {
          in_zone[s] = true;
          beyond.push_back(s);
        }
      }
    }
    ring = std::move(beyond);
  }
  return in_zone;
}

/// Assigns the triangles of a zone to the seed that is the fewest steps away: breadth first from all seeds.
Partition partition(const Mesh& mesh, std::span<const TriangleId> seeds, const ById<TriangleId, bool>& zone) {
  Partition result;
  result.place.resize(mesh.triangles.size());
  std::vector<TriangleId> met;
  const auto meet = [&](TriangleId t, std::uint32_t part) {
    if (!zone[t] || result.place[t].part != kNone) return;
    result.place[t].part = part;
    met.push_back(t);
  };
  for (std::uint32_t k = 0; k < seeds.size(); ++k) meet(seeds[k], k);
  for (std::size_t i = 0; i < met.size(); ++i) {
    for (const Dart d : mesh.triangles[met[i]].opposite) meet(triangle_of(d), result.place[met[i]].part);
  }
  result.members.resize(seeds.size());
  for (const TriangleId t : met) {
    ById<TriangleId, TriangleId>& members = result.members[result.place[t].part];
    result.place[t].number = members.end_id();
    members.push_back(t);
  }
  return result;
}

/// Numbers the vertices of a part in the order in which they are met: a table with open addressing.
class VertexNumbers {
 public:
  /// Has room for this many vertices.
  explicit VertexNumbers(std::size_t most)
      : bits_(static_cast<unsigned>(std::bit_width(most)) + 1),
        table_(std::size_t{1} << bits_, {kNoVertex, VertexId(0)}) {}
  [[nodiscard]] VertexId operator()(VertexId v) {
    constexpr std::uint64_t kGolden = 0x9e3779b97f4a7c15;  // Multiplicative hashing.
    auto i = static_cast<std::size_t>((v.number() * kGolden) >> (64 - bits_));
    while (table_[i].first != v) {
      if (table_[i].first == kNoVertex) {
        table_[i] = {v, met_.end_id()};
        met_.push_back(v);
        break;
      }
      i = (i + 1) & (table_.size() - 1);
    }
    return table_[i].second;
  }
  [[nodiscard]] ById<VertexId, VertexId> take() { return std::move(met_); }

 private:
  static constexpr VertexId kNoVertex{kNone};

  unsigned bits_;
  std::vector<std::pair<VertexId, VertexId>> table_;
  ById<VertexId, VertexId> met_;
};

/// The vertices and triangles of the whole triangulation. Their vectors grow at their ends while parts are refined,
/// but do not move, as they have enough room.
class Whole {
 public:
  explicit Whole(Mesh& mesh)
      : points_(mesh.points.data()), charts_(mesh.charts.data()), triangles_(mesh.triangles.data()) {}

  [[nodiscard]] Complex<double>& point(VertexId v) const { return points_[v.number()]; }
  [[nodiscard]] ChartId& chart(VertexId v) const { return charts_[v.number()]; }
  [[nodiscard]] Triangle& triangle(TriangleId t) const { return triangles_[t.number()]; }

 private:
  Complex<double>* points_;
  ChartId* charts_;
  Triangle* triangles_;
};

/// A part of a triangulation with its own numbering: first the triangles and vertices that it had at the beginning,
/// then the new ones. Darts that lead out of it are kOutside. An object can be reused, which saves allocations.
class Part {
 public:
  /// Copies the triangles of a part and the darts between them. `list` has its pending triangles, by their numbers in
  /// the part.
  void take(const Whole& whole, const Partition& partition, std::uint32_t part, std::span<const TriangleId> list) {
    triangles_ = partition.members[part];
    pending_.clear();
    flips_ = 0;
    forgotten_ = false;
    mesh_.points.clear();
    mesh_.charts.clear();
    mesh_.triangles.clear();
    VertexNumbers number(3 * triangles_.size());
    for (const TriangleId t : triangles_) {
      Triangle triangle = whole.triangle(t);
      for (VertexId& v : triangle.vertex) v = number(v);
      for (Dart& d : triangle.opposite) {
        const Partition::Place place = partition.place[triangle_of(d)];
        d = place.part == part ? make_dart(place.number, corner_of(d)) : kOutside;
      }
      mesh_.triangles.push_back(triangle);
    }
    vertices_ = number.take();
    for (const VertexId v : vertices_) {
      mesh_.points.push_back(whole.point(v));
      mesh_.charts.push_back(whole.chart(v));
    }
    list_given_ = list;
    for (const TriangleId t : list) list_.push({&t, 1});
  }

  void refine(KnownLabels& labels, const Threshold& apart, const Threshold& large) {
    NewTriangles made;
    while (list_.size() > 0) {
      const TriangleId t = list_.pop();
      if (!mesh_.triangles[t].marked()) continue;
      const auto centre = circumcentre_fast(mesh_, labels.atlas(), t);
      const auto insert = [&] {
        const LiftedPoint point = in_nearest_chart(mesh_, labels.atlas(), t, *centre);
        return norm(point.z) <= kChartRadius * kChartRadius &&
               insert_locally(mesh_, labels, t, point, apart, large, made);
      };
      if (!centre || !insert()) {
        pending_.push_back(t);
        continue;
      }
      list_.push({made.large_slots.data(), made.large_count});
      for (std::uint32_t k = 0; k < made.unsure_count; ++k) {
        mesh_.triangles[made.unsure_slots[k]].labels_and_mark |= 1;
        pending_.push_back(made.unsure_slots[k]);
      }
      flips_ += made.count - 3;
    }
  }

  /// Numbers the new vertices and triangles in the order of a breadth-first search, so that neighbours on the surface
  /// are near each other in memory, which makes later passes over the net faster.
  void order() {
    vertex_order_.assign(mesh_.points.size() - vertices_.size(), kNone);
    triangle_order_.assign(mesh_.triangles.size() - triangles_.size(), kNone);
    std::uint32_t vertices = 0;
    std::uint32_t triangles = 0;
    const auto meet = [](std::vector<std::uint32_t>& order, std::size_t i, std::uint32_t& count) {
      const bool is_new = order[i] == kNone;
      if (is_new) order[i] = count++;
      return is_new;
    };
    std::vector<TriangleId>& met = search_;
    met.clear();
    // From every old triangle, visits the new ones that can be reached through new ones alone.
    for (const TriangleId first : triangles_.ids()) {
      met.push_back(first);
      for (std::size_t i = met.size() - 1; i < met.size(); ++i) {
        const Triangle& triangle = mesh_.triangles[met[i]];
        for (const VertexId v : triangle.vertex) {
          if (v >= vertices_.end_id()) (void)meet(vertex_order_, v.number() - vertices_.size(), vertices);
        }
        for (const Dart d : triangle.opposite) {
          const TriangleId t = triangle_of(d);
          if (d != kOutside && t >= triangles_.end_id() &&
              meet(triangle_order_, t.number() - triangles_.size(), triangles)) {
            met.push_back(t);
          }
        }
      }
    }
  }

  [[nodiscard]] std::size_t made_vertices() const { return mesh_.points.size() - vertices_.size(); }
  [[nodiscard]] std::size_t made_triangles() const { return mesh_.triangles.size() - triangles_.size(); }
  [[nodiscard]] std::uint64_t flips() const { return flips_; }

  /// Discards all changes, as there is no room for them.
  void forget() {
    forgotten_ = true;
    pending_.assign(list_given_.begin(), list_given_.end());
    flips_ = 0;
    mesh_.points.resize(vertices_.size());
    mesh_.charts.resize(vertices_.size());
    mesh_.triangles.resize(triangles_.size());
  }
  /// Sets the numbers, in the whole, of the first new vertex and the first new triangle.
  void number_from(std::size_t vertex, std::size_t triangle) {
    first_vertex_ = vertex;
    first_triangle_ = triangle;
    for (TriangleId& t : pending_) t = triangle_number(t);
  }
  /// The triangles still pending, by their numbers in the whole.
  [[nodiscard]] const std::vector<TriangleId>& pending() const { return pending_; }

  /// Writes the part back. Touches only its own triangles and the new vertices and triangles.
  void give_back(const Whole& whole) const {
    if (forgotten_) return;
    for (VertexId v = vertices_.end_id(); v < mesh_.points.end_id(); ++v) {
      whole.point(vertex_number(v)) = mesh_.points[v];
      whole.chart(vertex_number(v)) = mesh_.charts[v];
    }
    for (const TriangleId t : mesh_.triangles.ids()) {
      const Triangle& from = mesh_.triangles[t];
      Triangle& to = whole.triangle(triangle_number(t));
      for (std::uint32_t i = 0; i < 3; ++i) {
        to.vertex[i] = vertex_number(from.vertex[i]);
        // A triangle with a neighbour outside has not changed, and neither has this dart.
        if (from.opposite[i] != kOutside) {
          to.opposite[i] = make_dart(triangle_number(triangle_of(from.opposite[i])), corner_of(from.opposite[i]));
        }
      }
      to.labels_and_mark = from.labels_and_mark;
    }
  }

 private:
  /// The numbers in the whole.
  [[nodiscard]] VertexId vertex_number(VertexId v) const {
    const std::size_t old = vertices_.size();
    return v.number() < old ? vertices_[v] : VertexId(first_vertex_ + vertex_order_[v.number() - old]);
  }
  [[nodiscard]] TriangleId triangle_number(TriangleId t) const {
    const std::size_t old = triangles_.size();
    return t.number() < old ? triangles_[t] : TriangleId(first_triangle_ + triangle_order_[t.number() - old]);
  }

  ById<TriangleId, TriangleId> triangles_;  ///< The numbers in the whole of those that it had at the beginning.
  ById<VertexId, VertexId> vertices_;
  std::vector<std::uint32_t> vertex_order_;    ///< Of the new ones.
  std::vector<std::uint32_t> triangle_order_;  ///< Of the new ones.
  std::vector<TriangleId> search_;
  std::size_t first_vertex_ = 0;
  std::size_t first_triangle_ = 0;
  Mesh mesh_;
  std::span<const TriangleId> list_given_;
  TriangleQueue list_;
  std::vector<TriangleId> pending_;
  bool forgotten_ = false;
  std::uint64_t flips_ = 0;
};

/// Refines the whole triangulation in rounds of parts.
class PartRefinement {
 public:
  PartRefinement(Triangulation& triangulation, const Threshold& apart, const Threshold& large,
                 const PartOptions& options)
      : triangulation_(triangulation),
        mesh_(Editor(triangulation).mesh()),
        apart_(apart),
        large_(large),
        options_(options) {}

  [[nodiscard]] PartResult run(std::vector<TriangleId> pending) {
    result_.pending = std::move(pending);
    for (unsigned k = 0; k < kRounds && !result_.pending.empty(); ++k) round();
    return std::move(result_);
  }

 private:
  /// Refines parts around some of the pending triangles.
  void round() {
    const std::vector<TriangleId> seeds = choose_seeds();
    const Partition parts = partition(mesh_, seeds, zone_around(mesh_, result_.pending));
    // The list of each part keeps the order of the whole list. Triangles in no part stay pending.
    std::vector<std::vector<TriangleId>> lists(seeds.size());
    std::vector<TriangleId> pending;
    for (const TriangleId t : result_.pending) {
      const auto [part, triangle] = parts.place[t];
      if (part == kNone) {
        pending.push_back(t);
      } else {
        lists[part].push_back(triangle);
      }
    }
    const int threads = options_.threads == 0 ? threads_here() : static_cast<int>(options_.threads);
    const auto tokens = 3 * static_cast<std::size_t>(threads);
    const std::thread::id caller = std::this_thread::get_id();
    ForEachThread<KnownLabels> labels([this] { return KnownLabels(triangulation_.atlas()); });
    std::vector<Part> memory(tokens);
    SharedQueue<Part*> idle;
    for (Part& part : memory) {
      idle.push(&part);
      hand_on(&part);
    }
    hand_on(&mesh_);
    const Whole whole(mesh_);
    const auto refine = [&](std::uint32_t k) {
      Part* part = nullptr;
      (void)idle.try_pop(part);  // There are as many as there are tokens, so one is idle.
      receive(part);
      part->take(whole, parts, k, lists[k]);
      part->refine(labels.local(), apart_, large_);
      part->order();
      hand_on(part);
      if (std::this_thread::get_id() == caller) options_.report(vertices_);
      return part;
    };
    const auto number = [&](Part* part) {
      receive(part);
      receive(&mesh_);
      // Other threads read and write their parts meanwhile, so the vectors must not move.
      if (mesh_.points.size() + part->made_vertices() > mesh_.points.capacity() ||
          mesh_.charts.size() + part->made_vertices() > mesh_.charts.capacity() ||
          mesh_.triangles.size() + part->made_triangles() > mesh_.triangles.capacity()) {
        part->forget();
      }
      part->number_from(mesh_.points.size(), mesh_.triangles.size());
      mesh_.points.resize(mesh_.points.size() + part->made_vertices());
      mesh_.charts.resize(mesh_.points.size());
      mesh_.triangles.resize(mesh_.triangles.size() + part->made_triangles());
      vertices_ = mesh_.points.size();
      pending.insert(pending.end(), part->pending().begin(), part->pending().end());
      result_.insertions += part->made_vertices();
      result_.flips += part->flips();
      hand_on(&mesh_);
      hand_on(part);
      return part;
    };
    const auto give_back = [&](Part* part) {
      receive(part);
      part->give_back(whole);
      hand_on(part);
      hand_on(&idle);
      idle.push(part);
    };
    pipeline<Part*>(static_cast<std::uint32_t>(seeds.size()), tokens, refine, number, give_back);
    receive(&mesh_);
    receive(&idle);
    std::erase_if(pending, [&](TriangleId t) { return !mesh_.triangles[t].marked(); });
    result_.pending = std::move(pending);
  }

  /// Takes pending triangles at equal intervals; as they are ordered by age, the seeds are spread over the surface.
  [[nodiscard]] std::vector<TriangleId> choose_seeds() const {
    const double left = options_.expected_vertices - static_cast<double>(mesh_.points.size());
    const auto count = static_cast<double>(result_.pending.size());
    const double parts = std::max({1.0, left / kVerticesOfPart, count / kPendingOfPart});
    const auto stride = static_cast<std::size_t>(std::max(1.0, count / parts));
    std::vector<TriangleId> seeds;
    for (std::size_t k = 0; k < result_.pending.size(); k += stride) seeds.push_back(result_.pending[k]);
    return seeds;
  }

  Triangulation& triangulation_;
  Mesh& mesh_;
  const Threshold& apart_;
  const Threshold& large_;
  const PartOptions& options_;
  std::atomic<std::size_t> vertices_ = 0;
  PartResult result_;
};

}  // namespace

PartResult refine_in_parts(Triangulation& triangulation, std::vector<TriangleId> pending, const Threshold& apart,
                           const Threshold& large, const PartOptions& options) {
  assert(std::ranges::all_of(pending, [&](TriangleId t) { return triangulation.triangle(t).marked(); }));
  PartRefinement refinement(triangulation, apart, large, options);
  if (options.threads == 0) return refinement.run(std::move(pending));
  return with_threads(options.threads, [&] { return refinement.run(std::move(pending)); });
}

}  // namespace epsnet
