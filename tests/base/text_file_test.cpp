// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/limits.h"
#include "core/base/table_text.h"
#include "core/base/text_file.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace dewpoint::tests {
namespace {

namespace fs = std::filesystem;

class TextFile : public testing::Test {
protected:
  void SetUp() override {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    file_ = fs::path(testing::TempDir()) / (std::string("TextFile") + info->name());
  }
  void TearDown() override { fs::remove(file_); }
  fs::path write(const std::string& bytes) {
    std::ofstream(file_, std::ios::binary) << bytes;
    return file_;
  }

  fs::path file_;
};

TEST_F(TextFile, IsReadByteByByte) {
  const std::string text = std::string("a\r\n\0\xFF", 5) + std::string(200'000, 'x');
  EXPECT_EQ(base::readTextFile(write(text)).value(), text);
  EXPECT_EQ(base::readTableText(file_).value(), text);
  EXPECT_EQ(base::readTextFile(write("")).value(), "");
}

TEST_F(TextFile, HasNoByteOrderMark) {
  EXPECT_EQ(base::readTextFile(write("\xEF\xBB\xBF"
                                     "a = 1"))
                .value(),
            "a = 1");
}

TEST_F(TextFile, ThatIsMissingOrNoFileIsAnError) {
  EXPECT_EQ(base::readTextFile(file_).error().code, ErrorCode::FileMissing);
  EXPECT_EQ(base::readTextFile(fs::path(testing::TempDir())).error().detail, "it is a folder");
  // It never ends.
  EXPECT_EQ(base::errorSentence(base::readTextFile("/dev/zero").error()),
            "/dev/zero: the file cannot be read (it is a device)");
}

TEST_F(TextFile, LargerThanItsLimitIsAnError) {
  write("x");
  fs::resize_file(file_, base::limits::kMaxTextBytes + 1); // of a file with a hole
  EXPECT_EQ(base::readTextFile(file_).error().code, ErrorCode::FileUnreadable);
  EXPECT_EQ(base::readTextFile(file_).error().detail, "it is larger than 64 MiB");
  fs::resize_file(file_, base::limits::kMaxTableBytes + 1);
  EXPECT_EQ(base::readTableText(file_).error().detail, "it is larger than 4096 MiB");
}

} // namespace
} // namespace dewpoint::tests
