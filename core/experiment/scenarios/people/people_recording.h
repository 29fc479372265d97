// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/frame.h"
#include "core/experiment/scenarios/grade.h"
#include "core/geometry/camera.h"
#include "core/simulation/people/office.h"
#include "core/simulation/room/view_cache.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace dewpoint::experiment {

/// Scene of people as the cameras of a grade record it: what methods may know, and the truth.
struct PeopleRecording {
  Grade grade = Grade::Ideal;
  OfficeScene scene; ///< has the true cameras
  CameraRig rig;     ///< calibration that methods receive
  std::vector<std::shared_ptr<const simulation::RoomView>> views; ///< views of the true cameras
  /// Images of frame k as they arrive: delayed, with errors in the time stamps, null where a frame
  /// is dropped. A pure function.
  std::function<FrameSetPtr(std::int64_t)> frames;
};

/// Grade `Ideal` leaves the scene as it is; `Room` and `Wild` draw what is wrong with its images,
/// time stamps and calibration from the scene's seed and the scenario's `name`, as GradeModel says;
/// `Wild` also puts the cameras up elsewhere and changes the room, see wildOffice(). The background
/// image that methods learn from comes from the same cameras as all else. Not for `Real`.
PeopleRecording recordPeople(const std::string& name, OfficeScene scene, Grade grade,
                             simulation::ViewCache& views);

} // namespace dewpoint::experiment
