// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/bundle/fault.h"
#include "core/calibration/quality/fault_question.h"

#include <cstddef>
#include <optional>

namespace dewpoint::calibration {

/// One camera that is left out, and what the others show.
struct Suspect {
  std::size_t camera = 0;
  const ImagePoints* imagePoints = nullptr;
  const PointPositions* positions = nullptr; ///< as the others see them
  double sigmaPx = 1.0;                      ///< of image points as the others explain them
};

/// The hypothesis that explains a suspect best, if it does so clearly better than none.
std::optional<NamedFault> faultOfCamera(const FaultQuestion& question, const Suspect& suspect);

} // namespace dewpoint::calibration
