// SPDX-License-Identifier: GPL-3.0-or-later
// Which videos are mirrored, by the board that they show.
#include "core/calibration/board/board_picture.h"
#include "core/setup/calibration/mirrored_videos.h"
#include "tests/calibration/board_views.h"

#include <opencv2/core.hpp>

namespace dewpoint::tests {
namespace {

using Cause = MirroredVideos::Cause;

TEST(MirroredVideos, AnotherCameraTellsTheVideoFromTheBoard) {
  EXPECT_EQ(mirroredVideos({{8, 0}, {0, 8}}), (MirroredVideos{Cause::Videos, {1}}));
  EXPECT_EQ(mirroredVideos({{0, 8}}), (MirroredVideos{Cause::BoardOrVideos, {0}}));
  EXPECT_EQ(mirroredVideos({{0, 8}, {0, 5}}), (MirroredVideos{Cause::BoardOrVideos, {0, 1}}));
  // A camera that saw nothing tells nothing.
  EXPECT_EQ(mirroredVideos({{0, 0}, {0, 5}}), (MirroredVideos{Cause::BoardOrVideos, {1}}));
}

TEST(MirroredVideos, ABoardThatIsSeenFromBothSidesIsNoMirroredVideo) {
  EXPECT_EQ(mirroredVideos({{8, 0}, {1, 8}}).cause, Cause::None);
  EXPECT_EQ(mirroredVideos({{8, 0}, {0, 2}}).cause, Cause::None); // too few images
  EXPECT_EQ(mirroredVideos({{8, 0}, {8, 0}}).cause, Cause::None);
}

TEST(MirroredVideos, SidesAreCountedInImages) {
  const BoardDescription board = boardOf("charuco:7x5:0.03:0.0225:DICT_4X4_50");
  std::vector<cv::Mat> images;
  for (const auto& pose : variedPoses(board, testCamera(480, 360), 3, 4)) {
    images.push_back(renderBoard(board, testCamera(480, 360), pose, 3));
  }
  cv::Mat flipped;
  cv::flip(images[0], flipped, 1);
  images[0] = flipped;
  images.emplace_back(360, 480, CV_8UC1, cv::Scalar(90));
  const MirroringCounts sides = countMirroredImages(board, images);
  EXPECT_EQ(sides.unmirroredCount, 2);
  EXPECT_EQ(sides.mirroredCount, 1);
  EXPECT_EQ(countMirroredImages(boardOf("chessboard:6x4:0.03"), images).mirroredCount, 0);
}

TEST(MirroredVideos, TheSentenceNamesTheCamera) {
  const std::vector<std::string> names{"left", "right"};
  EXPECT_NE(mirroredText({Cause::Videos, {1}}, names).find("The video of 'right' is mirrored"),
            std::string::npos);
  EXPECT_NE(mirroredText({Cause::BoardOrVideos, {0}}, names).find("board or the video of 'left'"),
            std::string::npos);
  EXPECT_EQ(mirroredText({}, names), "");
}

TEST(MirroredVideos, TheProjectMirrorsTheirImages) {
  Project project;
  for (int k = 0; k < 2; ++k) {
    ProjectCamera& camera = project.cameras.emplace_back();
    camera.camera = testCamera();
    camera.source = SourceKind::Video;
  }
  project.cameras[1].isMirrored = true; // mirrored by mistake: so it is undone
  const Project mended = withUnmirroredVideos(project, {Cause::Videos, {1}});
  EXPECT_FALSE(mended.cameras[1].isMirrored);
  EXPECT_EQ(mended.cameras[0], project.cameras[0]);
  EXPECT_TRUE(withUnmirroredVideos(project, {Cause::Videos, {0}}).cameras[0].isMirrored);
}

} // namespace
} // namespace dewpoint::tests
