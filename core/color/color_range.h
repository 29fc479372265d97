// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace dewpoint {

/// A target color as ranges in HSI (Gonzalez & Woods). Hue in degrees [0, 360), circular: hueMin >
/// hueMax wraps through 0. Saturation and intensity in [0, 1]. All bounds inclusive.
struct ColorRange {
  double hueMin = 0.0;
  double hueMax = 0.0;
  double saturationMin = 0.0;
  double saturationMax = 1.0;
  double intensityMin = 0.0;
  double intensityMax = 1.0;

  bool operator==(const ColorRange&) const = default;
};

} // namespace dewpoint
