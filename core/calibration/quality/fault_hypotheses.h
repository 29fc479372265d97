// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/quality/fault_finder.h"

namespace dewpoint::calibration {

/// One camera that is left out, and what the others say.
struct Suspect {
  std::size_t camera = 0;
  const ImagePoints* looks = nullptr;
  const PointPlaces* places = nullptr; ///< as the others see them
  double sigmaPx = 1.0;                ///< of image points as the others explain them
};

/// The hypothesis that explains a suspect best, if it does so clearly better than none.
std::optional<NamedFault> faultOfCamera(const FaultQuestion& question, const Suspect& suspect);

/// Faults of all cameras together, from the fit of all: half a pixel, resolution.
std::optional<NamedFault> faultOfAll(const FaultQuestion& question, const ImagePoints& looks,
                                     const PointFit& fit);

/// Faults of typed lengths, boards and floors, from points as all cameras see them.
std::vector<NamedFault> faultsOfBodies(const FaultQuestion& question, const PointPlaces& places,
                                       const CameraRig& rig);

/// A relative standard deviation of the rough rig's size.
double sizeSigma(const CameraRig& rig, const RoughSigma& sigma);

} // namespace dewpoint::calibration
