#pragma once

#include <string_view>

namespace epsnet {

/// The text of viewer/viewer.html with the files that it names: the page, with places for its data.
extern const std::string_view kViewerPage;

}  // namespace epsnet
