// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/scene3d/map_look.h"

#include <limits>

namespace dewpoint::ui {
namespace {

constexpr double kEndless = std::numeric_limits<double>::infinity();

} // namespace

std::vector<MapClass> mapClasses(const MapOptions& look) {
  if (look.quantity == MapQuantity::CameraCount) {
    return {{1.0, sceneColor(0xf0a35e), false},
            {2.0, sceneColor(0xc6dbef), true},
            {3.0, sceneColor(0x7fb8da), true},
            {4.0, sceneColor(0x3787c0), true},
            {kEndless, sceneColor(0x0b559f), false}};
  }
  const double good = look.maxGoodSigma;
  return {{0.2 * good, sceneColor(0x2166ac), false}, {0.4 * good, sceneColor(0x5aa3cf), true},
          {good, sceneColor(0xa9d3e8), true},        {2.0 * good, sceneColor(0xfdd481), true},
          {4.0 * good, sceneColor(0xf08a4b), false}, {kEndless, sceneColor(0xc23b2e), false}};
}

std::size_t mapClassOf(const std::vector<MapClass>& classes, double value) {
  if (!(value > 0.0)) {
    return classes.size();
  }
  std::size_t k = 0;
  while (k < classes.size() && value > classes[k].upperBound) {
    ++k;
  }
  return k;
}

} // namespace dewpoint::ui
