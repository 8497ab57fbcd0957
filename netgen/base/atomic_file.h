#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <vector>

#include "triangulation/surface/surface.h"

namespace epsnet {

/// A file to write: its path, and a function that writes its contents to a stream.
struct NewFile {
  std::filesystem::path path;
  std::function<void(std::ostream&)> write;
};

/// Writes files so that either all are complete or all are as before. The contents go to temporary files in the same
/// directories. These are renamed once all are written and `before_renaming`, if given, has returned.
///
/// Exceptions of `write` and `before_renaming` are passed on after the temporary files are removed. Every write and
/// every closing is checked. A symbolic link stays a link, and leads to the new contents. An existing file keeps its
/// permissions. A path that is not a regular file (/dev/null, a pipe) is written directly, after the temporary files.
/// The files are not synchronised with the disk: a power failure may lose them. Throws WriteError.
void write_files_atomically(const std::vector<NewFile>& files, const std::function<void()>& before_renaming = {});

/// Like write_files_atomically, for one file.
void write_file_atomically(const std::filesystem::path& path, const std::function<void(std::ostream&)>& write);

/// Returns the path to which symbolic links lead, whether a file exists there or not. Writing to `path` writes there.
/// Throws WriteError for circular links.
[[nodiscard]] std::filesystem::path followed_links(const std::filesystem::path& path);

/// Throws WriteError if a file cannot be written at this path now: the path is a directory, its folder is missing or
/// not writable, or its name is too long. Changes nothing.
void check_writable(const std::filesystem::path& path);

/// Removes the temporary files of all calls in progress. Async-signal-safe, for the handler of a signal that ends the
/// program.
void remove_temporary_files() noexcept;

}  // namespace epsnet
