// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/scenarios/draft/camera_timing.h"
#include "core/experiment/scenarios/random_draws.h"
#include "core/geometry/camera.h"
#include "core/simulation/room/illumination.h"
#include "core/simulation/sensor/automatic_gain.h"
#include "core/simulation/sensor/sensor_model.h"

#include <optional>
#include <vector>

namespace dewpoint::experiment::scenarios {

/// How wrong the calibration is that methods get: standard deviations.
struct CalibrationError {
  double focal = 0.0;    ///< of the focal length, relative
  double position = 0.0; ///< per axis, meters
  double rotation = 0.0; ///< about a random axis, radians
  double radial = 0.0;   ///< of the first coefficient of the radial distortion
  bool operator==(const CalibrationError&) const = default;
};

/// The camera as it is believed: the true one with errors drawn.
Camera miscalibrated(Camera camera, const CalibrationError& error, Draws& draws);

/// Light that is not even over an image: shares of the light in its middle.
struct UnevenLight {
  double vignette = 0.0; ///< lost in the corners
  double right = 0.0;    ///< gained from the middle to the right border
  double down = 0.0;
};

/// What is wrong with one camera.
struct CameraFaults {
  simulation::SensorModel sensor;
  /// Sets the gains of `sensor` unless it has some.
  std::optional<simulation::AutomaticGain> automatic;
  UnevenLight unevenLight;
  CameraTiming timing;
  CalibrationError calibration;
};

/// All that keeps images, time stamps and calibration of a run from being ideal.
struct SensingFaults {
  std::vector<CameraFaults> cameras;
  simulation::Illumination illumination;
};

struct ScenarioDraft;

/// Ideal cameras in the room's own light.
SensingFaults noFaults(const ScenarioDraft& draft);

/// Makes the draft's stage and time stamps those of the faults, and returns the calibration that
/// methods get, with errors drawn from `draws`.
CameraRig applyFaults(const SensingFaults& faults, ScenarioDraft& draft, Draws& draws);

} // namespace dewpoint::experiment::scenarios
