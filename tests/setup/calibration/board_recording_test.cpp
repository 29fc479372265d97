// SPDX-License-Identifier: GPL-3.0-or-later
// What a recording of a board gives in one go: the calibration or a proposal, and mirrored videos.
#include "core/setup/calibration/board_recording.h"
#include "tests/setup/calibration/shown_recording.h"

namespace dewpoint::tests {
namespace {

constexpr BoardGoal kLenses{true, false};

TEST(BoardRecording, TheCalibrationIsThatOfTheDetections) {
  const ShownRecording recording(8);
  const auto request = requestFor(kShown);
  const auto source = recording.open();
  const auto computed = calibrateFromBoardRecording(recording.project, *source, request, kLenses);
  ASSERT_TRUE(computed.outcome) << errorSentence(computed.outcome.error());
  EXPECT_FALSE(computed.otherBoard);
  EXPECT_TRUE(computed.hasSearchedAllFrames);
  EXPECT_EQ(computed.mirroredVideos, MirroredVideos());
  const auto seen = findBoards(recording.project, *source, request);
  ASSERT_TRUE(seen);
  const auto expected = calibrateFromBoards(recording.project, *seen, request, kLenses);
  ASSERT_TRUE(expected);
  EXPECT_EQ(computed.outcome->project, expected->project);
}

TEST(BoardRecording, AFailedCalibrationSaysWhatWasSeenInstead) {
  const ShownRecording recording(40);
  const auto source = recording.open();
  const auto computed = calibrateFromBoardRecording(recording.project, *source,
                                                    requestFor("chessboard:9x6:0.025"), kLenses);
  ASSERT_FALSE(computed.outcome);
  EXPECT_EQ(computed.outcome.error().code, ErrorCode::NotFound);
  ASSERT_TRUE(computed.otherBoard);
  EXPECT_EQ(boardText(computed.otherBoard->board), kRight);
  EXPECT_FALSE(computed.hasSearchedAllFrames);
}

TEST(BoardRecording, MirroredVideosAreNamedWithTheCalibrationAndWithTheProposal) {
  const MirroredVideos expected{MirroredVideos::Cause::Videos, {1}};
  const ShownRecording recording(8, true);
  const auto source = recording.open();
  const auto computed =
      calibrateFromBoardRecording(recording.project, *source, requestFor(kShown), kLenses);
  EXPECT_TRUE(computed.outcome); // the other camera is calibrated
  EXPECT_EQ(computed.mirroredVideos, expected);
  const auto proposal = proposeBoardsAndMirroredVideos(*source, boardOf("chessboard:9x6:0.025"));
  ASSERT_TRUE(proposal) << errorSentence(proposal.error());
  EXPECT_EQ(boardText(proposal->guesses.front().board), kRight);
  ASSERT_TRUE(proposal->mirroredVideos);
  EXPECT_EQ(*proposal->mirroredVideos, expected);
}

TEST(BoardRecording, BothCanBeCanceled) {
  const ShownRecording recording(8);
  const auto source = recording.open();
  const CalibrationProgress stop = [](CalibrationStage, double) { return false; };
  const auto computed =
      calibrateFromBoardRecording(recording.project, *source, requestFor(kShown), kLenses, stop);
  ASSERT_FALSE(computed.outcome);
  EXPECT_EQ(computed.outcome.error().code, ErrorCode::Canceled);
  const auto proposal =
      proposeBoardsAndMirroredVideos(*source, boardOf(kShown), kBoardProposalFrames, stop);
  ASSERT_FALSE(proposal);
  EXPECT_EQ(proposal.error().code, ErrorCode::Canceled);
}

} // namespace
} // namespace dewpoint::tests
