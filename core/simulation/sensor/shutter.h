// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/sensor/usual_camera.h"

#include <vector>

namespace dewpoint::simulation {

/// Timing of the exposure of each image row. The time of a frame is the time of its central row.
struct Shutter {
  double exposureSeconds =
      kDefaultExposureSeconds; ///< exposure of each row, centered on the row's time
  double readoutSeconds = 0.0; ///< time from the first to the last row; 0: global shutter
};

/// Returns the time of row `row` relative to the frame time, in seconds, for an image with `rows`
/// rows. The time is negative in the upper half of the image.
double rowTime(const Shutter& shutter, int row, int rows);

/// Band of image rows [firstRow, endRow) that are rendered as if they had the same time.
struct RowBand {
  int firstRow = 0;
  int endRow = 0;
  double centerTime = 0.0; ///< time of the band's central row, seconds from the frame's time
};

/// Divides an image with `rows` rows into bands, from top to bottom. A global shutter gives a
/// single band.
std::vector<RowBand> rowBands(const Shutter& shutter, int rows);

/// Flicker of lamps on alternating current, whose light oscillates at twice the mains frequency.
struct Flicker {
  double frequencyHz = 100.0; ///< frequency of the light, Hz
  double modulationDepth =
      0.0; ///< amplitude of the oscillation relative to the mean light; 0: steady light
  double phaseRadians = 0.0; ///< phase of the oscillation at time 0, radians
};

/// Returns the light in each image row of a frame at `time` (seconds), relative to steady light:
/// the mean of the oscillation over the row's exposure. Rolling shutters show the oscillation as
/// bands. If the exposure is a whole number of periods, there are no bands.
std::vector<float> rowGains(const Flicker& flicker, const Shutter& shutter, int rows, double time);

} // namespace dewpoint::simulation
