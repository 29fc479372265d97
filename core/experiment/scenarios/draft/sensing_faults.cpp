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
  return light.vignette != 0.0 || light.gainToRight != 0.0 || light.gainToBottom != 0.0;
}

void addUnevenLight(const SensingFaults& faults, simulation::Stage& stage) {
  stage.illuminationGains.clear();
  if (std::ranges::none_of(faults.cameras, isUneven)) {
    return;
  }
  for (std::size_t camera = 0; camera < faults.cameras.size(); ++camera) {
    const simulation::RoomView& view = *stage.views[camera];
    const UnevenLight& light = faults.cameras[camera].unevenLight;
    stage.illuminationGains.push_back(simulation::unevenLight(
        {view.width, view.height}, light.vignette, light.gainToRight, light.gainToBottom));
  }
}

} // namespace

Camera miscalibrated(Camera camera, const CalibrationError& error, RandomDraws& draws) {
  if (error == CalibrationError{}) {
    return camera;
  }
  const double focal = 1.0 + draws.normal(error.relativeFocalLength);
  camera.intrinsics.focalX *= focal;
  camera.intrinsics.focalY *= focal;
  const double x = draws.normal(error.position);
  const double y = draws.normal(error.position);
  const double z = draws.normal(error.position);
  const Eigen::Vector3d position = camera.center() + Eigen::Vector3d(x, y, z);
  const double angle = draws.normal(error.rotation);
  const Eigen::AngleAxisd rotation(angle, draws.direction());
  camera.cameraFromWorld.linear() = rotation * camera.cameraFromWorld.linear();
  camera.cameraFromWorld.translation() = -(camera.cameraFromWorld.linear() * position);
  camera.distortion[0] += draws.normal(error.radialDistortion);
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
    if (own.automaticGain && sensor.gains.gainPerFrame.empty()) {
      sensor.gains = gainsOf(draft, camera, *own.automaticGain);
    }
    draft.stage.sensors.push_back(std::move(sensor));
    draft.timings.push_back(own.timing);
    believed.push_back(miscalibrated(draft.rig[camera], own.calibration, draws));
  }
  return believed;
}

} // namespace dewpoint::experiment::scenarios
