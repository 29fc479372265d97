// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/formats/calibration_format.h"

#include <string>
#include <vector>

namespace dewpoint::calibration {

/// How a calibration is written.
struct CalibrationTarget {
  std::filesystem::path path; ///< a file, or a folder for formats with a file per camera
  std::string format;         ///< name; guessed from the ending where only one format has it
  std::optional<double> unit; ///< meters in one unit, for formats that leave it open
  bool replace = false;       ///< overwrite files that exist
};

/// What a conversion did to one camera.
struct CameraDifference {
  std::string camera;
  bool refitted = false;      ///< the lens was fitted again, the format has no such coefficients
  double largestPixels = 0.0; ///< greatest distance between the pixels of the same point
  int lostDirections = 0;     ///< of the 9 x 9, those that the written camera does not see
};

/// What a conversion decided and how much it changed.
struct CalibrationConversion {
  std::string from; ///< names of formats
  std::string to;
  std::vector<std::string> decisions; ///< whole sentences, of reading and of writing
  std::vector<CameraDifference> cameras;
  double largestPixels = 0.0;
  std::vector<std::filesystem::path> written;
};

/// The greatest distance, in pixels, between the images of the same points: 9 x 9 pixels over the
/// image, at 0.3, 1, 3 and 10 m before the camera. `otherFromWorld` leads from the world of
/// `camera` to that of `other`.
CameraDifference difference(const Camera& camera, const Camera& other,
                            const Eigen::Isometry3d& otherFromWorld);

/// Writes a rig (meters) in a format: refits lenses it cannot hold, makes the first camera the
/// world where it has none; then reads the files again and compares every camera with the original.
Result<CalibrationConversion> writeCalibration(const CameraRig& rig,
                                               const CalibrationTarget& target);

/// readCalibration(), then writeCalibration().
Result<CalibrationConversion> convertCalibration(const std::filesystem::path& in,
                                                 const CalibrationHints& hints,
                                                 const CalibrationTarget& target);

} // namespace dewpoint::calibration
