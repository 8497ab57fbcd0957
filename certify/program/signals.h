#pragma once

namespace epsnet::certify::program {

/// From here on every death by signal that can be turned into the exit code of an internal fault is: GMP and FLINT out
/// of memory, std::terminate, a crash. A reader that went away and a file as large as it may be show as failed writes.
void catch_signals();

}  // namespace epsnet::certify::program
