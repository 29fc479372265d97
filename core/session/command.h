// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/camera.h"
#include "core/geometry/world_box.h"
#include "core/project/project.h"
#include "core/session/playback_pace.h"
#include "core/tracking/parameters.h"
#include "core/tracking/target.h"

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace dewpoint::session {

/// Requests of the user, passed by value to the tracking thread.
namespace command {
/// Starts or resumes playing.
struct Play {};
/// Pauses; an unfinished rerun is abandoned.
struct Pause {};
/// Tracks the next frame with all its iterations, then pauses.
struct StepFrame {};
/// Runs one filter iteration on the current frame of the run, then pauses.
struct StepIteration {};
/// Restarts the run at the first frame, without prior knowledge.
struct Restart {
  std::optional<std::uint64_t> seed; ///< not set: the previous seed
};
/// Changes the parameters of the method.
struct Configure {
  ParameterValues parameters;
};
/// Changes the method; the seed is kept. If the method begins at frame `from`, earlier results are
/// kept.
struct SetMethod {
  std::string method;
  ParameterValues parameters;
  std::optional<std::int64_t> from; ///< not set: from the first frame
};
/// Pauses and shows another frame: an earlier one as it was tracked, or a later one of a recording
/// without results. The run itself stays at its frame. Playing continues from the frame shown: it
/// first replays recorded frames up to the frame of the run, then tracks.
struct ShowFrame {
  std::int64_t frame = 0;
};
/// Shows the current frame of the run again.
struct BackToHead {};
/// Tracks again from this frame on, as fast as it goes, up to where the run stood: with the
/// parameters, colors and background images of now. What was recorded from there on is replaced.
/// Pausing stops it.
struct Rerun {
  std::int64_t from = 0;
  /// If true, the displayed frame stays: frames tracked meanwhile are not published, unless the
  /// rerun takes noticeably long.
  bool keepsView = false;
};
/// Turns likelihood maps on or off (TargetSnapshot::maps).
struct ShowMaps {
  bool wanted = false;
};
/// Changes the targets. Other colors or radii apply at once; with another number of targets, all
/// tracks start from scratch.
struct SetTargets {
  std::vector<Target> targets;
};
/// Changes the calibration of the same cameras from the next iteration on; tracks continue. A rig
/// with other image sizes or another number of cameras needs a new run and is ignored.
struct SetCameras {
  CameraRig rig;
};
/// Other background images of the same cameras (loadBackgroundImages); what is believed stays.
struct SetBackgroundImages {
  std::vector<std::string> files; ///< as the project names them
  std::vector<cv::Mat> rooms;
};
/// Changes or removes the volume of interest from the next iteration on. It limits the creation of
/// tracks from the next restart on.
struct SetVolumeOfInterest {
  std::optional<WorldBox> volume;
};
/// Turns masks on or off: the pixels that have the color of a target, or that move
/// (TrackSnapshot::masks).
struct ShowMasks {
  bool wanted = false;
};
/// Turns hulls and level curves of people on or off (TargetSnapshot::shape).
struct ShowShapes {
  bool wanted = false;
};
/// Sets the number of filter threads from the next iteration on (filterThreads()). It never changes
/// the result.
struct SetThreads {
  int threads = 0;
};
/// Sets the speed of playing. It never changes the result.
struct SetPace {
  Pace pace;
};
/// Reports that a calibration board is being shown to live cameras, or no longer is. Meanwhile no
/// camera is reported as moved (CameraMotionWatch::setResting()).
struct ShowBoard {
  bool shown = false;
};
/// Replaces all corrections of people; only methods for people use them. The run is tracked again
/// from the first frame whose result differs.
struct SetPeople {
  std::vector<PersonCorrection> people; ///< ordered by frame
};
/// Replaces all corrections of positions; methods that cannot apply them ignore them. The run is
/// tracked again from the first frame whose result differs.
struct SetCorrections {
  std::vector<PositionCorrection> corrections; ///< ordered by frame
};
} // namespace command

/// Any request to the tracking thread.
using Command =
    std::variant<command::Play, command::Pause, command::StepFrame, command::StepIteration,
                 command::Restart, command::Configure, command::SetMethod, command::SetTargets,
                 command::SetCameras, command::SetBackgroundImages, command::ShowMasks,
                 command::ShowFrame, command::BackToHead, command::Rerun, command::ShowMaps,
                 command::ShowShapes, command::ShowBoard, command::SetPeople, command::SetThreads,
                 command::SetVolumeOfInterest, command::SetCorrections, command::SetPace>;

} // namespace dewpoint::session
