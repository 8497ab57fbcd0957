#pragma once

#include <string_view>

namespace epsnet {

/// The text of viewer.html: the page with places for what it shows.
extern const std::string_view kViewerPage;

}  // namespace epsnet
