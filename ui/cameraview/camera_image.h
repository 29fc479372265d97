// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QColor>
#include <QImage>
#include <QRect>
#include <QSize>
#include <opencv2/core/mat.hpp>

#include <memory>
#include <vector>

namespace dewpoint::capture {
struct Frame;
} // namespace dewpoint::capture
namespace dewpoint::session {
struct TrackSnapshot;
} // namespace dewpoint::session

namespace dewpoint::ui {

using FramePtr = std::shared_ptr<const Frame>;
using TrackSnapshotPtr = std::shared_ptr<const TrackSnapshot>;

/// Input from which the pixels of a camera view are drawn. It keeps its data alive, so that two
/// inputs can be compared by the addresses of their data.
struct CameraImageSource {
  int camera = 0;
  FramePtr frame; ///< frame with the image to draw; null: no image
  /// Pixels with a target color or motion; ignored if its size differs from the image.
  cv::Mat mask;
  bool isMotionMask = false;      ///< true: the mask shows moving pixels instead of targets
  std::vector<QColor> maskColors; ///< colors in which the mask is drawn, one per target
  QRect imagePart;                ///< part of the image to draw, pixels
  QSize size;                     ///< size of `imagePart` on the screen, device pixels
  bool isZoomed = false;          ///< true: enlarged pixels are drawn as squares
  TrackSnapshotPtr mapSnapshot;   ///< snapshot whose maps are drawn; null for none

  bool operator==(const CameraImageSource& other) const;
};

/// Drawn pixels of a camera view, with the input from which they were drawn.
struct CameraImage {
  CameraImageSource source;
  QImage image;
  std::vector<QImage> likelihoodMaps; ///< one per target; null if a target has no map
  QImage motionMap;                   ///< map of the whole image; null if there is none
};

/// Draws the pixels of a camera view. Slow for large images. May be called from any thread.
CameraImage drawCameraImage(const CameraImageSource& source);

} // namespace dewpoint::ui
