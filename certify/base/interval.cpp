#include "certify/base/interval.h"

#include "certify/base/decimals.h"

namespace epsnet::certify {

std::string to_string(Interval x) {
  return std::string("[").append(decimal_below(x.lower)).append(", ").append(decimal_above(x.upper)).append("]");
}

}  // namespace epsnet::certify
