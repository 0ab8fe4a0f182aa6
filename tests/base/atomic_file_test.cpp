#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <thread>

#include "hydro/Errors.h"
#include "hydro/base/AtomicFile.h"

namespace cutwater::test {
namespace {

namespace fs = std::filesystem;

std::string textOf(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

struct AtomicFile : testing::Test {
  fs::path folder = fs::temp_directory_path() / ("cutwater_atomic_" + std::to_string(::getpid()));
  AtomicFile() { fs::create_directory(folder); }
  ~AtomicFile() override { fs::remove_all(folder); }
  auto files() const { return std::distance(fs::directory_iterator(folder), {}); }
};

TEST_F(AtomicFile, ReplacesTheWholeFileAndLeavesNoOther) {
  const fs::path path = folder / "file";
  writeWhole(path, "a long first text");
  writeWhole(path, "short");
  EXPECT_EQ(textOf(path), "short");
  EXPECT_EQ(files(), 1);
}

TEST_F(AtomicFile, LinkStaysALink) {
  writeWhole(folder / "file", "old");
  fs::create_symlink("file", folder / "link");
  writeWhole(folder / "link", "new");
  EXPECT_TRUE(fs::is_symlink(folder / "link"));
  EXPECT_EQ(textOf(folder / "file"), "new");
}

TEST_F(AtomicFile, PipeIsWrittenAsItIs) {
  const fs::path pipe = folder / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  std::string read;
  std::thread reader([&] { read = textOf(pipe); });
  writeWhole(pipe, "through");
  reader.join();
  EXPECT_EQ(read, "through");
  EXPECT_EQ(files(), 1);
}

TEST_F(AtomicFile, ModeIsKeptAndANewFileHasTheUsualOne) {
  const fs::path path = folder / "file";
  writeWhole(path, "first");
  const mode_t mask = ::umask(0);
  ::umask(mask);
  EXPECT_EQ(static_cast<unsigned>(fs::status(path).permissions()), 0666u & ~mask);
  fs::permissions(path, fs::perms(0640));
  writeWhole(path, "second");
  EXPECT_EQ(fs::status(path).permissions(), fs::perms(0640));
}

// Of root as well, who could write it.
TEST_F(AtomicFile, ReadOnlyFileIsRefused) {
  const fs::path path = folder / "file";
  writeWhole(path, "mine");
  fs::permissions(path, fs::perms(0444));
  fs::create_symlink("file", folder / "link");
  for (const char* name : {"file", "link"}) {
    EXPECT_THROW(writeWhole(folder / name, "other"), HydroError);
    EXPECT_THROW(requireWritable(folder / name), HydroError);
  }
  EXPECT_EQ(textOf(path), "mine");
  EXPECT_EQ(files(), 2);
}

TEST_F(AtomicFile, ADiskThatIsFullLeavesTheOldFile) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full";
  EXPECT_THROW(writeWhole("/dev/full", "text"), HydroError);
  EXPECT_TRUE(fs::is_character_file("/dev/full"));
}

TEST_F(AtomicFile, WorkIsRefusedBeforeWhereItsResultWouldBe) {
  EXPECT_NO_THROW(requireWritable(folder / "new"));
  EXPECT_NO_THROW(requireWritable("new"));  // in the folder that we are in
  EXPECT_NO_THROW(requireWritable("/dev/null"));
  EXPECT_THROW(requireRegular("/dev/null"), HydroError);
  for (const fs::path& path : {folder / "no" / "file", folder, fs::path()})
    EXPECT_THROW(requireWritable(path), HydroError) << path;
  EXPECT_EQ(files(), 0);
}

TEST_F(AtomicFile, RefusalNamesTheFileAndLeavesNothing) {
  fs::create_directory(folder / "folder");
  fs::create_symlink("nowhere", folder / "dangling");
  for (const char* name : {"missing/file", "folder", "dangling"}) {
    try {
      writeWhole(folder / name, "text");
      ADD_FAILURE() << name << " was written";
    } catch (const HydroError& error) {
      EXPECT_EQ(error.fault(), Fault::FileNotWritable);
      EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << error.what();
    }
  }
  EXPECT_EQ(files(), 2);
}

}  // namespace
}  // namespace cutwater::test
