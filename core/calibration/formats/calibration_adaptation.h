// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/geometry/camera.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace dewpoint::calibration {

/// How images differ from those that a camera was calibrated with, when their size differs.
enum class SizeFit {
  Crop,      ///< equal margins were cut off, or added, on opposite sides
  Trim,      ///< rows below and columns at the right were cut off, or added (1088 rows are 1080)
  Scale,     ///< the whole image was resampled to another size
  Rotate90,  ///< the image was rotated clockwise
  Rotate270, ///< the image was rotated counterclockwise
};

/// Names of cameras in a file, by the names that they get.
using CameraRenaming = std::map<std::string, std::string>;

/// What the user says about a calibration that does not fit.
struct CalibrationAdaptation {
  CameraRenaming names;
  std::optional<SizeFit> fit; ///< for cameras whose images have another size
};

/// Returns the value of a name on the command line: crop, trim, scale, rotate-90 or rotate-270.
std::optional<SizeFit> parseSizeFit(const std::string& text);

/// Returns the camera for images of `width` x `height` pixels that differ from the calibrated ones
/// as `fit` says. Every world point moves with its pixel: a rotation also changes the pose. Pixel
/// centers are at integer coordinates, so that scaling by s maps column u to s (u + 1/2) - 1/2.
/// Mismatch if a rotated image would have another size, or if the principal point would be outside
/// the image.
Result<Camera> fittedToSize(const Camera& camera, int width, int height, SizeFit fit);

/// Returns a sentence like "left: cropped from 1920 x 1088 to 1920 x 1080 pixels.".
std::string sizeFitSentence(const Camera& before, const Camera& after, SizeFit fit);

/// Parses texts like "left=camera 1", where `left` is the name that the file's "camera 1" gets.
/// Errors name --map.
Result<CameraRenaming> parseCameraRenaming(const std::vector<std::string>& texts);

/// Gives the cameras read from `file` their new names; the others keep theirs. NotFound lists the
/// names in the file if one of them is missing there; BadValue if two cameras would have one name.
Status renameCameras(CameraRig& rig, const CameraRenaming& names, const std::string& file);

/// Returns the names in quotes, separated by commas.
std::string quotedNames(const std::vector<std::string>& names);
std::string quotedNames(const CameraRig& rig);

} // namespace dewpoint::calibration
