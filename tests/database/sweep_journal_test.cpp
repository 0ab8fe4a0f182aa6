#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "hydro/Errors.h"
#include "hydro/database/SweepJournal.h"

namespace cutwater::test {
namespace {

namespace fs = std::filesystem;

class SweepJournalFile : public ::testing::Test {
 protected:
  void SetUp() override { fs::remove(path); }
  void TearDown() override { fs::remove(path); }
  static std::vector<double> numbers(double first) { return {first, -0.0, 1e-310}; }
  void fill() const {
    SweepJournal journal(path, 7, 3);
    journal.append(4, numbers(4.0));
    journal.append(0, numbers(0.5));
  }
  // Tests run beside one another: a file for each.
  const std::string path =
      (fs::path(::testing::TempDir()) /
       (std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()) + ".sweep"))
          .string();
};

TEST_F(SweepJournalFile, GivesBackWhatWasAppended) {
  fill();
  const SweepJournal again(path, 7, 3);
  ASSERT_EQ(again.found().size(), 2u);
  EXPECT_EQ(again.found().at(4), numbers(4.0));
  EXPECT_EQ(again.found().at(0), numbers(0.5));
}

// Killed while it wrote: the file may end anywhere. What is whole is kept, and appending goes on.
TEST_F(SweepJournalFile, ATornEndIsCutOffWhereverItIs) {
  fill();
  const auto size = fs::file_size(path);
  for (auto left = size; left-- > 0;) {
    fs::remove(path);
    fill();
    fs::resize_file(path, left);
    std::size_t kept = 0;
    {
      SweepJournal torn(path, 7, 3);
      kept = torn.found().size();
      EXPECT_LT(kept, 2u);
      torn.append(9, numbers(9.0));
    }
    const SweepJournal again(path, 7, 3);
    ASSERT_EQ(again.found().size(), kept + 1) << left;
    EXPECT_EQ(again.found().at(9), numbers(9.0));
  }
}

TEST_F(SweepJournalFile, AChangedByteLosesItsRecordOnly) {
  fill();
  std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
  file.seekp(static_cast<std::streamoff>(fs::file_size(path)) - 20);
  file.put('x');
  file.close();
  const SweepJournal again(path, 7, 3);
  ASSERT_EQ(again.found().size(), 1u);
  EXPECT_TRUE(again.found().contains(4));
}

// Nothing is thrown away: each ship and setting finds its own frequencies again.
TEST_F(SweepJournalFile, AnotherShipOrSettingBeginsAnewAndKeepsTheOld) {
  fill();
  const std::string aside = path + ".0000000000000007";
  {
    SweepJournal other(path, 8, 3);
    EXPECT_TRUE(other.found().empty());
    EXPECT_TRUE(fs::exists(aside));
    other.append(1, numbers(1.0));
  }
  EXPECT_EQ(SweepJournal(path, 7, 3).found().size(), 2u);
  EXPECT_FALSE(fs::exists(aside));
  EXPECT_EQ(SweepJournal(path, 8, 3).found().size(), 1u);
  fs::remove(aside);
}

TEST_F(SweepJournalFile, OneProgramAtATimeAndNoLinks) {
  {
    const SweepJournal first(path, 7, 3);
    EXPECT_THROW(SweepJournal(path, 7, 3), HydroError);
    EXPECT_THROW(SweepJournal(path, 8, 3), HydroError);  // and it does not move it away
  }
  EXPECT_NO_THROW(SweepJournal(path, 7, 3));
  const std::string notes = path + ".notes";
  fs::remove(path);
  std::ofstream(notes) << "";
  fs::create_symlink(notes, path);
  EXPECT_THROW(SweepJournal(path, 7, 3), HydroError);
  EXPECT_EQ(fs::file_size(notes), 0u);
  fs::remove(notes);
}

TEST_F(SweepJournalFile, LeavesOtherFilesAlone) {
  for (const std::string text : {"my notes", "notes that are longer than the head of a journal"}) {
    std::ofstream(path, std::ios::trunc) << text;
    EXPECT_THROW(SweepJournal(path, 7, 3), HydroError);
    EXPECT_EQ(fs::file_size(path), text.size());
  }
  EXPECT_THROW(SweepJournal("/no/such/folder/x.sweep", 7, 3), HydroError);
}

}  // namespace
}  // namespace cutwater::test
