// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/scenarios/draft/sensing_faults.h"

#include "core/experiment/scenarios/draft/scenario_draft.h"
#include "core/simulation/sensor/sensor.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace dewpoint::experiment::scenarios {
namespace {

/// The camera's automatics over the run in the light of the stage.
simulation::GainCurve gainsOf(const ScenarioDraft& draft, std::size_t camera,
                              const simulation::AutomaticGain& automatic) {
  std::vector<Eigen::Vector3d> stops;
  stops.reserve(static_cast<std::size_t>(draft.frameCount));
  for (std::int64_t frame = 0; frame < draft.frameCount; ++frame) {
    stops.push_back(simulation::meteredBrightnessStops(draft.stage, camera, draft.timeOf(frame)));
  }
  return simulation::automaticGains(automatic, stops, draft.framesPerSecond);
}

bool isUneven(const CameraFaults& faults) {
  const UnevenLight& light = faults.unevenLight;
  return light.vignette != 0.0 || light.lightGainTowardRight != 0.0 ||
         light.lightGainTowardBottom != 0.0;
}

void addUnevenLight(const SensingFaults& faults, simulation::Stage& stage) {
  stage.illuminationGains.clear();
  if (std::ranges::none_of(faults.cameras, isUneven)) {
    return;
  }
  for (std::size_t camera = 0; camera < faults.cameras.size(); ++camera) {
    const simulation::RoomView& view = *stage.views[camera];
    const UnevenLight& light = faults.cameras[camera].unevenLight;
    stage.illuminationGains.push_back(
        simulation::unevenLightGains({view.width, view.height}, light.vignette,
                                     light.lightGainTowardRight, light.lightGainTowardBottom));
  }
}

} // namespace

Camera withCalibrationError(Camera camera, const CalibrationError& error, RandomDraws& draws) {
  if (error == CalibrationError{}) {
    return camera;
  }
  const double focal = 1.0 + draws.drawNormal(error.relativeFocalLength);
  camera.intrinsics.focalX *= focal;
  camera.intrinsics.focalY *= focal;
  const double x = draws.drawNormal(error.positionMeters);
  const double y = draws.drawNormal(error.positionMeters);
  const double z = draws.drawNormal(error.positionMeters);
  const Eigen::Vector3d position = camera.center() + Eigen::Vector3d(x, y, z);
  const double angle = draws.drawNormal(error.rotationRadians);
  const Eigen::AngleAxisd rotation(angle, draws.drawDirection());
  camera.cameraFromWorld.linear() = rotation * camera.cameraFromWorld.linear();
  camera.cameraFromWorld.translation() = -(camera.cameraFromWorld.linear() * position);
  camera.distortion[0] += draws.drawNormal(error.radialDistortion);
  return camera;
}

SensingFaults noFaults(const ScenarioDraft& draft) {
  SensingFaults faults;
  faults.cameras.resize(draft.rig.size());
  for (CameraFaults& camera : faults.cameras) {
    camera.sensor.shutter.exposureSeconds = draft.stage.exposureSeconds;
  }
  faults.illumination = draft.stage.illumination;
  return faults;
}

CameraRig applyFaults(const SensingFaults& faults, ScenarioDraft& draft, RandomDraws& draws) {
  draft.stage.illumination = faults.illumination;
  simulation::prepareLight(draft.stage);
  addUnevenLight(faults, draft.stage);
  draft.stage.sensors.clear();
  draft.timings.clear();
  CameraRig believed;
  believed.reserve(draft.rig.size());
  for (std::size_t camera = 0; camera < draft.rig.size(); ++camera) {
    const CameraFaults& own = faults.cameras.at(camera);
    simulation::SensorModel sensor = own.sensor;
    if (own.automaticGain && sensor.gainCurve.gainPerFrame.empty()) {
      sensor.gainCurve = gainsOf(draft, camera, *own.automaticGain);
    }
    draft.stage.sensors.push_back(std::move(sensor));
    draft.timings.push_back(own.timing);
    believed.push_back(withCalibrationError(draft.rig[camera], own.calibration, draws));
  }
  return believed;
}

} // namespace dewpoint::experiment::scenarios
