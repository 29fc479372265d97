// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/manual/measured_points.h"
#include "core/capture/device_settings.h"
#include "core/geometry/camera.h"
#include "core/geometry/image_margins.h"
#include "core/geometry/reference_grid.h"
#include "core/geometry/world_box.h"
#include "core/project/calibration_record.h"
#include "core/project/output_settings.h"
#include "core/tracking/catalog/method_catalog.h"
#include "core/tracking/parameters.h"
#include "core/tracking/target.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace dewpoint::project {

/// Kind of image source for a camera.
enum class SourceKind { Simulation, Video, Images, Device, Stream };

/// A camera in a project: its image source and its calibration.
struct ProjectCamera {
  Camera camera;
  SourceKind source = SourceKind::Simulation;
  std::string location;  ///< absolute path of a video or image folder, device, or address
  int rotateDegrees = 0; ///< clockwise rotation of the images before use: 0, 90, 180 or 270 degrees
  bool isMirrored = false; ///< images are mirrored left to right after the rotation
  /// For a simulated camera: true if the project contains a calibration of this camera. It is then
  /// used instead of the calibration in the scene.
  bool hasOwnCalibration = false;
  /// Absolute path of an image, video or image folder that shows the scene without any target. The
  /// file contains images as the camera sends them; `rotateDegrees`, `isMirrored` and `crop` are
  /// applied when it is read. Empty if there is none.
  std::string backgroundImageFile = {};
  /// Absolute path of a table with the capture time of each image (recordings only). Empty if the
  /// images were taken at regular intervals.
  std::string captureTimeFile = {};
  /// Image delay in seconds: each image was captured this long before its time stamp. For each
  /// frame of a recording, the image whose capture time is closest to the time of the frame is
  /// used. Methods that can use capture times correct for the remaining difference.
  double delay = 0.0;
  /// Identity, format and controls of the device (`source` is Device only).
  DeviceSettings device = {};
  /// How the camera was calibrated, and how accurate the calibration is, as far as this is known.
  CameraRecord calibrationRecord = {};
  /// Margins cut off from the images after rotation and mirroring. The calibration is that of the
  /// cropped images.
  ImageMargins crop = {};

  /// Sets `hasOwnCalibration` if the camera is simulated. Call this function after changing the
  /// calibration of the camera in the project.
  void markCalibrationChanged() {
    hasOwnCalibration = hasOwnCalibration || source == SourceKind::Simulation;
  }

  /// Returns whether the images come from a live camera, not from a recording or a simulation.
  bool isLive() const { return source == SourceKind::Device || source == SourceKind::Stream; }

  bool operator==(const ProjectCamera&) const = default;
};

/// A marker: a frame in the recording that the user has named.
struct ProjectMarker {
  std::int64_t frame = 0;
  std::string name;

  bool operator==(const ProjectMarker&) const = default;
};

/// Correction made by the user for methods that find people automatically. It marks a person at a
/// position or at a pixel, or reports that a tracked person does not exist.
struct PersonCorrection {
  /// Click on a person in the image of one camera.
  struct Click {
    /// Index of the camera in Project::cameras.
    int camera = 0;
    Eigen::Vector2d pixel = Eigen::Vector2d::Zero();

    bool operator==(const Click&) const = default;
  };

  std::int64_t frame = 0; ///< the correction takes effect at the end of this frame
  /// Position on the floor: world x and y, in meters. Either `position` or `click` is set.
  std::optional<Eigen::Vector2d> position = {};
  std::optional<Click> click = {};
  /// False if the person tracked at `position` does not exist. Requires `position`.
  bool isPresent = true;

  bool operator==(const PersonCorrection&) const = default;
};

/// Correction of a target's position in one frame of a recording. World frame, meters.
struct PositionCorrection {
  std::int64_t frame = 0; ///< the correction takes effect at the end of this frame
  int target = 0;         ///< index in Project::targets
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity(); ///< position covariance (m²)
  /// Clicks on the target in the images for this frame, from which the position was computed. There
  /// is at most one click per camera.
  std::vector<PointClick> clicks = {};
  /// If this correction was obtained by tracking backward in time: frame of the user's correction
  /// where the backward tracking started. Empty if the user made this correction.
  std::optional<std::int64_t> trackedFrom = std::nullopt;

  bool operator==(const PositionCorrection&) const = default;
};

/// A project: all inputs of a run, but none of its results.
struct Project {
  /// File that the project was loaded from; empty for the built-in demo.
  std::filesystem::path file;
  std::string name;
  std::string method{defaultMethod()};
  std::uint64_t seed = 1;
  /// Frame rate of image folders; 0: rate of the source, or 30 if the source has none.
  double framesPerSecond = 0.0;
  ParameterValues parameters;
  std::vector<Target> targets;
  std::vector<ProjectCamera> cameras;
  /// Absolute path of truth.csv, the true positions.
  std::optional<std::filesystem::path> truthFile;
  std::string scene; ///< name or file of the simulated scene; empty if there is none
  std::vector<ProjectMarker> markers; ///< markers in the recording, ordered by frame
  /// Grid drawn over the images while cameras are adjusted by hand.
  std::optional<ReferenceGrid> grid;
  /// Points measured in the room and clicked in the images.
  std::vector<MeasuredPoint> measuredPoints;
  /// Volume in which targets are searched for; empty: everywhere.
  std::optional<WorldBox> volumeOfInterest;
  std::vector<PersonCorrection> personCorrections; ///< corrections for people, ordered by frame
  /// Corrections of target positions, ordered by frame.
  std::vector<PositionCorrection> corrections;
  /// Outputs that send results to other programs during a run; they do not affect the results.
  OutputSettings output;
  WorldRecord worldRecord;  ///< how floor and scale of the world frame were determined, if known
  std::string windowLayout; ///< view layout saved by the window; empty: default layout

  bool operator==(const Project&) const = default;
};

/// Returns the parameters used to track a project. Parameters that the user has not set are derived
/// from the volume that the cameras see, where possible.
ParameterValues effectiveParameters(const Project& project);

/// Inserts a correction after the existing corrections for the same frame.
void addPersonCorrection(Project& project, const PersonCorrection& person);
/// Inserts a correction after the other corrections for its frame, or replaces the correction for
/// the same target and frame. If the user made the new correction, also removes corrections that
/// were obtained by tracking backward and are no longer valid: those whose tracking started from
/// the replaced correction, and those whose tracking passed through the frame of the new
/// correction.
void addCorrection(Project& project, const PositionCorrection& correction);
/// Removes a target's correction in a frame, and all corrections tracked backward from it.
void removeCorrection(Project& project, std::int64_t frame, int target);
/// Removes the target with this index and its corrections.
void removeTarget(Project& project, std::size_t index);
/// Removes the camera with this index, and everything that was clicked or marked in its images:
/// clicks on points and corrected targets, color samples, first boxes of targets, and people marked
/// by a click. Colors, corrected positions and the calibration of the other cameras are not
/// changed.
void removeCamera(Project& project, std::size_t index);

} // namespace dewpoint::project
