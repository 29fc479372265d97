// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/formats/calibration_format.h"

#include <string>
#include <vector>

namespace dewpoint::calibration {

/// Where and how to write a calibration.
struct CalibrationTarget {
  std::filesystem::path path; ///< a file, or a folder for formats with one file per camera
  std::string format; ///< name of the format; derived from the extension if only one format has it
  std::optional<double> unit; ///< meters in one unit, for formats that do not define their unit
  bool replace = false;       ///< whether existing files are overwritten
};

/// Effect of a conversion on one camera.
struct CameraDifference {
  std::string camera;
  bool refitted =
      false; ///< whether the lens was fitted again because the format lacks some coefficients
  double largestPixels = 0.0; ///< largest distance between the pixels of the same point
  int lostDirections = 0; ///< number of the 9 x 9 directions that the written camera does not see
};

/// Decisions and accuracy of a conversion.
struct CalibrationConversion {
  std::string from;                   ///< name of the format that was read
  std::string to;                     ///< name of the format that was written
  std::vector<std::string> decisions; ///< full sentences about reading and writing
  std::vector<CameraDifference> cameras;
  double largestPixels = 0.0; ///< largest over all cameras
  std::vector<std::filesystem::path> written;
};

/// Largest distance, in pixels, between the projections of the same points: 9 x 9 pixels over the
/// image, at 0.3, 1, 3 and 10 m in front of the camera. `otherFromWorld` maps the world of `camera`
/// to that of `other`.
CameraDifference difference(const Camera& camera, const Camera& other,
                            const Eigen::Isometry3d& otherFromWorld);

/// Writes a rig (meters) in a format. Lens models that the format lacks are fitted again, and the
/// first camera defines the world if the format requires that. Then the files are read back and
/// every camera is compared with the original.
Result<CalibrationConversion> writeCalibration(const CameraRig& rig,
                                               const CalibrationTarget& target);

/// Calls readCalibration(), then writeCalibration().
Result<CalibrationConversion> convertCalibration(const std::filesystem::path& in,
                                                 const CalibrationHints& hints,
                                                 const CalibrationTarget& target);

} // namespace dewpoint::calibration
