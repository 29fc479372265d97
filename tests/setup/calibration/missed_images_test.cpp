// SPDX-License-Identifier: GPL-3.0-or-later
// Which images show no board, and why.
#include "core/calibration/board/board_picture.h"
#include "core/setup/calibration/board_outcome.h"
#include "tests/calibration/board_views.h"
#include "tests/calibration/own_folder.h"

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

namespace dewpoint::tests {
namespace {

BoardDetections::PerCamera searchedCamera(const std::vector<std::int64_t>& seen,
                                          const std::vector<std::int64_t>& missed) {
  BoardDetections::PerCamera camera;
  camera.searchedImageCount = static_cast<int>(seen.size() + missed.size());
  for (const std::int64_t frame : seen) {
    camera.views.push_back({"", frame, {}});
  }
  for (const std::int64_t frame : missed) {
    camera.missedImages.push_back({"", frame, {}});
  }
  return camera;
}

TEST(MissedImages, FramesThatFollowEachOtherAreOneRun) {
  EXPECT_EQ(missedImagesText(searchedCamera({0, 5}, {})), "");
  EXPECT_EQ(missedImagesText(searchedCamera({0, 5}, {10})), "no board was found in frame 10");
  EXPECT_EQ(missedImagesText(searchedCamera({15, 25}, {0, 5, 10, 20})),
            "no board was found in frames 0-10, 20");
  auto camera = searchedCamera({}, {0, 5, 10});
  camera.missedImages[1].missReason = {BoardMiss::Reason::TooFewCorners, 3, 0.0, 0.0};
  EXPECT_EQ(missedImagesText(camera), "no board was found in frames 0, 5 (too few corners: 3), 10");
}

TEST(MissedImages, ALongListIsCut) {
  std::vector<std::int64_t> seen;
  std::vector<std::int64_t> missed;
  for (std::int64_t frame = 0; frame < 12; ++frame) {
    missed.push_back(2 * frame);
    seen.push_back(2 * frame + 1);
  }
  EXPECT_EQ(missedImagesText(searchedCamera(seen, missed)),
            "no board was found in frames 0, 2, 4, 6, 8, 10, 12, 14 and in 4 others");
}

TEST(MissedImages, EachPictureWithoutABoardIsNamed) {
  const BoardDescription board = boardOf("chessboard:9x6:0.025");
  const auto folder = ownFolder();
  std::vector<std::filesystem::path> files;
  const auto poses = variedPoses(board, testCamera(), 7, 3);
  for (std::size_t k = 0; k < poses.size(); ++k) {
    cv::Mat image = renderBoard(board, testCamera(), poses[k], 3);
    if (k == 2) {
      image.setTo(90);
    } else if (k == 5) {
      image = renderBoard(board, testCamera(), boardAt(board, {0.0, 0.0, 0.55}, 0.0, 0.0), 3);
      image.colRange(0, 90).setTo(0); // a dark and a bright thing beside the board
      image.colRange(90, 180).setTo(255);
      cv::GaussianBlur(image, image, {0, 0}, 25.0); // as wide as the squares: no pattern is left
    }
    files.push_back(folder / ("picture" + std::to_string(k) + ".png"));
    ASSERT_TRUE(cv::imwrite(files.back().string(), image));
  }
  const auto seen = findBoards(files, board, DetectionEffort::Sample);
  ASSERT_TRUE(seen) << errorSentence(seen.error());
  const std::string text = missedImagesText(seen->cameras[0]);
  EXPECT_NE(text.find("no board was found in picture2.png, picture5.png (blurred"),
            std::string::npos)
      << text;
  BoardCalibrationRequest request;
  request.board = board;
  Project project;
  project.cameras.emplace_back().camera.name = "camera";
  const auto outcome = calibrateFromBoards(project, *seen, request, {true, false});
  ASSERT_TRUE(outcome) << errorSentence(outcome.error());
  ASSERT_EQ(outcome->missedRuns.size(), 1U);
  ASSERT_EQ(outcome->missedRuns[0].size(), 2U);
  EXPECT_EQ(outcome->missedRuns[0][1].file, "picture5.png");
}

TEST(MissedImages, ACameraThatSawNothingHasTheReasons) {
  BoardDetections seen;
  auto& camera = seen.cameras.emplace_back();
  camera.name = "camera";
  camera.searchedImageCount = 1;
  camera.missedImages.push_back({"a.png", 0, {BoardMiss::Reason::TooSmall, 0, 0.0, 6.2}});
  BoardCalibrationRequest request;
  request.board = boardOf("chessboard:9x6:0.025");
  const auto lenses = intrinsicsFromBoards(seen, request);
  ASSERT_FALSE(lenses);
  EXPECT_EQ(lenses.error().detail, "it never saw the board in 1 images; no board was found in "
                                   "a.png (too small, squares of 6 px)");
}

} // namespace
} // namespace dewpoint::tests
