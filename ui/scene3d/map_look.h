// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/scene3d/scene_palette.h"

#include <vector>

namespace dewpoint::ui {

/// Quantity shown in a rig's map.
enum class MapQuantity {
  Sigma,      ///< expected error: standard deviation along the worst direction
  CameraCount ///< number of cameras that see the position
};

/// Appearance of a rig's map.
struct MapOptions {
  MapQuantity quantity = MapQuantity::Sigma;
  bool showsLayer = true;   ///< shows a horizontal layer
  double layerHeight = 0.0; ///< height of the layer, meters
  bool showsVolume = false; ///< shows surfaces between some color classes (MapClass::hasSurface)
  /// Standard deviation (meters) that is good enough; it is the center of the color scale.
  double maxGoodSigma = 0.005;

  bool operator==(const MapOptions&) const = default;
};

/// Class of map values drawn in one color: values up to `upperBound` and above the bound of the
/// preceding class.
struct MapClass {
  double upperBound; ///< meters, or number of cameras; infinite for the last Sigma class
  SceneColor color;
  bool hasSurface; ///< whether the outer surface is drawn if the volume is shown
};

/// Returns the classes of a map, in increasing order of bound. Sigma: three blues up to the good
/// value and three warm colors above it, after the RdYlBu scale of ColorBrewer, which color-blind
/// users can distinguish. CameraCount: a warm color for one camera, and blues for two, three, four,
/// and more cameras. Positions not seen by any camera are not drawn.
std::vector<MapClass> mapClasses(const MapOptions& look);

/// Returns the index of the class of a value, or the number of classes if the value is not drawn
/// (NaN, or no camera).
std::size_t mapClassOf(const std::vector<MapClass>& classes, double value);

} // namespace dewpoint::ui
