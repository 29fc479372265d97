// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/color/color_sample.h"
#include "core/experiment/clips/clip_frames.h"
#include "core/experiment/scenarios/scenario.h"

#include <Eigen/Core>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace dewpoint::experiment {

/// Target of a clip, with the click or box from which its color is learned. If the sample marks
/// only a part of a larger object, it also contains the radius. The `frame` field of the sample is
/// the index of an instant.
struct ClipTarget {
  std::string name;
  ColorSample click;
};

/// True position of a target. World frame of the clip's rig, meters.
struct ClipPosition {
  std::int64_t instant = 0;
  std::size_t target = 0;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
};

/// Half the side length of the box in which the search starts, meters. The same value is used in
/// rendered scenarios that start near the truth.
inline constexpr double kClipStartHalfSize = 0.1;
/// Largest distance (pixels) from all marks of a frame at which an estimate counts as on its
/// target, unless the clip sets another value. It is about half the width of the bands in
/// tapes2_limbs. Chosen from the range 5 to 30.
inline constexpr double kClipMarkGatePx = 10.0;

/// Recording of calibrated cameras with ground truth, and everything that a run on it needs.
struct CalibratedClip {
  std::string name; ///< name of the scenario
  CameraRig rig;
  std::vector<std::filesystem::path> cameras; ///< a video or a folder of images per camera
  std::vector<ClipInstant> instants;
  double framesPerSecond = 30.0;
  std::vector<ClipTarget> targets;
  std::vector<ClipPosition> positions; ///< may be empty; then the marks are the truth
  /// Marked centers. `frame` is the index of an instant. If empty, the marks are the projections of
  /// the positions.
  std::vector<MarkedCenter> marks;
  double markGate = kClipMarkGatePx;
  /// Position of each target at which the search starts, meters. If not given, it is the first
  /// entry in `positions`.
  std::vector<Eigen::Vector3d> starts;
  /// Half the side length of the boxes around the starts, meters. Larger if the starts are
  /// uncertain.
  double startHalfSize = kClipStartHalfSize;
};

/// Creates a run of a clip, with grade `Real`. The color of each target is learned from its one
/// click. The search starts in a box around the targets' first positions, shifted by up to half of
/// `startHalfSize` per axis. The seed determines this shift and the random numbers of the methods.
/// The files are opened here. Mismatch if images and calibration have different sizes.
Result<ScenarioRun> clipRun(const CalibratedClip& clip, std::uint64_t seed);

/// Returns the point (world, meters) where the rays through a target's marks at one instant meet
/// (nearestPoint()). Nothing for fewer than two marks, or if the rays do not meet in front of the
/// cameras.
std::optional<Eigen::Vector3d> positionOfMarks(const CameraRig& rig,
                                               const std::vector<MarkedCenter>& marks,
                                               std::int64_t instant, std::size_t target);

} // namespace dewpoint::experiment
