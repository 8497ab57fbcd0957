#include "netgen/eigenvalues/eigenvalues.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "certify/base/text.h"
#include "netgen/eigenvalues/eigenfunction.h"
#include "netgen/eigenvalues/prover.h"
#include "netgen/eigenvalues/trace_matrices.h"
#include "netgen/eigenvalues/window_search.h"
#include "netgen/geodesics/geodesics.h"
#include "netgen/nets/certified_net.h"

namespace epsnet {
namespace {

using certify::EigenvaluesDocument;
using certify::Interval;

/// For the lengths of the geodesics of the document, the shortest first. Throws LimitError if they have too many
/// multiples.
Prover prover_of(const Surface& surface, const EigenvaluesDocument& document, const RealVector& lengths) {
  constexpr double kMostMultiples = 1e6;
  const double up_to = static_cast<double>(Length(document.up_to).value());
  double multiples = 0;
  for (const Real& length : lengths) multiples += std::floor(up_to / static_cast<double>(length));
  if (multiples > kMostMultiples) {
    throw LimitError("the closed geodesics have more than 1000000 multiples of length at most " + document.up_to +
                     "; the shortest one has the length " + certify::shortest(static_cast<double>(lengths.front())));
  }
  const TestSpace space{static_cast<Real>(Length(document.up_to).value()), document.order, document.degree};
  std::vector<Interval> known;
  for (const auto& function : document.eigenfunctions) known.push_back(function.in);
  return {space, trace_matrices(space, surface.genus(), lengths), std::move(known)};
}

std::uint32_t genus_of(const EigenvaluesDocument& document) {
  return static_cast<std::uint32_t>((document.net.triangles.size() - 2 * document.net.vertices.size()) / 4 + 1);
}

/// How many eigenvalues are counted exactly, and then how narrow the first window's two enclosures together are.
using Quality = std::pair<std::uint64_t, double>;
Quality quality_of(const EigenvaluesDocument& document) {
  std::uint64_t counted = 0;
  for (const auto& window : document.windows) counted += window.least == window.most ? window.most : 0;
  if (document.windows.empty()) return {counted, -HUGE_VAL};
  const auto& first = document.windows.front();
  return {counted, -std::abs(first.smallest.upper - first.greatest.lower)};
}

using Eigenfunctions = std::vector<EigenvaluesDocument::Eigenfunction>;

/// Adds functions of the eigenvalues within `reach` of `place` that are found and not known. Returns about where the
/// nearest eigenvalue is; nothing if the search says nothing. An eigenvalue of some multiplicity has as many guesses,
/// next to each other.
std::optional<double> add_near(double place, double reach, const EigenfunctionSearch& search,
                               Eigenfunctions& functions) {
  const auto is_known = [&](double lower, double upper) {
    return std::any_of(functions.begin(), functions.end(),
                       [&](const auto& known) { return lower <= known.in.upper && known.in.lower <= upper; });
  };
  const std::vector<double> guesses = search.around(place);
  if (guesses.empty()) return std::nullopt;
  const double same = 1e-4 * reach;
  std::vector<std::pair<double, double>> led;  // Guesses, and the eigenvalues to which they led.
  const auto leads_to_same = [&](double guess) {
    return std::any_of(led.begin(), led.end(), [&](const auto& other) {
      return std::abs(guess - other.first) < std::abs(other.second - other.first) / 4;
    });
  };
  for (const double guess : guesses) {
    if (std::abs(guess - place) > reach || is_known(guess - same, guess + same) || leads_to_same(guess)) continue;
    auto function = search.near(guess);
    if (!function) continue;
    led.emplace_back(guess, function->lambda);
    if (!is_known(function->in.lower, function->in.upper)) functions.push_back(*std::move(function));
  }
  return guesses.front();
}

/// Adds functions of eigenvalues less than `end`, as surfaces with short geodesics have them. The constant functions,
/// of the eigenvalue 0, hide them from a search at greater places; so this one goes to smaller and smaller places,
/// where the trace formula leaves room for an eigenvalue.
void add_small_eigenfunctions(double end, const Prover& prover, const EigenfunctionSearch& search,
                              Eigenfunctions& functions) {
  constexpr int kHalvings = 12;
  double place = end;
  for (int i = 0; i < kHalvings; ++i, place /= 2) {
    if (prover.most_at(place) >= kOpen) add_near(place, place / 2, search, functions);
  }
}

/// Adds functions of eigenvalues behind those that are known, in increasing order, until there are `count` or none is
/// found any more. The place from which to search on is `from`.
void add_eigenfunctions(std::size_t count, const EigenfunctionSearch& search, double& from, Eigenfunctions& functions,
                        double stride) {
  constexpr double kLast = 40;
  while (from < kLast && functions.size() < count) {
    const double middle = from + stride / 2;
    const std::optional<double> nearest = add_near(middle, 0.75 * stride, search, functions);
    if (!nearest) break;
    // Where the nearest one is far, its place is a rough estimate.
    from += std::max(stride, std::abs(*nearest - middle) / 2);
  }
  std::sort(functions.begin(), functions.end(), [](const auto& x, const auto& y) { return x.lambda < y.lambda; });
}

/// A document with a spectrum and perhaps functions, completed by windows and what proves them.
EigenvaluesDocument with_windows(const Surface& surface, const EigenvaluesOptions& options,
                                 const EigenvaluesDocument& start, const RealVector& lengths) {
  // Which order is better depends on the surface: a high one on those whose eigenvalues are far apart.
  std::optional<Quality> quality;
  EigenvaluesDocument best;
  for (const std::uint32_t order : {8U, 12U}) {
    EigenvaluesDocument document = start;
    document.order = order;
    document.windows.clear();
    document.at_most.clear();
    document.at_least.clear();
    Prover prover = prover_of(surface, document, lengths);
    if (!find_windows(prover, options.count, options.progress, document)) continue;
    const Quality found = quality_of(document);
    if (quality && found <= *quality) continue;
    quality = found;
    best = std::move(document);
  }
  if (!quality) {
    throw NetError("nothing can be said about the eigenvalues from closed geodesics of length at most " + start.up_to +
                   "; a length of 1 or more is needed");
  }
  return best;
}

/// From closed geodesics up to one length. Functions of `last`, if there is one, are taken over.
EigenvaluesDocument eigenvalues_from(const Surface& surface, const EigenvaluesOptions& options, const Length& up_to,
                                     const EigenvaluesDocument* last) {
  GeodesicsOptions geodesics_options;
  geodesics_options.threads = options.threads;
  geodesics_options.progress = options.progress;
  EigenvaluesDocument best;
  static_cast<certify::GeodesicsDocument&>(best) = spectrum(surface, up_to, geodesics_options);
  if (last != nullptr && last->net == best.net) best.eigenfunctions = last->eigenfunctions;
  const RealVector lengths = lengths_of(surface, best);
  // A few functions, which certify checks within the work that it allows by default; more if more eigenvalues are
  // wanted than these prove.
  constexpr std::size_t kBatch = 5;
  std::optional<EigenfunctionSearch> search;
  // Throws, before any work for eigenfunctions, if next to no length was asked for.
  if (up_to.value() < 1) static_cast<void>(with_windows(surface, options, best, lengths));
  if (options.eigenfunctions && best.eigenfunctions.empty()) search.emplace(best, options.threads, options.progress);
  // Eigenvalues are about 1/(g − 1) apart.
  const double stride = 1.0 / surface.genus();
  if (search) add_small_eigenfunctions(stride / 4, prover_of(surface, best, lengths), *search, best.eigenfunctions);
  double from = 0;
  for (std::size_t wanted = options.count == 0 ? kBatch : std::min<std::size_t>(options.count + 1, kBatch);;
       wanted += kBatch) {
    if (search) add_eigenfunctions(wanted, *search, from, best.eigenfunctions, stride);
    const bool all = !search || best.eigenfunctions.size() < wanted || options.count <= kBatch;
    best = with_windows(surface, options, best, lengths);
    if (all || quality_of(best).first >= options.count) return best;
  }
}

/// How narrow the intervals of the first `count` eigenvalues are; infinite if they are not counted.
double width_of_first(const EigenvaluesDocument& document, std::uint32_t count) {
  double width = 0;
  std::uint64_t found = 0;
  for (const EigenvaluesDocument::Window& window : document.windows) {
    if (found >= count || window.least != window.most) break;
    found += window.most;
    const bool simple = window.most == 1;
    width = std::max(width, simple ? window.smallest.upper - window.greatest.lower : window.in.upper - window.in.lower);
  }
  return found >= count ? width : HUGE_VAL;
}

/// From longer and longer closed geodesics, until the width is reached or the time is used.
EigenvaluesDocument eigenvalues_from_more(const Surface& surface, const EigenvaluesOptions& options) {
  constexpr double kFirstLength = 8;
  constexpr double kLeastStep = 0.25;
  const Length greatest = options.up_to.value_or(Length(options.seconds ? "30" : "16"));
  const std::uint32_t wanted = std::max(options.count, 1U);
  const auto start = std::chrono::steady_clock::now();
  const auto elapsed = [&] { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(); };
  std::optional<EigenvaluesDocument> best;
  double reached = HUGE_VAL;
  double length = kFirstLength;
  for (double before = 0;;) {
    const bool last = greatest.value() <= length;
    const Length up_to = last ? greatest : Length(length);
    try {
      best = eigenvalues_from(surface, options, up_to, best ? &*best : nullptr);
    } catch (const LimitError&) {
      if (!best) throw;
      break;
    }
    reached = width_of_first(*best, wanted);
    if (last || (options.width && reached < *options.width)) break;
    double step = 1;
    const double now = elapsed();
    if (options.seconds) {
      // The time is at most proportional to e^L, and a check takes as long again.
      const double more = std::log(std::max(*options.seconds - now, 0.0) / (2 * (now - before)));
      step = std::min(step, std::floor(more / kLeastStep) * kLeastStep);
      if (!(step > 0)) break;
    }
    before = now;
    length += step;
  }
  if (options.width && !(reached < *options.width)) {
    const std::string which =
        wanted == 1 ? "the first eigenvalue is" : "the first " + std::to_string(wanted) + " eigenvalues are";
    throw NetError(
        which + (reached < HUGE_VAL ? " enclosed to " + certify::shortest(reached) + " only" : " not counted") +
        " by closed geodesics of length at most " + best->up_to + ", expected " + certify::shortest(*options.width));
  }
  return *std::move(best);
}

}  // namespace

EigenvaluesDocument eigenvalues(const Surface& surface, const EigenvaluesOptions& options) {
  constexpr int kLongest = 30;
  if (options.up_to && options.up_to->value() > kLongest) throw std::invalid_argument("the length is more than 30");
  if (options.width && !(*options.width > 0)) throw std::invalid_argument("the width is not positive");
  if (options.seconds && !(*options.seconds > 0)) throw std::invalid_argument("the time is not positive");
  if (options.width || options.seconds) return eigenvalues_from_more(surface, options);
  return eigenvalues_from(surface, options, options.up_to.value_or(Length("10")), nullptr);
}

std::optional<double> length_to_count_first(const EigenvaluesDocument& document) {
  if (document.windows.empty()) return std::nullopt;
  const EigenvaluesDocument::Window& first = document.windows.front();
  if (first.least == first.most) return std::nullopt;
  const double up_to = static_cast<double>(Length(document.up_to).value());
  const double area = 2 * std::numbers::pi * (genus_of(document) - 1.0);
  return std::max(up_to + 1, area / 2 * std::sqrt(std::max(0.0, first.in.upper - 0.25)) + 3);
}

std::vector<double> eigenvalue_bounds(const Surface& surface, const EigenvaluesDocument& document,
                                      const std::vector<double>& lambdas) {
  const Prover prover = prover_of(surface, document, lengths_of(surface, document));
  std::vector<double> result;
  result.reserve(lambdas.size());
  for (const double lambda : lambdas) result.push_back(prover.most_at(lambda));
  return result;
}

}  // namespace epsnet
