#include "certify/document/fault.h"

namespace epsnet::certify {

void throw_fault(const char* what, std::size_t index) { throw Fault(what + (" " + std::to_string(index))); }

}  // namespace epsnet::certify
