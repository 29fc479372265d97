// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/run/sphere_sample.h"

namespace dewpoint::session {

TrajectorySample sampleOf(const SphereEstimate& sphere, const std::string& target,
                          std::int64_t frame, double time) {
  TrajectorySample sample;
  sample.time = time;
  sample.frame = frame;
  sample.target = target;
  sample.position = sphere.mean;
  sample.covariance = sphere.covariance;
  sample.effectiveSampleSize = sphere.effectiveSampleSize;
  sample.cameraCount = sphere.seeingCameraCount;
  sample.isValid = sphere.isValid;
  sample.existenceProbability = sphere.existenceProbability;
  sample.bestParticle = bestParticleOf(sphere);
  sample.isAmbiguous = sphere.isAmbiguous;
  sample.extent = sphere.extent;
  if (sphere.measurement) {
    sample.measurement =
        PositionMeasurement{sphere.measurement->mean, sphere.measurement->covariance};
  }
  return sample;
}

} // namespace dewpoint::session
