// SPDX-License-Identifier: GPL-3.0-or-later
// A person who does as told, before rendered cameras.
#include "core/calibration/board/board_picture.h"
#include "core/setup/calibration/board_guide_thread.h"
#include "tests/calibration/board_views.h"

#include <opencv2/imgproc.hpp>

#include <atomic>
#include <chrono>
#include <functional>
#include <map>
#include <thread>

namespace dewpoint::tests {
namespace {

using Phase = BoardGuideState::Phase;

constexpr double kFrame = 0.2; // seconds: three still images are half a second
constexpr int kStill = 4;      // images for which a board is held

/// Two cameras beside each other, half the size of VGA, and a board that is moved about.
struct Room {
  BoardDescription board = boardOf("chessboard:7x4:0.03");
  CameraRig cameras;
  Project project;
  BoardGuideRequest wish;
  std::int64_t index = 0;
  std::vector<cv::Mat> pictures; ///< as drawn last
  Eigen::Isometry3d drawn = Eigen::Isometry3d::Identity();

  explicit Room(int count = 2) {
    for (int k = 0; k < count; ++k) {
      Camera camera = testCamera(400, 300);
      camera.name = k == 0 ? "left" : "right";
      camera.cameraFromWorld.translation().x() = k == 0 ? 0.0 : -0.12;
      cameras.push_back(camera);
      ProjectCamera known;
      known.camera.name = camera.name;
      project.cameras.push_back(known);
    }
    wish.board.board = board;
    wish.lensGuidance.holdSeconds = 2.5 * kFrame;
    wish.rigGuidance.holdSeconds = 2.5 * kFrame;
  }

  /// The next images, with the board there; still images are drawn once.
  FrameSetPtr frames(const Eigen::Isometry3d& worldFromBoard) {
    if (pictures.empty() || !worldFromBoard.isApprox(drawn, 1e-12)) {
      pictures.clear();
      for (const Camera& camera : cameras) {
        cv::Mat& picture = pictures.emplace_back();
        cv::cvtColor(renderBoard(board, camera, camera.cameraFromWorld * worldFromBoard, 3),
                     picture, cv::COLOR_GRAY2BGR);
      }
      drawn = worldFromBoard;
    }
    auto set = std::make_shared<FrameSet>();
    set->index = index++;
    set->time = timeStamp(kFrame * static_cast<double>(set->index));
    for (const cv::Mat& picture : pictures) {
      set->frames.push_back(std::make_shared<const Frame>(Frame{set->index, set->time, picture}));
    }
    return set;
  }

  /// Where a board before the left camera is when it should be seen in a region, tilted.
  Eigen::Isometry3d shown(int region, BoardTilt tilt, double depth = 0.42) const {
    const auto& in = cameras[0].intrinsics;
    const double x = (region % BoardCoverage::kColumns + 0.5) / BoardCoverage::kColumns - 0.5;
    const double y =
        (region / BoardCoverage::kColumns + 0.5) / BoardCoverage::kRows - 0.5; // NOLINT
    const double tiltX = tilt == BoardTilt::TopNear      ? 0.5
                         : tilt == BoardTilt::BottomNear ? -0.5
                                                         : 0.0;
    const double tiltY = tilt == BoardTilt::RightNear  ? 0.5
                         : tilt == BoardTilt::LeftNear ? -0.5
                                                       : 0.0;
    const double reach = 0.45 * depth / in.focalX;
    return boardAt(board, {reach * x * in.width, reach * y * in.height, depth}, tiltX, tiltY);
  }
};

TEST(BoardGuide, WhoDoesAsToldGetsALens) {
  Room room(1);
  room.wish.lensGuidance.requiredProjectionSigmaPx = 2.0;
  BoardGuide guide(room.project, room.wish);
  std::size_t step = 0;
  BoardGuideState state;
  for (; step < 60 && state.phase == Phase::Lenses; ++step) {
    const int region = static_cast<int>((step * 7) % 24);
    const auto tilt = static_cast<BoardTilt>(step % 5);
    const auto pose = room.shown(region, tilt, step % 4 == 3 ? 0.3 : 0.42);
    for (int k = 0; k < kStill && state.phase == Phase::Lenses; ++k) {
      state = guide.processFrame(*room.frames(pose));
    }
  }
  EXPECT_EQ(state.phase, Phase::Finished) << step;
  ASSERT_TRUE(state.cameras[0].lensGuidance.projectionSigmaPx);
  EXPECT_LE(*state.cameras[0].lensGuidance.projectionSigmaPx, 2.0);
  EXPECT_GE(state.cameras[0].capturedOutlines.size(), 10U);
  EXPECT_EQ(state.cameras[0].capturedOutlines.size(), state.detections->cameras[0].views.size());

  BoardCalibrationRequest wish = room.wish.board;
  wish.maxViews = 60;
  const auto outcome = calibrateFromBoards(room.project, *state.detections, wish, {true, false});
  ASSERT_TRUE(outcome) << errorSentence(outcome.error());
  const double focal = outcome->project.cameras[0].camera.intrinsics.focalX;
  EXPECT_NEAR(focal, room.cameras[0].intrinsics.focalX, 4.0);
}

TEST(BoardGuide, TheSameFramesGiveTheSameViews) {
  std::vector<BoardDetections> runs;
  for (int run = 0; run < 2; ++run) {
    Room room;
    BoardGuide guide(room.project, room.wish, 1 + run);
    for (int k = 0; k < 3 * kStill; ++k) {
      guide.processFrame(*room.frames(room.shown(7 + 3 * (k / kStill), BoardTilt::Flat)));
    }
    runs.push_back(*guide.state().detections);
  }
  ASSERT_EQ(runs[0].cameras[0].views.size(), 3U);
  for (std::size_t k = 0; k < 2; ++k) {
    ASSERT_EQ(runs[0].cameras[k].views.size(), runs[1].cameras[k].views.size());
    for (std::size_t v = 0; v < runs[0].cameras[k].views.size(); ++v) {
      EXPECT_EQ(runs[0].cameras[k].views[v].instant, runs[1].cameras[k].views[v].instant);
      EXPECT_EQ(runs[0].cameras[k].views[v].detection.pixels,
                runs[1].cameras[k].views[v].detection.pixels);
    }
  }
}

TEST(BoardGuide, PlacesFromABoardThatBothSee) {
  Room room;
  for (std::size_t k = 0; k < 2; ++k) {
    room.project.cameras[k].camera = room.cameras[k];
    room.project.cameras[k].camera.cameraFromWorld.setIdentity();
  }
  room.wish.goal = {false, true};
  room.wish.rigGuidance.instantsPerPair = 5;
  BoardGuide guide(room.project, room.wish);
  EXPECT_EQ(guide.state().phase, Phase::Poses);
  BoardGuideState state;
  for (int place = 0; place < 20 && state.phase != Phase::Finished; ++place) {
    for (int k = 0; k < kStill && state.phase != Phase::Finished; ++k) {
      state = guide.processFrame(
          *room.frames(room.shown((place * 5) % 24, static_cast<BoardTilt>(place % 5), 0.5)));
    }
    if (place == 0) {
      EXPECT_EQ(state.rigGuidance.firstCamera, 0);
      EXPECT_EQ(state.rigGuidance.secondCamera, 1);
    }
  }
  EXPECT_EQ(state.phase, Phase::Finished);
  EXPECT_GE(state.rigGuidance.instantCount, 5);
  ASSERT_TRUE(state.cameras[1].positionSigma);
  EXPECT_LE(*state.cameras[1].positionSigma, room.wish.requiredPositionSigma);
  const auto outcome =
      calibrateFromBoards(room.project, *state.detections, room.wish.board, room.wish.goal);
  ASSERT_TRUE(outcome) << errorSentence(outcome.error());
  // The right camera stands 12 cm to the right of the left one.
  EXPECT_LT((outcome->project.cameras[1].camera.center() - Eigen::Vector3d(0.12, 0.0, 0.0)).norm(),
            0.002);
}

TEST(BoardGuide, TakesWhatAPersonAsksForAndGoesOn) {
  Room room;
  room.wish.goal = {true, true};
  BoardGuide guide(room.project, room.wish);
  guide.processFrame(*room.frames(room.shown(9, BoardTilt::Flat)));
  const auto state = guide.captureNow();
  EXPECT_EQ(state.cameras[0].lensGuidance.viewCount, 1);
  EXPECT_EQ(state.detections->cameras[0].views.size(), 1U);
  EXPECT_EQ(guide.skipToPoses().phase, Phase::Poses);
  guide.processFrame(*room.frames(room.shown(16, BoardTilt::Flat, 0.5)));
  EXPECT_EQ(guide.captureNow().rigGuidance.instantCount, 1);
  EXPECT_EQ(guide.state().cameras[1].pairViewCount, 1);
  EXPECT_FALSE(guide.state().floorFrame);
  guide.processFrame(*room.frames(room.shown(10, BoardTilt::Flat, 0.5)));
  EXPECT_EQ(guide.captureFloor().floorFrame, 2);
}

TEST(BoardGuide, AllThatWasTakenIsCalibratedFrom) {
  BoardGuideRequest wish;
  wish.board.maxViews = 30;
  wish.lensGuidance.maxViews = 60;
  wish.board.maxInstants = 17;
  wish.board.floorFrame = 3; // of a recording: live, the floor is what was shown
  BoardGuideState state;
  const BoardCalibrationRequest without = requestForCapturedViews(wish, state);
  EXPECT_EQ(without.maxViews, 60); // as many as the guidance takes of a lens, not 30 of them
  EXPECT_FALSE(without.floorFrame);
  EXPECT_EQ(without.maxInstants, 17);
  state.floorFrame = 42;
  wish.board.maxViews = 80;
  const BoardCalibrationRequest onFloor = requestForCapturedViews(wish, state);
  EXPECT_EQ(onFloor.maxViews, 80); // more are never too many
  EXPECT_EQ(onFloor.floorFrame, 42);
}

TEST(BoardGuide, ACameraWithoutImagesHoldsNobodyUp) {
  Room room;
  BoardGuide guide(room.project, room.wish);
  BoardGuideState state;
  for (int k = 0; k < kStill; ++k) {
    FrameSet frames = *room.frames(room.shown(9, BoardTilt::Flat));
    frames.frames[1] = nullptr;
    state = guide.processFrame(frames);
  }
  EXPECT_EQ(state.cameras[0].lensGuidance.viewCount, 1);
  EXPECT_EQ(state.cameras[1].imageWidth, 0);
}

TEST(BoardGuideThread, LooksAtTheNewestImagesInItsOwnThread) {
  Room room;
  std::atomic<int> woken = 0;
  BoardGuideThread watch([&] { ++woken; });
  EXPECT_TRUE(watch.newestState()->cameras.empty());
  watch.start(room.project, room.wish);
  const auto pose = room.shown(9, BoardTilt::Flat);
  const auto until = [&](const std::function<bool()>& reached) {
    while (!reached()) {
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
  };
  for (int k = 0; k < kStill; ++k) {
    const auto frames = room.frames(pose);
    watch.offer(frames);
    until([&] { return watch.newestState()->frame == frames->index; });
  }
  EXPECT_EQ(watch.newestState()->cameras[0].lensGuidance.viewCount, 1);
  EXPECT_GE(woken, kStill);
  watch.captureNow();
  until([&] { return watch.newestState()->cameras[0].lensGuidance.viewCount == 2; });
  watch.start(room.project, room.wish); // over again, at once
  EXPECT_EQ(watch.newestState()->cameras[0].lensGuidance.viewCount, 0);
}

} // namespace
} // namespace dewpoint::tests
