// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/thread_team.h"
#include "core/calibration/board/board_guidance.h"
#include "core/calibration/board/extrinsics_from_board.h"
#include "core/calibration/board/rig_guidance.h"
#include "core/capture/frame.h"
#include "core/project/project.h"
#include "core/setup/board_outcome.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace dewpoint::setup {

/// The request of a user who shows a board to live cameras.
struct BoardGuideRequest {
  BoardCalibrationRequest board;
  BoardGoal goal;
  GuidanceSettings lenses;          ///< with the accuracy at which a lens is known well enough
  RigGuidance::Settings rig;        ///< how often pairs of cameras see the board together
  double requestedPosition = 0.002; ///< meters: CameraFit::centerSigma of each camera at the end
  int mostInstants = 60;            ///< then it ends whatever the accuracy
  std::size_t outlinesKept = 100;   ///< per camera
};

/// Where the guidance is. Immutable once published.
struct BoardGuideState {
  enum class Phase {
    Lenses,  ///< the board is shown to each camera by itself
    Poses,   ///< and to several at once
    Finished ///< the requested accuracy is reached
  };
  using Outline = std::vector<Eigen::Vector2d>; ///< pixels, around the board's corners
  struct PerCamera {
    std::string name;
    int width = 0; ///< of its images; 0: there was none yet
    int height = 0;
    GuidanceState lens;                  ///< in the phase Lenses
    std::optional<BoardDetection> seen;  ///< in the newest image
    Outline outline;                     ///< of it; may be empty
    std::vector<Outline> taken;          ///< of the views that were taken
    std::optional<double> rmsPx;         ///< of the newest calibration of its lens
    std::optional<double> positionSigma; ///< meters, of the newest calibration of the poses
    int pairViews = 0;                   ///< taken together with another camera
  };

  Phase phase = Phase::Lenses;
  std::int64_t frame = -1; ///< the last frame set that was searched
  std::vector<PerCamera> cameras;
  RigGuidance::State rig;
  std::optional<std::int64_t> floorFrame; ///< in which the board lies on the floor
  /// What was taken so far, for calibrateFromBoards().
  std::shared_ptr<const SeenBoards> seen;
};
using BoardGuideStatePtr = std::shared_ptr<const BoardGuideState>;

/// What calibrateFromBoards() is to do with the views that were taken from live cameras: lenses are
/// found from all of them, and the world is that of the floor that was shown.
BoardCalibrationRequest requestForTaken(const BoardGuideRequest& request,
                                        const BoardGuideState& state);

/// Guides the user through the calibration of live cameras with a board: searches for it in the
/// images, tells what to show next, captures it while it is held still, calibrates in between, and
/// ends by itself when the requested accuracy is reached. No clock and no thread of its own besides
/// those that share the images: the same frames give the same states.
class BoardGuide {
public:
  BoardGuide(Project project, const BoardGuideRequest& request, int threads = 1);

  /// The newest images, in rising order.
  BoardGuideState step(const FrameSet& frames);
  /// Takes the images given last, where they show the board: on the user's request.
  BoardGuideState captureNow();
  /// The same; there the board lies on the floor. What is not seen at all makes no floor.
  BoardGuideState captureFloor();
  /// Leaves the lenses as well known as they are and goes on to the poses.
  BoardGuideState goOn();
  const BoardGuideState& state() const { return state_; }

private:
  using Detections = std::vector<std::optional<BoardDetection>>;
  Detections detectIn(const FrameSet& frames);
  void begin(const FrameSet& frames);
  void stepLenses(double time, const Detections& found);
  void stepRig(double time, const Detections& found);
  void learnLens(std::size_t camera);
  void calibrateRig();
  void keepLens(std::size_t camera, const GuidanceState& state);
  void keepRig(const RigGuidance::State& state);
  void keepView(std::size_t camera);
  void beginRig();

  Project project_; ///< with the lenses found so far
  BoardGuideRequest request_;
  BoardDetector detector_;
  ThreadTeam team_;
  BoardGuideState state_;
  SeenBoards seen_;
  std::vector<std::optional<BoardGuidance>> lenses_; ///< nothing before a camera's first image
  std::vector<std::size_t> tried_; ///< views of each camera when its lens was calibrated last
  std::optional<RigGuidance> rigGuidance_;
};

} // namespace dewpoint::setup
