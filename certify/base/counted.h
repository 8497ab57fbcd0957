#pragma once

#include <string>
#include <string_view>

namespace epsnet::certify {

/// Returns a number and its noun: "1 tile", "2 tiles".
[[nodiscard]] inline std::string counted(std::size_t count, std::string_view one, std::string_view many) {
  return std::to_string(count).append(" ").append(count == 1 ? one : many);
}

}  // namespace epsnet::certify
