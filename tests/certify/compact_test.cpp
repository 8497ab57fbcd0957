#include "certify/file/compact.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <gtest/gtest.h>
#include <limits>
#include <memory>
#include <random>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "certify/file/file.h"

/// Compact net files say what net files say, and nothing that is damaged, cut off or contradictory is read.
namespace epsnet::certify::compact_test {
namespace {

NetDocument load_net(const std::string& name) {
  return read_file<NetDocument>(std::string(EPSNET_TEST_DATA) + "/" + name);
}

std::string compact(const NetDocument& document) {
  std::ostringstream out;
  write_compact_net(document, out);
  return out.str();
}

/// The bytes with the checksum that they ask for.
std::string with_checksum(std::string bytes) {
  bytes.resize(bytes.size() - 8);
  CompactChecksum sum;
  sum.add(bytes);
  for (unsigned i = 0; i < 8; ++i) bytes += static_cast<char>(static_cast<unsigned char>(sum.value() >> (8 * i)));
  return bytes;
}

std::string problem(const std::string& bytes) {
  try {
    (void)parse_file<NetDocument>(bytes, "net.epsn");
    return "";
  } catch (const MalformedError& error) {
    return error.what();
  }
}

void set_word(std::string& bytes, std::size_t at, std::uint32_t value) {
  for (unsigned i = 0; i < 4; ++i) bytes[at + i] = static_cast<char>(static_cast<unsigned char>(value >> (8 * i)));
}
std::uint32_t word(const std::string& bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (unsigned i = 0; i < 4; ++i) value |= std::uint32_t{static_cast<unsigned char>(bytes[at + i])} << (8 * i);
  return value;
}

/// Where the parts of a file begin.
struct Parts {
  explicit Parts(const std::string& bytes) {
    const std::size_t n = word(bytes, 16);
    const std::size_t t = word(bytes, 20);
    head = 32;
    x = head + word(bytes, 12);
    charts = x + 16 * n;
    vertices = charts + n * word(bytes, 24);
    opposites = vertices + 12 * t;
    labelled = opposites + 6 * t;
    labels = labelled + (2 * t + 7) / 8;
  }
  std::size_t head, x, charts, vertices, opposites, labelled, labels;
};

/// The same numbers, those of charts and labels in more bytes.
std::string widened(const std::string& bytes, std::uint32_t chart_width, std::uint32_t label_width) {
  const Parts parts(bytes);
  const auto wider = [&](std::size_t begin, std::size_t end, std::size_t from, std::size_t to) {
    std::string result;
    for (std::size_t at = begin; at < end; at += from) result += bytes.substr(at, from) + std::string(to - from, '\0');
    return result;
  };
  std::string result = bytes.substr(0, parts.charts) +
                       wider(parts.charts, parts.vertices, word(bytes, 24), chart_width) +
                       bytes.substr(parts.vertices, parts.labels - parts.vertices) +
                       wider(parts.labels, bytes.size() - 8, word(bytes, 28), label_width) + bytes.substr(0, 8);
  set_word(result, 24, chart_width);
  set_word(result, 28, label_width);
  return with_checksum(result);
}

class Compact : public testing::Test {
 protected:
  /// What is said of the file after a change, its checksum made right.
  std::string after(const std::function<void(std::string&)>& change) const {
    std::string bytes = good_;
    change(bytes);
    return problem(with_checksum(bytes));
  }
  const NetDocument net_ = load_net("certify/verified/octagon-33-vertices.json");
  const std::string good_ = compact(net_);
  const Parts parts_{good_};
};

/// Tests that take seconds with sanitizers.
class SlowCompact : public Compact {};

TEST_F(Compact, SaysWhatNetFilesSay) {
  int nets = 0;
  for (const char* folder : {"certify/verified", "certify/refuted", "certify/undecided"}) {
    for (const auto& entry : std::filesystem::directory_iterator(std::string(EPSNET_TEST_DATA) + "/" + folder)) {
      ClaimDocument document;
      try {
        document = read_file<ClaimDocument>(entry.path());
      } catch (const MalformedError&) {
        continue;
      }
      const auto* net = std::get_if<NetDocument>(&document);
      if (net == nullptr) continue;
      std::string bytes;
      try {
        bytes = compact(*net);
      } catch (const std::invalid_argument&) {
        continue;  // Darts that are not paired.
      }
      ++nets;
      const NetDocument read = parse_file<NetDocument>(bytes, "compact");
      EXPECT_EQ(read, *net) << entry.path();
      EXPECT_EQ(compact(read), bytes);
      EXPECT_EQ(std::get<NetDocument>(parse_file<ClaimDocument>(bytes, "compact")), *net);
    }
  }
  EXPECT_GT(nets, 40);
}

TEST_F(Compact, NumbersKeepTheirSigns) {
  NetDocument net = net_;
  net.vertices[1].x = -0.0;
  net.vertices[1].y = 5e-324;
  const NetDocument read = parse_file<NetDocument>(compact(net), "compact");
  EXPECT_TRUE(std::signbit(read.vertices[1].x));
  EXPECT_EQ(read.vertices[1].y, 5e-324);
}

TEST_F(Compact, NumbersThatJsonDoesNotHaveAreOutsideOfTheDisk) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const double x : {std::numeric_limits<double>::quiet_NaN(), kInfinity, -kInfinity, 1e308, 1.0}) {
    NetDocument net = net_;
    net.vertices[1].x = x;
    const std::string said = problem(compact(net));
    EXPECT_TRUE(said.starts_with("net.epsn: vertices[1]: ")) << said;
    EXPECT_TRUE(said.ends_with("is not inside the unit disk")) << said;
  }
}

TEST_F(Compact, DartsThatAreNotPairedCannotBeWritten) {
  NetDocument net = net_;
  net.triangles[0].opposite[1] = 1;
  std::ostringstream out;
  EXPECT_THROW(write_compact_net(net, out), std::invalid_argument);
  EXPECT_EQ(out.str(), "");
  net = net_;
  net.triangles[0].opposite[1] = 4'000'000'000;
  EXPECT_THROW(write_compact_net(net, out), std::invalid_argument);
}

TEST_F(Compact, NumbersMayTakeMoreBytesThanTheyMust) {
  for (const std::uint32_t charts : {1U, 2U, 4U}) {
    for (const std::uint32_t labels : {1U, 2U, 4U}) {
      EXPECT_EQ(parse_file<NetDocument>(widened(good_, charts, labels), "compact"), net_) << charts << labels;
    }
  }
  for (const std::uint32_t width : {3U, 5U, 8U, 16U}) {
    EXPECT_EQ(problem(widened(good_, width, 1)), "net.epsn: header: charts of vertices: a width of " +
                                                     std::to_string(width) + " bytes, expected 1, 2 or 4");
    EXPECT_EQ(problem(widened(good_, 1, width)), "net.epsn: header: labels of corners: a width of " +
                                                     std::to_string(width) + " bytes, expected 1, 2 or 4");
  }
}

/// As its specification says of no bytes at all.
TEST_F(Compact, TheChecksumIsXxh64WithTheSeed0) {
  CompactChecksum sum;
  EXPECT_EQ(sum.value(), 0xef46db3751d8e999U);
  sum.add("a");
  EXPECT_EQ(sum.value(), 0xd24ec4f1a98c6e5bU);
  sum.add("bc");
  EXPECT_EQ(sum.value(), 0x44bc2cf5ad770999U);
}

/// However many bytes charts and labels take.
TEST_F(SlowCompact, AnyByteThatChangesIsNoticed) {
  for (const std::uint32_t charts : {1U, 2U, 4U}) {
    for (const std::uint32_t labels : {1U, 2U, 4U}) {
      const std::string good = widened(good_, charts, labels);
      for (std::size_t i = 0; i < good.size(); ++i) {
        std::string bytes = good;
        bytes[i] = static_cast<char>(bytes[i] ^ 0x20);
        EXPECT_NE(problem(bytes), "") << i << " " << charts << labels;
      }
    }
  }
}

/// An index is all of its bytes: of the few vertices, darts, charts and labels here only the first byte is not 0.
TEST_F(Compact, EveryByteOfAnIndexCounts) {
  ASSERT_LT(3 * net_.triangles.size(), 256U);
  for (const std::uint32_t width : {2U, 4U}) {
    const std::string good = widened(good_, width, width);
    const Parts parts(good);
    const auto expect_every_byte_counts = [&](std::size_t begin, std::size_t end, std::size_t size, const char* place) {
      ASSERT_LT(begin, end) << place;
      for (std::size_t i = begin; i < end; ++i) {
        if ((i - begin) % size == 0) continue;
        std::string bytes = good;
        ASSERT_EQ(bytes[i], 0) << place;
        bytes[i] = 1;
        const std::string said = problem(with_checksum(bytes));
        EXPECT_TRUE(said.starts_with(std::string("net.epsn: ") + place)) << place << ", byte " << i << ": " << said;
      }
    };
    expect_every_byte_counts(parts.charts, parts.vertices, width, "vertices[");
    expect_every_byte_counts(parts.vertices, parts.opposites, 4, "triangles[");
    expect_every_byte_counts(parts.opposites, parts.labelled, 4, "opposites[");
    expect_every_byte_counts(parts.labels, good.size() - 8, width, "triangles[");
  }
}

TEST_F(Compact, AnyEndIsNoticed) {
  for (std::size_t size = kCompactMagic.size(); size < good_.size(); ++size) {
    EXPECT_EQ(problem(good_.substr(0, size)),
              size < 16 ? "net.epsn: checksum: the file ends before it"
                        : "net.epsn: checksum: the file was damaged, or is not complete: its checksum is another")
        << size;
  }
  EXPECT_EQ(problem(good_ + '\0'),
            "net.epsn: checksum: the file was damaged, or is not complete: its checksum is another");
  EXPECT_EQ(problem(with_checksum(good_ + "12345678")), "net.epsn: checksum: 8 bytes too many before it");
}

TEST_F(Compact, AHeaderThatEndsEarlyIsNamed) {
  for (std::size_t there = 0; there < 24; ++there) {
    EXPECT_EQ(problem(with_checksum(good_.substr(0, 8 + there) + "12345678")),
              "net.epsn: header: has 4 bytes, of which " + std::to_string(there % 4) + " are there");
  }
}

TEST_F(Compact, LabelsThatEndEarlyAreNamed) {
  for (const std::uint32_t width : {1U, 2U, 4U}) {
    const std::string bytes = widened(good_, width, width);
    const std::size_t size = bytes.size() - 8 - Parts(bytes).labels;
    for (std::size_t missing = 1; missing <= size; ++missing) {
      EXPECT_EQ(problem(with_checksum(bytes.substr(0, bytes.size() - missing))),
                "net.epsn: labels of corners: has " + std::to_string(size) + " bytes, of which " +
                    std::to_string(size - missing) + " are there");
    }
  }
}

/// A file is read in pieces of 2^18 bytes, of which the first ends here in the checksum or next to it.
TEST_F(Compact, PiecesMayEndInTheChecksum) {
  NetDocument document = parse_file<NetDocument>(good_, "test");
  document.surface.about = "a";
  const std::size_t least = compact(document).size();
  for (std::size_t more = 0; more <= 20; ++more) {
    const std::size_t size = (std::size_t{1} << 18U) + more;
    document.surface.about.assign(1 + size - least, 'a');
    const std::string bytes = compact(document);
    ASSERT_EQ(bytes.size(), size);
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::tmpfile(), &std::fclose);
    ASSERT_EQ(std::fwrite(bytes.data(), 1, size, file.get()), size);
    std::rewind(file.get());
    ByteStream pieces(file.get(), size, {});
    EXPECT_EQ(parse_compact(pieces, [](std::string_view head) { return parse_file<NetDocument>(head, "head"); }),
              document)
        << more;
  }
}

TEST_F(Compact, EveryRuleOfTheFormatIsNamed) {
  EXPECT_EQ(after([](std::string&) {}), "");
  for (const std::uint32_t version : {0U, 2U}) {
    EXPECT_EQ(
        after([&](std::string& b) { set_word(b, 8, version); }),
        "net.epsn: header: version " + std::to_string(version) + " is not a version this program reads, expected 1");
  }
  EXPECT_TRUE(after([](std::string& b) {
                set_word(b, 12, 0xffffffff);
              }).starts_with("net.epsn: head: has 4294967295 bytes, of which "));
  EXPECT_TRUE(after([](std::string& b) { set_word(b, 16, 0xffffffff); }).starts_with("net.epsn: vertices: has "));
  for (const std::uint32_t triangles : {(1U << 30) + 1, 0xffffffffU}) {
    EXPECT_EQ(after([&](std::string& b) { set_word(b, 20, triangles); }),
              "net.epsn: header: more than the limit of 1073741824 triangles");
  }
  EXPECT_TRUE(after([](std::string& b) { set_word(b, 20, 1U << 30); }).starts_with("net.epsn: triangles: has "));
  EXPECT_EQ(after([](std::string& b) { set_word(b, 20, word(b, 20) - 1); }),
            "net.epsn: triangles: an odd number of darts, which cannot be paired");
  EXPECT_EQ(after([](std::string& b) { set_word(b, 24, 3); }),
            "net.epsn: header: charts of vertices: a width of 3 bytes, expected 1, 2 or 4");
  EXPECT_EQ(after([](std::string& b) { set_word(b, 28, 0); }),
            "net.epsn: header: labels of corners: a width of 0 bytes, expected 1, 2 or 4");
  EXPECT_TRUE(after([&](std::string& b) { b[parts_.head] = '['; }).starts_with("net.epsn: head: "));
  EXPECT_EQ(after([&](std::string& b) { set_word(b, parts_.opposites, 0); }),
            "net.epsn: opposites[0]: the opposite of dart 0 is 0, expected a later dart that has none");
  EXPECT_EQ(after([&](std::string& b) { set_word(b, parts_.opposites, 3 * word(b, 20)); }),
            "net.epsn: opposites[0]: the opposite of dart 0 is " + std::to_string(3 * net_.triangles.size()) +
                ", expected a later dart that has none");
  EXPECT_EQ(after([&](std::string& b) { set_word(b, parts_.opposites + 4, word(b, parts_.opposites)); }),
            "net.epsn: opposites[1]: the opposite of dart 1 is " + std::to_string(net_.triangles[0].opposite[0]) +
                ", expected a later dart that has none");
  EXPECT_EQ(after([&](std::string& b) { b[parts_.labels] = 0; }),
            "net.epsn: labels of corners[0]: 0, expected another, as the corner is said to have one");
  EXPECT_EQ(after([&](std::string& b) { b[parts_.labels + 2] = 0; }),
            "net.epsn: labels of corners[2]: 0, expected another, as the corner is said to have one");
  ASSERT_NE(2 * net_.triangles.size() % 8, 0U);
  for (std::size_t bit = 2 * net_.triangles.size() % 8; bit < 8; ++bit) {
    EXPECT_EQ(after([&](std::string& b) { b[parts_.labels - 1] = static_cast<char>(b[parts_.labels - 1] | 1 << bit); }),
              "net.epsn: labelled corners: a bit beyond the last corner is set");
  }
  // What a net file must not say either.
  EXPECT_TRUE(
      after([&](std::string& b) { set_word(b, parts_.vertices, 1U << 31); }).starts_with("net.epsn: triangles[0]: "));
  EXPECT_TRUE(after([&](std::string& b) { b[parts_.charts] = 77; }).starts_with("net.epsn: vertices[0]: "));
}

TEST_F(Compact, TheHeadHasNoVertices) {
  const auto with_head = [&](const NetDocument& head) {
    std::ostringstream text;
    write_file(head, text);
    std::string bytes = good_.substr(0, 32) + text.str() + good_.substr(parts_.x);
    set_word(bytes, 12, static_cast<std::uint32_t>(text.str().size()));
    return problem(with_checksum(bytes));
  };
  NetDocument head = net_;
  EXPECT_EQ(with_head(head), "net.epsn: head: vertices or triangles in the JSON text, expected none");
  head.vertices.clear();
  EXPECT_EQ(with_head(head), "net.epsn: head: vertices or triangles in the JSON text, expected none");
  head.triangles.clear();
  EXPECT_EQ(with_head(head), "");
  head.vertices = net_.vertices;
  EXPECT_EQ(with_head(head), "net.epsn: head: vertices or triangles in the JSON text, expected none");
}

TEST_F(SlowCompact, WhateverIsReadIsWrittenTheSame) {
  std::mt19937_64 random(7);
  int readable = 0;
  for (int k = 0; k < 3000; ++k) {
    std::string bytes = good_;
    for (int changes = 0; changes < 1 + k % 3; ++changes) {
      bytes[parts_.x + random() % (bytes.size() - 8 - parts_.x)] = static_cast<char>(random());
    }
    try {
      const NetDocument document = parse_file<NetDocument>(with_checksum(bytes), "compact");
      ++readable;
      EXPECT_EQ(parse_file<NetDocument>(compact(document), "compact"), document);
    } catch (const MalformedError&) {
    }
  }
  EXPECT_GT(readable, 300);
}

}  // namespace
}  // namespace epsnet::certify::compact_test
