#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <ostream>
#include <stdexcept>
#include <string>
#include <sys/stat.h>
#include <vector>

#include "certify/file/file.h"
#include "netgen/base/atomic_file.h"
#include "netgen/exchange/exchange.h"
#include "netgen/exchange/text_formats.h"
#include "netgen/surfaces/surfaces.h"
#include "tests/support/polygons.h"

namespace epsnet::surface_file_test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// Each test has its own directory.
class FileTest : public testing::Test {
 public:
  FileTest() {
    std::string name = testing::TempDir() + "/epsnet-XXXXXX";
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary directory");
    directory_ = name;
  }
  FileTest(const FileTest&) = delete;
  FileTest& operator=(const FileTest&) = delete;
  ~FileTest() override { fs::remove_all(directory_); }

 protected:
  [[nodiscard]] std::size_t files() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(directory_), fs::directory_iterator()));
  }

  fs::path directory_;
};

using SurfaceFile = FileTest;
using AtomicFile = FileTest;

template <class Error>
std::string complaint(const std::function<void()>& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

void write_text(const fs::path& path, const std::string& text) {
  write_file_atomically(path, [&](std::ostream& out) { out << text; });
}

void save(const Surface& surface, const fs::path& path) {
  std::ofstream out(path);
  certify::write_file(to_document(surface), out);
}

TEST_F(SurfaceFile, WhatIsSavedLoadsTheSame) {
  for (const auto& path : test::data_files("polygons")) {
    const Surface surface = test::imported(path);
    save(surface, directory_ / "a.json");
    const Surface copy = load_surface(directory_ / "a.json");
    EXPECT_EQ(copy.tiles(), surface.tiles());
    EXPECT_EQ(copy.gluing(), surface.gluing());
    EXPECT_EQ(copy.genus(), surface.genus());
    save(copy, directory_ / "b.json");
    EXPECT_EQ(test::file_text(directory_ / "a.json"), test::file_text(directory_ / "b.json"));
  }
}

TEST_F(SurfaceFile, SeveralTilesLoadTheSame) {
  const auto polygon = test::with_vertex_on_side(test::paired_polygon(random_octagon(1)), 2, Rational(1, 3));
  const Surface surface = read_domain(test::domain_text(polygon), "test");
  save(surface, directory_ / "a.json");
  EXPECT_EQ(load_surface(directory_ / "a.json").tiles(), surface.tiles());
}

TEST_F(SurfaceFile, AWellFormedFileThatIsNoSurfaceIsASurfaceError) {
  save(random_octagon(123), directory_ / "a.json");
  std::string text = test::file_text(directory_ / "a.json");
  text.replace(text.find("3769/5000"), 9, "3768/5000");
  write_text(directory_ / "a.json", text);
  const std::string message = complaint<SurfaceError>([&] { static_cast<void>(load_surface(directory_ / "a.json")); });
  EXPECT_THAT(message, testing::StartsWith((directory_ / "a.json").string() + ": side "));
  EXPECT_THAT(message, HasSubstr("are paired but differ"));
}

TEST_F(SurfaceFile, MalformedAndMissingFilesAreErrorsOfTheirOwn) {
  write_text(directory_ / "a.json", "{}");
  EXPECT_THROW(static_cast<void>(load_surface(directory_ / "a.json")), certify::MalformedError);
  EXPECT_THROW(static_cast<void>(load_surface(directory_ / "none.json")), certify::FileError);
}

TEST_F(AtomicFile, CreatesAndReplaces) {
  const fs::path path = directory_ / "a";
  const std::string large(1'000'000, 'x');
  write_text(path, "first");
  EXPECT_EQ(test::file_text(path), "first");
  write_text(path, large);
  EXPECT_EQ(test::file_text(path), large);
  write_text(path, "");
  EXPECT_EQ(fs::file_size(path), 0U);
  EXPECT_EQ(files(), 1U);
}

TEST_F(AtomicFile, ARelativePathIsInTheCurrentFolder) {
  const fs::path before = fs::current_path();
  fs::current_path(directory_);
  write_text("a", "text");
  fs::current_path(before);
  EXPECT_EQ(test::file_text(directory_ / "a"), "text");
}

TEST_F(AtomicFile, ErrorLeavesTheOldFileAlone) {
  const fs::path path = directory_ / "a";
  write_text(path, "old");
  EXPECT_THROW(write_file_atomically(path,
                                     [](std::ostream& out) {
                                       out << std::string(1'000'000, 'x') << std::flush;
                                       throw std::domain_error("no more");
                                     }),
               std::domain_error);
  EXPECT_EQ(test::file_text(path), "old");
  EXPECT_THROW(write_file_atomically(path, [](std::ostream& out) { out.setstate(std::ios::failbit); }), WriteError);
  EXPECT_EQ(test::file_text(path), "old");
  EXPECT_EQ(files(), 1U);
}

TEST_F(AtomicFile, AFullDiskIsAnErrorHoweverLittleIsWritten) {
  for (const std::size_t size : {std::size_t{1}, std::size_t{1'000'000}}) {
    const std::string message = complaint<WriteError>([&] { write_text("/dev/full", std::string(size, 'x')); });
    EXPECT_EQ(message, "/dev/full: cannot be written: No space left on device");
  }
  EXPECT_TRUE(fs::exists("/dev/full"));
}

TEST_F(AtomicFile, APathThatCannotBeWrittenIsNamedAndNothingIsLeft) {
  EXPECT_THAT(complaint<WriteError>([&] { write_text(directory_ / "none" / "a", "x"); }),
              HasSubstr("none/a: cannot be created: there is no directory "));
  EXPECT_THAT(complaint<WriteError>([&] { write_text(directory_, "x"); }), HasSubstr("Is a directory"));
  EXPECT_THAT(complaint<WriteError>([&] { write_text("", "x"); }), HasSubstr("path to write to is empty"));
  EXPECT_EQ(files(), 0U);
}

TEST_F(AtomicFile, LinksAndPermissionsStay) {
  const fs::path path = directory_ / "a";
  write_text(path, "old");
  fs::permissions(path, fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink("a", directory_ / "link");
  fs::create_symlink("none", directory_ / "dangling");
  write_text(directory_ / "link", "new");
  EXPECT_TRUE(fs::is_symlink(directory_ / "link"));
  EXPECT_EQ(test::file_text(path), "new");
  EXPECT_EQ(fs::status(path).permissions(), fs::perms::owner_read | fs::perms::owner_write);
  write_text(directory_ / "dangling", "text");
  EXPECT_EQ(test::file_text(directory_ / "none"), "text");
  fs::create_symlink("loop", directory_ / "loop");
  EXPECT_THAT(complaint<WriteError>([&] { write_text(directory_ / "loop", "x"); }),
              HasSubstr("loop: cannot be opened"));
}

TEST_F(AtomicFile, EitherAllFilesAreReplacedOrNone) {
  const fs::path first = directory_ / "first";
  write_text(first, "old");
  const NewFile text{first, [](std::ostream& out) { out << "new"; }};
  const NewFile other{directory_ / "second", text.write};
  // A file that cannot be written, in any position; a full disk; another failure.
  for (const std::vector<NewFile>& files_to_write :
       {std::vector<NewFile>{text, {directory_ / "none" / "a", text.write}},
        std::vector<NewFile>{text, {directory_, text.write}},
        std::vector<NewFile>{text, other, {"/dev/full", text.write}},
        std::vector<NewFile>{{"/dev/full", text.write}, text, other}}) {
    EXPECT_THROW(write_files_atomically(files_to_write), WriteError);
    EXPECT_EQ(test::file_text(first), "old");
    EXPECT_EQ(files(), 1U);
  }
  EXPECT_THROW(write_files_atomically({text, other}, [] { throw std::domain_error("no more"); }), std::domain_error);
  EXPECT_EQ(test::file_text(first), "old");
  EXPECT_EQ(files(), 1U);
  write_files_atomically({text, other}, [&] { EXPECT_EQ(test::file_text(first), "old"); });
  EXPECT_EQ(test::file_text(first), "new");
  EXPECT_EQ(test::file_text(directory_ / "second"), "new");
  EXPECT_EQ(files(), 2U);
}

TEST_F(AtomicFile, WhatASignalHandlerRemovesIsGone) {
  const fs::path path = directory_ / "a";
  write_text(path, "old");
  std::size_t before = 0;
  std::size_t after = 0;
  EXPECT_THROW(write_file_atomically(path,
                                     [&](std::ostream& out) {
                                       out << "new";
                                       before = files();
                                       remove_temporary_files();
                                       after = files();
                                     }),
               WriteError);
  EXPECT_EQ(before, 2U);
  EXPECT_EQ(after, 1U);
  EXPECT_EQ(test::file_text(path), "old");
  remove_temporary_files();
  EXPECT_EQ(files(), 1U);
}

TEST_F(AtomicFile, CheckWritableTellsBeforeAnythingIsWritten) {
  write_text(directory_ / "a", "old");
  check_writable(directory_ / "a");
  check_writable(directory_ / "new");
  check_writable("/dev/null");
  EXPECT_EQ(test::file_text(directory_ / "a"), "old");
  EXPECT_EQ(files(), 1U);
  // A name cannot be written either if the longer name of the temporary file is too long.
  for (const fs::path& path : {directory_, directory_ / "none" / "a", fs::path(), directory_ / std::string(255, 'x')}) {
    EXPECT_THROW(check_writable(path), WriteError) << path;
  }
  EXPECT_EQ(files(), 1U);
}

}  // namespace
}  // namespace epsnet::surface_file_test
