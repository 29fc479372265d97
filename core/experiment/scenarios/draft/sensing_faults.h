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

/// Errors of the calibration that methods receive: standard deviations.
struct CalibrationError {
  double focal = 0.0;    ///< of the focal length, relative
  double position = 0.0; ///< per axis, meters
  double rotation = 0.0; ///< about a random axis, radians
  double radial = 0.0;   ///< of the first radial distortion coefficient
  bool operator==(const CalibrationError&) const = default;
};

/// Returns the calibration of a camera that methods receive: the true one with random errors.
Camera miscalibrated(Camera camera, const CalibrationError& error, Draws& draws);

/// Uneven light over an image, as shares of the light in the center.
struct UnevenLight {
  double vignette = 0.0; ///< share lost in the corners
  double right = 0.0;    ///< share gained from the center to the right border
  double down = 0.0;     ///< share gained from the center to the lower border
};

/// Faults of one camera.
struct CameraFaults {
  simulation::SensorModel sensor;
  /// Sets the gains of `sensor` unless it already has some.
  std::optional<simulation::AutomaticGain> automatic;
  UnevenLight unevenLight;
  CameraTiming timing;
  CalibrationError calibration;
};

/// All faults of the images, time stamps and calibration of a run.
struct SensingFaults {
  std::vector<CameraFaults> cameras;
  simulation::Illumination illumination;
};

struct ScenarioDraft;

/// Returns ideal cameras in the room's own light.
SensingFaults noFaults(const ScenarioDraft& draft);

/// Applies the faults to the draft's stage and time stamps. Returns the calibration that methods
/// receive, with errors drawn from `draws`.
CameraRig applyFaults(const SensingFaults& faults, ScenarioDraft& draft, Draws& draws);

} // namespace dewpoint::experiment::scenarios
