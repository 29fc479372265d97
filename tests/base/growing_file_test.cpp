// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/growing_file.h"
#include "core/base/text_file.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

TEST(GrowingFile, CanBeReadWhileItGrows) {
  const auto path = std::filesystem::path(testing::TempDir()) / "growing.txt";
  ASSERT_TRUE(writeTextFile(path, "what was there before"));
  auto file = GrowingFile::create(path);
  ASSERT_TRUE(file);
  EXPECT_EQ(readTextFile(path).value(), "");
  ASSERT_TRUE(file->append("one\n"));
  EXPECT_EQ(readTextFile(path).value(), "one\n");
  ASSERT_TRUE(file->append("two\n"));
  ASSERT_TRUE(file->close());
  EXPECT_EQ(readTextFile(path).value(), "one\ntwo\n");
}

TEST(GrowingFile, SaysThatTheDiskIsFull) {
  auto file = GrowingFile::create("/dev/full"); // every write fails there as on a full disk
  ASSERT_TRUE(file);
  const auto written = file->append("one\n");
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().code, ErrorCode::FileUnwritable);
  EXPECT_EQ(written.error().file, "/dev/full");
  EXPECT_EQ(written.error().detail, "No space left on device");
}

TEST(GrowingFile, RefusesWhatCannotBeMadeAndWhatIsClosed) {
  const auto missing = GrowingFile::create("/no/such/folder/file.txt");
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().code, ErrorCode::FileUnwritable);

  auto file = GrowingFile::create(std::filesystem::path(testing::TempDir()) / "closed.txt");
  ASSERT_TRUE(file);
  ASSERT_TRUE(file->close());
  EXPECT_FALSE(file->append("more"));
  EXPECT_FALSE(file->close());
}

} // namespace
} // namespace dewpoint::tests
