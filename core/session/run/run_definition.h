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

/// All that decides what a run makes of its frames: one value, never changed once it is made, so
/// that the tracking thread, its history and its snapshots can share it. A change is another value.
struct RunDefinition {
  std::string method;
  ParameterValues parameters;                  ///< those in use, see useCameras()
  std::vector<Target> targets;                 ///< the project's; methods for people find others
  std::shared_ptr<const CameraRig> rig;        ///< never null; in the order of the project
  std::vector<cv::Mat> emptyRooms;             ///< per camera, as of loadEmptyRooms(); may be empty
  std::vector<std::string> emptyRoomFiles;     ///< per camera, as the project names them
  std::vector<PersonCorrection> people;        ///< by frame; methods for people make them come true
  std::optional<WorldBox> volumeOfInterest;    ///< targets are searched for in it alone
  std::vector<PositionCorrection> corrections; ///< by frame; methods apply them that can
  std::uint64_t seed = 1;

  /// What a project says; `emptyRooms` as of loadEmptyRooms(), or none.
  static RunDefinition of(const Project& project, std::vector<cv::Mat> emptyRooms = {});
  /// The project with what this says in place of its own.
  Project appliedTo(Project project) const;

  /// Takes the parameters that nobody gave from the cameras (parametersInUse()). A definition with
  /// other cameras, parameters or volume of interest needs it; of() has done so.
  void useCameras();

  MethodFamily family() const { return methodFamily(method); }
  /// Of empty rooms the pixels are compared, unless they are the same in memory.
  bool operator==(const RunDefinition& other) const;
};
using RunDefinitionPtr = std::shared_ptr<const RunDefinition>;

/// A volume of interest in words: its two corners, meters.
std::string volumeText(const WorldBox& volume);

/// Whether both are images of the same empty rooms.
bool areSameRooms(const std::vector<cv::Mat>& a, const std::vector<cv::Mat>& b);

/// What is otherwise in `after` than in `before`, in words for the header of a trajectory; empty
/// when nothing is. Corrections of positions are not told: rows of a trajectory are marked by them.
std::string differences(const RunDefinition& before, const RunDefinition& after);

} // namespace dewpoint::session
