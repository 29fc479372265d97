// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/clips/clip_table.h"
#include "tests/capture/temporary_folder.h"

#include <gtest/gtest.h>

#include <fstream>

namespace dewpoint::tests {
namespace {

TEST(ClipTable, GivesTheColumnsThatAreRequested) {
  const test::TemporaryFolder folder;
  std::ofstream(folder / "t.csv") << "# a comment\nframe,color,u,v\n3,red,1.5,-2\n\n4,blue,7,8\r\n";
  const auto table = readClipTable(folder / "t.csv", {"v", "frame"}, "color");
  ASSERT_TRUE(table) << errorSentence(table.error());
  EXPECT_EQ(table->rows, (std::vector<std::vector<double>>{{-2.0, 3.0}, {8.0, 4.0}}));
  EXPECT_EQ(table->wordCells, (std::vector<std::string>{"red", "blue"}));
}

TEST(ClipTable, NamesWhatIsWrong) {
  const test::TemporaryFolder folder;
  EXPECT_EQ(readClipTable(folder / "none.csv", {"u"}).error().code, ErrorCode::FileMissing);
  std::ofstream(folder / "empty.csv") << "# nothing else\n";
  EXPECT_EQ(readClipTable(folder / "empty.csv", {"u"}).error().code, ErrorCode::NotParsed);
  std::ofstream(folder / "t.csv") << "# a comment\nu,v\n1,2\n3,x\n";
  const auto column = readClipTable(folder / "t.csv", {"w"});
  EXPECT_EQ(column.error().code, ErrorCode::MissingKey);
  EXPECT_EQ(column.error().field, "w");
  const auto cell = readClipTable(folder / "t.csv", {"u", "v"});
  EXPECT_EQ(cell.error().code, ErrorCode::NotParsed);
  EXPECT_EQ(cell.error().field, "line 4");
  std::ofstream(folder / "t.csv") << "u,v\n1\n";
  EXPECT_EQ(readClipTable(folder / "t.csv", {"v"}).error().field, "line 2") << "the row is short";
}

TEST(ClipTable, HasFiniteNumbersAndFramesWithinALimit) {
  const test::TemporaryFolder folder;
  std::ofstream(folder / "t.csv") << "u\nnan\n";
  EXPECT_EQ(readClipTable(folder / "t.csv", {"u"}).error().field, "line 2");
  const std::filesystem::path file = folder / "f.csv";
  EXPECT_TRUE(checkFrameColumns({{{0.0, -1.0}, {1e6, 0.5}}, {}}, {"frame"}, file));
  for (const double number : {-1.0, 0.5, 1e6 + 1.0, 1e300}) {
    const auto checked = checkFrameColumns({{{3.0, number}}, {}}, {"frame", "cam_id"}, file);
    ASSERT_FALSE(checked) << number;
    EXPECT_EQ(checked.error().code, ErrorCode::NotParsed);
    EXPECT_EQ(checked.error().file, file.string());
    EXPECT_EQ(checked.error().field, "cam_id");
  }
}

} // namespace
} // namespace dewpoint::tests
