// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cameraview/particle_ramp.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace dewpoint::ui {

namespace {

QColor colorBetween(const QColor& from, const QColor& to, double share) {
  const auto part = [share](int low, int high) {
    return static_cast<int>(std::lround(low + share * (high - low)));
  };
  return {part(from.red(), to.red()), part(from.green(), to.green()), part(from.blue(), to.blue())};
}

} // namespace

ParticleRamp ParticleRamp::heatRamp() {
  return ParticleRamp({QColor("#4a1f96"), QColor("#95278c"), QColor("#e0457b"), QColor("#ffa071"),
                       QColor("#fffcc8")});
}

ParticleRamp ParticleRamp::tintedRamp(const QColor& color) {
  return ParticleRamp(
      {colorBetween(color, Qt::black, 0.6), color, colorBetween(color, Qt::white, 0.8)});
}

QColor ParticleRamp::colorAt(double weight) const {
  const double place = std::clamp(weight, 0.0, 1.0) * static_cast<double>(stops_.size() - 1);
  const auto low = std::min(static_cast<std::size_t>(place), stops_.size() - 2);
  return colorBetween(stops_[low], stops_[low + 1], place - static_cast<double>(low));
}

} // namespace dewpoint::ui
