#include "certify/base/lookup.h"

#include <string>

namespace epsnet::certify {

void throw_fault(const char* what) { throw Fault(what); }

void throw_fault(const char* what, std::size_t index) { throw Fault(what + (" " + std::to_string(index))); }

}  // namespace epsnet::certify
