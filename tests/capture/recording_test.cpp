// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/frame_reader.h"
#include "core/capture/frame_writer.h"
#include "core/capture/natural_order.h"
#include "core/capture/recording.h"
#include "tests/capture/temporary_folder.h"

#include <gtest/gtest.h>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace dewpoint::tests {
namespace {

using test::TemporaryFolder;

// Any small size that is not square, so that a rotation shows.
constexpr int kWidth = 48;
constexpr int kHeight = 32;

/// Noise that differs in every frame: nothing but the right frame, unchanged, compares equal.
cv::Mat noise(std::int64_t frame) {
  cv::Mat picture(kHeight, kWidth, CV_8UC3);
  cv::RNG(static_cast<std::uint64_t>(frame) + 1).fill(picture, cv::RNG::UNIFORM, 0, 256);
  return picture;
}

bool same(const cv::Mat& a, const cv::Mat& b) {
  return a.size() == b.size() && a.type() == b.type() && cv::norm(a, b, cv::NORM_INF) == 0;
}

void writeAll(Result<FrameWriter> writer, int frames) {
  ASSERT_TRUE(writer);
  for (int k = 0; k < frames; ++k) {
    ASSERT_TRUE(writer->write(noise(k)));
  }
  const auto finished = writer->finish();
  ASSERT_TRUE(finished) << errorSentence(finished.error());
  EXPECT_EQ(writer->writtenFrameCount(), frames);
}

RecordedCamera video(const std::string& path, const std::string& name = "left") {
  RecordedCamera camera;
  camera.name = name;
  camera.path = path;
  return camera;
}

RecordedCamera folder(const std::string& path) {
  RecordedCamera camera = video(path);
  camera.kind = RecordedCamera::Kind::Images;
  return camera;
}

RecordedCamera generated(std::int64_t frames) {
  RecordedCamera camera = video("", "made");
  camera.kind = RecordedCamera::Kind::Generated;
  camera.generate = noise;
  camera.generatedFrameCount = frames;
  return camera;
}

Error errorOf(const RecordedCamera& camera) {
  const auto source = openRecording({camera}, 0);
  EXPECT_FALSE(source);
  return source ? Error{} : source.error();
}

void expectFrame(FrameSetSource& source, std::int64_t k) {
  const auto set = source.next();
  ASSERT_TRUE(set) << errorSentence(set.error());
  ASSERT_TRUE(*set);
  EXPECT_EQ((*set)->index, k);
  for (const auto& frame : (*set)->frames) {
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->index, k);
    EXPECT_TRUE(same(frame->image, noise(k))) << "frame " << k;
  }
}

class VideoRates : public testing::TestWithParam<double> {};

TEST_P(VideoRates, comeBackBitExactInSequenceAndAfterEverySeek) {
  const TemporaryFolder home;
  writeAll(FrameWriter::createVideo(home / "a.mkv", GetParam()), 150);
  const auto opened = openRecording({video(home / "a.mkv")}, 0);
  ASSERT_TRUE(opened) << errorSentence(opened.error());
  FrameSetSource& source = **opened;
  EXPECT_EQ(source.frameCount(), 150);
  EXPECT_FALSE(source.isLive());
  // Matroska rounds the duration of a frame to the millisecond or better.
  EXPECT_NEAR(source.framesPerSecond(), GetParam(), 0.01 * GetParam());
  EXPECT_TRUE(source.notices().empty());
  for (int k = 0; k < 150; ++k) {
    expectFrame(source, k);
  }
  EXPECT_EQ(source.next().value(), nullptr);
  for (const int k : {149, 0, 75, 74, 75, 3, 100, 140, 139, 0}) { // back, ahead, near, far
    ASSERT_TRUE(source.seek(k));
    expectFrame(source, k);
  }
  expectFrame(source, 1);
  const auto fresh = openRecording({video(home / "a.mkv")}, 0); // far ahead, never read before
  ASSERT_TRUE(fresh);
  ASSERT_TRUE((*fresh)->seek(120));
  expectFrame(**fresh, 120);
  expectFrame(**fresh, 121);
}

INSTANTIATE_TEST_SUITE_P(Rates, VideoRates, testing::Values(30.0, 25.0, 29.97, 7.3, 120.0));

TEST(Recording, seekOutsideIsRefused) {
  const auto source = openRecording({generated(5)}, 0);
  ASSERT_TRUE(source);
  EXPECT_TRUE((*source)->seek(5));
  EXPECT_EQ((*source)->next().value(), nullptr);
  EXPECT_FALSE((*source)->seek(6));
  EXPECT_FALSE((*source)->seek(-1));
  EXPECT_EQ((*source)->next().value(), nullptr);
}

TEST(Recording, stampsFramesByTheRate) {
  const auto source = openRecording({generated(3)}, 20);
  ASSERT_TRUE(source);
  EXPECT_EQ((*source)->framesPerSecond(), 20);
  for (int k = 0; k < 3; ++k) {
    const auto set = (*source)->next();
    ASSERT_TRUE(set);
    EXPECT_EQ((*set)->time, std::chrono::milliseconds(50 * k)); // 1 / 20 s
    EXPECT_EQ((*set)->frames[0]->captureTime, (*set)->time);
  }
  EXPECT_EQ((*openRecording({generated(3)}, 0))->framesPerSecond(), 30); // the documented default
  EXPECT_EQ(openRecording({generated(3)}, -1).error().code, ErrorCode::BadValue);
  EXPECT_EQ(openRecording({}, 0).error().code, ErrorCode::MissingKey);
}

TEST(Recording, aTruncatedVideoEndsEarly) {
  const TemporaryFolder home;
  writeAll(FrameWriter::createVideo(home / "whole.mkv", 30), 60);
  std::filesystem::copy_file(home / "whole.mkv", home / "cut.mkv");
  std::filesystem::resize_file(home / "cut.mkv",
                               std::filesystem::file_size(home / "whole.mkv") / 2);
  const auto source = openRecording({video(home / "cut.mkv")}, 0);
  ASSERT_TRUE(source) << errorSentence(source.error());
  EXPECT_EQ((*source)->frameCount(), 60); // what the header still says
  Result<FrameSetPtr> set;
  int frames = -1;
  do {
    set = (*source)->next();
    ++frames;
  } while (set && *set);
  ASSERT_FALSE(set);
  EXPECT_EQ(set.error().code, ErrorCode::EndedEarly);
  EXPECT_EQ(set.error().file, home / "cut.mkv");
  EXPECT_NEAR(frames, 30, 3); // noise: every frame takes about as many bytes
  EXPECT_NE(set.error().detail.find("60"), std::string::npos) << set.error().detail;
  EXPECT_NE(set.error().detail.find(std::to_string(frames)), std::string::npos);
  EXPECT_FALSE((*source)->next()); // and stays so
  ASSERT_TRUE((*source)->seek(55));
  EXPECT_EQ((*source)->next().error().code, ErrorCode::EndedEarly);
  ASSERT_TRUE((*source)->seek(4));
  expectFrame(**source, 4);
}

TEST(Recording, aContainerWithoutFrameCountIsCounted) {
  const TemporaryFolder home;
  // JPEG pictures one after the other are a raw MJPEG stream: no header, no count, no index.
  std::ofstream stream(home / "raw.mjpeg", std::ios::binary);
  for (int k = 0; k < 40; ++k) {
    std::vector<unsigned char> jpeg;
    cv::imencode(".jpg", cv::Mat(kHeight, kWidth, CV_8UC3, cv::Scalar::all(6 * k)), jpeg);
    stream.write(reinterpret_cast<const char*>(jpeg.data()), std::ssize(jpeg));
  }
  stream.close();
  const auto source = openRecording({video(home / "raw.mjpeg")}, 0);
  ASSERT_TRUE(source) << errorSentence(source.error());
  EXPECT_EQ((*source)->frameCount(), 40);
  for (const int k : {0, 39, 5, 38}) {
    ASSERT_TRUE((*source)->seek(k));
    const auto set = (*source)->next();
    ASSERT_TRUE(set && *set);
    EXPECT_NEAR(cv::mean((*set)->frames[0]->image)[1], 6 * k, 2); // 2: JPEG's loss on a flat area
  }
}

TEST(Recording, differentLengthsAndRatesAreNoticed) {
  const TemporaryFolder home;
  writeAll(FrameWriter::createVideo(home / "a.mkv", 30), 12);
  writeAll(FrameWriter::createVideo(home / "b.mkv", 15), 9);
  const auto source = openRecording({video(home / "a.mkv"), video(home / "b.mkv", "right")}, 0);
  ASSERT_TRUE(source) << errorSentence(source.error());
  EXPECT_EQ((*source)->frameCount(), 9);
  const auto notices = (*source)->notices();
  ASSERT_EQ(notices.size(), 2U);
  EXPECT_EQ(notices[0].code, ErrorCode::Mismatch);
  EXPECT_NE(notices[0].detail.find("a.mkv: 12"), std::string::npos) << notices[0].detail;
  EXPECT_NE(notices[0].detail.find("b.mkv: 9"), std::string::npos);
  EXPECT_EQ(notices[0].file, home / "b.mkv"); // the shorter one is what limits
  EXPECT_EQ(notices[0].field, "camera 'right'");
  EXPECT_EQ(notices[1].file, home / "b.mkv");
  for (int k = 0; k < 9; ++k) {
    expectFrame(**source, k);
  }
  EXPECT_EQ((*source)->next().value(), nullptr);
}

TEST(Recording, aWrongSizeIsRefused) {
  const TemporaryFolder home;
  writeAll(FrameWriter::createVideo(home / "a.mkv", 30), 2);
  RecordedCamera camera = video(home / "a.mkv");
  camera.width = 320;
  camera.height = 240;
  const Error error = errorOf(camera);
  EXPECT_EQ(error.code, ErrorCode::Mismatch);
  EXPECT_EQ(error.file, home / "a.mkv");
  EXPECT_EQ(error.detail, "48 x 32, but its calibration is for 320 x 240");
}

TEST(Recording, rotatesClockwise) {
  for (const int degrees : {0, 90, 180, 270}) {
    RecordedCamera camera = generated(1);
    camera.rotateDegrees = degrees;
    const bool lying = degrees % 180 != 0;
    camera.width = lying ? kHeight : kWidth; // the size is the one after the rotation
    camera.height = lying ? kWidth : kHeight;
    const auto source = openRecording({camera}, 0);
    ASSERT_TRUE(source) << errorSentence(source.error());
    const cv::Mat image = (*source)->next().value()->frames[0]->image;
    // Where the top left pixel goes when the picture turns like the hands of a clock.
    const cv::Point corner(degrees == 90 || degrees == 180 ? image.cols - 1 : 0,
                           degrees == 180 || degrees == 270 ? image.rows - 1 : 0);
    EXPECT_EQ(image.at<cv::Vec3b>(corner), noise(0).at<cv::Vec3b>(0, 0)) << degrees;
  }
  RecordedCamera tilted = generated(1);
  tilted.rotateDegrees = 45;
  EXPECT_EQ(errorOf(tilted).code, ErrorCode::BadValue);
}

TEST(Recording, mirrorsAfterTurning) {
  RecordedCamera camera = generated(1);
  camera.rotateDegrees = 90;
  camera.isMirrored = true;
  const auto source = openRecording({camera}, 0);
  ASSERT_TRUE(source) << errorSentence(source.error());
  const cv::Mat image = (*source)->next().value()->frames[0]->image;
  // Turned clockwise the top left pixel is at the top right, mirrored it is at the left again.
  EXPECT_EQ(image.at<cv::Vec3b>(0, 0), noise(0).at<cv::Vec3b>(0, 0));
  EXPECT_EQ(image.at<cv::Vec3b>(image.rows - 1, 0), noise(0).at<cv::Vec3b>(0, kWidth - 1));
}

TEST(Recording, missingAndUnreadableFilesAreNamed) {
  const TemporaryFolder home;
  std::ofstream(home / "text.mkv") << "no video at all\n";
  std::ofstream(home / "empty.mp4").close();
  std::filesystem::create_directory(home / "folder");
  const Error missing = errorOf(video(home / "nowhere.mkv"));
  EXPECT_EQ(missing.code, ErrorCode::FileMissing);
  EXPECT_EQ(missing.file, home / "nowhere.mkv");
  EXPECT_EQ(missing.field, "camera 'left'");
  EXPECT_EQ(errorOf(video(home / "nowhere.mkv", "camera 2")).field, "'camera 2'");
  for (const char* name : {"text.mkv", "empty.mp4", "folder"}) {
    const Error error = errorOf(video(home / name));
    EXPECT_EQ(error.code, ErrorCode::FileUnreadable) << name;
    EXPECT_EQ(error.file, home / name);
  }
  EXPECT_EQ(errorOf(folder(home / "nowhere")).code, ErrorCode::FileMissing);
  EXPECT_EQ(errorOf(folder(home / "text.mkv")).code, ErrorCode::FileUnreadable);
  const Error bare = errorOf(folder(home / "folder"));
  EXPECT_EQ(bare.code, ErrorCode::FileUnreadable);
  EXPECT_NE(bare.detail.find("no images"), std::string::npos);
}

TEST(Recording, foldersOfPicturesComeInNaturalOrder) {
  const TemporaryFolder home;
  std::filesystem::create_directory(home / "pictures");
  const std::vector<std::string> names{"f1.png", "f2.bmp", "f09.tif", "f10.png", "f100.PNG"};
  for (std::size_t k = 0; k < names.size(); ++k) {
    ASSERT_TRUE(cv::imwrite(home / ("pictures/" + names[k]), noise(static_cast<int>(k))));
  }
  std::ofstream(home / "pictures/notes.txt") << "not a picture\n";
  std::ofstream(home / "pictures/.f3.png") << "left over by another program\n";
  const auto source = openRecording({folder(home / "pictures"), generated(5)}, 0);
  ASSERT_TRUE(source) << errorSentence(source.error());
  EXPECT_EQ((*source)->frameCount(), 5);
  for (int k = 0; k < 5; ++k) {
    expectFrame(**source, k);
  }
  ASSERT_TRUE((*source)->seek(3));
  expectFrame(**source, 3);
}

TEST(Recording, aDamagedPictureIsNamed) {
  const TemporaryFolder home;
  writeAll(FrameWriter::createImageFolder(home / "p"), 3);
  std::ofstream(home / "p/000001.png", std::ios::trunc) << "broken";
  cv::imwrite(home / "p/000002.png", cv::Mat::zeros(8, 8, CV_8UC3));
  RecordedCamera camera = folder(home / "p");
  camera.width = kWidth;
  camera.height = kHeight;
  const auto source = openRecording({camera}, 0);
  ASSERT_TRUE(source);
  expectFrame(**source, 0);
  const auto broken = (*source)->next();
  ASSERT_FALSE(broken);
  EXPECT_EQ(broken.error().code, ErrorCode::FileUnreadable);
  EXPECT_EQ(broken.error().file, home / "p/000001.png");
  ASSERT_TRUE((*source)->seek(2));
  const auto small = (*source)->next();
  ASSERT_FALSE(small);
  EXPECT_EQ(small.error().code, ErrorCode::Mismatch);
  EXPECT_EQ(small.error().file, home / "p/000002.png");
}

TEST(Recording, aThrowingGeneratorIsAnError) {
  RecordedCamera camera = generated(2);
  camera.generate = [](std::int64_t) -> cv::Mat { throw std::runtime_error("no more paint"); };
  EXPECT_EQ(errorOf(camera).detail, "no more paint");
}

TEST(FrameWriter, refusesWhatItCannotWrite) {
  const TemporaryFolder home;
  std::ofstream(home / "f") << "in the way\n";
  EXPECT_EQ(FrameWriter::createImageFolder(home / "f").error().code, ErrorCode::FileUnwritable);
  EXPECT_EQ(FrameWriter::createVideo(home / "f/a.mkv", 30).error().code, ErrorCode::FileUnwritable);
  EXPECT_EQ(FrameWriter::createVideo(home / "a.mkv", 0).error().code, ErrorCode::BadValue);
  auto writer = FrameWriter::createImageFolder(home / "p");
  ASSERT_TRUE(writer);
  EXPECT_EQ(writer->write(cv::Mat()).error().code, ErrorCode::BadValue);
  ASSERT_TRUE(writer->write(noise(0)));
  EXPECT_EQ(writer->write(cv::Mat::zeros(4, 4, CV_8UC3)).error().code, ErrorCode::Mismatch);
  ASSERT_TRUE(writer->finish());
  EXPECT_FALSE(writer->write(noise(1)));
}

TEST(NaturalOrder, numbersCountAsNumbers) {
  EXPECT_TRUE(isBeforeInNaturalOrder("a2", "a10"));
  EXPECT_FALSE(isBeforeInNaturalOrder("a10", "a2"));
  EXPECT_TRUE(isBeforeInNaturalOrder("a9b2", "a09b3"));
  EXPECT_TRUE(isBeforeInNaturalOrder("a", "a1"));
  EXPECT_TRUE(isBeforeInNaturalOrder("99999999999999999998", "99999999999999999999"));
  EXPECT_FALSE(isBeforeInNaturalOrder("a", "a"));
}

// The seek of a compressed real video (H.264 or MPEG-4, far key frames) against reading in a row.
TEST(RealRecording, seeksToTheSamePicturesAsReading) {
  const char* data = std::getenv("DEWPOINT_DATA");
  const std::string path = std::string(data ? data : "") + "/hand2_desk/cam0.mp4";
  if (!std::filesystem::exists(path)) {
    GTEST_SKIP() << "the recording hand2_desk is not there";
  }
  const auto source = openRecording({video(path)}, 0);
  ASSERT_TRUE(source) << errorSentence(source.error());
  std::vector<cv::Mat> row;
  for (auto set = (*source)->next(); set && *set && row.size() < 120; set = (*source)->next()) {
    row.push_back((*set)->frames[0]->image);
  }
  ASSERT_EQ(row.size(), 120U);
  const auto fresh = openRecording({video(path)}, 0);
  for (const int k : {100, 7, 119, 60, 0}) {
    ASSERT_TRUE((*fresh)->seek(k));
    EXPECT_TRUE(same((*fresh)->next().value()->frames[0]->image, row[static_cast<std::size_t>(k)]))
        << k;
  }
}

// The picture nearest in time is taken, with the time of what it shows; those beyond either end are
// missing.
TEST(Recording, PicturesOfALateCameraAreMatchedByTime) {
  RecordedCamera punctual = generated(6);
  punctual.name = "punctual";
  RecordedCamera late = generated(6);
  late.delaySeconds = 0.24; // at 10 pictures per second: 2 pictures and 40 ms
  RecordedCamera early = generated(6);
  early.name = "early";
  early.delaySeconds = -0.1;
  const auto source = openRecording({punctual, late, early}, 10.0);
  ASSERT_TRUE(source) << errorSentence(source.error());
  EXPECT_EQ((*source)->frameCount(), 6);
  const auto first = (*source)->next();
  ASSERT_TRUE(first && *first);
  ASSERT_TRUE((*first)->frames[1]);
  EXPECT_FALSE((*first)->frames[2]); // its first picture shows the second instant
  EXPECT_EQ((*first)->frames[1]->index, 2);
  EXPECT_TRUE(same((*first)->frames[1]->image, noise(2)));
  EXPECT_EQ((*first)->frames[1]->captureTime, timeStamp(-0.04));
  ASSERT_TRUE((*source)->seek(4));
  const auto fifth = (*source)->next();
  ASSERT_TRUE(fifth && *fifth);
  EXPECT_FALSE((*fifth)->frames[1]); // it ended two pictures before
  ASSERT_TRUE((*fifth)->frames[2]);
  EXPECT_EQ((*fifth)->frames[2]->index, 3);
  EXPECT_EQ((*fifth)->frames[2]->captureTime, (*fifth)->time);
}

} // namespace
} // namespace dewpoint::tests
