#pragma once

#include <string>

#include "netgen/nets/certified_net.h"

/// The record of a net: one line in the table of a sweep over surfaces and ε (docs/experiments.md).
namespace epsnet {

/// Processor time, in seconds.
struct NetSeconds {
  double net = 0;          ///< From the surface to the net, everything included.
  double certificate = 0;  ///< Of all threads.
};

/// Returns the names of the columns, separated by commas, without a line end. Only the last two, the seconds, differ
/// between runs and machines.
[[nodiscard]] std::string net_record_columns();

/// Returns the line of a net, without a line end: the name of its surface, how it was made, its counts, the verdict,
/// the thesis' statistics (IV.6), the proved enclosures and the bound for the systole that follows from the net
/// (systole_lower_bound). Values are separated by commas (RFC 4180); a value that does not exist is empty, such as the
/// shortest loop of a net without loops. Reals have enough digits to read back as the same number.
[[nodiscard]] std::string net_record(const std::string& surface, const UncertifiedNet& net,
                                     const certify::Certificate& certificate, const NetOptions& options,
                                     const NetSeconds& seconds);

}  // namespace epsnet
