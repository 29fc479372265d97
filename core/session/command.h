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
struct Play {};
struct Pause {};
/// The next frame with all its iterations, then pause.
struct StepFrame {};
/// One filter iteration on the frame that the run stands at, then pause.
struct StepIteration {};
/// From the first frame, knowing nothing.
struct Restart {
  std::optional<std::uint64_t> seed; ///< the same as before unless given
};
/// Other parameters of the same method.
struct Configure {
  ParameterValues parameters;
};
/// Another method, with the same seed. When it begins at a frame, what was tracked before it stays.
struct SetMethod {
  std::string method;
  ParameterValues parameters;
  std::optional<std::int64_t> from; ///< nothing: from the start
};
/// Pauses and shows an earlier frame as it was (or a later one of a recording, untracked); the run
/// itself stays where it is. Playing goes on from the frame shown: through what was recorded up to
/// where the run stands, then tracking.
struct ShowFrame {
  std::int64_t frame = 0;
};
/// Shows where the run stands again.
struct BackToHead {};
/// Tracks again from this frame on, as fast as it goes, up to where the run stood: with the
/// parameters, colors and empty rooms of now. What was recorded from there on is replaced. Pausing
/// stops it.
struct Rerun {
  std::int64_t from = 0;
  /// The frame that is shown stays shown: of the frames that are tracked meanwhile none is
  /// published, unless it takes longer than a moment.
  bool keepsView = false;
};
/// Likelihood maps (TargetSnapshot::maps).
struct ShowMaps {
  bool wanted = false;
};
/// Other colors or radii take effect at once; another number of targets means new beliefs.
struct SetTargets {
  std::vector<Target> targets;
};
/// Another calibration of the same cameras, from the next iteration on; what is believed stays. A
/// rig with other image sizes, or another number of cameras, is ignored: that is another run.
struct SetCameras {
  CameraRig rig;
};
/// Other empty rooms of the same cameras (loadEmptyRooms); what is believed stays.
struct SetEmptyRooms {
  std::vector<std::string> files; ///< as the project names them
  std::vector<cv::Mat> rooms;
};
/// Another volume of interest, or none, from the next iteration on; tracks begin in it from the
/// next restart on.
struct SetVolumeOfInterest {
  std::optional<WorldBox> volume;
};
/// Which pixels have a target's color, or move (TrackSnapshot::masks).
struct ShowMasks {
  bool wanted = false;
};
/// Hulls and level curves of persons (TargetSnapshot::shape).
struct ShowShapes {
  bool wanted = false;
};
/// The number of threads that share the work of the filter from the next iteration on
/// (filterThreads()); it never changes the result.
struct SetThreads {
  int threads = 0;
};
/// How fast what plays goes on; it never changes the result.
struct SetPace {
  Pace pace;
};
/// A calibration board is shown to live cameras from now on, or no more: meanwhile no camera is
/// taken for moved (CameraMotionWatch::setResting()).
struct ShowBoard {
  bool shown = false;
};
/// The corrections of people, instead of all before; only methods for people listen. The run is
/// tracked again from the first frame for which it is otherwise.
struct SetPeople {
  std::vector<PersonCorrection> people; ///< in the order of their frames
};
/// The corrections of positions, instead of all before; methods that cannot apply them go on
/// without. The run is tracked again from the first frame for which it is otherwise.
struct SetCorrections {
  std::vector<PositionCorrection> corrections; ///< in the order of their frames
};
} // namespace command

using Command =
    std::variant<command::Play, command::Pause, command::StepFrame, command::StepIteration,
                 command::Restart, command::Configure, command::SetMethod, command::SetTargets,
                 command::SetCameras, command::SetEmptyRooms, command::ShowMasks,
                 command::ShowFrame, command::BackToHead, command::Rerun, command::ShowMaps,
                 command::ShowShapes, command::ShowBoard, command::SetPeople, command::SetThreads,
                 command::SetVolumeOfInterest, command::SetCorrections, command::SetPace>;

} // namespace dewpoint::session
