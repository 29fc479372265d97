// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/scenarios/people/people_recording.h"

#include "core/base/random.h"
#include "core/experiment/scenarios/draft/draft_frames.h"
#include "core/experiment/scenarios/draft/grade_model.h"
#include "core/experiment/scenarios/draft/sensing_faults.h"
#include "core/experiment/scenarios/people/wild_office.h"

#include <utility>

namespace dewpoint::experiment {
namespace {

using scenarios::ScenarioDraft;

/// Keeps the noise's seed apart from the draws'.
constexpr std::uint32_t kOfficeNoisePart = 0x0FF1CE;
/// How many times as far the office's cameras are from its middle (4.9 m) as those at the desk
/// (1.1 m), for which GradeModel says how exact a calibration is: what is measured by hand there is
/// as many times less exact.
constexpr double kDesksAcross = 4.5;
/// Of further lamps from the middle of the office, meters: before its walls (kOfficeHalfSize).
constexpr double kOfficeLampDistance = 3.2;
/// Above the middle of the floor, meters: what the cameras look at, and what lamps are set against.
const Eigen::Vector3d kOfficeMiddle{0.0, 0.0, 0.8};

FrameSetPtr idealFrames(const OfficeRenderer& renderer, std::int64_t frame) {
  const OfficeScene& scene = renderer.scene();
  FrameSet set{frame, timeStamp(scene.timeOf(frame)), {}};
  for (std::size_t k = 0; k < scene.cameras.size(); ++k) {
    set.frames.push_back(
        std::make_shared<const Frame>(Frame{frame, set.time, renderer.render(k, frame)}));
  }
  return std::make_shared<const FrameSet>(std::move(set));
}

/// What is wrong with a recording, in the light of the lamp that hangs at `lamp`.
scenarios::SensingFaults officeFaults(const ScenarioDraft& draft,
                                      const simulation::Vector3f& lamp) {
  const scenarios::GradeModel& model = scenarios::gradeModel(draft.grade);
  RandomDraws draws(draft.seed, draft.name + " " + model.name);
  scenarios::FaultContext context;
  context.cameraCount = draft.rig.size();
  context.durationSeconds = draft.timeOf(draft.frameCount);
  context.framesPerSecond = draft.framesPerSecond;
  context.targetStart = kOfficeMiddle;
  context.lampDistance = kOfficeLampDistance;
  scenarios::SensingFaults faults = scenarios::randomFaults(model, context, draws);
  faults.illumination.lampPosition = lamp;
  for (scenarios::CameraFaults& camera : faults.cameras) {
    camera.calibration.positionMeters *= kDesksAcross;
  }
  return faults;
}

/// The cameras of a grade and what they see of the room at rest; returns where its lamp hangs.
simulation::Vector3f placeCameras(const std::string& name, PeopleRecording& recording,
                                  simulation::ViewCache& views) {
  OfficeScene& scene = recording.scene;
  if (recording.grade == Grade::Wild) {
    RandomDraws draws(scene.seed, name + " office");
    WildOffice office = makeWildOffice(scene, draws);
    scenarios::setRandomLenses(recording.grade, office.rig, draws);
    scene.cameras = office.rig;
    const simulation::Room room(simulation::Furnishing::Office, office.design);
    for (const Camera& camera : scene.cameras) {
      // Not from the cache: no other scene has these views.
      recording.roomViews.push_back(std::make_shared<const simulation::RoomView>(camera, room));
    }
    return room.lampPosition();
  }
  RandomDraws lenses(scene.seed, name + " lenses");
  scenarios::setRandomLenses(recording.grade, scene.cameras, lenses);
  for (const Camera& camera : scene.cameras) {
    recording.roomViews.push_back(views.view(camera, simulation::Furnishing::Office));
  }
  return simulation::kOfficeLampPosition;
}

ScenarioDraft draftOf(const std::string& name, const PeopleRecording& recording) {
  const OfficeScene& scene = recording.scene;
  ScenarioDraft draft{name, recording.grade, scene.seed, RandomDraws(scene.seed, name),
                      scene.cameras};
  draft.framesPerSecond = scene.framesPerSecond;
  draft.frameCount = scene.frameCount;
  draft.stage.seed = derivedSeed(scene.seed, hashOf(name) ^ kOfficeNoisePart);
  draft.stage.views = recording.roomViews;
  draft.stage.people = scene.people;
  draft.stage.furniture = scene.furniture;
  draft.stage.arePeopleMainSubject = true;
  return draft;
}

} // namespace

PeopleRecording recordPeople(const std::string& name, OfficeScene scene, Grade grade,
                             simulation::ViewCache& views) {
  const std::string drawn = "people-" + name; // as on the command line
  PeopleRecording recording;
  recording.grade = grade;
  recording.scene = std::move(scene);
  const simulation::Vector3f lamp = placeCameras(drawn, recording, views);
  recording.rig = recording.scene.cameras;
  if (grade == Grade::Ideal) {
    // As it was drawn, to the bit.
    const auto renderer =
        std::make_shared<const OfficeRenderer>(recording.scene, recording.roomViews);
    recording.frames = [renderer](std::int64_t frame) { return idealFrames(*renderer, frame); };
    return recording;
  }
  ScenarioDraft draft = draftOf(drawn, recording);
  RandomDraws errors(recording.scene.seed, drawn + " calibration");
  recording.rig = scenarios::applyFaults(officeFaults(draft, lamp), draft, errors);
  const auto shared = std::make_shared<const ScenarioDraft>(std::move(draft));
  recording.frames = [shared](std::int64_t frame) { return frameSetOf(*shared, frame); };
  return recording;
}

} // namespace dewpoint::experiment
