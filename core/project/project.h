// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/manual/measured_points.h"
#include "core/geometry/camera.h"
#include "core/geometry/reference_grid.h"
#include "core/geometry/world_box.h"
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

/// Kind of source that a camera takes its images from.
enum class SourceKind { Simulation, Video, Images, Device, Stream };

/// One camera of a project: the source of its images, and its calibration.
struct ProjectCamera {
  Camera camera;
  SourceKind source = SourceKind::Simulation;
  std::string location;  ///< absolute path of a video or image folder, device, or address
  int rotateDegrees = 0; ///< images are rotated clockwise by 0, 90, 180 or 270 degrees before use
  bool mirrored = false; ///< images are mirrored left to right after the rotation
  /// True if the calibration of a simulated camera is the project's own instead of the scene's.
  bool adjusted = false;
  /// Absolute path of an image, a video or a folder of images that show the scene without any
  /// target, not yet rotated; empty: there is none.
  std::string backgroundImage = {};
  /// Absolute path of a table that says when each of its images was taken (recordings); empty:
  /// they were taken evenly.
  std::string times = {};
  /// Delay of the images in seconds: they show what happened this long before their time. In a
  /// recording, the image nearest in time is used; methods that can use times correct for the rest.
  double delay = 0.0;

  /// Marks the calibration of a simulated camera as the project's own. Does nothing for other
  /// cameras.
  void markAdjusted() { adjusted = adjusted || source == SourceKind::Simulation; }

  bool operator==(const ProjectCamera&) const = default;
};

/// A marker: a frame of the recording with a name given by the user.
struct ProjectMarker {
  std::int64_t frame = 0;
  std::string name;

  bool operator==(const ProjectMarker&) const = default;
};

/// Correction made by the user for methods that find people automatically. It states that a person
/// stands at a position, that a person is seen at a pixel, or that no person is there.
struct PersonCorrection {
  /// Click on a person in the image of one camera.
  struct Click {
    /// Index of the camera in Project::cameras.
    int camera = 0;
    Eigen::Vector2d pixel = Eigen::Vector2d::Zero();

    bool operator==(const Click&) const = default;
  };

  std::int64_t frame = 0; ///< the correction holds from the end of this frame on
  /// Position on the floor: world x and y in meters. Either this or `click` is set.
  std::optional<Eigen::Vector2d> position = {};
  std::optional<Click> click = {};
  /// False if the person tracked at `position` does not exist. Requires `position`.
  bool present = true;

  bool operator==(const PersonCorrection&) const = default;
};

/// Correction of a target's position in one frame of a recording. World frame, meters.
struct PositionCorrection {
  std::int64_t frame = 0; ///< the correction holds from the end of this frame on
  int target = 0;         ///< index in Project::targets
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity(); ///< of the position, m²
  /// Clicks on the target from which the position was computed, in images of this frame; at most
  /// one per camera.
  std::vector<PointClick> clicks = {};
  /// Frame of the user's correction from which this one was found by tracking backward in time.
  /// Empty if the user made this correction.
  std::optional<std::int64_t> trackedFrom = std::nullopt;

  bool operator==(const PositionCorrection&) const = default;
};

/// A project: everything that a run needs, and none of its results.
struct Project {
  std::filesystem::path file; ///< file it was loaded from; empty for the built-in demo
  std::string name;
  std::string method{defaultMethod()};
  std::uint64_t seed = 1;
  double framesPerSecond = 0.0; ///< frame rate of image folders; 0: rate of the source, or 30
  ParameterValues parameters;
  std::vector<Target> targets;
  std::vector<ProjectCamera> cameras;
  std::optional<std::filesystem::path> truth; ///< absolute path of truth.csv
  std::string scene; ///< name or file of the simulated scene; empty if there is none
  std::vector<ProjectMarker> markers;          ///< ordered by frame
  std::optional<ReferenceGrid> grid;           ///< drawn over the images to adjust cameras by hand
  std::vector<MeasuredPoint> points;           ///< measured in the room and clicked in the images
  std::optional<WorldBox> volumeOfInterest;    ///< targets are searched for only inside it
  std::vector<PersonCorrection> people;        ///< corrections of people, ordered by frame
  std::vector<PositionCorrection> corrections; ///< corrections of targets, ordered by frame
  std::string layout; ///< layout of the views as the window saved it; empty: default layout

  bool operator==(const Project&) const = default;
};

/// Returns the parameters with which a project is tracked; see tracking::parametersInUse().
ParameterValues parametersInUse(const Project& project);

/// Inserts a correction after the others of its frame.
void addPerson(Project& project, const PersonCorrection& person);
/// Inserts a correction after the others of its frame, or replaces the one of the same target and
/// frame. A correction made by the user also removes tracked-back corrections that no longer hold:
/// those that started from the replaced correction, and earlier ones that were tracked back across
/// its frame.
void addCorrection(Project& project, const PositionCorrection& correction);
/// Removes the correction of a target in a frame, and those that were tracked back from it.
void removeCorrection(Project& project, std::int64_t frame, int target);
/// Removes the target with this index, and its corrections.
void removeTarget(Project& project, std::size_t index);

} // namespace dewpoint::project
