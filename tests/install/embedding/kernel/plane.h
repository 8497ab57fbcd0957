#pragma once

/// A header of the project that has the path of one of epsnet's.
constexpr int kOwn = 1;
