// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/capture_times.h"
#include "tests/capture/temporary_folder.h"

#include <gtest/gtest.h>

#include <fstream>

namespace dewpoint::tests {
namespace {

using test::TemporaryFolder;

class CaptureTimesFile : public testing::Test {
protected:
  Result<CaptureTimes> read(const std::string& text, const std::vector<std::string>& ids = {}) {
    std::ofstream(file_) << text;
    return readCaptureTimes(file_, ids, "camera left");
  }
  Error errorOf(const std::string& text, const std::vector<std::string>& ids = {}) {
    const auto times = read(text, ids);
    EXPECT_FALSE(times);
    return times ? Error{} : times.error();
  }

  TemporaryFolder folder_;
  std::string file_ = folder_ / "times.csv";
};

TEST_F(CaptureTimesFile, WithoutAHeadingHoldsSeconds) {
  EXPECT_EQ(read("0\n0.1\n0.25\n").value(), (CaptureTimes{0.0, 0.1, 0.25}));
  EXPECT_EQ(read("0 5.5\r\n1 5.75\r\n").value(), (CaptureTimes{5.5, 5.75}));
  EXPECT_EQ(read("# made by a camera\n\n1e1\n").value(), (CaptureTimes{10.0}));
}

TEST_F(CaptureTimesFile, HasUnitsInItsHeading) {
  EXPECT_EQ(read("frame;timestamp_ms\n0;500\n1;750\n").value(), (CaptureTimes{0.5, 0.75}));
  EXPECT_EQ(read("\"Time_us\",frame\n2000000,7\n").value(), (CaptureTimes{2.0}));
  EXPECT_EQ(read("t\tx\n3\t1\n").value(), (CaptureTimes{3.0}));
}

TEST_F(CaptureTimesFile, HasLinesOfSeveralCamerasInAnyOrder) {
  const std::string table = "sync_index,cam_id,frame_time\n0,1,2.5\n0,0,2.25\n1,0,2.0\n1,1,3.0\n";
  EXPECT_EQ(read(table, {"left", "0"}).value(), (CaptureTimes{2.0, 2.25}));
  EXPECT_EQ(read(table, {"1", "0"}).value(), (CaptureTimes{2.5, 3.0}));
  EXPECT_EQ(errorOf(table, {"left", "2"}).detail, "it has no line for camera left or 2");
}

TEST_F(CaptureTimesFile, OfWindowsIsTheSame) {
  EXPECT_EQ(read("\xEF\xBB\xBFtime_s,cam_id\r\n2.5,0\r\n3,0\r\n", {"0"}).value(),
            (CaptureTimes{2.5, 3.0}));
}

TEST_F(CaptureTimesFile, OfALineWithoutAnEndIsAnError) {
  EXPECT_EQ(errorOf("time_s\n" + std::string(1'000'000, ',') + "\n").code, ErrorCode::NotParsed);
  EXPECT_EQ(errorOf(std::string(1'000'000, '1')).code, ErrorCode::BadValue); // 1e999999
  EXPECT_EQ(errorOf("time_s\n1e400\n").code, ErrorCode::NotParsed);
}

TEST_F(CaptureTimesFile, SaysWhatIsWrong) {
  EXPECT_EQ(readCaptureTimes(folder_ / "none.csv", {}, "camera left").error().code,
            ErrorCode::FileMissing);
  EXPECT_EQ(errorOf("").code, ErrorCode::BadValue);
  EXPECT_EQ(errorOf("a,b\n1,2\n").detail, "it has no column time_s, frame_time or timestamp");
  const Error cut = errorOf("frame,time_s\n0,0.5\n1\n");
  EXPECT_EQ(cut.code, ErrorCode::NotParsed);
  EXPECT_EQ(cut.detail, "line 3 has no time in column 2");
  EXPECT_EQ(cut.field, "camera left");
  EXPECT_EQ(errorOf("time_s\n0.5\nnan\n").code, ErrorCode::NotParsed);
  EXPECT_EQ(errorOf("0.5\n0.25\n0.5\n").detail, "two images have the time 0.5 s");
}

} // namespace
} // namespace dewpoint::tests
