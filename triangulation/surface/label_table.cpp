#include "triangulation/surface/label_table.h"

#include <cmath>
#include <utility>

#include "triangulation/surface/words.h"

namespace epsnet {
namespace {

std::uint64_t pair_key(std::uint32_t first, std::uint32_t second) { return (std::uint64_t{first} << 32) | second; }

/// See LabelTable::image_error and docs/error-bounds.md, E5.
double error_of_images(const Isometry<double>& f) {
  const double a = std::sqrt(norm(f.a));
  const double b = std::sqrt(norm(f.b));
  return kUnitRoundoff * (16 * (a + b) / (a - 0.75 * b) + 16);
}

}  // namespace

LabelId LabelTable::product(LabelId f, LabelId g) const {
  const auto known = products_.find(pair_key(f, g));
  return known != products_.end() ? known->second : kUnknownLabel;
}

template <class T>
const Isometry<T>* LabelTable::isometry_in(LabelId l) const {
  const auto& values = std::get<Values<T>>(values_);
  const auto found = values.find(l);
  return found != values.end() ? &found->second : nullptr;
}

std::span<const LabelId> LabelTable::to(ChartId chart) const {
  return chart.number() < to_.size() ? std::span<const LabelId>(to_[chart]) : std::span<const LabelId>{};
}

std::span<const LabelId> LabelTable::between(ChartId from, ChartId to) const {
  const auto found = between_.find(pair_key(from.number(), to.number()));
  return found != between_.end() ? std::span<const LabelId>(found->second) : std::span<const LabelId>{};
}

std::optional<LabelId> LabelTable::find(ChartId from, ChartId to, const Charts::Disk& disk, const Isometry<double>& h,
                                        double size) const {
  // Two isometries are the same if they take the centre of a disk that the group moves off itself to points nearer than
  // twice its radius: sinh of half of the distance of n/d and n'/d' is |n d' − n' d|/(1 − |centre|²).
  const double gap = 1 - norm(disk.centre);
  struct Image {
    Complex<double> n;
    Complex<double> d;
  };
  const auto image = [&](const Isometry<double>& f) {
    return Image{f.a * disk.centre + f.b, conj(f.b) * disk.centre + conj(f.a)};
  };
  const Image wanted = image(h);
  // docs/error-bounds.md, E6.
  const auto is_exact_enough = [&](double size_of_other) {
    return 64 * kUnitRoundoff * size * size_of_other <= 0.25 * disk.sinh_radius * gap;
  };
  if (!is_exact_enough(1)) {
    return std::nullopt;
  }
  const auto is_same = [&](const Isometry<double>& f) -> std::optional<bool> {
    if (!is_exact_enough(size_of(f))) {
      return std::nullopt;
    }
    const Image other = image(f);
    return norm(wanted.n * other.d - other.n * wanted.d) < 0.25 * disk.sinh_radius * disk.sinh_radius * gap * gap;
  };
  if (from == to) {
    if (const auto same = is_same({}); !same || *same) {
      return same ? std::optional(kIdentity) : std::nullopt;
    }
  }
  for (const LabelId l : between(from, to)) {
    if (const auto same = is_same(isometry(l)); !same || *same) {
      return same ? std::optional(l) : std::nullopt;
    }
  }
  return kUnknownLabel;
}

LabelId LabelTable::add(Entry entry) {
  const Isometry<double> isometry = convert<double>(entry.value);
  const auto id = static_cast<LabelId>(entries_.size() + 1);
  rounded_.push_back({isometry, error_of_images(isometry), kUnknownLabel});
  between_[pair_key(entry.from.number(), entry.to.number())].push_back(id);
  if (entry.to.number() >= to_.size()) to_.resize(std::size_t{entry.to.number()} + 1);
  to_[entry.to].push_back(id);
  entries_.push_back(std::move(entry));
  return id;
}

void LabelTable::set_product(LabelId f, LabelId g, LabelId product) { products_.emplace(pair_key(f, g), product); }

const Evaluated<Mp256>& LabelTable::set_precise(LabelId l, Evaluated<Mp256> value) {
  assert(has(l));
  return entries_[l - 1].precise.emplace(std::move(value));
}

template <class T>
const Isometry<T>& LabelTable::set_isometry(LabelId l, const Isometry<T>& value) {
  assert(has(l));
  return std::get<Values<T>>(values_).emplace(l, value).first->second;
}

template const Isometry<Mp1024>* LabelTable::isometry_in<Mp1024>(LabelId) const;
template const Isometry<Mp4096>* LabelTable::isometry_in<Mp4096>(LabelId) const;
template const Isometry<Mp1024>& LabelTable::set_isometry<Mp1024>(LabelId, const Isometry<Mp1024>&);
template const Isometry<Mp4096>& LabelTable::set_isometry<Mp4096>(LabelId, const Isometry<Mp4096>&);

}  // namespace epsnet
