#include "certify/exact/line_bundle.h"

#include <algorithm>
#include <array>
#include <utility>

#include "certify/exact/interval.h"

namespace epsnet::exact {
namespace {

mpz_class whole_part(const mpq_class& x) {
  mpz_class result;
  mpz_fdiv_q(result.get_mpz_t(), x.get_num_mpz_t(), x.get_den_mpz_t());
  return result;
}

mpq_class modulo_1(const mpq_class& x) { return x - whole_part(x); }

}  // namespace

LineBundle::LineBundle(std::vector<mpq_class> phases, const NetStructure& net)
    : phases_(std::move(phases)), net_(net) {}

void LineBundle::check() const {
  each_relation(net_, [&](const std::vector<Index>& sides, const std::string& name) {
    mpq_class sum;
    for (const Index s : sides) sum += phases_[s];
    if (sum.get_den() != 1) throw Refutation{"the phases of " + name + " do not add up to an integer"};
  });
}

Inertia::Values LineBundle::values() const {
  const auto is_half = [](const mpq_class& x) { return x.get_den() <= 2; };
  return std::all_of(phases_.begin(), phases_.end(), is_half) ? Inertia::Values::real : Inertia::Values::complex;
}

mpq_class LineBundle::of_label(Index label) const {
  mpq_class sum;
  if (label != 0) {
    for (const Index s : net_.net().labels[label - 1].word) sum += phases_[s];
  }
  return modulo_1(sum);
}

std::vector<mpq_class> LineBundle::across(Index halvings) const {
  std::map<Index, mpq_class> labels;
  const auto from_vertex = [&](Index dart) -> const mpq_class& {
    const Index label = net_.label_number(dart);
    const auto found = labels.find(label);
    return found != labels.end() ? found->second : labels.emplace(label, of_label(label)).first->second;
  };
  std::vector<mpq_class> result;
  // The vertex where a dart starts is that where the opposite one ends.
  for (Index dart = 0; dart < net_.darts(); ++dart)
    result.push_back(modulo_1(from_vertex(dart) - from_vertex(next(net_.opposite(dart)))));
  // Parts of a triangle have its frame.
  for (; halvings > 0; --halvings) {
    std::vector<mpq_class> halves(4 * result.size());
    for (Index dart = 0; dart < result.size(); ++dart)
      halves[first_half(dart)] = halves[second_half(dart)] = result[dart];
    result = std::move(halves);
  }
  return result;
}

std::vector<mpq_class> LineBundle::of_starts(const HalvedNet& halved, Index halvings) const {
  const std::vector<mpq_class> transitions = across(halvings);
  std::vector<mpq_class> result(transitions.size());
  std::vector<bool> seen(result.size());
  for (Index first = 0; first < result.size(); ++first) {
    // Around the vertex, from the triangle of the first dart, whose frame is the vertex's.
    mpq_class sum;
    for (Index dart = first; !seen[dart];) {
      seen[dart] = true;
      result[dart] = sum;
      dart = halved.opposite[previous(dart)];
      sum = modulo_1(sum + transitions[dart]);
    }
  }
  return result;
}

std::vector<mpq_class> LineBundle::of_sides(const HalvedNet& halved, Index halvings) const {
  std::vector<mpq_class> result = across(halvings);
  for (Index dart = 0; dart < result.size(); ++dart) {
    if (dart < halved.opposite[dart]) result[dart] = 0;
  }
  return result;
}

Inertia::Turn LineBundle::turn(const mpq_class& phase) {
  const mpz_class quarters = whole_part(4 * phase);
  const mpq_class rest = phase - mpq_class(quarters) / 4;  // Less than a quarter.
  Inertia::Turn result{1, 0};
  if (rest != 0) {
    const Interval angle = 2 * Interval(rest) * Interval::pi();
    result = {cos(angle), sin(angle)};
  }
  for (mpz_class i = 0; i < quarters; ++i) result = {-result[1], result[0]};
  return result;
}

}  // namespace epsnet::exact
