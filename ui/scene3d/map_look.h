// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/scene3d/scene_palette.h"

#include <vector>

namespace dewpoint::ui {

/// Quantity that a map of a rig shows.
enum class MapQuantity {
  Sigma,      ///< expected error: standard deviation along the worst direction
  CameraCount ///< number of cameras that see the position
};

/// Appearance of a map of a rig.
struct MapLook {
  MapQuantity quantity = MapQuantity::Sigma;
  bool slice = true;   ///< shows a horizontal layer
  double height = 0.0; ///< height of the layer, meters
  bool volume = false; ///< shows the surfaces between some of the classes
  /// standard deviation that is good enough, meters: center of the color scale
  double goodSigma = 0.005;

  bool operator==(const MapLook&) const = default;
};

/// Class of values drawn in one color: values up to `bound` that belong to no earlier class.
struct MapClass {
  double bound; ///< meters or number of cameras; infinite for the last class of Sigma
  SceneColor color;
  bool surface; ///< whether the outer surface is drawn when the volume is shown
};

/// Returns the classes of a map, by increasing bound. Sigma: three blues up to the good value,
/// three warm colors above it (after the RdYlBu scale of ColorBrewer, which color-blind people can
/// read). CameraCount: one camera (warm); two, three, four, and more (blues). Positions without a
/// camera are not drawn.
std::vector<MapClass> mapClasses(const MapLook& look);

/// Returns the index of the class of a value; the number of classes if the value is not drawn (NaN,
/// no camera).
std::size_t classOf(const std::vector<MapClass>& classes, double value);

} // namespace dewpoint::ui
