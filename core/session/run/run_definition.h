// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/camera.h"
#include "core/project/project.h"
#include "core/tracking/catalog/method_catalog.h"
#include "core/tracking/parameters.h"
#include "core/tracking/target.h"

#include <opencv2/core/mat.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace dewpoint::session {

/// Settings of a run: together with its frames, they determine the results. A definition is not
/// changed after it has been shared between the tracking thread, its history and its snapshots.
/// Every change creates a new definition.
struct RunDefinition {
  std::string method;
  ParameterValues parameters; ///< parameters of the method, as used in the run
  /// Targets in the project; methods for people find their targets themselves.
  std::vector<Target> targets;
  std::shared_ptr<const CameraRig> rig;          ///< all cameras, in project order; never null
  std::vector<cv::Mat> backgroundImages;         ///< one per camera; may be empty
  std::vector<std::string> backgroundImageFiles; ///< files of the background images, one per
                                                 ///< camera, as named in the project
  /// Corrections for people, ordered by frame; used only by methods that track people.
  std::vector<PersonCorrection> personCorrections;
  std::optional<WorldBox> volumeOfInterest; ///< volume in which targets are searched for
  /// Corrections of target positions, ordered by frame; ignored by methods that cannot apply them.
  std::vector<PositionCorrection> corrections;
  std::uint64_t seed = 1;

  /// Returns the definition (settings) of a run of this project. `backgroundImages` has one image
  /// per camera, as returned by loadBackgroundImages(), or is empty.
  static RunDefinition fromProject(const Project& project,
                                   std::vector<cv::Mat> backgroundImages = {});
  /// Returns the project with its settings replaced by those of this definition.
  Project appliedTo(Project project) const;

  /// Sets the parameters that the user has not set to values that suit the cameras
  /// (effectiveParameters()). Call this after a change of cameras, parameters or volume of
  /// interest; of() has already done so.
  void adaptParametersToCameras();

  MethodFamily family() const { return methodFamily(method); }
  /// Compares all fields. Background images are compared pixel by pixel, unless they share the same
  /// memory.
  bool operator==(const RunDefinition& other) const;
};
using RunDefinitionPtr = std::shared_ptr<const RunDefinition>;

/// Returns the two corners of a volume of interest, in meters, as text.
std::string volumeText(const WorldBox& volume);

/// Returns whether the images are equal, pixel by pixel.
bool areImagesEqual(const std::vector<cv::Mat>& a, const std::vector<cv::Mat>& b);

/// Describes how `after` differs from `before`, as text for the header of a trajectory; empty if
/// there is no difference. Corrections of positions are omitted because they are marked in the rows
/// of the trajectory.
std::string differences(const RunDefinition& before, const RunDefinition& after);

} // namespace dewpoint::session
