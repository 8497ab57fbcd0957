#include "certify/file/pieces.h"

#include <algorithm>
#include <cstring>

#include "certify/file/reader.h"

namespace epsnet::certify {

void Pieces::read(std::size_t size) {
  constexpr std::size_t kPiece = std::size_t{1} << 18;  // Fits into caches.
  if (!here_.empty()) std::memmove(buffer_.data(), here_.data(), here_.size());
  const std::size_t kept = here_.size();
  const std::size_t wanted = std::max(size, kPiece) - kept;
  const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(wanted, unread_));
  buffer_.resize(std::max(buffer_.size(), kept + count));
  if (std::fread(buffer_.data() + kept, 1, count, file_) != count) throw MalformedError("the file ends early");
  unread_ -= count;
  if (witness_) witness_({buffer_.data() + kept, count});
  here_ = {buffer_.data(), kept + count};
}

}  // namespace epsnet::certify
