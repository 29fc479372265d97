// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/board/board_guidance.h"
#include "core/calibration/board/rig_guidance.h"
#include "tests/calibration/board_views.h"

namespace dewpoint::tests {
namespace {

constexpr double kFrame = 1.0 / 30.0;

struct Showing {
  BoardDescription board = boardOf("chessboard:9x6:0.025");
  Camera camera = testCamera();
  BoardGuidance guidance = BoardGuidance(board, 640, 480);
  double seconds = 0.0;

  GuidanceState show(const Eigen::Isometry3d& pose, double edgeWidthPx = 1.6) {
    seconds += kFrame;
    auto view = viewOf(board, camera, pose, 0.05, static_cast<std::uint32_t>(seconds / kFrame));
    view.detection.edgeWidthPx = edgeWidthPx;
    return guidance.update(seconds, view.detection);
  }
};

TEST(BoardGuidance, AsksForTheBoard) {
  Showing showing;
  EXPECT_EQ(showing.guidance.update(0.0, std::nullopt).advice,
            GuidanceAdvice::ShowCalibrationBoard);
}

TEST(BoardGuidance, TakesAViewThatIsHeldStillOnceOnly) {
  Showing showing;
  const auto pose = boardAt(showing.board, {0.0, 0.0, 0.5}, 0.0, 0.0);
  int captured = 0;
  bool asked = false;
  for (int k = 0; k < 60; ++k) {
    const auto state = showing.show(pose);
    captured += state.wasCaptured ? 1 : 0;
    asked = asked || state.advice == GuidanceAdvice::HoldStill;
  }
  EXPECT_EQ(captured, 1);
  EXPECT_TRUE(asked);
}

TEST(BoardGuidance, TakesNothingInMotionOrOutOfFocus) {
  Showing moving;
  for (int k = 0; k < 60; ++k) {
    const auto state = moving.show(boardAt(moving.board, {-0.15 + 0.005 * k, 0.0, 0.5}, 0.0, 0.0));
    EXPECT_FALSE(state.wasCaptured);
  }
  Showing soft;
  GuidanceState state;
  for (int k = 0; k < 60; ++k) {
    state = soft.show(boardAt(soft.board, {0.0, 0.0, 0.5}, 0.0, 0.0), 9.0);
    EXPECT_FALSE(state.wasCaptured);
  }
  EXPECT_EQ(state.advice, GuidanceAdvice::Sharpen);
}

/// Before a region of the image, half a meter away.
Eigen::Vector3d placeFor(const Camera& camera, int region) {
  const auto& in = camera.intrinsics;
  const double x = (region % BoardCoverage::kColumns + 0.5) / BoardCoverage::kColumns * in.width;
  const double y =
      (region / BoardCoverage::kColumns + 0.5) / BoardCoverage::kRows * in.height; // NOLINT
  return {0.4 * (x - in.centerX) / in.focalX, 0.4 * (y - in.centerY) / in.focalY, 0.5};
}

// Who does as told comes to the end: the accuracy asked for, reached by itself.
TEST(BoardGuidance, FollowingTheAdviceEndsByItself) {
  Showing showing;
  Eigen::Vector3d middle(0.0, 0.0, 0.45);
  double tiltX = 0.0;
  double tiltY = 0.0;
  GuidanceState state;
  int frames = 0;
  for (; frames < 6000 && state.advice != GuidanceAdvice::Finished; ++frames) {
    if (state.advice == GuidanceAdvice::TiltTo) {
      tiltX = state.tilt == BoardTilt::TopNear      ? 0.6
              : state.tilt == BoardTilt::BottomNear ? -0.6
                                                    : 0.0;
      tiltY = state.tilt == BoardTilt::RightNear  ? 0.6
              : state.tilt == BoardTilt::LeftNear ? -0.6
                                                  : 0.0;
      middle = placeFor(showing.camera, state.requestedRegion);
    } else if (state.advice == GuidanceAdvice::ComeNearer) {
      middle = {0.0, 0.0, 0.3};
    } else if (state.advice == GuidanceAdvice::MoveTo) {
      middle = placeFor(showing.camera, state.requestedRegion);
    }
    // A person's board never stands twice in the very same place.
    middle.x() += state.wasCaptured ? 0.01 * (frames % 7 - 3) : 0.0;
    state = showing.show(boardAt(showing.board, middle, tiltX, tiltY));
    if (state.wasCaptured && showing.guidance.isCalibrationDue()) {
      IntrinsicsRequest request{showing.board, showing.guidance.views(), 640, 480};
      const auto result = calibrateIntrinsics(request);
      ASSERT_TRUE(result);
      showing.guidance.acceptCalibration(*result);
    }
  }
  EXPECT_EQ(state.advice, GuidanceAdvice::Finished);
  ASSERT_TRUE(state.projectionSigmaPx);
  EXPECT_LE(*state.projectionSigmaPx, 0.3);
  for (const int count : state.coverage.tiltCounts) {
    EXPECT_GE(count, 1);
  }
  EXPECT_LT(state.viewCount, 40);
}

TEST(RigGuidance, NamesThePairThatIsMissingAndEnds) {
  const BoardDescription board = boardOf("chessboard:9x6:0.025");
  RigGuidance::Settings settings;
  settings.instantsPerPair = 2;
  RigGuidance guidance({640, 640, 640}, settings);
  RigGuidance::State state;
  double seconds = 0.0;
  for (std::uint32_t place = 0; place < 8 && !state.isFinished; ++place) {
    const bool last = place >= 3; // first cameras 1 and 2, then 2 and 3
    for (int k = 0; k < 30 && !state.isFinished; ++k) {
      const auto pose =
          boardAt(board, {0.1 * (place % 3) - 0.1, 0.05 * (place % 2), 0.6}, 0.2, 0.0);
      const auto view = viewOf(board, testCamera(), pose, 0.0, 0).detection;
      const auto none = std::optional<BoardDetection>();
      state = guidance.update(seconds += kFrame, {last ? none : view, view, last ? view : none});
    }
    if (place == 2) {
      EXPECT_EQ(state.firstCamera, 0);
      EXPECT_EQ(state.secondCamera, 2);
    }
  }
  EXPECT_TRUE(state.isFinished);
  EXPECT_GE(guidance.sharedInstantCount(1, 2), 2);
  EXPECT_EQ(guidance.sharedInstantCount(0, 2), 0);
}

} // namespace
} // namespace dewpoint::tests
