#pragma once

#include <string>
#include <vector>

namespace epsnet::certify {

/// Returns the name that was probably meant by one that is unknown, for messages: the nearest by letters that are
/// inserted, deleted, replaced, or swapped with the next one, of at most a third of the letters and one; or one that
/// begins like it. Dashes in front do not count. Empty if there is none.
[[nodiscard]] std::string nearest_name(const std::string& typed, const std::vector<std::string>& names);

}  // namespace epsnet::certify
