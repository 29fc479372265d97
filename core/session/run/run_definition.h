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

/// Everything that determines the results of a run from its frames. A definition is immutable after
/// it is made, so the tracking thread, its history and its snapshots can share it. A change creates
/// a new definition.
struct RunDefinition {
  std::string method;
  ParameterValues parameters;  ///< values in use, see useCameras()
  std::vector<Target> targets; ///< targets of the project; methods for people find their own
  std::shared_ptr<const CameraRig> rig; ///< never null; cameras in the order of the project
  /// Background image per camera, as returned by loadEmptyRooms(); may be empty.
  std::vector<cv::Mat> emptyRooms;
  std::vector<std::string> emptyRoomFiles;  ///< per camera, as named in the project
  std::vector<PersonCorrection> people;     ///< ordered by frame; used by methods for people
  std::optional<WorldBox> volumeOfInterest; ///< targets are searched for only inside it
  /// Ordered by frame; used by methods that support it.
  std::vector<PositionCorrection> corrections;
  std::uint64_t seed = 1;

  /// Returns the definition of a project; `emptyRooms` as returned by loadEmptyRooms(), or none.
  static RunDefinition of(const Project& project, std::vector<cv::Mat> emptyRooms = {});
  /// Returns the project with the values of this definition.
  Project appliedTo(Project project) const;

  /// Derives parameters that the user has not set from the cameras (parametersInUse()). Required
  /// after a change of cameras, parameters or volume of interest; of() includes it.
  void useCameras();

  MethodFamily family() const { return methodFamily(method); }
  /// Compares background images by their pixels, unless they share memory.
  bool operator==(const RunDefinition& other) const;
};
using RunDefinitionPtr = std::shared_ptr<const RunDefinition>;

/// Returns the two corners of a volume of interest as text, in meters.
std::string volumeText(const WorldBox& volume);

/// Returns whether both contain the same background images.
bool areSameRooms(const std::vector<cv::Mat>& a, const std::vector<cv::Mat>& b);

/// Returns the differences between `after` and `before` as text for the header of a trajectory;
/// empty if there are none. Corrections of positions are omitted because they are marked in the
/// rows of the trajectory.
std::string differences(const RunDefinition& before, const RunDefinition& after);

} // namespace dewpoint::session
