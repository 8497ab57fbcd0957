#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <vector>

#include "netgen/base/write_error.h"

namespace epsnet {

/// A file to be made: its path, and what writes its contents to a stream.
struct NewFile {
  std::filesystem::path path;
  std::function<void(std::ostream&)> write;
};

/// Writes files so that they are either all complete or as they were before: into temporary files in the same
/// directories, renamed when all of them are written and `before_renaming`, if given, has returned.
///
/// What `write` or `before_renaming` throws is passed on after the temporary files were removed. Every write and the
/// closing are checked. A symbolic link stays a link to the new contents; an existing file keeps its permissions. What
/// is not a regular file (/dev/null, a pipe) is written directly, after the temporary files. Not synchronised with the
/// disk: after a power failure the files may be lost. Throws WriteError.
void write_files_atomically(const std::vector<NewFile>& files, const std::function<void()>& before_renaming = {});

/// The same for one file.
void write_file_atomically(const std::filesystem::path& path, const std::function<void(std::ostream&)>& write);

/// Where symbolic links lead, whether there is a file or not: what is written where the path is. Throws WriteError for
/// links that go around.
[[nodiscard]] std::filesystem::path followed_links(const std::filesystem::path& path);

/// Throws WriteError if a file at this path could not be written now: a directory, a folder that is missing or may not
/// be written to, a name that is too long. Leaves everything as it is.
void check_writable(const std::filesystem::path& path);

/// Removes the temporary files of all calls that are under way. Async-signal-safe: for the handler of a signal that
/// ends the program.
void remove_temporary_files() noexcept;

}  // namespace epsnet
