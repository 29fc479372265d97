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
// Lightness (OKLab, 0 to 1) that differs enough from a white floor and from a dark one.
constexpr double kDarkestOnLight = 0.30;
constexpr double kBrightestOnLight = 0.74;
constexpr double kDarkestOnDark = 0.62;
constexpr double kBrightestOnDark = 0.92;
constexpr double kAlike = 0.09; ///< OKLab: about a sixth of the way from red to green

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

DisplayColor legibleOn(const DisplayColor& color, bool darkBackground) {
  Eigen::Vector3d lab = okLab(color);
  const double lightness = darkBackground ? std::clamp(lab[0], kDarkestOnDark, kBrightestOnDark)
                                          : std::clamp(lab[0], kDarkestOnLight, kBrightestOnLight);
  if (lightness == lab[0]) {
    return color;
  }
  lab[0] = lightness;
  return nearestDisplayable(lab);
}

bool areSimilar(const DisplayColor& one, const DisplayColor& other) {
  return areLabsSimilar(okLab(one), okLab(other));
}

std::vector<DisplayColor> displayColors(const std::vector<DisplayColorSource>& sources,
                                        const std::vector<DisplayColor>& palette,
                                        bool darkBackground) {
  std::vector<std::optional<LabColor>> chosen(sources.size());
  for (std::size_t k = 0; k < sources.size(); ++k) {
    if (sources[k].fixed) {
      chosen[k] = labColor(*sources[k].fixed);
    } else if (!sources[k].learned.empty()) {
      const auto middle = centralColor(sources[k].learned[0]);
      chosen[k] =
          middle ? std::optional(labColor(legibleOn(*middle, darkBackground))) : std::nullopt;
    }
  }
  // All of a group that look alike give way, so that none of them depends on their order.
  const auto before = chosen;
  for (std::size_t k = 0; k < sources.size(); ++k) {
    for (std::size_t other = 0; other < sources.size() && !sources[k].fixed; ++other) {
      if (other != k && before[k] && before[other] &&
          areLabsSimilar(before[k]->lab, before[other]->lab)) {
        chosen[k].reset();
        break;
      }
    }
  }
  std::vector<LabColor> offered;
  std::ranges::transform(palette, std::back_inserter(offered), labColor);
  const auto isTaken = [&](const LabColor& color) {
    return std::ranges::any_of(
        chosen, [&](const auto& one) { return one && areLabsSimilar(one->lab, color.lab); });
  };
  std::vector<DisplayColor> colors;
  colors.reserve(chosen.size());
  for (std::size_t k = 0; k < sources.size(); ++k) {
    for (std::size_t next = k; !chosen[k] && next < k + offered.size(); ++next) {
      if (const LabColor& color = offered[next % offered.size()]; !isTaken(color)) {
        chosen[k] = color;
      }
    }
    colors.push_back(chosen[k].value_or(offered[k % offered.size()]).color);
  }
  return colors;
}

} // namespace dewpoint::session
