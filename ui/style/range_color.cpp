// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/style/range_color.h"

#include <algorithm>

namespace dewpoint::ui {

QColor rangeColor(const ColorRange& range) {
  const double width =
      color::spansEveryHue(range) ? 0.0 : color::normalizedHue(range.hueMax - range.hueMin);
  const double hue = color::normalizedHue(range.hueMin + 0.5 * width) / 360.0;
  const double saturation =
      color::spansEveryHue(range) ? 0.0 : 0.5 * (range.saturationMin + range.saturationMax);
  const double intensity = 0.5 * (range.intensityMin + range.intensityMax);
  return QColor::fromHsvF(static_cast<float>(std::min(hue, 0.9999)), static_cast<float>(saturation),
                          static_cast<float>(std::clamp(1.4 * intensity, 0.0, 1.0)));
}

} // namespace dewpoint::ui
