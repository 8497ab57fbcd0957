#include "epsnet/netgen/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <ostream>
#include <streambuf>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace epsnet {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& path, const std::string& what, int error) {
  throw WriteError(path.string() + ": " + what + ": " + std::system_category().message(error));
}

/// A buffered file descriptor that remembers the first error, which std::ofstream does not tell.
class Output : public std::streambuf {
 public:
  explicit Output(int descriptor) : descriptor_(descriptor), buffer_(std::size_t{1} << 16) { reset(); }
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;
  ~Output() override {
    if (descriptor_ >= 0) ::close(descriptor_);
  }

  /// Writes what is left and closes. The first error of all, 0 if there was none.
  int finish() {
    flush();
    if (::close(std::exchange(descriptor_, -1)) != 0 && error_ == 0) error_ = errno;
    return error_;
  }

 protected:
  int_type overflow(int_type c) override {
    if (!flush()) return traits_type::eof();
    if (!traits_type::eq_int_type(c, traits_type::eof())) {
      *pptr() = traits_type::to_char_type(c);
      pbump(1);
    }
    return traits_type::not_eof(c);
  }

  int sync() override { return flush() ? 0 : -1; }

 private:
  void reset() { setp(buffer_.data(), buffer_.data() + buffer_.size()); }

  bool flush() {
    for (const char* from = pbase(); from != pptr() && error_ == 0;) {
      const ssize_t written = ::write(descriptor_, from, static_cast<std::size_t>(pptr() - from));
      if (written >= 0) {
        from += written;
      } else if (errno != EINTR) {
        error_ = errno;
      }
    }
    reset();
    return error_ == 0;
  }

  int descriptor_;
  int error_ = 0;
  std::vector<char> buffer_;
};

/// Removes a file at the end unless told to keep it.
class TemporaryFile {
 public:
  explicit TemporaryFile(fs::path path) : path_(std::move(path)) {}
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() {
    if (!path_.empty()) ::unlink(path_.c_str());
  }
  void keep() { path_.clear(); }

 private:
  fs::path path_;
};

/// Where symbolic links lead, whether there is a file or not: rename() would replace the link itself.
fs::path followed(const fs::path& path) {
  fs::path target = path;
  std::error_code error;
  for (int links = 0; fs::is_symlink(target, error); ++links) {
    if (links == 40) fail(path, "cannot be opened for writing", ELOOP);
    const fs::path next = fs::read_symlink(target, error);
    if (error) fail(path, "cannot be opened for writing", error.value());
    target = target.parent_path() / next;
  }
  return target;
}

/// Hands the stream to `write` and closes the file.
void write_all(const fs::path& path, int descriptor, const std::function<void(std::ostream&)>& write) {
  Output output(descriptor);
  std::ostream stream(&output);
  write(stream);
  if (const int error = output.finish()) fail(path, "cannot be written", error);
  // A writer may have given up for a reason of its own.
  if (!stream) throw WriteError(path.string() + ": cannot be written");
}

}  // namespace

void write_file_atomically(const fs::path& path, const std::function<void(std::ostream&)>& write) {
  if (path.empty()) throw WriteError("the path to write to is empty");
  const fs::path target = followed(path);

  struct stat status = {};
  const bool exists = ::stat(path.c_str(), &status) == 0;
  if (exists && !S_ISREG(status.st_mode)) {
    const int descriptor = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
    if (descriptor < 0) fail(path, "cannot be opened for writing", errno);
    write_all(path, descriptor, write);
    return;
  }
  // rename() asks for no permission to write to the file that it replaces.
  if (exists && ::access(path.c_str(), W_OK) != 0) fail(path, "cannot be opened for writing", errno);

  fs::path temporary;
  int descriptor = -1;
  for (int attempt = 0; descriptor < 0; ++attempt) {
    temporary = target;
    temporary += ".tmp-" + std::to_string(::getpid()) + "-" + std::to_string(attempt);
    descriptor = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor < 0 && (errno != EEXIST || attempt == 1000)) fail(path, "cannot be created", errno);
  }
  TemporaryFile cleanup(temporary);
  if (exists) static_cast<void>(::fchmod(descriptor, status.st_mode & 07777));  // Best effort: the contents matter.
  write_all(path, descriptor, write);
  if (::rename(temporary.c_str(), target.c_str()) != 0) fail(path, "cannot be replaced", errno);
  cleanup.keep();
}

}  // namespace epsnet
