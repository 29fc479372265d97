// SPDX-License-Identifier: GPL-3.0-or-later
// What is said of recordings that show another board than the requested one.
#include "core/setup/calibration/board_outcome.h"
#include "core/setup/calibration/board_proposal.h"
#include "core/setup/calibration/mirrored_videos.h"
#include "tests/setup/calibration/shown_recording.h"

namespace dewpoint::tests {
namespace {

TEST(BoardSearch, AnotherBoardIsSaidWithHowToGoOn) {
  const ShownRecording recording(8);
  const auto request = requestFor("chessboard:9x6:0.025");
  const auto source = recording.open();
  const auto seen = findBoards(recording.project, *source, request);
  ASSERT_TRUE(seen) << errorSentence(seen.error());
  ASSERT_TRUE(seen->hasOnlyOtherBoard());
  EXPECT_EQ(boardText(seen->otherBoard->board), kRight);
  for (const BoardGoal& goal : {BoardGoal{true, true}, BoardGoal{false, true}}) {
    const auto outcome = calibrateFromBoards(recording.project, *seen, request, goal);
    ASSERT_FALSE(outcome);
    EXPECT_EQ(outcome.error().code, ErrorCode::NotFound);
    EXPECT_EQ(outcome.error().field, "chessboard:9x6:0.025");
    EXPECT_NE(outcome.error().detail.find(std::string("--board ") + kRight), std::string::npos)
        << outcome.error().detail;
  }
}

TEST(BoardSearch, ALongRecordingIsNotSearchedForTheWrongBoard) {
  const ShownRecording recording(40);
  auto request = requestFor("chessboard:9x6:0.025");
  const auto source = recording.open();
  const auto first = findBoards(recording.project, *source, request);
  ASSERT_TRUE(first) << errorSentence(first.error());
  EXPECT_TRUE(first->hasOnlyOtherBoard());
  EXPECT_FALSE(first->hasSearchedAllFrames);
  EXPECT_EQ(first->cameras[0].searchedImageCount, kBoardProposalFrames);
  request.checksForOtherBoardFirst = false;
  const auto all = findBoards(recording.project, *source, request);
  ASSERT_TRUE(all) << errorSentence(all.error());
  EXPECT_TRUE(all->hasOnlyOtherBoard());
  EXPECT_TRUE(all->hasSearchedAllFrames);
  EXPECT_EQ(all->cameras[0].searchedImageCount, 40);
}

TEST(BoardSearch, TheRightBoardIsSearchedForInAllFrames) {
  const ShownRecording recording(40);
  auto request = requestFor(kShown);
  const auto source = recording.open();
  double last = -1.0;
  const auto seen =
      findBoards(recording.project, *source, request, [&](CalibrationStage, double part) {
        EXPECT_GE(part, last);
        last = part;
        return true;
      });
  ASSERT_TRUE(seen);
  EXPECT_FALSE(seen->otherBoard);
  EXPECT_EQ(seen->cameras[1].searchedImageCount, 40);
  request.checksForOtherBoardFirst = false;
  const auto again = findBoards(recording.project, *source, request);
  ASSERT_TRUE(again);
  ASSERT_EQ(again->cameras[0].views.size(), seen->cameras[0].views.size());
  EXPECT_EQ(again->cameras[0].views.back().detection.pixels,
            seen->cameras[0].views.back().detection.pixels);
}

TEST(BoardSearch, AMirroredCameraIsNamed) {
  const ShownRecording recording(8, true);
  const auto request = requestFor(kShown);
  const auto source = recording.open();
  const auto seen = findBoards(recording.project, *source, request);
  ASSERT_TRUE(seen);
  EXPECT_FALSE(seen->otherBoard);
  EXPECT_FALSE(seen->cameras[0].otherBoard);
  ASSERT_TRUE(seen->cameras[1].otherBoard);
  EXPECT_TRUE(seen->cameras[1].otherBoard->isMirrored);
  const MirroredVideos mirrored = mirroredVideos(*seen);
  EXPECT_EQ(mirrored.cause, MirroredVideos::Cause::Videos);
  EXPECT_EQ(mirrored.mirroredCameras, std::vector<std::size_t>{1});
  EXPECT_EQ(findMirroredVideos(*source, request.board).value(), mirrored);
  const auto lenses = intrinsicsFromBoards(*seen, request);
  ASSERT_TRUE(lenses) << errorSentence(lenses.error());
  ASSERT_EQ(lenses->keptIntrinsicsReasons.size(), 1U);
  EXPECT_NE(lenses->keptIntrinsicsReasons[0].detail.find("mirror"), std::string::npos)
      << lenses->keptIntrinsicsReasons[0].detail;
  const auto poses = extrinsicsFromBoards(recording.project, *seen, request);
  ASSERT_FALSE(poses);
  EXPECT_NE(poses.error().detail.find("mirror"), std::string::npos) << poses.error().detail;
}

TEST(BoardSearch, ProposalsForARecordingAndForOneTime) {
  const ShownRecording recording(8);
  const auto source = recording.open();
  const BoardDescription requested = boardOf("chessboard:9x6:0.025");
  const auto boards = proposeBoards(*source, requested);
  ASSERT_TRUE(boards) << errorSentence(boards.error());
  EXPECT_EQ(boardText(boards->front().board), kRight);
  EXPECT_EQ(boards->front().searchedImageCount, 16);
  ASSERT_TRUE(source->seek(3));
  const auto frames = source->next();
  ASSERT_TRUE(frames && *frames);
  const auto now = proposeBoards(**frames, requested);
  ASSERT_TRUE(now) << errorSentence(now.error());
  EXPECT_EQ(boardText(now->front().board), kRight);
}

TEST(BoardSearch, NoBoardIsNotFound) {
  FrameSet nothing;
  nothing.frames = {std::make_shared<const Frame>(
                        Frame{0, {}, cv::Mat(240, 320, CV_8UC3, cv::Scalar(90, 90, 90))}),
                    nullptr};
  const auto boards = proposeBoards(nothing, boardOf("chessboard:9x6:0.025"));
  ASSERT_FALSE(boards);
  EXPECT_EQ(boards.error().code, ErrorCode::NotFound);
  EXPECT_EQ(boards.error().detail, "1 image searched");
  const auto none = proposeBoards(std::vector<std::filesystem::path>{"no-such.png"},
                                  boardOf("chessboard:9x6:0.025"));
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().code, ErrorCode::FileMissing);
}

TEST(BoardSearch, ACameraWithoutViewsHasNoErrorInTheReport) {
  BoardReport report;
  report.title = "Poses";
  report.board = boardOf(kShown);
  report.cameras.emplace_back().name = "door";
  const std::string page = htmlText(report);
  EXPECT_NE(page.find("never saw the board"), std::string::npos);
  EXPECT_EQ(page.find("0.0000 px"), std::string::npos);
}

} // namespace
} // namespace dewpoint::tests
