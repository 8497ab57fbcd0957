#pragma once

#include "certify/base/interval.h"

/// The distance of two geodesic segments, in intervals of binary64 that are rounded outward.
namespace epsnet::certify {

/// Of two segments, from s to e and from r to l: enclosures of the cosh of the distances of their ends and of their
/// lengths.
struct SegmentPair {
  Interval e_l;
  Interval s_l;
  Interval e_r;
  Interval s_r;
  Interval l_r;
  Interval e_s;
};

/// A lower bound of cosh² of the distance of two segments that do not cross each other: the least of four distances of
/// an end from the other segment, and that of the lines, if it is possibly attained on the segments.
[[nodiscard]] double cosh2_below(SegmentPair pair);

}  // namespace epsnet::certify
