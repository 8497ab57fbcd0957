#pragma once

#include <optional>

#include "certify/claims/geodesics/chord_table.h"

namespace epsnet::certify {

/// The side of an axis on which a corner of a chord's triangle lies, exactly: 1 for left of it or on it, −1 for right.
/// `corner` is 0, 1 or 2; the geodesic's element is the inverse of label `number`.
///
/// Returns nullopt if the numbers are too large. The product of all labels on the way to the chord is made.
[[nodiscard]] std::optional<int> exact_side(const NetDocument& net, const LabelEvaluator& evaluator,
                                            const ChordTable& table, std::uint32_t number, ChordTable::Place place,
                                            std::uint32_t corner);

}  // namespace epsnet::certify
