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

/// Standard deviations of the errors in the calibration that methods receive.
struct CalibrationError {
  double relativeFocalLength = 0.0; ///< relative error of the focal length
  double positionMeters = 0.0;      ///< error of the position per axis, meters
  double rotationRadians = 0.0;     ///< rotation error about a random axis, radians
  double radialDistortion = 0.0;    ///< error of the first radial distortion coefficient
  bool operator==(const CalibrationError&) const = default;
};

/// Returns the calibration of a camera that methods receive: the true calibration with random
/// errors.
Camera withCalibrationError(Camera camera, const CalibrationError& error, RandomDraws& draws);

/// Uneven light over an image, as fractions of the light in the center.
struct UnevenLight {
  double vignette = 0.0; ///< fraction of light lost in the corners
  double lightGainTowardRight =
      0.0; ///< fraction of light gained from the center to the right border
  double lightGainTowardBottom =
      0.0; ///< fraction of light gained from the center to the lower border
};

/// Faults of one camera.
struct CameraFaults {
  simulation::SensorModel sensor;
  /// Automatic exposure and white balance. They determine the gains of `sensor`, unless these gains
  /// are already set.
  std::optional<simulation::AutomaticGain> automaticGain;
  UnevenLight unevenLight;
  CameraTiming timing;
  CalibrationError calibration;
};

/// All faults in the images, time stamps and calibration of a run.
struct SensingFaults {
  std::vector<CameraFaults> cameras;
  simulation::Illumination illumination;
};

struct ScenarioDraft;

/// Returns faults for ideal cameras in the unchanged light of the room.
SensingFaults noFaults(const ScenarioDraft& draft);

/// Applies the faults to the simulated scene (`draft.stage`) and the time stamps of the draft.
/// Returns the calibration that methods receive, with errors drawn from `draws`.
CameraRig applyFaults(const SensingFaults& faults, ScenarioDraft& draft, RandomDraws& draws);

} // namespace dewpoint::experiment::scenarios
