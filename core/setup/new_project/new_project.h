// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/formats/calibration_adaptation.h"
#include "core/camera_motion/agreement/camera_disagreement.h"
#include "core/project/project.h"

#include <opencv2/core/types.hpp>

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace dewpoint::setup {

/// Image size, in pixels, that is assumed for a camera whose size is not known until the camera is
/// opened. The origin of the values is not recorded.
inline constexpr int kAssumedImageWidth = 640;
inline constexpr int kAssumedImageHeight = 480;

/// A camera named by the user for a new project.
struct NewCamera {
  std::string name; ///< name of the camera; empty: name of its file
  SourceKind sourceKind = SourceKind::Video;
  std::string location; ///< video, image folder, device or address
};

/// Inputs of a new project.
struct NewProject {
  std::string name; ///< name of the project; empty: name of the folder of its first recording
  std::vector<NewCamera> cameras;
  std::optional<std::filesystem::path> calibrationFile;
  double framesPerSecond = 0.0; ///< frame rate for image folders; 0 means 30
  /// Adaptation of a calibration that has other camera names or image sizes.
  CalibrationAdaptation adaptation = {};
};

/// A new project, and notes about it.
struct CreatedProject {
  Project project; ///< project without a file and without targets; the user adds targets later
  /// True if the poses are guessed but the method needs calibrated ones, so that positions in space
  /// are not meaningful yet.
  bool lacksCalibration = false;
  /// True if the names in the calibration file match no camera, so that cameras were matched by
  /// order.
  bool wereCamerasMatchedByOrder = false;
  /// Full sentences about calibrations that were fitted to the size of the images.
  std::vector<std::string> decisions = {};
  /// Likely mistakes in the calibration file: two cameras with the same pose (checkRig()).
  std::vector<camera_motion::CameraDisagreement> likelyMistakes = {};
};

/// Creates a project from videos, image folders, devices or streams. The calibrations in a file are
/// matched to the cameras by name, or by order if there is one for each camera. Without a
/// calibration file, each camera is assumed to have a horizontal field of view of 53 degrees. All
/// cameras are assumed to stand in a ring around a box with sides of 1 m. A single camera without a
/// calibration file gets a method that needs no calibration. Returns FileMissing, Mismatch,
/// BadValue and the errors of the calibration file.
Result<CreatedProject> createNewProject(const NewProject& wanted);

/// Returns the project with the calibration of its cameras from a file, matched as in
/// createNewProject(). Returns Mismatch if the calibration is for another image size than that of a
/// recording, unless `adaptation` describes how the sizes differ (fitCalibration()).
Result<CreatedProject> withCalibration(Project project, const std::filesystem::path& file,
                                       const CalibrationAdaptation& adaptation = {});

/// Returns the project with the calibration of the cameras in `rig`. The calibrations were read
/// from `file` and already have the names of the project's cameras. Returns Mismatch if a
/// calibration is for another image size than that of a recording, unless `fit` describes how the
/// sizes differ.
Result<CreatedProject> withCalibration(Project project, const CameraRig& rig,
                                       const std::string& file,
                                       const std::optional<SizeFit>& fit = {});

/// Sets the image size and a guessed pose for every camera with unknown image size (without a
/// calibration, see loadProject()). Returns the errors of createNewProject().
Status guessMissingCameras(Project& project);

/// Returns whether at least one camera has the pose guessed by createNewProject(), so that
/// positions in space are not meaningful.
bool hasGuessedPose(const Project& project);
/// Returns whether one camera has the pose guessed by createNewProject().
bool hasGuessedPose(const Project& project, std::size_t camera);
/// Returns whether the intrinsics of a camera are those guessed by createNewProject().
bool hasGuessedLens(const Project& project, std::size_t camera);
/// Guesses the calibration of a camera again, for images of this size in pixels. This is needed for
/// live cameras, because their image size is known only after the first image.
void guessCalibration(Project& project, std::size_t camera, const cv::Size& size);

/// Returns the proposed file for a project that was not saved yet: named after the project, next to
/// its first recording; without a folder if no camera is a recording.
std::filesystem::path proposedProjectFile(const Project& project);

/// Returns the kind of an image source, determined from its location alone. A folder is an image
/// folder. A number or a path that begins with /dev/ is a device. A text that begins with "gst:" or
/// contains "://" is a stream. Anything else is a video.
SourceKind guessSourceKind(const std::string& location);

} // namespace dewpoint::setup
