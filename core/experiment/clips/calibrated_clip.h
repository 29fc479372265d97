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

/// Target of a clip (recording with ground truth), with the click or box from which its color is
/// learned. If `click` marks only a part of a larger object, `click` also contains the radius of
/// this part. ColorSample::frame is an index into CalibratedClip::instants.
struct ClipTarget {
  std::string name;
  ColorSample click;
};

/// True position of a target at one instant (an index into CalibratedClip::instants). World frame
/// of the clip's rig, meters.
struct ClipPosition {
  std::int64_t instant = 0;
  std::size_t target = 0;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
};

/// Default half side length of the box in which the search starts, in meters. Rendered scenarios
/// that start near the truth use the same value.
inline constexpr double kClipStartHalfSize = 0.1;
/// Default limit for the distance between a projected estimate and the marked target center,
/// pixels; see CalibratedClip::markGatePx. Chosen from the range of 5 to 30 pixels: it is about
/// half the width of the colored bands that are tracked in the clip tapes2_limbs.
inline constexpr double kClipMarkGatePx = 10.0;

/// Recording of calibrated cameras with ground truth, and everything that a run on it needs.
struct CalibratedClip {
  std::string name; ///< name of the scenario
  CameraRig rig;
  std::vector<std::filesystem::path> cameraPaths; ///< one video or one folder of images per camera
  std::vector<ClipInstant> instants;
  double framesPerSecond = 30.0;
  std::vector<ClipTarget> targets;
  std::vector<ClipPosition> positions; ///< true positions; if empty, `markedCenters` is the truth
  /// Target centers marked in the images. The field `frame` of each mark is an index into
  /// `instants`. If empty, the projections of `positions` are used as marks.
  std::vector<MarkedCenter> markedCenters;
  /// Limit, in pixels, for the distance between the projection of an estimate and each mark of its
  /// target, below which the estimate counts as being on the target.
  double markGatePx = kClipMarkGatePx;
  /// Initial position of each target, near which the search starts (world, meters). If empty, the
  /// first entry of each target in `positions` is used.
  std::vector<Eigen::Vector3d> startPositions;
  /// Margin, in meters, by which the box in which the search starts extends beyond the initial
  /// positions of all targets. Clips with uncertain initial positions have a larger margin.
  double startMargin = kClipStartHalfSize;
};

/// Creates a run of a recorded clip; its grade (level of realism) is `Real`. The color of each
/// target is learned from its one click. The search starts in a box around the initial positions of
/// the targets. This box is shifted by up to half of `startMargin` along each axis. The seed
/// determines this shift and the random numbers of the methods. The function opens the files of the
/// clip. Returns Mismatch if images and calibration have different sizes.
Result<ScenarioRun> makeClipRun(const CalibratedClip& clip, std::uint64_t seed);

/// Returns the point (world, meters) where the rays through the marked centers of a target at one
/// instant meet (nearestPoint()). Returns nothing for fewer than two marks, or if the rays do not
/// meet in front of the cameras.
std::optional<Eigen::Vector3d> triangulateMarks(const CameraRig& rig,
                                                const std::vector<MarkedCenter>& marks,
                                                std::int64_t instant, std::size_t target);

} // namespace dewpoint::experiment
