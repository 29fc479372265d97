// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/scene3d/scene_palette.h"

#include <vector>

namespace dewpoint::ui {

/// What a map of a rig shows of each position.
enum class MapQuantity {
  Sigma,      ///< expected error: one standard deviation along the worst direction
  CameraCount ///< how many cameras see it
};

/// How a map of a rig is drawn.
struct MapLook {
  MapQuantity quantity = MapQuantity::Sigma;
  bool slice = true;        ///< a horizontal layer of it
  double height = 0.0;      ///< of the layer, meters
  bool volume = false;      ///< the surfaces between some of the classes
  double goodSigma = 0.005; ///< what is good enough, meters: the center of the scale

  bool operator==(const MapLook&) const = default;
};

/// Values that are drawn in one color: those up to `bound` that are in no class before.
struct MapClass {
  double bound; ///< meters or cameras; infinite for the last one of a Sigma
  SceneColor color;
  bool surface; ///< of a volume: its outer surface is drawn
};

/// The classes of a map, by growing bound. Sigma: three blues up to what is good enough, three warm
/// colors beyond (after ColorBrewer's RdYlBu, which color-blind people can tell apart).
/// CameraCount: one (warm), then two, three, four, and more (blues); none is not drawn.
std::vector<MapClass> mapClasses(const MapLook& look);

/// Index into the classes; their number when a value is not drawn (NaN, no camera).
std::size_t classOf(const std::vector<MapClass>& classes, double value);

} // namespace dewpoint::ui
