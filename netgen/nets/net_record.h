#pragma once

#include <string>

#include "netgen/nets/certified_net.h"

/// A net as a line of a table: what a sweep over surfaces and ε keeps of it (docs/experiments.md).
namespace epsnet {

/// Processor time, in seconds.
struct NetSeconds {
  double net = 0;          ///< From the surface to the net, everything included.
  double certificate = 0;  ///< Of all threads.
};

/// The names of the columns, separated by commas; no line end. The last two, the seconds, are the only ones that
/// another run or another machine changes.
[[nodiscard]] std::string net_record_columns();

/// The line of a net: the name of its surface, how it was made, its counts, the verdict, the thesis' statistics (IV.6),
/// the proved enclosures and the bound of the systole that follows from the net (systole_lower_bound). No line end.
/// Comma-separated values as of RFC 4180; empty where there is nothing, as for the shortest loop of a net without
/// loops. Reals have the digits that read back the same.
[[nodiscard]] std::string net_record(const std::string& surface, const UncertifiedNet& net,
                                     const certify::Certificate& certificate, const NetOptions& options,
                                     const NetSeconds& seconds);

}  // namespace epsnet
