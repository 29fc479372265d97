// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/geometry/camera.h"
#include "core/geometry/world_box.h"
#include "core/project/project.h"
#include "core/session/playback_pace.h"
#include "core/tracking/parameters.h"
#include "core/tracking/target.h"

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace dewpoint::session {

struct TrackSnapshot;

/// User requests, passed by value to the tracking thread.
namespace command {
/// Starts or resumes playing.
struct Play {};
/// Pauses. If past frames are being tracked again (Rerun), the remaining ones are not tracked.
struct Pause {};
/// Tracks the next frame with all its iterations, then pauses.
struct StepFrame {};
/// Runs one filter iteration on the current frame of the run, then pauses.
struct StepIteration {};
/// Restarts the run from scratch at the first frame; all tracks are removed.
struct Restart {
  std::optional<std::uint64_t> seed; ///< not set: the previous seed
};
/// Changes the parameters of the method.
struct SetParameters {
  ParameterValues parameters;
};
/// Changes the tracking method and tracks the frames again with it. The random seed is kept. If
/// `fromFrame` is set, the results of frames before it are kept.
struct SetMethod {
  std::string method;
  ParameterValues parameters;
  /// First frame to track again; not set: the first frame of the run.
  std::optional<std::int64_t> fromFrame;
};
/// Pauses and shows another frame: an earlier frame with its results or, in a recording, a later
/// frame that was not tracked yet. The run itself stays at its current frame. The command Play then
/// continues from the frame shown: frames up to the current frame of the run are replayed, later
/// ones are tracked.
struct ShowFrame {
  std::int64_t frame = 0;
};
/// Shows the current frame of the run again, after ShowFrame.
struct ReturnToNewestFrame {};
/// Tracks frames again, from frame `fromFrame` up to the frame that the run had reached, as fast as
/// possible, with the current parameters, colors and background images. The former results of these
/// frames are replaced. Pausing stops the rerun.
struct Rerun {
  std::int64_t fromFrame = 0;
  /// If true, the frame that is shown does not change: frames are tracked again without being
  /// published, unless this takes noticeably long.
  bool keepView = false;
};
/// Turns likelihood maps on or off in snapshots, the copies of the results that the tracking thread
/// publishes for display.
struct ShowMaps {
  bool isShown = false;
};
/// Changes the targets. New colors or radii take effect immediately. If the number of targets
/// changes, all tracks start from scratch.
struct SetTargets {
  std::vector<Target> targets;
};
/// Changes the calibration of the cameras from the next iteration on; tracks continue. Ignored if
/// the number of cameras or an image size differs, because this requires a new run.
struct SetCameras {
  CameraRig rig;
};
/// Replaces the background images of the cameras. `images` has one image per camera, as returned by
/// loadBackgroundImages(). The current estimates are kept.
struct SetBackgroundImages {
  std::vector<std::string> files; ///< paths as named in the project
  std::vector<cv::Mat> images;
};
/// Changes or removes the volume of interest, to which targets are limited. The change applies to
/// existing tracks from the next iteration on, and to the positions at which new tracks are created
/// from the next restart on.
struct SetVolumeOfInterest {
  std::optional<WorldBox> volume;
};
/// Turns masks on or off in snapshots, the copies of the results that the tracking thread publishes
/// for display. A mask marks the pixels that have the color of a target, or that are moving.
struct ShowMasks {
  bool isShown = false;
};
/// Turns the body shapes of people on or off in snapshots, the copies of the results that the
/// tracking thread publishes for display.
struct ShowBodyShapes {
  bool isShown = false;
};
/// Sets the number of filter threads from the next iteration on. The results do not depend on this
/// number.
struct SetThreadCount {
  int threadCount = 0;
};
/// Sets the playback speed. The results do not depend on this speed.
struct SetPace {
  Pace pace;
};
/// Sets whether a calibration board is being shown to live cameras. While a board is being shown,
/// no camera is reported as moved.
struct ShowCalibrationBoard {
  bool isShown = false;
};
/// Replaces all of the user's corrections of people (persons added or removed). Only methods that
/// find people automatically use these corrections. Past frames are tracked again from the first
/// frame whose corrections changed.
struct SetPersonCorrections {
  std::vector<PersonCorrection> corrections; ///< ordered by frame
};
/// Replaces all of the user's corrections of target positions. Methods that cannot apply
/// corrections ignore them. Past frames are tracked again from the first frame whose corrections
/// changed.
struct SetCorrections {
  std::vector<PositionCorrection> corrections; ///< ordered by frame
};
/// Requests a snapshot (copy of the results) of one frame for the sender alone. The snapshot is not
/// published, and neither the run nor the frame that is shown changes.
struct DescribeFrame {
  std::int64_t frame = 0;
  /// Receives the snapshot or an error: Canceled, NotFound, or an error of reading the frame.
  /// Called exactly once, in the tracking thread, unless the session ends first. Must return
  /// immediately.
  std::function<void(Result<std::shared_ptr<const TrackSnapshot>>)> receive;
  /// Returns whether the snapshot is still wanted. Any thread may call it.
  std::function<bool()> isWanted = [] { return true; };
};
} // namespace command

/// Any request to the tracking thread.
using Command =
    std::variant<command::Play, command::Pause, command::StepFrame, command::StepIteration,
                 command::Restart, command::SetParameters, command::SetMethod, command::SetTargets,
                 command::SetCameras, command::SetBackgroundImages, command::ShowMasks,
                 command::ShowFrame, command::ReturnToNewestFrame, command::Rerun,
                 command::ShowMaps, command::ShowBodyShapes, command::ShowCalibrationBoard,
                 command::SetPersonCorrections, command::SetThreadCount,
                 command::SetVolumeOfInterest, command::SetCorrections, command::SetPace,
                 command::DescribeFrame>;

} // namespace dewpoint::session
