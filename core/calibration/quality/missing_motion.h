// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/wand/wand_calibration.h"

#include <cstddef>
#include <string>
#include <vector>

namespace dewpoint::calibration {

/// Kinds of motion that a recording of a wand may lack.
enum class MissingMotion {
  Duration,    ///< the ball was seen for too short a time
  OffTheLine,  ///< the ball moved only along a line
  OffThePlane, ///< the ball moved only within a plane
  InDepth,     ///< the distance from a camera to the ball hardly changed
  WholeVolume, ///< the ball stayed in a small part of the volume that the cameras see together
  WholeImage,  ///< a camera saw the ball only in a small part of its image
  SeenTogether ///< two cameras rarely saw the ball at the same time
};

/// Part of an image. `Edges` means all four sides.
enum class ImageSide { Edges, Left, Right, Top, Bottom };

/// Kind of motion that a recording lacks.
struct MotionGap {
  MissingMotion missingMotion = MissingMotion::Duration;
  /// Indices in the rig. InDepth and WholeImage: the camera. OffThePlane: the camera whose optical
  /// axis is closest to the normal of the plane. SeenTogether: the two cameras. Otherwise empty.
  std::vector<std::size_t> cameras = {};
  /// Amount of this motion in the recording. Duration: time from the first to the last sight of
  /// the ball, seconds. OffTheLine and OffThePlane: extent of the ball's positions across the line
  /// or the plane, meters. InDepth: range of the distances, meters. WholeVolume and WholeImage:
  /// fraction of the volume or of the image, 0 to 1. SeenTogether: number of frames.
  double motionAmount = 0.0;
  ImageSide side = ImageSide::Edges; ///< WholeImage: side at which the ball was not seen
  /// Fraction of the required minimum motion that is missing, 0 to 1; 1 if there was no such
  /// motion.
  double severity = 0.0;
};

/// Returns the kinds of motion that the recording of a wand lacks: at most two, the most severe
/// first. Empty if there was enough motion of each kind, and also if the result has fewer than two
/// cameras or fewer than four positions of the ball.
///
/// The extents of the ball's positions along their principal axes are compared with the distance to
/// the cameras, and with the volume that the cameras see together (findCommonView()). Each camera's
/// image is divided into 6 x 4 regions. The regions in which the ball was seen are compared with
/// the regions that show the common volume. For two cameras that share much of their views, two
/// numbers of frames are compared: those in which both cameras saw the ball, and those in which the
/// camera with fewer sightings saw the ball. All limits of lengths are relative to the size of the
/// rig, so they suit a desk as well as a hall.
std::vector<MotionGap> findMissingMotion(const WandResult& result);

/// Returns one or two sentences that say what is missing and what to do. `rig` contains the names
/// of the cameras.
std::string motionGapText(const MotionGap& gap, const CameraRig& rig);

} // namespace dewpoint::calibration
