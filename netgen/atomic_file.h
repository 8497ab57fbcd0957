#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>

#include "epsnet/triangulation/error.h"

namespace epsnet {

/// A file could not be written. what() is one line: the path and the reason ("No space left on device").
class WriteError : public Error {
 public:
  using Error::Error;
};

/// Writes a file so that it is either complete or as it was before: into a temporary file in the same directory,
/// renamed at the end.
///
/// `write` gets the stream; what it throws is passed on after the temporary file was removed. Every write and the
/// closing are checked. A symbolic link stays a link to the new contents; an existing file keeps its permissions. What
/// is not a regular file (/dev/stdout, a pipe) is written directly. Not synchronised with the disk: after a power
/// failure the file may be lost. Throws WriteError.
void write_file_atomically(const std::filesystem::path& path, const std::function<void(std::ostream&)>& write);

}  // namespace epsnet
