#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "certify/claims/bound/document.h"
#include "certify/claims/curves/document.h"
#include "certify/claims/distance/document.h"
#include "certify/claims/eigenvalues/document.h"
#include "certify/claims/geodesics/document.h"
#include "certify/claims/isometries/document.h"
#include "certify/claims/pants/document.h"
#include "certify/net/document.h"

/// Defects of documents and of their text, each chosen at random.
namespace epsnet::attack {

/// The document contains nothing that the mutation could change.
struct NothingToChange {};

/// Random numbers that are the same with every standard library.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  [[nodiscard]] std::uint32_t below(std::size_t n) {
    if (n == 0) throw NothingToChange{};
    return static_cast<std::uint32_t>(engine_() % n);
  }
  [[nodiscard]] double share() { return std::ldexp(static_cast<double>(engine_() >> 11), -53); }
  [[nodiscard]] double sign() { return below(2) == 0 ? 1 : -1; }
  template <class T>
  [[nodiscard]] T& of(std::vector<T>& rows) {
    if (rows.empty()) throw NothingToChange{};
    return rows[below(rows.size())];
  }

 private:
  std::mt19937_64 engine_;
};

template <class Document>
struct MutationOf {
  const char* name;
  std::function<void(Document&, Random&)> apply;
};
using Mutation = MutationOf<certify::NetDocument>;

/// Defects of nets, most of them for surfaces made of tiles. They throw NothingToChange where there is nothing to
/// change.
[[nodiscard]] const std::vector<Mutation>& mutations();
/// Defects of regular surfaces and of pseudo nets only.
[[nodiscard]] const std::vector<Mutation>& regular_mutations();
/// Of surfaces over a number field.
[[nodiscard]] const std::vector<Mutation>& field_mutations();
[[nodiscard]] const std::vector<Mutation>& collar_mutations();

/// Defects of the parts of a claim other than its net.
[[nodiscard]] const std::vector<MutationOf<certify::GeodesicsDocument>>& geodesics_mutations();
[[nodiscard]] const std::vector<MutationOf<certify::DistanceDocument>>& distance_mutations();
[[nodiscard]] const std::vector<MutationOf<certify::BoundDocument>>& bound_mutations();
[[nodiscard]] const std::vector<MutationOf<certify::EigenvaluesDocument>>& eigenvalues_mutations();
[[nodiscard]] const std::vector<MutationOf<certify::IsometriesDocument>>& isometries_mutations();
[[nodiscard]] const std::vector<MutationOf<certify::PantsDocument>>& pants_mutations();
[[nodiscard]] const std::vector<MutationOf<certify::CurvesDocument>>& curves_mutations();

/// Defects of the text: its bytes, tokens, and the notation of numbers.
void change_text(std::string& text, Random& random);

}  // namespace epsnet::attack
