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

/// Scene with people, as recorded by cameras with the faults of a grade (level of realism). Methods
/// may know only `rig` and the images; everything else is ground truth.
struct PeopleRecording {
  Grade grade = Grade::Ideal;
  OfficeScene scene; ///< scene, with the true calibration of the cameras
  CameraRig rig;     ///< calibration that methods receive
  /// Views of the room at rest from the true cameras.
  std::vector<std::shared_ptr<const simulation::RoomView>> roomViews;
  /// Returns the images of frame k as they arrive: delayed, with errors in the time stamps, and
  /// null where a frame is dropped. This is a pure function.
  std::function<FrameSetPtr(std::int64_t)> frames;
};

/// Records a scene with people in a grade (level of realism). Grade `Ideal` leaves the scene
/// unchanged. `Room` and `Wild` add faults of images, time stamps and calibration (see GradeModel),
/// drawn from the scene's seed and the scenario's `name`. `Wild` also mounts the cameras elsewhere
/// and changes the room (see makeWildOffice()). The background images have the same faults as all
/// other images. `Real` is not allowed.
PeopleRecording recordPeople(const std::string& name, OfficeScene scene, Grade grade,
                             simulation::ViewCache& views);

} // namespace dewpoint::experiment
