// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/snapshot/display_colors.h"

#include "core/color/hsi.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace dewpoint::session {

namespace {

// A range beyond these holds grays, or colors that nobody would call by one name.
constexpr double kLeastSaturation = 0.05; ///< of its lower bound
constexpr double kWidestHue = 150.0;      ///< degrees
constexpr double kLeastChroma = 0.02;     ///< of its middle, OKLab
constexpr double kAlike = 0.09;           ///< OKLab: about a sixth of the way from red to green

/// Lightness (OKLab, 0 to 1) from the darkest to the brightest color that can be seen.
struct LightnessRange {
  double darkest;
  double brightest;
};

/// In an image, lines cross the target itself. So they are lighter than most objects, and have a
/// dark halo.
LightnessRange lightnessOn(DisplayBackground ground) {
  switch (ground) {
  case DisplayBackground::Light:
    return {0.30, 0.74};
  case DisplayBackground::Dark:
    return {0.62, 0.92};
  case DisplayBackground::Image:
    break;
  }
  return {0.76, 0.92};
}

DisplayColor colorFromHex(unsigned rgb) {
  return DisplayColor((rgb >> 16U) & 255U, (rgb >> 8U) & 255U, rgb & 255U) / 255.0;
}

double linearFromScreen(double value) {
  return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

double screenFromLinear(double value) {
  return value <= 0.0031308 ? 12.92 * value : 1.055 * std::pow(value, 1.0 / 2.4) - 0.055;
}

// The matrices of Ottosson, "A perceptual color space for image processing" (2020).
const Eigen::Matrix3d& conesFromLinear() {
  static const Eigen::Matrix3d kMatrix{{0.4122214708, 0.5363325363, 0.0514459929},
                                       {0.2119034982, 0.6806995451, 0.1073969566},
                                       {0.0883024619, 0.2817188376, 0.6299787005}};
  return kMatrix;
}

const Eigen::Matrix3d& labFromRoots() {
  static const Eigen::Matrix3d kMatrix{{0.2104542553, 0.7936177850, -0.0040720468},
                                       {1.9779984951, -2.4285922050, 0.4505937099},
                                       {0.0259040371, 0.7827717662, -0.8086757660}};
  return kMatrix;
}

/// Lightness, green to red, blue to yellow.
Eigen::Vector3d okLab(const DisplayColor& color) {
  const Eigen::Vector3d linear = color.cwiseMax(0.0).cwiseMin(1.0).unaryExpr(&linearFromScreen);
  const Eigen::Vector3d roots =
      (conesFromLinear() * linear).unaryExpr([](double cone) { return std::cbrt(cone); });
  return labFromRoots() * roots;
}

/// May lie outside [0, 1].
DisplayColor screenColor(const Eigen::Vector3d& lab) {
  static const Eigen::Matrix3d kRootsFromLab = labFromRoots().inverse();
  static const Eigen::Matrix3d kLinearFromCones = conesFromLinear().inverse();
  const Eigen::Vector3d roots = kRootsFromLab * lab;
  const Eigen::Vector3d linear = kLinearFromCones * roots.cwiseProduct(roots).cwiseProduct(roots);
  return linear.unaryExpr(&screenFromLinear);
}

/// Paler until the screen can show it.
DisplayColor nearestDisplayable(const Eigen::Vector3d& lab) {
  double shown = 0.0;
  double tooMuch = 1.0;
  const auto at = [&](double chroma) {
    return screenColor({lab[0], chroma * lab[1], chroma * lab[2]});
  };
  const auto fits = [](const DisplayColor& color) {
    return color.minCoeff() >= -1e-6 && color.maxCoeff() <= 1.0 + 1e-6;
  };
  if (fits(at(1.0))) {
    shown = 1.0;
  }
  for (int halving = 0; shown < 1.0 && halving < 12; ++halving) {
    const double middle = 0.5 * (shown + tooMuch);
    (fits(at(middle)) ? shown : tooMuch) = middle;
  }
  return at(shown).cwiseMax(0.0).cwiseMin(1.0);
}

/// A color, and how it looks.
struct LabColor {
  DisplayColor color;
  Eigen::Vector3d lab; ///< OKLab
};

LabColor labColor(const DisplayColor& color) {
  return {color, okLab(color)};
}

bool areLabsSimilar(const Eigen::Vector3d& one, const Eigen::Vector3d& other) {
  Eigen::Vector3d difference = one - other;
  difference[0] *= 0.5;
  return difference.norm() < kAlike;
}

} // namespace

std::optional<DisplayColor> centralColor(const ColorRange& range) {
  double width = range.hueMax - range.hueMin;
  width += width < 0.0 ? 360.0 : 0.0;
  if (range.saturationMin < kLeastSaturation || width > kWidestHue) {
    return std::nullopt;
  }
  const Hsi middle{normalizedHue(range.hueMin + 0.5 * width),
                   0.5 * (range.saturationMin + range.saturationMax),
                   0.5 * (range.intensityMin + range.intensityMax)};
  const auto [blue, green, red] = bgrFromHsi(middle);
  DisplayColor found = DisplayColor(red, green, blue) / 255.0;
  found /= std::max(1.0, found.maxCoeff());
  if (!found.allFinite() || okLab(found).tail<2>().norm() < kLeastChroma) {
    return std::nullopt;
  }
  return found;
}

DisplayColor legibleColor(const DisplayColor& color, DisplayBackground ground) {
  Eigen::Vector3d lab = okLab(color);
  const LightnessRange range = lightnessOn(ground);
  const double lightness = std::clamp(lab[0], range.darkest, range.brightest);
  if (lightness == lab[0]) {
    return color;
  }
  lab[0] = lightness;
  return nearestDisplayable(lab);
}

bool areSimilar(const DisplayColor& one, const DisplayColor& other) {
  return areLabsSimilar(okLab(one), okLab(other));
}

const std::vector<DisplayColor>& displayPalette(DisplayBackground ground) {
  static const std::vector<DisplayColor> kWindow{colorFromHex(0xd55e00), colorFromHex(0x0072b2),
                                                 colorFromHex(0x009e73), colorFromHex(0xcc79a7),
                                                 colorFromHex(0xe69f00), colorFromHex(0xb8a500)};
  static const std::vector<DisplayColor> kImage{colorFromHex(0xff8640), colorFromHex(0x56b4e9),
                                                colorFromHex(0x2fc79a), colorFromHex(0xe59ac6),
                                                colorFromHex(0xe69f00), colorFromHex(0xf0e442)};
  return ground == DisplayBackground::Image ? kImage : kWindow;
}

std::vector<DisplayColor> displayColors(const std::vector<DisplayColorSource>& sources,
                                        DisplayBackground ground) {
  // All grounds share one choice, so that a target has one hue in all views. It is made for the
  // ground with the narrowest range of lightness: what differs there differs on the others, too.
  constexpr DisplayBackground kDecisive = DisplayBackground::Image;
  const std::size_t own = std::min(sources.size(), kMaxOwnColors);
  std::vector<std::optional<LabColor>> chosen(own); // as seen on the decisive ground
  std::vector<DisplayColor> colors(sources.size());
  for (std::size_t k = 0; k < own; ++k) {
    if (sources[k].fixedColor) {
      chosen[k] = labColor(*sources[k].fixedColor);
      colors[k] = *sources[k].fixedColor;
    } else if (!sources[k].learnedColors.empty()) {
      if (const auto middle = centralColor(sources[k].learnedColors[0])) {
        chosen[k] = labColor(legibleColor(*middle, kDecisive));
        colors[k] = legibleColor(*middle, ground);
      }
    }
  }
  // All of a group that look alike give way, so that none of them depends on their order.
  const auto before = chosen;
  for (std::size_t k = 0; k < own; ++k) {
    for (std::size_t other = 0; other < own && !sources[k].fixedColor; ++other) {
      if (other != k && before[k] && before[other] &&
          areLabsSimilar(before[k]->lab, before[other]->lab)) {
        chosen[k].reset();
        break;
      }
    }
  }
  const std::vector<DisplayColor>& palette = displayPalette(ground);
  std::vector<LabColor> offered;
  std::ranges::transform(displayPalette(kDecisive), std::back_inserter(offered), labColor);
  const auto isTaken = [&](const LabColor& color) {
    return std::ranges::any_of(
        chosen, [&](const auto& one) { return one && areLabsSimilar(one->lab, color.lab); });
  };
  for (std::size_t k = 0; k < sources.size(); ++k) {
    if (k < own && chosen[k]) {
      continue;
    }
    std::size_t index = k % offered.size();
    for (std::size_t next = k; k < own && next < k + offered.size(); ++next) {
      if (const LabColor& color = offered[next % offered.size()]; !isTaken(color)) {
        index = next % offered.size();
        chosen[k] = color;
        break;
      }
    }
    colors[k] = k >= own && sources[k].fixedColor ? *sources[k].fixedColor : palette[index];
  }
  return colors;
}

} // namespace dewpoint::session
