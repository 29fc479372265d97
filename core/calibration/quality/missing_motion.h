// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/wand/wand_calibration.h"

#include <cstddef>
#include <string>
#include <vector>

namespace dewpoint::calibration {

/// Kinds of motion that a recording of a wand may lack.
enum class MissingMotion {
  LongEnough,  ///< the recording is short
  OffTheLine,  ///< the ball moved only along a line
  OffThePlane, ///< the ball moved only within a plane
  InDepth,     ///< the ball was always about as far from a camera
  WholeVolume, ///< the ball stayed in a small part of the volume that the cameras see together
  WholeImage,  ///< a camera saw the ball only in a small part of its image
  SeenTogether ///< two cameras rarely saw the ball at the same time
};

/// Part of an image.
enum class ImageSide { Edges, Left, Right, Top, Bottom };

/// Motion that a recording lacks.
struct MotionGap {
  MissingMotion missing = MissingMotion::LongEnough;
  /// InDepth and WholeImage: the camera. OffThePlane: the camera that looks most nearly across the
  /// plane. SeenTogether: the two cameras. Otherwise empty.
  std::vector<std::size_t> cameras = {};
  /// Number that describes what there was. LongEnough: seconds. OffTheLine, OffThePlane: the extent
  /// across the line or the plane, meters. InDepth: the range of distances, meters. WholeVolume,
  /// WholeImage: share of the volume or of the image. SeenTogether: number of instants.
  double value = 0.0;
  ImageSide side = ImageSide::Edges; ///< WholeImage: where the ball was not seen
  double severity = 0.0; ///< 0 to 1: how much is missing; 1: there was no such motion at all
};

/// Returns the kinds of motion that the recording of a wand lacks, the most severe first, at most
/// two. Empty if there was enough of all.
///
/// The positions of the ball are compared with the volume that the cameras see together
/// (commonView()), along their principal axes; the image points are compared with the parts of the
/// images in which that volume lies (6 x 4 regions), and the numbers of instants at which two
/// cameras saw the ball with those at which they could have seen it. All limits are relative to the
/// rig, so that they hold for a desk as well as for a hall.
std::vector<MotionGap> missingMotion(const WandResult& result);

/// Returns one or two sentences: what is missing, and what to do. They refer to cameras by name.
std::string motionGapText(const MotionGap& gap, const CameraRig& rig);

} // namespace dewpoint::calibration
