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
/// Pauses. If past frames are being tracked again (Rerun), this ends before the remaining ones are
/// tracked.
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
/// Changes the method; the seed is kept. If `from` is set, the results of frames before it are
/// kept.
struct SetMethod {
  std::string method;
  ParameterValues parameters;
  std::optional<std::int64_t> from; ///< not set: from the first frame
};
/// Pauses and shows another frame. This can be an earlier frame, as it was tracked, or, in a
/// recording, a later frame that was not tracked yet. The run itself stays at its frame. Play then
/// continues from the frame shown: it replays frames up to the frame of the run, then tracks the
/// following ones.
struct ShowFrame {
  std::int64_t frame = 0;
};
/// Shows the current frame of the run again.
struct ReturnToNewestFrame {};
/// Tracks again from this frame up to the frame that the run had reached, as fast as possible, with
/// the current parameters, colors and background images. The results recorded from this frame on
/// are replaced. Pausing stops the rerun.
struct Rerun {
  std::int64_t from = 0;
  /// If true, the frame that is shown does not change: frames are tracked again without being
  /// published, unless this takes noticeably long.
  bool keepView = false;
};
/// Turns likelihood maps on or off (TargetSnapshot::maps).
struct ShowMaps {
  bool shown = false;
};
/// Changes the targets. New colors or radii take effect immediately. If the number of targets
/// changes, all tracks start from scratch.
struct SetTargets {
  std::vector<Target> targets;
};
/// Changes the calibration of the same cameras from the next iteration on; tracks continue. A rig
/// with different image sizes or a different number of cameras requires a new run and is ignored.
struct SetCameras {
  CameraRig rig;
};
/// Replaces the background images of the cameras. `images` are those returned by
/// loadBackgroundImages(). The current estimates are kept.
struct SetBackgroundImages {
  std::vector<std::string> files; ///< paths as named in the project
  std::vector<cv::Mat> images;
};
/// Changes or removes the volume of interest. Targets are limited to it from the next iteration on;
/// the positions at which tracks are created, from the next restart on.
struct SetVolumeOfInterest {
  std::optional<WorldBox> volume;
};
/// Turns masks on or off (TrackSnapshot::masks). A mask marks the pixels that have the color of a
/// target, or that are moving.
struct ShowMasks {
  bool shown = false;
};
/// Turns people's hulls and density contours on or off (TargetSnapshot::shape).
struct ShowShapes {
  bool shown = false;
};
/// Sets the number of filter threads from the next iteration on. The results do not depend on this
/// number.
struct SetThreads {
  int threads = 0;
};
/// Sets the playback speed. The results do not depend on it.
struct SetPace {
  Pace pace;
};
/// Reports whether a calibration board is being shown to live cameras. While it is, no camera is
/// reported as moved (CameraMotionWatch::setPaused()).
struct ShowBoard {
  bool shown = false;
};
/// Replaces all person corrections; only tracking methods that find people automatically use them.
/// Past frames are tracked again from the first frame whose corrections changed.
struct SetPersonCorrections {
  std::vector<PersonCorrection> people; ///< ordered by frame
};
/// Replaces all position corrections; tracking methods that cannot apply them ignore them. Past
/// frames are tracked again from the first frame whose corrections changed.
struct SetCorrections {
  std::vector<PositionCorrection> corrections; ///< ordered by frame
};
/// Makes a snapshot of one frame for the sender alone. Neither the run nor the frame that is shown
/// changes, and the snapshot is not published.
struct DescribeFrame {
  std::int64_t frame = 0;
  /// Called in the tracking thread, exactly once, unless the session ends first. It must return
  /// immediately. Errors: Canceled, NotFound, and those of reading the frame.
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
                 command::ShowMaps, command::ShowShapes, command::ShowBoard,
                 command::SetPersonCorrections, command::SetThreads, command::SetVolumeOfInterest,
                 command::SetCorrections, command::SetPace, command::DescribeFrame>;

} // namespace dewpoint::session
