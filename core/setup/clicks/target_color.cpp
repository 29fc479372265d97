// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/clicks/target_color.h"

#include "core/color/color_classifier.h"

#include <algorithm>
#include <vector>

namespace dewpoint::setup {
namespace {

/// The first of the colors that most of a sample matches; nothing matches none.
std::size_t colorShown(const ColorSample& sample, const ColorRanges& colors) {
  std::size_t shown = colors.size();
  std::ptrdiff_t most = 0;
  for (std::size_t k = 0; k < colors.size(); ++k) {
    const color::ColorClassifier classifier(colors[k]);
    const auto matching = std::ranges::count_if(sample.colors, [&](const color::BgrColor& bgr) {
      return classifier.matches(bgr[0], bgr[1], bgr[2]);
    });
    if (matching > most) {
      most = matching;
      shown = k;
    }
  }
  return shown;
}

} // namespace

void removeColor(std::size_t index, Target& target) {
  const ColorRanges colors = target.colors();
  if (colors.size() < 2 || index >= colors.size()) {
    return;
  }
  std::erase_if(target.samples, [&](const ColorSample& sample) {
    return !sample.isExcluded && colorShown(sample, colors) == index;
  });
  std::vector<ColorRange> kept(colors.begin(), colors.end());
  kept.erase(kept.begin() + static_cast<std::ptrdiff_t>(index));
  target.color = kept.front();
  target.otherColors.assign(kept.begin() + 1, kept.end());
}

void setColor(std::size_t index, const ColorRange& range, Target& target) {
  if (index == 0) {
    target.color = range;
  } else {
    target.otherColors.at(index - 1) = range;
  }
}

} // namespace dewpoint::setup
