// SPDX-License-Identifier: GPL-3.0-or-later
// From the frames of a recording to lenses and poses, as the window and the command line do it.
#include "core/calibration/board/board_picture.h"
#include "core/capture/recording.h"
#include "core/setup/calibration/board_outcome.h"
#include "tests/calibration/board_views.h"

#include <opencv2/imgproc.hpp>

namespace dewpoint::tests {
namespace {

constexpr int kFrames = 14;

/// Two cameras beside each other, a board that is shown around before them; in frame 0 it lies at
/// the world's origin, turned up to the cameras.
struct Recorded {
  BoardDescription board = boardOf("charuco:7x5:0.03:0.022:DICT_4X4_50");
  CameraRig cameras;
  std::vector<Eigen::Isometry3d> worldFromBoard;
  Project project;

  Recorded() {
    for (int k = 0; k < 2; ++k) {
      Camera camera = testCamera(480, 360);
      camera.distortion = {-0.1, 0.02, 0.0, 0.0, 0.0};
      camera.name = k == 0 ? "left" : "right";
      camera.cameraFromWorld = lookAt({k == 0 ? -0.1 : 0.25, -0.25, 0.35}, {0.1, -0.06, 0.0});
      cameras.push_back(camera);
      ProjectCamera known;
      known.camera = camera;
      known.camera.cameraFromWorld.setIdentity(); // to be found
      project.cameras.push_back(known);
    }
    for (std::uint32_t frame = 0; frame < kFrames; ++frame) {
      Eigen::Isometry3d pose = worldFromFlatBoard();
      if (frame > 0) {
        const RandomStream random(8, frame, 0, RandomPurpose::Simulation);
        const auto u = random.uniform3(0);
        const auto v = random.uniform3(1);
        pose.translation() = Eigen::Vector3d(0.1 * u[0] - 0.05, 0.1 * u[1] - 0.05, 0.08 * u[2]);
        pose.rotate(Eigen::AngleAxisd(1.2 * v[0] - 0.6, Eigen::Vector3d::UnitX()) *
                    Eigen::AngleAxisd(1.2 * v[1] - 0.6, Eigen::Vector3d::UnitY()));
      }
      worldFromBoard.push_back(pose);
    }
  }

  std::unique_ptr<FrameSetSource> open() const {
    std::vector<RecordedCamera> recorded;
    for (const Camera& camera : cameras) {
      RecordedCamera one;
      one.name = camera.name;
      one.kind = RecordedCamera::Kind::Generated;
      one.generatedFrameCount = kFrames;
      one.generate = [this, &camera](std::int64_t frame) {
        cv::Mat picture = renderBoard(
            board, camera, camera.cameraFromWorld * worldFromBoard[static_cast<std::size_t>(frame)],
            4);
        cv::cvtColor(picture, picture, cv::COLOR_GRAY2BGR);
        return picture;
      };
      recorded.push_back(one);
    }
    return std::move(openRecording(recorded, 30.0).value());
  }

  BoardCalibrationRequest wish() const {
    BoardCalibrationRequest wanted;
    wanted.board = board;
    return wanted;
  }
};

TEST(BoardCalibration, LensesAndPosesOfARecording) {
  const Recorded recorded;
  BoardCalibrationRequest wish = recorded.wish();
  wish.floorFrame = 0;
  const auto source = recorded.open();
  const auto seen = findBoards(recorded.project, *source, wish);
  ASSERT_TRUE(seen) << errorSentence(seen.error());
  ASSERT_EQ(seen->cameras.size(), 2U);
  EXPECT_EQ(seen->cameras[0].searchedImageCount, kFrames);
  EXPECT_GE(seen->cameras[0].views.size(), 12U);

  const auto lenses = intrinsicsFromBoards(*seen, wish);
  ASSERT_TRUE(lenses) << errorSentence(lenses.error());
  EXPECT_NEAR(lenses->cameras[0]->camera.intrinsics.focalX, 0.85 * 480, 3.0);

  const auto poses = extrinsicsFromBoards(recorded.project, *seen, wish);
  ASSERT_TRUE(poses) << errorSentence(poses.error());
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_LT((poses->cameras[k].center() - recorded.cameras[k].center()).norm(), 0.001) << k;
  }

  const Project calibrated =
      withCameras(withIntrinsics(recorded.project, lenses->cameras), poses->cameras);
  EXPECT_EQ(calibrated.cameras[1].camera.name, "right");
  EXPECT_EQ(calibrated.cameras[1].camera.cameraFromWorld.matrix(),
            poses->cameras[1].cameraFromWorld.matrix());

  // Once more, the same to the last bit.
  const auto again = findBoards(recorded.project, *source, wish).and_then([&](const auto& boards) {
    return extrinsicsFromBoards(recorded.project, boards, wish);
  });
  ASSERT_TRUE(again);
  EXPECT_EQ(again->cameras, poses->cameras);
}

TEST(BoardCalibration, StopsWhenTold) {
  const Recorded recorded;
  const auto source = recorded.open();
  int calls = 0;
  const auto seen =
      findBoards(recorded.project, *source, recorded.wish(), [&](CalibrationStage stage, double) {
        EXPECT_EQ(stage, CalibrationStage::BoardDetection);
        return ++calls < 3;
      });
  ASSERT_FALSE(seen);
  EXPECT_EQ(seen.error().code, ErrorCode::Canceled);
  EXPECT_EQ(calls, 3);
}

TEST(BoardCalibration, OnlyTheFramesOfARangeAreSearched) {
  const Recorded recorded;
  const auto source = recorded.open();
  BoardCalibrationRequest wish = recorded.wish();
  wish.firstFrame = 3;
  wish.endFrame = 6;
  auto seen = findBoards(recorded.project, *source, wish);
  ASSERT_TRUE(seen) << errorSentence(seen.error());
  EXPECT_EQ(seen->cameras[0].searchedImageCount, 3);
  for (const BoardView& view : seen->cameras[0].views) {
    EXPECT_GE(view.instant, 3);
    EXPECT_LT(view.instant, 6);
  }

  wish.floorFrame = 0; // outside the range, but it is what makes the world
  seen = findBoards(recorded.project, *source, wish);
  ASSERT_TRUE(seen) << errorSentence(seen.error());
  EXPECT_EQ(seen->cameras[0].searchedImageCount, 4);

  wish.firstFrame = kFrames;
  wish.endFrame.reset();
  seen = findBoards(recorded.project, *source, wish);
  ASSERT_FALSE(seen);
  EXPECT_EQ(seen.error().field, "--frames");
}

TEST(BoardCalibration, FramesBetweenThoseLookedAtArePassedOver) {
  const Recorded recorded;
  BoardCalibrationRequest wish = recorded.wish();
  wish.maxSearchedFrames = 5; // every third frame
  wish.floorFrame = 7;
  const auto source = recorded.open();
  const auto seen = findBoards(recorded.project, *source, wish);
  ASSERT_TRUE(seen);
  std::vector<std::int64_t> instants;
  for (const BoardView& view : seen->cameras[0].views) {
    instants.push_back(view.instant);
  }
  EXPECT_EQ(instants, (std::vector<std::int64_t>{0, 3, 6, 7, 9, 12}));
}

/// A third camera that looks the other way, and where the others saw the board.
struct BlindCamera {
  Recorded recorded;
  BoardDetections seen;

  BlindCamera() {
    const auto source = recorded.open();
    seen = findBoards(recorded.project, *source, recorded.wish()).value();
    BoardDetections::PerCamera blind = seen.cameras[0];
    blind.name = "door";
    blind.views.clear();
    blind.missedImages.clear();
    seen.cameras.insert(seen.cameras.begin(), blind);
    ProjectCamera camera = recorded.project.cameras[0];
    camera.camera.name = "door";
    camera.camera.cameraFromWorld.translation().z() = 4.0;
    recorded.project.cameras.insert(recorded.project.cameras.begin(), camera);
  }
};

TEST(BoardCalibration, ACameraThatNeverSawTheBoardKeepsWhatItHas) {
  const BlindCamera blind;
  const auto outcome =
      calibrateFromBoards(blind.recorded.project, blind.seen, blind.recorded.wish(), {true, true});
  ASSERT_TRUE(outcome) << errorSentence(outcome.error());
  EXPECT_EQ(outcome->project.cameras[0], blind.recorded.project.cameras[0]);
  EXPECT_NE(outcome->project.cameras[1].camera.intrinsics,
            blind.recorded.project.cameras[1].camera.intrinsics);
  const auto remarks = outcomeRemarks(*outcome);
  ASSERT_EQ(remarks.size(), 3U);
  EXPECT_EQ(remarks[0], "door keeps its intrinsics: it never saw the board in 14 images.");
  EXPECT_EQ(remarks[1], "'door' never saw the board: it keeps its pose.");
  // Fourteen small images leave the edges open; the other lens was given.
  EXPECT_TRUE(remarks[2].starts_with("the lens of 'left' is poorly known")) << remarks[2];
  EXPECT_TRUE(outcome->extrinsics->cameraFits[0].views.empty());
  EXPECT_GE(outcome->extrinsics->cameraFits[2].views.size(), 10U);
  // The distance between the other two is that of the scene.
  const double apart =
      (outcome->project.cameras[1].camera.center() - outcome->project.cameras[2].camera.center())
          .norm();
  EXPECT_NEAR(apart, 0.35, 0.003);
  EXPECT_NE(outcome->report.find("door keeps its intrinsics"), std::string::npos);
}

TEST(BoardCalibration, LensesRemainWherePlacesCannotBeFound) {
  BlindCamera blind;
  blind.seen.cameras[2].views.clear(); // one camera is left
  const auto outcome =
      calibrateFromBoards(blind.recorded.project, blind.seen, blind.recorded.wish(), {true, true});
  ASSERT_TRUE(outcome) << errorSentence(outcome.error());
  ASSERT_TRUE(outcome->extrinsicsError);
  EXPECT_NE(outcome->extrinsicsError->detail.find("'right'"), std::string::npos);
  EXPECT_TRUE(outcome->lenses->cameras[1]);
  EXPECT_EQ(outcomeRemarks(*outcome).size(), 3U);
  EXPECT_FALSE(calibrateFromBoards(blind.recorded.project, blind.seen, blind.recorded.wish(),
                                   {false, true}));
}

TEST(BoardCalibration, NobodySawTheBoard) {
  BlindCamera blind;
  for (auto& camera : blind.seen.cameras) {
    camera.views.clear();
  }
  const auto outcome =
      calibrateFromBoards(blind.recorded.project, blind.seen, blind.recorded.wish(), {true, false});
  ASSERT_FALSE(outcome);
  EXPECT_EQ(outcome.error().field, "door");
}

TEST(BoardCalibration, SaysAVerdictAndNoFault) {
  Recorded recorded;
  for (std::size_t k = 0; k < 2; ++k) {
    recorded.project.cameras[k].camera.cameraFromWorld = recorded.cameras[k].cameraFromWorld;
  }
  BoardCalibrationRequest wish = recorded.wish();
  wish.floorFrame = 0;
  const auto source = recorded.open();
  const auto outcome =
      findBoards(recorded.project, *source, wish).and_then([&](const BoardDetections& seen) {
        return calibrateFromBoards(recorded.project, seen, wish, {false, true});
      });
  ASSERT_TRUE(outcome) << errorSentence(outcome.error());
  ASSERT_TRUE(outcome->accuracy) << outcome->accuracySummary;
  EXPECT_TRUE(outcome->extrinsics->faults.empty()) << outcome->extrinsics->faults[0].sentence;
  // 0.2 mm over 7 squares of 30 mm are 0.1 % (one sigma), at least.
  EXPECT_NEAR(outcome->accuracy->scaleError95.value(), 1.96 * 0.2 / 210.0, 0.0005);
  EXPECT_GT(outcome->accuracy->upAngleError95.value(), 0.001);
  EXPECT_LT(outcome->accuracy->upAngleError95.value(), 0.05);
  EXPECT_LT(outcome->accuracy->positionError95, 0.002);
  EXPECT_NE(outcome->report.find("In this volume"), std::string::npos);
}

TEST(BoardCalibration, APoorlyKnownLensIsNamed) {
  Recorded recorded;
  project::LensRecord known = project::recordOfLens(recorded.cameras[1], CalibrationOrigin::File);
  known.error = 25.0;
  recorded.project.cameras[1].calibrationRecord.lens = known;
  const auto source = recorded.open();
  const auto seen = findBoards(recorded.project, *source, recorded.wish());
  ASSERT_TRUE(seen) << errorSentence(seen.error());
  const auto outcome = calibrateFromBoards(recorded.project, *seen, recorded.wish(), {false, true});
  ASSERT_TRUE(outcome) << errorSentence(outcome.error());
  ASSERT_TRUE(outcome->extrinsics);
  const auto named = [](const std::string& notice) {
    return notice.starts_with("the lens of 'right' is poorly known: a ray may be off by 25 px");
  };
  EXPECT_EQ(std::ranges::count_if(outcome->extrinsics->notices, named), 1);
}

TEST(BoardCalibration, AVideoThatWasRotatedIsNamed) {
  Recorded recorded;
  const auto source = recorded.open();
  const auto seen = findBoards(recorded.project, *source, recorded.wish());
  ASSERT_TRUE(seen);
  Intrinsics& in = recorded.project.cameras[1].camera.intrinsics;
  std::swap(in.width, in.height);
  const auto poses = extrinsicsFromBoards(recorded.project, *seen, recorded.wish());
  ASSERT_FALSE(poses);
  EXPECT_EQ(poses.error().field, "right");
  EXPECT_NE(poses.error().detail.find("rotate = 90 or 270"), std::string::npos)
      << poses.error().detail;
}

TEST(BoardCalibration, AWrongSquareSizeIsNamed) {
  Recorded recorded;
  for (std::size_t k = 0; k < 2; ++k) {
    recorded.project.cameras[k].camera.cameraFromWorld = recorded.cameras[k].cameraFromWorld;
  }
  BoardCalibrationRequest wish = recorded.wish();
  const auto source = recorded.open();
  auto seen = findBoards(recorded.project, *source, wish);
  ASSERT_TRUE(seen);
  wish.board.squareSize *= 1000.0; // typed in millimeters
  wish.board.markerSize *= 1000.0;
  const auto outcome = calibrateFromBoards(recorded.project, *seen, wish, {false, true});
  ASSERT_TRUE(outcome) << errorSentence(outcome.error());
  ASSERT_EQ(outcome->extrinsics->faults.size(), 1U);
  EXPECT_EQ(outcome->extrinsics->faults[0].fault, CalibrationFault::WrongUnitMillimeters);
}

} // namespace
} // namespace dewpoint::tests
