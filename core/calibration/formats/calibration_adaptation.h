// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/geometry/camera.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace dewpoint::calibration {

/// Relation of a camera's images to the images for which it was calibrated, if their sizes differ.
enum class SizeFit {
  Crop, ///< equal margins were cut off, or added, on opposite sides
  /// Rows at the bottom and columns at the right were cut off, or added (for example, 1088 rows cut
  /// to 1080).
  Trim,
  Scale,     ///< the whole image was resampled to another size
  Rotate90,  ///< the image was rotated clockwise
  Rotate270, ///< the image was rotated counterclockwise
};

/// Renaming of cameras: new name -> name in the file.
using CameraRenaming = std::map<std::string, std::string>;

/// Instructions of the user for a calibration whose camera names or image sizes do not fit.
struct CalibrationAdaptation {
  CameraRenaming cameraRenaming;
  /// How to adapt cameras to images of another size; empty: cameras are not adapted.
  std::optional<SizeFit> sizeFit;
};

/// Parses a value of the command line: crop, trim, scale, rotate-90 or rotate-270. Returns nothing
/// for any other text.
std::optional<SizeFit> parseSizeFit(const std::string& text);

/// Returns a calibrated camera adapted to images of `width` x `height` pixels. `fit` specifies how
/// these images were made from images of the calibrated size. Every world point is still projected
/// onto the same image content, so if the image was rotated, the pose is rotated, too. Pixel
/// centers are at integer coordinates, so scaling by s maps column u to s (u + 1/2) - 1/2. Error:
/// Mismatch if a rotated image would have another size, or if the principal point would be outside
/// the image.
Result<Camera> fittedToSize(const Camera& camera, int width, int height, SizeFit fit);

/// Returns a sentence such as "left: cropped from 1920 x 1088 to 1920 x 1080 pixels.".
std::string sizeFitSentence(const Camera& before, const Camera& after, SizeFit fit);

/// Parses texts such as "left=camera 1", where "left" is the new name of the camera that is called
/// "camera 1" in the file. Errors name --map.
Result<CameraRenaming> parseCameraRenaming(const std::vector<std::string>& texts);

/// Renames the cameras that were read from `file`. Cameras without a new name keep their names.
/// Errors: NotFound, which lists the names in the file, if the file does not contain one of the
/// cameras to rename; BadValue if two cameras would have the same name.
Status renameCameras(CameraRig& rig, const CameraRenaming& names, const std::string& file);

/// Returns the names in quotes, separated by commas.
std::string quotedNames(const std::vector<std::string>& names);
std::string quotedNames(const CameraRig& rig);

} // namespace dewpoint::calibration
