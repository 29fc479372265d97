// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/thread_team.h"
#include "core/calibration/board/board_guidance.h"
#include "core/calibration/board/extrinsics_from_board.h"
#include "core/calibration/board/rig_guidance.h"
#include "core/capture/frame.h"
#include "core/project/project.h"
#include "core/setup/calibration/board_outcome.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace dewpoint::setup {

/// Options of a guided calibration, in which the user shows a board to live cameras.
struct BoardGuideRequest {
  BoardCalibrationRequest board;
  BoardGoal goal;
  GuidanceSettings
      lensGuidance; ///< settings for intrinsics, including the accuracy that is sufficient
  RigGuidance::Settings rigGuidance; ///< how often pairs of cameras must see the board together
  /// Largest accepted standard deviation of each camera position, meters.
  double requiredPositionSigma = 0.002;
  /// Number of captured frames after which the calibration ends regardless of its accuracy.
  int maxInstants = 60;
  /// Maximum number of captured outlines of the board kept for each camera.
  std::size_t maxOutlines = 100;
};

/// State of a guided calibration with a board. Immutable once published.
struct BoardGuideState {
  enum class Phase {
    Lenses,  ///< the board is shown to each camera separately
    Poses,   ///< the board is shown to several cameras at the same time
    Finished ///< the requested accuracy is reached
  };
  using Outline = std::vector<Eigen::Vector2d>; ///< polygon around the corners of the board, pixels
  struct PerCamera {
    std::string name;
    /// Width of the images, pixels. 0: this camera has not delivered an image yet.
    int imageWidth = 0;
    int imageHeight = 0;
    GuidanceState lensGuidance;              ///< guidance of the user in phase Lenses
    std::optional<BoardDetection> detection; ///< detection of the board in the newest image
    Outline outline; ///< outline of the board in the newest image; may be empty
    std::vector<Outline> capturedOutlines; ///< outlines of the board in the captured views
    /// Reprojection error of the latest calibration of this camera's intrinsics, pixels.
    std::optional<double> rmsPx;
    /// Standard deviation of the camera position in the latest calibration of the poses, meters.
    std::optional<double> positionSigma;
    /// Number of captured views of the board that another camera saw at the same time.
    int pairViewCount = 0;
  };

  Phase phase = Phase::Lenses;
  std::int64_t frame = -1; ///< number of the last frame whose images were searched for the board
  std::vector<PerCamera> cameras;
  RigGuidance::State rigGuidance;
  std::optional<std::int64_t> floorFrame; ///< frame in which the board lies on the floor
  /// Views captured so far, for calibrateFromBoards().
  std::shared_ptr<const BoardDetections> detections;
};
using BoardGuideStatePtr = std::shared_ptr<const BoardGuideState>;

/// Returns the options with which calibrateFromBoards() processes the captured views of live
/// cameras: intrinsics are estimated from all views, and the captured view of the board on the
/// floor defines the world frame.
BoardCalibrationRequest requestForCapturedViews(const BoardGuideRequest& request,
                                                const BoardGuideState& state);

/// Guides the user through the calibration of live cameras with a board. It searches for the board
/// in the images, shows the user how to hold the board next, captures the board while it is held
/// still, calibrates repeatedly, and ends automatically when the requested accuracy is reached. It
/// has no clock, and no threads except those that process the images: the same frames give the same
/// states.
class BoardGuide {
public:
  BoardGuide(Project project, const BoardGuideRequest& request, int threads = 1);

  /// Processes the images of one frame and returns the new state. Pass the newest frame each time;
  /// frame numbers must be ascending.
  BoardGuideState processFrame(const FrameSet& frames);
  /// Captures the last images that show the board. Call this function when the user asks for it.
  BoardGuideState captureNow();
  /// Captures the last images that show the board, which must lie on the floor. At least one camera
  /// must have detected the board.
  BoardGuideState captureFloor();
  /// Ends the phase Lenses, in which intrinsics are calibrated, whatever accuracy it has reached.
  /// Continues with the camera poses.
  BoardGuideState skipToPoses();
  const BoardGuideState& state() const { return state_; }

private:
  using Detections = std::vector<std::optional<BoardDetection>>;
  Detections detectIn(const FrameSet& frames);
  void begin(const FrameSet& frames);
  void stepLenses(double time, const Detections& found);
  void stepRig(double time, const Detections& found);
  void calibrateLens(std::size_t camera);
  void calibrateRig();
  void storeLensState(std::size_t camera, const GuidanceState& state);
  void storeRigState(const RigGuidance::State& state);
  void storeView(std::size_t camera);
  void beginRig();

  Project project_; ///< project with the intrinsics estimated so far
  BoardGuideRequest request_;
  BoardDetector detector_;
  ThreadTeam team_;
  BoardGuideState state_;
  BoardDetections seen_;
  std::vector<std::optional<BoardGuidance>> lenses_; ///< empty before a camera's first image
  /// Number of views of each camera at the last calibration of its intrinsics.
  std::vector<std::size_t> viewsAtCalibration_;
  std::optional<RigGuidance> rigGuidance_;
};

} // namespace dewpoint::setup
