// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/capture/device_settings.h"
#include "core/project/project.h"

#include <opencv2/core/types.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace dewpoint::setup {

// Changes to the set of cameras of a project. None of them opens a source, except
// examinedSource().

/// A source of images for a camera of a project.
struct CameraSource {
  std::string name; ///< name for a new camera; empty: the name of the file, or "camera 2"
  SourceKind kind = SourceKind::Video;
  std::string location; ///< absolute path of a recording, device, or address
  cv::Size size = {};   ///< size of its images, pixels; empty if it is not known
  /// Identity and settings of a device; empty for other sources.
  capture::DeviceSettings device = {};
};

/// Returns whether images of this kind come from recordings: videos and image folders.
bool comesFromRecording(SourceKind kind);

/// Returns a location as it is shown: without passwords.
std::string shownLocation(const std::string& location);

/// Returns the source at a location. The first image of a recording is read, which may take long;
/// live sources are not opened. Errors: BadValue if the location is empty or of no known type,
/// FileMissing, FileUnreadable.
Result<CameraSource> examinedSource(const std::string& location, const std::string& name = {});

/// Returns whether sources of this kind can be added to a project: all its cameras must be
/// recordings, or all live. Error: Mismatch with a sentence; BadValue for a simulated scene, which
/// has its own cameras.
Status checkCanAdd(const Project& project, SourceKind kind);

/// Adds cameras. Each gets a name that no other camera has, and a guessed calibration, as in
/// createNewProject(). If the other cameras of a recording have tables of times, it needs one, too.
/// Errors: those of checkCanAdd(). Nothing has changed then.
Status addCameras(Project& project, const std::vector<CameraSource>& sources);

/// Gives a camera another source; it keeps its name and calibration. If another camera has this
/// source, the two cameras exchange their sources. A device of the same model gets the format and
/// the controls of the one before. A table of times belongs to its recording. A calibration that
/// was only guessed is guessed again for the new image size. Errors: Mismatch if the kinds of the
/// sources differ (checkCanAdd(); the only camera of a project may get any source), or if the
/// images of a recording do not have the size that the camera is calibrated for.
Status replaceSource(Project& project, std::size_t camera, const CameraSource& source);

/// Makes two cameras exchange their sources, for example after their cables were exchanged.
void exchangeSources(Project& project, std::size_t one, std::size_t other);

/// Removes a camera, as project::removeCamera() does. Calibrations that were only guessed are
/// guessed again, because the guess depends on the number of cameras. Error: MissingKey if it is
/// the only camera.
Status removeProjectCamera(Project& project, std::size_t camera);

} // namespace dewpoint::setup
