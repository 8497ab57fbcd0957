#include "netgen/base/atomic_file.h"

#include <array>
#include <atomic>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstring>
#include <deque>
#include <fcntl.h>
#include <ostream>
#include <streambuf>
#include <string>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>
#include <vector>

namespace epsnet {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& path, const std::string& what, int error) {
  throw WriteError(
      certify::ErrorParts{.file = path.string(), .problem = what + ": " + std::system_category().message(error)});
}

/// A buffered file descriptor that remembers the first error, which std::ofstream does not report.
class Output : public std::streambuf {
 public:
  explicit Output(int descriptor) : descriptor_(descriptor), buffer_(std::size_t{1} << 16) { reset(); }
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;
  ~Output() override {
    if (descriptor_ >= 0) ::close(descriptor_);
  }

  /// Writes the rest of the buffer and closes. Returns the first error since the beginning, 0 if there was none.
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

/// The name of a temporary file, stored where a signal handler, which must not allocate, can read it.
struct Name {
  std::atomic<bool> used = false;
  std::array<char, PATH_MAX> path = {};
};
/// More than are ever written at once. A file beyond this number would not be removed by the signal handler.
std::array<Name, 16> temporary_names;
static_assert(std::atomic<bool>::is_always_lock_free);

/// Blocks signals during its lifetime.
class SignalsBlocked {
 public:
  SignalsBlocked() {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before_);
  }
  SignalsBlocked(const SignalsBlocked&) = delete;
  SignalsBlocked& operator=(const SignalsBlocked&) = delete;
  ~SignalsBlocked() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

 private:
  sigset_t before_ = {};
};

/// A new file with a unique name beside another one. Its destructor and remove_temporary_files remove it, unless it has
/// replaced the other one.
class TemporaryFile {
 public:
  /// `path` is for messages.
  TemporaryFile(const fs::path& path, const fs::path& beside) {
    const SignalsBlocked blocked;
    for (int attempt = 0; descriptor_ < 0; ++attempt) {
      path_ = beside.string() + ".tmp-" + std::to_string(::getpid()) + "-" + std::to_string(attempt);
      descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
      if (descriptor_ < 0 && (errno != EEXIST || attempt == 1000)) fail(path, "cannot be created", errno);
    }
    for (Name& name : temporary_names) {
      if (name.used || path_.size() >= name.path.size()) continue;
      std::memcpy(name.path.data(), path_.c_str(), path_.size() + 1);
      name.used = true;
      name_ = &name;
      break;
    }
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
    if (path_.empty()) return;
    const SignalsBlocked blocked;
    ::unlink(path_.c_str());
    forget();
  }

  /// The descriptor, which the caller closes.
  [[nodiscard]] int take_descriptor() { return std::exchange(descriptor_, -1); }

  /// Renames it. Returns the error, 0 if there was none.
  [[nodiscard]] int take_place_of(const fs::path& target) {
    const SignalsBlocked blocked;
    if (::rename(path_.c_str(), target.c_str()) != 0) return errno;
    forget();
    return 0;
  }

 private:
  void forget() {
    path_.clear();
    if (name_ != nullptr) name_->used = false;
  }

  std::string path_;
  int descriptor_ = -1;
  Name* name_ = nullptr;
};

/// Calls `write` with a stream to the file, then closes the file.
void write_all(const fs::path& path, int descriptor, const std::function<void(std::ostream&)>& write) {
  Output output(descriptor);
  std::ostream stream(&output);
  write(stream);
  if (const int error = output.finish()) fail(path, "cannot be written", error);
  // `write` may have set the error state of the stream itself.
  if (!stream) throw WriteError(certify::ErrorParts{.file = path.string(), .problem = "cannot be written"});
}

}  // namespace

// rename() would replace the link itself.
fs::path followed_links(const fs::path& path) {
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

namespace {

/// The state of a path before anything is written to it.
struct Place {
  fs::path target;  ///< Where symbolic links lead.
  bool exists = false;
  bool is_device = false;  ///< A device, a pipe or a socket, which is written directly.
  mode_t permissions = 0;  ///< Of an existing file.
};

/// Throws WriteError if a file certainly cannot be written.
Place place_of(const fs::path& path) {
  if (path.empty()) throw WriteError("the path to write to is empty");
  Place place{.target = followed_links(path)};
  struct stat status = {};
  place.exists = ::stat(path.c_str(), &status) == 0;
  if (place.exists) {
    if (S_ISDIR(status.st_mode)) fail(path, "cannot be written", EISDIR);
    place.is_device = !S_ISREG(status.st_mode);
    place.permissions = status.st_mode & 07777;
    // rename() replaces a file even without permission to write to it.
    if (::access(path.c_str(), W_OK) != 0) fail(path, "cannot be opened for writing", errno);
  } else {
    const fs::path parent = place.target.parent_path();
    std::error_code error;
    if (const fs::path directory = parent.empty() ? "." : parent; !fs::is_directory(directory, error))
      throw WriteError(certify::ErrorParts{
          .file = path.string(), .problem = "cannot be created: there is no directory " + directory.string()});
  }
  return place;
}

}  // namespace

void write_files_atomically(const std::vector<NewFile>& files, const std::function<void()>& before_renaming) {
  std::vector<Place> places;
  places.reserve(files.size());
  for (const NewFile& file : files) places.push_back(place_of(file.path));
  std::deque<TemporaryFile> written;
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (places[i].is_device) continue;
    TemporaryFile& temporary = written.emplace_back(files[i].path, places[i].target);
    const int descriptor = temporary.take_descriptor();
    // Failure is ignored, as the contents matter more than the permissions.
    if (places[i].exists) static_cast<void>(::fchmod(descriptor, places[i].permissions));
    write_all(files[i].path, descriptor, files[i].write);
  }
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (!places[i].is_device) continue;
    const int descriptor = ::open(files[i].path.c_str(), O_WRONLY | O_CLOEXEC);
    if (descriptor < 0) fail(files[i].path, "cannot be opened for writing", errno);
    write_all(files[i].path, descriptor, files[i].write);
  }
  if (before_renaming) before_renaming();
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (places[i].is_device) continue;
    if (const int error = written.front().take_place_of(places[i].target))
      fail(files[i].path, "cannot be replaced", error);
    written.pop_front();
  }
}

void write_file_atomically(const fs::path& path, const std::function<void(std::ostream&)>& write) {
  write_files_atomically({{path, write}});
}

void check_writable(const fs::path& path) {
  const Place place = place_of(path);
  // Only an attempt detects names that are too long, quotas, and read-only file systems.
  if (!place.is_device) const TemporaryFile trial(path, place.target);
}

void remove_temporary_files() noexcept {
  for (const Name& name : temporary_names) {
    if (name.used) ::unlink(name.path.data());
  }
}

}  // namespace epsnet
