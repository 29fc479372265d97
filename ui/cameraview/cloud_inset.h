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

/// Enlarges a cloud of particles that is too small to be seen in its camera view, in a corner of
/// the view away from it: the image around it, its particles, the 95 % ellipse where that is as
/// small, and a bar that says how large a pixel is. A thin line leads to the place.
struct CloudInset {
  const CameraOverlay& overlay; ///< of a target that is tracked
  const cv::Mat& image;         ///< CV_8UC3
  ImagePlacement placement;
  QRectF area; ///< what is seen of the image, widget units
  QColor color;
  ParticleRamp ramp;
  std::vector<QRectF> taken; ///< of that area, by something else
};

/// Draws it if the cloud is small and seen, and there is room.
void paintCloudInset(QPainter& painter, const CloudInset& inset);

} // namespace dewpoint::ui
