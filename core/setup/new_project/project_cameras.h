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

// Functions that change the set of cameras of a project. Only sourceAt() opens an image
// source.

/// A source of images for a camera of a project.
struct CameraSource {
  /// Name for a new camera; empty: name of the file, or a name such as "camera 2".
  std::string name;
  SourceKind kind = SourceKind::Video;
  std::string location; ///< absolute path of a recording, device, or address
  cv::Size size = {};   ///< size of the images, pixels; empty if it is not known
  /// Identity and settings of a device; empty for other sources.
  capture::DeviceSettings device = {};
};

/// Returns whether a source of this kind is a recording: a video or an image folder.
bool comesFromRecording(SourceKind kind);

/// Returns a location without passwords, for display.
std::string shownLocation(const std::string& location);

/// Returns the source at a location. Reads the first image of a recording, which may take long.
/// Does not open live sources. Errors: BadValue if the location is empty or of an unknown type;
/// FileMissing; FileUnreadable.
Result<CameraSource> sourceAt(const std::string& location, const std::string& name = {});

/// Checks whether sources of this kind can be added to a project. The cameras of a project must be
/// either all recordings or all live. Errors: Mismatch if they would be mixed; BadValue if the
/// project has a simulated scene, which defines its own cameras.
Status checkCanAddCamera(const Project& project, SourceKind kind);

/// Adds cameras with these sources to a project. Each camera gets a unique name and a guessed
/// calibration, as in createNewProject(). If the recordings of the project have tables of capture
/// times, the user must also provide such tables for the new cameras. Errors: those of
/// checkCanAddCamera(). After an error, the project is unchanged.
Status addCameras(Project& project, const std::vector<CameraSource>& sources);

/// Replaces the source of a camera. The camera keeps its name and calibration. If another camera
/// already has this source, the two cameras exchange their sources (swapSources()). Otherwise,
/// the table of capture times is removed, a guessed calibration is guessed again for the new image
/// size, and a new device of the same model gets the format and controls of the previous one.
///
/// Errors: those of checkCanAddCamera(), unless the camera is the only one in the project; Mismatch
/// if the images of a recording do not have the size for which the camera is calibrated.
Status replaceSource(Project& project, std::size_t camera, const CameraSource& source);

/// Exchanges the sources of two cameras, for example after their cables were exchanged.
void swapSources(Project& project, std::size_t one, std::size_t other);

/// Removes a camera with project::removeCamera(). Guessed calibrations of the other cameras are
/// guessed again, because the guess depends on the number of cameras. Errors: MissingKey if the
/// camera is the only one; BadValue if the project has a simulated scene.
Status removeProjectCamera(Project& project, std::size_t camera);

} // namespace dewpoint::setup
