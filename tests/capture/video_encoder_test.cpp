// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/text_file.h"
#include "core/capture/video_encoder.h"
#include "tests/capture/temporary_folder.h"

#include <gtest/gtest.h>
#include <opencv2/videoio.hpp>

#include <limits>

namespace dewpoint::tests {
namespace {

using test::TemporaryFolder;

/// FFV1, which every build of FFmpeg can write.
VideoOutput losslessOutput(const std::filesystem::path& file) {
  VideoOutput output;
  output.file = file;
  output.encoding = videoEncodings().back();
  output.width = 64;
  output.height = 48;
  return output;
}

cv::Mat grayPicture(int level) {
  return cv::Mat(48, 64, CV_8UC3, cv::Scalar::all(level));
}

std::size_t fileCount(const TemporaryFolder& folder) {
  const std::filesystem::directory_iterator files(folder / "");
  return static_cast<std::size_t>(std::distance(begin(files), end(files)));
}

TEST(VideoEncoder, WritesEveryEncodingThatItOffers) {
  const TemporaryFolder folder;
  const auto encodings = writableVideoEncodings(folder / "");
  EXPECT_EQ(fileCount(folder), 0U); // the probes are gone
  ASSERT_FALSE(encodings.empty());
  EXPECT_EQ(encodings.back().id, "ffv1");
  for (const VideoEncoding& encoding : encodings) {
    VideoOutput output = losslessOutput(folder / ("a" + std::string(encoding.suffix)));
    output.encoding = encoding;
    auto encoder = VideoEncoder::create(output);
    ASSERT_TRUE(encoder) << encoding.id;
    for (int frame = 0; frame < 20; ++frame) {
      ASSERT_TRUE(encoder->write(grayPicture(10 * frame))) << encoding.id;
    }
    EXPECT_FALSE(std::filesystem::exists(output.file)); // not before it is complete
    const auto finished = encoder->finish();
    EXPECT_TRUE(finished) << encoding.id;
    EXPECT_EQ(encoder->writtenFrameCount(), 20);
    cv::VideoCapture video(output.file.string(), cv::CAP_FFMPEG);
    cv::Mat picture;
    int frames = 0;
    while (video.read(picture)) {
      EXPECT_NEAR(cv::mean(picture)[1], 10.0 * frames, 6.0) << encoding.id;
      ++frames;
    }
    EXPECT_EQ(frames, 20) << encoding.id;
  }
}

TEST(VideoEncoder, TakesImagesWithAFourthChannel) {
  const TemporaryFolder folder;
  auto encoder = VideoEncoder::create(losslessOutput(folder / "a.mkv"));
  ASSERT_TRUE(encoder);
  EXPECT_TRUE(encoder->write(cv::Mat(48, 64, CV_8UC4, cv::Scalar(10, 20, 30, 0))));
  ASSERT_TRUE(encoder->finish());
  cv::Mat picture;
  ASSERT_TRUE(cv::VideoCapture(folder / "a.mkv", cv::CAP_FFMPEG).read(picture));
  EXPECT_NEAR(cv::mean(picture)[2], 30.0, 2.0);
}

TEST(VideoEncoder, LeavesNothingUnlessItIsFinished) {
  const TemporaryFolder folder;
  ASSERT_TRUE(writeTextFile(folder / "a.mkv", "precious"));
  {
    auto encoder = VideoEncoder::create(losslessOutput(folder / "a.mkv"));
    ASSERT_TRUE(encoder);
    EXPECT_TRUE(encoder->write(grayPicture(1)));
    EXPECT_EQ(fileCount(folder), 2U);
  }
  EXPECT_EQ(fileCount(folder), 1U);
  EXPECT_EQ(*readTextFile(folder / "a.mkv"), "precious");
}

TEST(VideoEncoder, AFullDiskIsOneSentenceAndLeavesNothing) {
  const TemporaryFolder folder;
  VideoOutput output = losslessOutput(folder / "a.mkv");
  output.reserve = std::numeric_limits<std::uintmax_t>::max(); // no disk has that much left
  const auto encoder = VideoEncoder::create(output);
  ASSERT_FALSE(encoder);
  EXPECT_EQ(encoder.error().code, ErrorCode::FileUnwritable);
  EXPECT_EQ(encoder.error().detail, "No space left on device");
  EXPECT_EQ(fileCount(folder), 0U);
}

TEST(VideoEncoder, SaysWhatIsWrong) {
  const TemporaryFolder folder;
  const auto errorOf = [](const VideoOutput& output) {
    const auto encoder = VideoEncoder::create(output);
    return encoder ? std::string() : errorSentence(encoder.error());
  };
  VideoOutput output = losslessOutput(folder / "no/such/a.mkv");
  EXPECT_NE(errorOf(output).find("No such file or directory"), std::string::npos);
  output = losslessOutput(folder / "a.mkv");
  output.width = 63;
  EXPECT_NE(errorOf(output).find("must be even"), std::string::npos);
  output = losslessOutput(folder / "a.mkv");
  output.framesPerSecond = 0.0;
  EXPECT_NE(errorOf(output).find("not a valid frame rate"), std::string::npos);
  output = losslessOutput(folder / "a.mkv");
  output.encoding.codec = "????";
  EXPECT_NE(errorOf(output).find("no encoder"), std::string::npos);
  EXPECT_EQ(fileCount(folder), 0U);
}

TEST(VideoEncoder, RefusesImagesOfAnotherSize) {
  const TemporaryFolder folder;
  auto encoder = VideoEncoder::create(losslessOutput(folder / "a.mkv"));
  ASSERT_TRUE(encoder);
  const auto written = encoder->write(cv::Mat(10, 10, CV_8UC3));
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().code, ErrorCode::Mismatch);
}

} // namespace
} // namespace dewpoint::tests
