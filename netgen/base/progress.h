#pragma once

#include <functional>
#include <string_view>

namespace epsnet {

/// How far a computation is: called now and then, from the thread that asked for it, with what is being done and the
/// share of that done, 0 to 1. The text lives as long as the call. certify::CheckOptions::progress is of this type.
using Progress = std::function<void(std::string_view what, double share)>;

}  // namespace epsnet
