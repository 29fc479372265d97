// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/crash_report.h"
#include "core/base/text_file.h"

#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <string>

namespace dewpoint::tests {
namespace {

namespace fs = std::filesystem;

class CrashReport : public testing::Test {
protected:
  void SetUp() override {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::path(testing::TempDir()) / (std::string("CrashReport") + info->name());
    fs::remove_all(folder_);
    file_ = folder_ / "below" / "crash.txt";
  }
  void TearDown() override { fs::remove_all(folder_); }
  std::string report() const { return readTextFile(file_).value_or(std::string()); }

  fs::path folder_;
  fs::path file_;
};

TEST_F(CrashReport, HoldsTheHeadingTheSignalAndTheNotes) {
  EXPECT_EXIT(
      {
        (void)enableCrashReport(file_, "Dewpoint 9.9, started today");
        addCrashReportNote("opened the demo");
        addCrashReportNote("message: no images");
        std::abort();
      },
      testing::KilledBySignal(SIGABRT), "");
  const std::string text = report();
  const auto first = text.find("opened the demo");
  EXPECT_EQ(text.rfind("Dewpoint 9.9, started today\nSIGABRT", 0), 0U) << text;
  EXPECT_NE(first, std::string::npos) << text;
  EXPECT_LT(first, text.find("message: no images")) << text;
  EXPECT_NE(text.find("Stack:\n"), std::string::npos) << text;
  EXPECT_GT(text.size(), text.find("Stack:\n") + 20) << "no stack: " << text;
}

TEST_F(CrashReport, KeepsOnlyTheNewestNotesAndCutsLongOnes) {
  EXPECT_EXIT(
      {
        (void)enableCrashReport(file_, "heading");
        for (std::size_t k = 0; k < kCrashNotes + 3; ++k) {
          addCrashReportNote("note " + std::to_string(k) + ".");
        }
        addCrashReportNote(std::string(10 * kCrashNoteLength, 'x'));
        std::abort();
      },
      testing::KilledBySignal(SIGABRT), "");
  const std::string text = report();
  EXPECT_EQ(text.find("note 3."), std::string::npos) << text;
  EXPECT_NE(text.find("\nnote 4.\n"), std::string::npos) << text;
  EXPECT_NE(text.find("\n" + std::string(kCrashNoteLength, 'x') + "\n"), std::string::npos) << text;
}

TEST_F(CrashReport, IsNotThereWithoutACrash) {
  EXPECT_EXIT(
      {
        (void)enableCrashReport(file_, "heading");
        addCrashReportNote("all is well");
        std::_Exit(0);
      },
      testing::ExitedWithCode(0), "");
  EXPECT_TRUE(fs::exists(file_.parent_path()));
  EXPECT_FALSE(fs::exists(file_));
}

TEST_F(CrashReport, SaysThatItsFolderCannotBeMade) {
  ASSERT_TRUE(fs::create_directories(folder_));
  ASSERT_TRUE(writeTextFile(folder_ / "below", "a file"));
  const auto enabled = enableCrashReport(file_, "heading");
  ASSERT_FALSE(enabled.has_value());
  EXPECT_EQ(enabled.error().code, ErrorCode::FileUnwritable);
  EXPECT_EQ(enabled.error().file, file_.string());
}

} // namespace
} // namespace dewpoint::tests
