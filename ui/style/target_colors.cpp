// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/style/target_colors.h"

#include "ui/style/theme.h"
#include "ui/style/to_color.h"

namespace dewpoint::ui {

DisplayBackground displayBackgroundOf(const QPalette& palette) {
  return isDarkPalette(palette) ? DisplayBackground::Dark : DisplayBackground::Light;
}

std::vector<QColor> targetColors(const std::vector<DisplayColorSource>& sources,
                                 DisplayBackground ground) {
  std::vector<QColor> colors;
  colors.reserve(sources.size());
  for (const DisplayColor& color : displayColors(sources, ground)) {
    colors.push_back(toQColor(color));
  }
  return colors;
}

} // namespace dewpoint::ui
