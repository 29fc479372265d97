// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_sample.h"
#include "core/color/likelihood/color_likelihood.h"

#include <utility>
#include <vector>

namespace dewpoint::tests {

inline const color::BgrColor kRed{40, 40, 200};

/// A sample of these colors, of so many pixels, that no image shows any more.
inline color::ColorSample sampleOf(std::vector<color::BgrColor> colors, int area,
                                   bool excluded = false) {
  color::ColorSample sample;
  sample.colors = std::move(colors);
  sample.areaPx = area;
  sample.isExcluded = excluded;
  return sample;
}

/// How much more likely the target shows this color than anything else does.
inline double nats(const color::ColorLikelihood& table, const color::BgrColor& bgr) {
  return table.logRatio(bgr[0], bgr[1], bgr[2]);
}

} // namespace dewpoint::tests
