#pragma once

#include <cstdint>
#include <cstdio>
#include <functional>
#include <string_view>
#include <vector>

namespace epsnet::certify {

/// The bytes of a file from front to back, of which a piece is in memory at a time.
class Pieces {
 public:
  /// Is shown all bytes of a file in their order.
  using Witness = std::function<void(std::string_view)>;

  /// Bytes that are in memory, in one piece.
  explicit Pieces(std::string_view bytes) : here_(bytes) {}
  /// The next `size` bytes of an open file.
  Pieces(std::FILE* file, std::uint64_t size, Witness witness)
      : file_(file), unread_(size), witness_(std::move(witness)) {}
  Pieces(const Pieces&) = delete;
  Pieces& operator=(const Pieces&) = delete;

  /// What is in memory of the bytes to come: `size` bytes at least, or all that are left. Good until the next call.
  /// Throws MalformedError if the file is shorter than it was said to be, or cannot be read.
  [[nodiscard]] std::string_view ahead(std::size_t size) {
    if (here_.size() < size && unread_ > 0) read(size);
    return here_;
  }
  /// Goes on behind bytes that are in memory.
  void skip(std::size_t size) { here_.remove_prefix(size); }
  /// Goes on to the end, and shows the witness what is left.
  void skip_all() {
    while (left() > 0) skip(ahead(1).size());
  }
  [[nodiscard]] std::uint64_t left() const { return here_.size() + unread_; }

 private:
  void read(std::size_t size);

  std::FILE* file_ = nullptr;
  std::uint64_t unread_ = 0;
  Witness witness_;
  std::vector<char> buffer_;
  std::string_view here_;
};

}  // namespace epsnet::certify
