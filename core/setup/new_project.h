// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"

#include <opencv2/core/types.hpp>

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace dewpoint::setup {

/// Assumed size of the images, pixels, of a camera that does not report it before it is opened.
/// Origin not recorded.
inline constexpr int kGuessedWidth = 640;
inline constexpr int kGuessedHeight = 480;

/// A camera as the user names it before there is a project.
struct NewCamera {
  std::string name; ///< empty: as its file is called
  SourceKind source = SourceKind::Video;
  std::string location; ///< video, image folder, device or address
};

/// What a project is made of.
struct NewProject {
  std::string name; ///< empty: as the folder of its first recording is called
  std::vector<NewCamera> cameras;
  std::optional<std::filesystem::path> calibration;
  double framesPerSecond = 0.0; ///< for image folders; 0: 30
};

/// A project, and notes about it.
struct MadeProject {
  Project project; ///< without file and without targets: their colors are still to be learned
  /// The poses are a guess, and the method needs them: positions in space mean nothing yet.
  bool lacksCalibration = false;
  bool matchedByOrder = false; ///< the calibration file's names fit no camera; its order was used
};

/// Makes a project of videos, image folders, devices or streams. Calibrations are matched by name,
/// else by order when there is one for each camera. Without a file, cameras are guessed: 53 degrees
/// wide, in a ring around a box of 1 m; a single one without a file is for a method that needs no
/// calibration. FileMissing, Mismatch, BadValue and what the calibration
/// file says.
Result<MadeProject> makeProject(const NewProject& wanted);

/// The project with the calibration of its cameras taken from a file, matched as by makeProject().
Result<MadeProject> withCalibration(Project project, const std::filesystem::path& file);

/// The same from cameras that were read from this file.
Result<MadeProject> withCalibration(Project project, const CameraRig& rig, const std::string& file);

/// Gives every camera whose image size is not known yet (it came without a calibration, see
/// loadProject()) the size of its images and a guessed pose. As makeProject() where it fails.
Status guessMissing(Project& project);

/// Whether some camera stands where makeProject() guessed it: positions in space mean nothing.
bool isGuessed(const Project& project);
/// The same of one camera.
bool isGuessed(const Project& project, std::size_t camera);
/// Guesses a camera again, for images of this size in pixels: of a live one it is known only once
/// it sends some.
void guessForSize(Project& project, std::size_t camera, const cv::Size& size);

/// The file that a project which is in none yet is best saved to: called as the project, beside its
/// first recording; without a folder when no camera is a recording.
std::filesystem::path proposedFile(const Project& project);

/// How a file given without more is meant: a folder is one of images, a number or /dev/... a
/// device, text with "://" or "gst:" a stream, all else a video.
SourceKind guessedSource(const std::string& location);

} // namespace dewpoint::setup
