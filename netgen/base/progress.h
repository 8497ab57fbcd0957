#pragma once

#include <functional>
#include <string_view>

namespace epsnet {

/// Reports the progress of a computation: called occasionally, from the thread that started it, with the name of the
/// current step and the share of it done, 0 to 1. The text is valid during the call only.
/// certify::CheckOptions::progress has this type.
using Progress = std::function<void(std::string_view what, double share)>;

}  // namespace epsnet
