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

/// A target of a clip, and the click or box that its color is learned from, and its radius where
/// that marks a part of something larger: `frame` counts instants.
struct ClipTarget {
  std::string name;
  ColorSample click;
};

/// Where a target truly is. World frame of the clip's rig, meters.
struct ClipPosition {
  std::int64_t instant = 0;
  std::size_t target = 0;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
};

/// Half of the side of the box in which the search starts, meters: that of the rendered scenarios
/// that start near the truth.
inline constexpr double kClipStartHalf = 0.1;
/// An estimate in pixels is on its target within this of all marks of a frame, unless the clip says
/// otherwise: about half the width of the bands of tapes2_limbs. Chosen, from 5 to 30.
inline constexpr double kClipMarkGatePx = 10.0;

/// A recording of calibrated cameras with a truth: everything that a run of it needs.
struct CalibratedClip {
  std::string name; ///< of the scenario
  CameraRig rig;
  std::vector<std::filesystem::path> cameras; ///< a video, or a folder of images, per camera
  std::vector<ClipInstant> instants;
  double framesPerSecond = 30.0;
  std::vector<ClipTarget> targets;
  std::vector<ClipPosition> positions; ///< may be empty: then the marks are the truth
  /// `frame` counts instants. Empty: the projections of the positions.
  std::vector<MarkedCenter> marks;
  double markGate = kClipMarkGatePx;
  /// Where each target is at first, meters, for the start of the search; the first of `positions`
  /// unless given.
  std::vector<Eigen::Vector3d> starts;
  double startHalf = kClipStartHalf; ///< around the starts, meters; larger where they are uncertain
};

/// A run of a clip, of grade `Real`. The color of each target is learned from its one click. The
/// search starts in a box around the targets' first positions, shifted by up to half of
/// `startHalf` per axis as the seed draws it: seeds differ in that, and in the methods' own random
/// numbers. The files are opened here; Mismatch when images and calibration are of other sizes.
Result<ScenarioRun> clipRun(const CalibratedClip& clip, std::uint64_t seed);

/// Where the rays through a target's marks at one instant meet (nearestPoint()), in meters; nothing
/// with fewer than two marks, or when they do not meet in front of the cameras.
std::optional<Eigen::Vector3d> positionOfMarks(const CameraRig& rig,
                                               const std::vector<MarkedCenter>& marks,
                                               std::int64_t instant, std::size_t target);

} // namespace dewpoint::experiment
