// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/cameraview/image_placement.h"
#include "ui/cameraview/particle_ramp.h"

#include <QColor>
#include <QRectF>
#include <opencv2/core/mat.hpp>

#include <vector>

class QPainter;

namespace dewpoint::session {
struct CameraOverlay;
} // namespace dewpoint::session

namespace dewpoint::ui {

/// Inset in a corner of a camera view that enlarges a particle cloud too small to see. It shows the
/// image around the cloud, the particles, the 95 % ellipse if this is also small, and a scale bar
/// in pixels. A thin line connects the inset with the cloud.
struct CloudInset {
  const CameraOverlay& overlay; ///< overlay of a tracked target
  const cv::Mat& image;         ///< camera image, CV_8UC3
  ImagePlacement placement;
  QRectF area; ///< visible part of the image, widget units
  QColor color;
  ParticleRamp ramp;
  std::vector<QRectF> occupiedAreas; ///< parts of `area` that are already occupied
};

/// Draws the inset if the cloud is small and visible and there is enough room.
void paintCloudInset(QPainter& painter, const CloudInset& inset);

} // namespace dewpoint::ui
