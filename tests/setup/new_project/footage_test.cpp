// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/new_project/footage.h"

#include <gtest/gtest.h>

#include <fstream>

namespace dewpoint::tests {
namespace {

namespace fs = std::filesystem;

class FootageTest : public testing::Test {
protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) / "footage" /
              testing::UnitTest::GetInstance()->current_test_info()->name();
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  std::string write(const std::string& name, const std::string& bytes = "") const {
    fs::create_directories((folder_ / name).parent_path());
    std::ofstream(folder_ / name, std::ios::binary) << bytes;
    return (folder_ / name).string();
  }

  fs::path folder_;
};

TEST(Footage, NumbersAreSortedByTheirValue) {
  const std::vector<std::string> sorted{"/z/cam 1.mkv", "/y/cam 2.mkv", "/x/cam 10.mkv"};
  EXPECT_EQ(sortedInNaturalOrder({sorted[2], sorted[1], sorted[0]}),
            sorted); // folders do not count
  EXPECT_TRUE(isBeforeInDisplayOrder("a9b10", "a10b9"));
  EXPECT_TRUE(isBeforeInDisplayOrder("cam 007", "cam 8"));
  EXPECT_TRUE(
      isBeforeInDisplayOrder("12345678901234567890", "12345678901234567891")); // beyond 64 bits
  EXPECT_FALSE(isBeforeInDisplayOrder("cam 2", "cam 2"));
}

TEST(Footage, LettersAreSortedAsPeopleDo) {
  EXPECT_TRUE(isBeforeInDisplayOrder("ball", "Camera"));
  EXPECT_TRUE(isBeforeInDisplayOrder("Camera", "door"));
  EXPECT_TRUE(isBeforeInDisplayOrder("Ärmel", "Bild")); // as an A
  EXPECT_TRUE(isBeforeInDisplayOrder("cam", "cam 1"));
  EXPECT_TRUE(isBeforeInDisplayOrder("cam_1", "cam1")); // signs, digits, letters
  EXPECT_TRUE(isBeforeInDisplayOrder("cam1", "cama"));
  EXPECT_NE(isBeforeInDisplayOrder("a1", "A1"),
            isBeforeInDisplayOrder("A1", "a1")); // an order even so
}

TEST_F(FootageTest, AnEndingTellsFootage) {
  EXPECT_TRUE(isFootage(write("left.MKV")));
  EXPECT_TRUE(isFootage(write("0001.png")));
  EXPECT_TRUE(isFootage(write("stream.h264")));
  EXPECT_FALSE(isFootage(write("truth.csv", "frame,x,y,z\n")));
  EXPECT_FALSE(isFootage(write("notes")));
}

TEST_F(FootageTest, WithoutAKnownEndingTheBeginningTells) {
  EXPECT_TRUE(isFootage(write("recording", "\x1A\x45\xDF\xA3 matroska")));
  EXPECT_TRUE(isFootage(write("clip.001", std::string("\0\0\0\x18"
                                                      "ftypisom",
                                                      12))));
  EXPECT_TRUE(isFootage(write("old.part", "RIFF....AVI LIST")));
  EXPECT_FALSE(isFootage(write("sound.part", "RIFF....WAVEfmt ")));
}

TEST_F(FootageTest, AFolderNeedsAnImage) {
  write("images/0.jpg");
  write("tables/0.csv");
  EXPECT_TRUE(canBeImageSource((folder_ / "images").string()));
  EXPECT_FALSE(canBeImageSource((folder_ / "tables").string()));
  EXPECT_TRUE(
      canBeImageSource("rtsp://camera.example/1")); // what is missing is said when it is opened
  EXPECT_TRUE(canBeImageSource("/dev/null"));
}

TEST_F(FootageTest, AFolderOfRecordingsIsTakenInNaturalOrder) {
  for (const char* name : {"cam 10.mkv", "cam 2.mkv", "truth.csv", "poster.png", "cam 3/0.png"}) {
    write(name);
  }
  const auto expected = {(folder_ / "cam 2.mkv").string(), (folder_ / "cam 3").string(),
                         (folder_ / "cam 10.mkv").string()};
  EXPECT_EQ(footageIn(folder_), std::vector<std::string>(expected));
  EXPECT_TRUE(footageIn(folder_ / "nowhere").empty());
}

} // namespace
} // namespace dewpoint::tests
