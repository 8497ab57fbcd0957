#include <cstdio>
#include <gtest/gtest.h>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "certify/file/file.h"
#include "certify/file/json.h"

namespace epsnet::certify::byte_stream_test {
namespace {

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

/// A file of its own that holds these bytes.
File file_of(const std::string& bytes) {
  File file(std::tmpfile(), &std::fclose);
  EXPECT_NE(file, nullptr);
  EXPECT_EQ(std::fwrite(bytes.data(), 1, bytes.size(), file.get()), bytes.size());
  std::rewind(file.get());
  return file;
}

/// No two places of it look alike.
std::string bytes_of(std::size_t size) {
  std::string bytes;
  for (std::size_t i = 0; bytes.size() < size; ++i) bytes += std::to_string(i) + ' ';
  bytes.resize(size);
  return bytes;
}

constexpr std::size_t kPiece = std::size_t{1} << 18U;

TEST(ByteStream, GivesTheBytesOfAFileInTheirOrder) {
  for (const std::size_t size : {std::size_t{1}, kPiece - 1, kPiece, kPiece + 1, 3 * kPiece + 12345}) {
    const std::string bytes = bytes_of(size);
    // How much is asked for, and how much is taken of it.
    for (const std::size_t asked : {std::size_t{1}, std::size_t{4096}, kPiece, 2 * kPiece, 10 * kPiece}) {
      for (const std::size_t taken : {std::size_t{1000}, asked}) {
        if (taken == 1 && size > 1) continue;  // Slow.
        const File file = file_of(bytes);
        std::string seen;
        ByteStream pieces(file.get(), bytes.size(), [&](std::string_view piece) { seen += piece; });
        std::size_t at = 0;
        while (at < bytes.size()) {
          ASSERT_EQ(pieces.left(), bytes.size() - at);
          const std::string_view ahead = pieces.ahead(asked);
          ASSERT_GE(ahead.size(), std::min(asked, bytes.size() - at));
          ASSERT_EQ(ahead, std::string_view(bytes).substr(at, ahead.size()));
          const std::size_t step = std::min(taken, ahead.size());
          pieces.skip(step);
          at += step;
        }
        EXPECT_EQ(pieces.left(), 0U);
        EXPECT_TRUE(pieces.ahead(1).empty());
        EXPECT_EQ(seen, bytes);
      }
    }
  }
}

TEST(ByteStream, ReadNoMoreThanTheyAreTold) {
  const std::string bytes = bytes_of(2 * kPiece);
  const File file = file_of(bytes);
  ByteStream pieces(file.get(), kPiece + 5, {});
  EXPECT_EQ(pieces.ahead(2 * kPiece), std::string_view(bytes).substr(0, kPiece + 5));
  pieces.skip(kPiece);
  EXPECT_EQ(pieces.ahead(100), std::string_view(bytes).substr(kPiece, 5));
}

TEST(ByteStream, AFileThatIsShorterThanItWasIsMalformed) {
  for (const std::size_t missing : {1U, 1000U}) {
    const std::string bytes = bytes_of(2 * kPiece);
    const File file = file_of(bytes);
    ByteStream pieces(file.get(), bytes.size() + missing, {});
    EXPECT_EQ(pieces.ahead(1).front(), bytes.front());
    EXPECT_THROW(static_cast<void>(pieces.ahead(bytes.size() + 1)), MalformedError);
  }
}

TEST(ByteStream, BytesInMemoryAreOnePiece) {
  const std::string bytes = bytes_of(1000);
  ByteStream pieces(bytes);
  EXPECT_EQ(pieces.ahead(1), bytes);
  EXPECT_EQ(pieces.ahead(5000), bytes);
  pieces.skip(300);
  EXPECT_EQ(pieces.left(), 700U);
  EXPECT_EQ(pieces.ahead(1), std::string_view(bytes).substr(300));
}

}  // namespace
}  // namespace epsnet::certify::byte_stream_test
