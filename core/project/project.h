// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/manual/measured_points.h"
#include "core/geometry/camera.h"
#include "core/geometry/reference_grid.h"
#include "core/geometry/world_box.h"
#include "core/tracking/parameters.h"
#include "core/tracking/target.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace dewpoint::project {

enum class SourceKind { Simulation, Video, Images, Device, Stream };

/// A camera of a project: where its images come from, and its calibration.
struct ProjectCamera {
  Camera camera;
  SourceKind source = SourceKind::Simulation;
  std::string location;  ///< absolute path of the video or image folder, device, or address
  int rotateDegrees = 0; ///< images are rotated clockwise by 0, 90, 180 or 270 before use
  bool mirrored = false; ///< and then mirrored left to right
  /// Of a simulated camera: its calibration is the project's own, not what the scene says.
  bool adjusted = false;
  /// Absolute path of an image, a video or a folder of images that show the scene without any
  /// target, not yet rotated; empty: there is none.
  std::string emptyRoom = {};
  /// Absolute path of a table that says when each of its images was taken (recordings); empty:
  /// they were taken evenly.
  std::string times = {};
  /// Seconds by which its images are late: what they show was so much before their time. Of
  /// recordings the image nearest in time is taken; methods that know of times use the rest.
  double delay = 0.0;

  /// Its calibration is the project's own from now on.
  void markAdjusted() { adjusted = adjusted || source == SourceKind::Simulation; }

  bool operator==(const ProjectCamera&) const = default;
};

/// A marker: a frame of the recording with a name that the user gave it.
struct ProjectMarker {
  std::int64_t frame = 0;
  std::string name;

  bool operator==(const ProjectMarker&) const = default;
};

/// A correction of the people in a recording, made in the window, for methods that find people by
/// themselves: a person stands at a position, is seen at a pixel, or is not there.
struct PersonCorrection {
  /// A click on somebody in the image of a camera.
  struct Click {
    int camera = 0;
    Eigen::Vector2d pixel = Eigen::Vector2d::Zero();

    bool operator==(const Click&) const = default;
  };

  std::int64_t frame = 0; ///< it holds from the end of this frame on
  /// On the floor, world x and y in meters. Either this or `click` is there.
  std::optional<Eigen::Vector2d> position = {};
  std::optional<Click> click = {};
  /// False, only with a position: the person whom the method tracks there does not exist.
  bool present = true;

  bool operator==(const PersonCorrection&) const = default;
};

/// A correction of where a target is, made at one frame of a recording. World frame, meters.
struct PositionCorrection {
  std::int64_t frame = 0; ///< it holds from the end of this frame on
  int target = 0;         ///< index in Project::targets
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity(); ///< of the position, m²
  /// The clicks on the target that it was made of, in images of this frame; at most one per camera.
  std::vector<PointClick> clicks = {};
  /// The frame of the correction by a person from which this one was found, by tracking back in
  /// time; nothing: a person made it.
  std::optional<std::int64_t> trackedFrom = std::nullopt;

  bool operator==(const PositionCorrection&) const = default;
};

/// The document: everything a run needs, and nothing of its results.
struct Project {
  std::filesystem::path file; ///< where it was loaded from; empty for the built-in demo
  std::string name;
  std::string method = "dewpoint";
  std::uint64_t seed = 1;
  double framesPerSecond = 0.0; ///< for image folders; 0: what the source says, or 30
  ParameterValues parameters;
  std::vector<Target> targets;
  std::vector<ProjectCamera> cameras;
  std::optional<std::filesystem::path> truth;  ///< truth.csv, absolute
  std::string scene;                           ///< name or file of the simulated scene, or empty
  std::vector<ProjectMarker> markers;          ///< in the order of their frames
  std::optional<ReferenceGrid> grid;           ///< laid over the images to adjust cameras by hand
  std::vector<MeasuredPoint> points;           ///< measured with a tape, clicked in the images
  std::optional<WorldBox> volumeOfInterest;    ///< targets are searched for in it alone
  std::vector<PersonCorrection> people;        ///< in the order of their frames
  std::vector<PositionCorrection> corrections; ///< in the order of their frames
  std::string layout; ///< of the window's views, as the window wrote it; empty: its own arrangement

  bool operator==(const Project&) const = default;
};

/// The parameters with which a project is tracked: see tracking::parametersInUse().
ParameterValues parametersInUse(const Project& project);

/// Puts a correction behind those of its frame.
void addPerson(Project& project, const PersonCorrection& person);
/// Puts a correction in place of that of the same target and frame, else behind those of its frame.
/// With one by a person, those go that were tracked back from the one it replaces, and those before
/// it that were tracked back across its frame: they were elsewhere.
void addCorrection(Project& project, const PositionCorrection& correction);
/// Removes the correction of a target at a frame, and those that were tracked back from it.
void removeCorrection(Project& project, std::int64_t frame, int target);
/// Removes a target and its corrections.
void removeTarget(Project& project, std::size_t index);

} // namespace dewpoint::project
