#include "certify/document/interval.h"

#include "certify/document/text.h"

namespace epsnet::certify {

std::string to_string(Interval x) {
  return std::string("[").append(shortest(x.lower)).append(", ").append(shortest(x.upper)).append("]");
}

}  // namespace epsnet::certify
