// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/image_reader.h"
#include "tests/setup/doctor/examined_project.h"

namespace dewpoint::tests {
namespace {

using RecordingChecks = ExaminedProject;

TEST_F(RecordingChecks, NothingIsWrongWithASoundProject) {
  const auto all = findings();
  EXPECT_EQ(worstLevelOf(all), FindingLevel::Ok) << linesOf(all);
  const Finding fine = found(FindingKind::RecordingFine);
  EXPECT_EQ(fine.field, "camera 1.images");
  EXPECT_EQ(fillPlaceholders(textsOf(fine.kind).description, fine.placeholderValues),
            "'camera 1' has 12 frames of 320 x 240 pixels, no rate stated.");
}

TEST_F(RecordingChecks, AMissingRecordingIsNamedAndTheOthersAreStillRead) {
  std::filesystem::remove_all(project_.cameras[1].location);
  const Finding missing = found(FindingKind::RecordingMissing);
  EXPECT_EQ(missing.field, "camera 2.images");
  EXPECT_EQ(missing.file, project_.file.string());
  EXPECT_EQ(found(FindingKind::RecordingFine).field, "camera 1.images");
}

TEST_F(RecordingChecks, WhatIsNoVideoIsUnreadable) {
  project_.cameras[0].source = SourceKind::Video;
  project_.cameras[0].location = text("left.mp4", "no video\n");
  EXPECT_EQ(found(FindingKind::RecordingUnreadable).file, project_.cameras[0].location);
}

TEST_F(RecordingChecks, ANumberedImageIsMissing) {
  std::filesystem::remove(imageFile(0, 5));
  const Finding gap = found(FindingKind::ImagesMissing);
  EXPECT_EQ(gap.placeholderValues, (std::vector<std::string>{"'camera 1'", "1", "12", "0004.png"}));
}

TEST_F(RecordingChecks, ADamagedImageIsFoundWhereItIsLookedAt) {
  std::ofstream(imageFile(1, kFrames - 1)) << "cut off";
  EXPECT_EQ(found(FindingKind::FrameUnreadable).file, imageFile(1, kFrames - 1));
}

TEST_F(RecordingChecks, ADamagedImageInBetweenIsFoundOnRequest) {
  std::ofstream(imageFile(1, 3)) << "cut off";
  const auto quick = findings();
  EXPECT_EQ(worstLevelOf(quick), FindingLevel::Ok) << linesOf(quick);
  options_.decodesEveryFrame = true;
  EXPECT_EQ(found(FindingKind::FrameUnreadable).placeholderValues[1], "3");
}

TEST_F(RecordingChecks, AVideoThatIsCutOffIsNamed) {
  makeVideo(0, ball::kRate);
  const std::string whole = project_.cameras[0].location;
  const std::string cut = (folder_ / "cut.avi").string();
  {
    // By its name of a container that states the number of its frames; half of it holds fewer.
    std::filesystem::copy_file(whole, cut);
    std::filesystem::resize_file(cut, std::filesystem::file_size(whole) / 2);
  }
  project_.cameras[0].location = cut;
  EXPECT_EQ(worstLevelOf(findings()), FindingLevel::Problem);
}

TEST_F(RecordingChecks, TheSizeIsNotThatOfTheCalibration) {
  project_.cameras[0].camera.intrinsics.width = 640;
  EXPECT_EQ(found(FindingKind::SizeDiffers).placeholderValues,
            (std::vector<std::string>{"'camera 1'", "320 x 240", "640 x 240"}));
  project_.cameras[0].camera.intrinsics = {240, 320, 350.0, 350.0, 119.5, 159.5};
  EXPECT_EQ(found(FindingKind::SizeRotated).field, "camera 1.rotate");
}

TEST_F(RecordingChecks, RecordingsOfDifferentLength) {
  std::filesystem::remove(imageFile(1, kFrames - 1));
  EXPECT_EQ(found(FindingKind::LengthsDiffer).placeholderValues,
            (std::vector<std::string>{"'camera 1' 12, 'camera 2' 11", "11"}));
}

TEST_F(RecordingChecks, LiveCamerasAreLookedForAndStreamsAreNotTried) {
  project_.cameras[0].source = SourceKind::Device;
  project_.cameras[0].location = "/dev/video987";
  project_.cameras[1].source = SourceKind::Stream;
  project_.cameras[1].location = "rtsp://camera.example/1";
  EXPECT_EQ(found(FindingKind::DeviceMissing).field, "camera 1.device");
  EXPECT_EQ(found(FindingKind::StreamNotTested).field, "camera 2.stream");
}

TEST_F(RecordingChecks, LiveCamerasAndRecordingsDoNotMix) {
  project_.cameras[0].source = SourceKind::Device;
  project_.cameras[0].location = "0";
  found(FindingKind::MixedSources);
}

TEST_F(RecordingChecks, ABackgroundImageOfAnotherSize) {
  project_.cameras[0].backgroundImageFile = (folder_ / "empty.png").string();
  cv::imwrite(project_.cameras[0].backgroundImageFile,
              cv::Mat(20, 20, CV_8UC3, cv::Scalar::all(9)));
  EXPECT_EQ(found(FindingKind::BackgroundImageUnusable).file,
            project_.cameras[0].backgroundImageFile);
}

TEST_F(RecordingChecks, TheExaminationCanBeEnded) {
  options_.decodesEveryFrame = true;
  int calls = 0;
  options_.shouldContinue = [&](double) { return ++calls < 2; };
  findings();
  EXPECT_LT(calls, 2 * kFrames);
}

} // namespace
} // namespace dewpoint::tests
