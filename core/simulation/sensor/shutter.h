// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/sensor/usual_camera.h"

#include <vector>

namespace dewpoint::simulation {

/// When the rows of an image collect light. The time of a frame is that of the image's middle row.
struct Shutter {
  double exposureSeconds = kUsualExposure; ///< each row's, centered on the row's time
  double readoutSeconds = 0.0; ///< from the first row's time to the last row's; 0: global shutter
};

/// Seconds from the frame's time to that of `row` (of `rows`): negative in the upper half.
double rowTime(const Shutter& shutter, int row, int rows);

/// Rows [begin, end) that are rendered at one time.
struct RowBand {
  int begin = 0;
  int end = 0;
  double time = 0.0; ///< of their middle row, seconds from the frame's time
};

/// The bands of an image of `rows` rows, from top to bottom; one for a global shutter.
std::vector<RowBand> rowBands(const Shutter& shutter, int rows);

/// Lamps on alternating current: their light swings at twice the frequency of the mains.
struct Flicker {
  double frequency = 100.0; ///< of the light, Hz
  double depth = 0.0;       ///< amplitude of the swing, of the mean light; 0: steady
  double phase = 0.0;       ///< radians
};

/// The light of each row relative to steady light: the mean of the swing over its exposure. Rolling
/// shutters turn the swing into bands; a whole number of periods per exposure leaves none.
std::vector<float> rowGains(const Flicker& flicker, const Shutter& shutter, int rows, double time);

} // namespace dewpoint::simulation
