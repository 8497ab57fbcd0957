#include <cerrno>
#include <cstdio>
#include <cstring>
#include <limits>
#include <memory>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>
#include <variant>

#include "certify/base/binary64.h"
#include "certify/base/text.h"
#include "certify/claims.h"
#include "certify/file/document_reader.h"
#include "certify/file/file.h"

namespace epsnet::certify {
namespace {

constexpr std::uint64_t kMaxFileBytes = std::uint64_t{4} << 30;
// Indices of rows are stored in 32 bits: a row takes two bytes or more, and a comma.
static_assert(kMaxFileBytes / 3 < std::numeric_limits<std::uint32_t>::max());

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

/// The bytes of a file, from the beginning as often as they are asked for.
class Source {
 public:
  explicit Source(std::string_view bytes) : size_(bytes.size()), bytes_(bytes) {}
  Source(std::FILE* file, std::uint64_t size) : size_(size), file_(file) {}

  [[nodiscard]] std::uint64_t size() const { return size_; }
  [[nodiscard]] ByteStream open_bytes(const Witness& witness = {}) const {
    if (file_ == nullptr) return ByteStream(bytes_);
    std::rewind(file_);
    return {file_, size_, witness};
  }

 private:
  std::uint64_t size_;
  std::FILE* file_ = nullptr;
  std::string_view bytes_;
};

constexpr const char* kTooLarge = "the file is larger than the limit of 4 GiB";

void read_source(const Source& source, const Witness& witness, Structure structure, DocumentPointer document) {
  ByteStream bytes = source.open_bytes(witness);
  try {
    read_document(bytes, document, structure);
  } catch (const MalformedError&) {
    bytes.skip_all();
    throw;
  }
}

/// An empty document of the kind that the format names, or else of the first.
template <class... Documents>
void choose(std::variant<Documents...>& document, const std::optional<std::string>& format) {
  (void)((format == Fields<Documents>::kKind.format && (document.template emplace<Documents>(), true)) || ...);
}

void read_source(const Source& source, const Witness& witness, Structure structure, ClaimDocument* document) {
  ByteStream beginning = source.open_bytes();
  choose(*document, format_of(beginning));
  read_source(source, witness, structure, std::visit([](auto& one) -> DocumentPointer { return &one; }, *document));
}

void read_contents(const Source& source, std::string_view name, const Witness& witness, Structure structure,
                   ContentsPointer contents) {
  const RoundingToNearest rounding;
  try {
    if (source.size() > kMaxFileBytes) throw MalformedError(ErrorParts{.place = "document", .problem = kTooLarge});
    std::visit([&](auto* one) { read_source(source, witness, structure, one); }, contents);
  } catch (const MalformedError& error) {
    ErrorParts parts = error.parts();
    parts.file = name;
    throw MalformedError(parts);
  }
}

/// Opens a file that should be read in chunks, and says how large it is.
std::pair<File, std::uint64_t> open_large_file(const std::filesystem::path& path) {
  File file(nullptr, &std::fclose);
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return {std::move(file), 0};
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (!error && size > kMaxBytesAtOnce && size <= kMaxFileBytes) file.reset(std::fopen(path.c_str(), "rb"));
  return {std::move(file), size};
}

}  // namespace

std::string display_name(const std::filesystem::path& path) {
  return path == "-" ? "standard input" : path_in_quotes(path.string());
}

std::string load(const std::filesystem::path& path) {
  const std::string name = display_name(path);
  const auto fail_to_read = [&](const std::string& why, const std::string& expected = {}) {
    throw FileError(ErrorParts{.file = name, .problem = why, .expected = expected});
  };
  std::FILE* file = stdin;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> opened(nullptr, &std::fclose);
  if (path != "-") {
    opened.reset(std::fopen(path.c_str(), "rb"));
    if (!opened)
      fail_to_read(errno == ENOENT ? "no such file" : "cannot be opened: " + std::string(std::strerror(errno)));
    file = opened.get();
  }
  struct stat status {};
  if (fstat(fileno(file), &status) != 0) fail_to_read("cannot be read: " + std::string(std::strerror(errno)));
  if (S_ISDIR(status.st_mode)) fail_to_read("is a directory", "a file");
  // Of the devices only a terminal ends: /dev/zero never would.
  if ((S_ISCHR(status.st_mode) && isatty(fileno(file)) == 0) || S_ISBLK(status.st_mode)) {
    fail_to_read("is a device", "a file");
  }
  std::string bytes;
  constexpr std::size_t kChunk = 1 << 20;
  if (S_ISREG(status.st_mode) && static_cast<std::uint64_t>(status.st_size) <= kMaxFileBytes) {
    // The last chunk, which is not filled, has to fit in as well.
    bytes.reserve(static_cast<std::size_t>(status.st_size) + kChunk);
  }
  for (std::size_t read = kChunk; read == kChunk;) {
    const std::size_t old_size = bytes.size();
    bytes.resize(old_size + kChunk);
    read = std::fread(bytes.data() + old_size, 1, kChunk, file);
    bytes.resize(old_size + read);
    if (bytes.size() > kMaxFileBytes) {
      throw MalformedError(ErrorParts{.file = name, .place = "document", .problem = kTooLarge});
    }
  }
  if (std::ferror(file) != 0) fail_to_read("cannot be read: " + std::string(std::strerror(errno)));
  return bytes;
}

void read_file_into(ContentsPointer contents, const std::filesystem::path& path, const Witness& witness,
                    Structure structure) {
  const std::string name = display_name(path);
  if (const auto [file, size] = open_large_file(path); file) {
    return read_contents(Source(file.get(), size), name, witness, structure, contents);
  }
  const std::string bytes = load(path);
  if (witness) witness(bytes);
  read_contents(Source(bytes), name, {}, structure, contents);
}

void parse_file_into(ContentsPointer contents, std::string_view bytes, std::string_view name) {
  read_contents(Source(bytes), name, {}, Structure::checked, contents);
}

}  // namespace epsnet::certify
