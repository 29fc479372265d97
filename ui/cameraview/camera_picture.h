// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/world_box.h"
#include "ui/cameraview/camera_image.h"
#include "ui/cameraview/image_placement.h"

#include <QImage>
#include <QPalette>
#include <QRectF>
#include <QSize>
#include <QString>

#include <optional>

class QPainter;

namespace dewpoint::ui {

/// Layers of a camera view that users can switch on and off.
struct CameraViewOptions {
  bool isMaskShown = false;
  bool isLikelihoodShown = false;   ///< likelihood maps and candidate positions
  bool isBestParticleShown = false; ///< each target's highest-weight particle
  bool isMagnifierShown = false;    ///< inset that enlarges a small particle cloud
  std::optional<WorldBox> volume;   ///< volume of interest; empty: no outline is shown
  int chosenTarget = -1;            ///< selected target; -1: none
  QPalette palette;
};

/// Returns the frame of a camera in a snapshot, or null if there is none.
FramePtr frameOf(const TrackSnapshotPtr& snapshot, int camera);

/// Returns the input for drawing a whole camera image in this size (device pixels) with the layers
/// that `look` switches on. The frame of the input is null if there is no image.
CameraImageSource makeImageSource(const TrackSnapshotPtr& snapshot, int camera,
                                  const CameraViewOptions& look, const QSize& size);

/// Position and visible part of a camera image in its view.
struct CameraImageArea {
  ImagePlacement placement;
  QRectF visibleArea; ///< visible part of the image
  bool isZoomed = false;
};

/// Paints everything over the pixels of a camera view: likelihood maps, the volume of interest,
/// people, particles and estimates, the inset, the zoom factor and the marker of a moved camera.
/// `look` selects what is painted, and `place` is the position of the image in the view. `image`
/// must have been drawn from a frame of `snapshot`. May be called from any thread.
void paintEstimates(QPainter& painter, const CameraImage& image, const TrackSnapshotPtr& snapshot,
                    const CameraViewOptions& look, const CameraImageArea& place);

/// Returns the text that a camera view shows if there is no image.
QString missingImageText(const TrackSnapshotPtr& snapshot, int camera);

/// Returns the background color around an image in a camera view.
QColor imageBackgroundColor(const QPalette& palette);

/// Returns an image of this size (pixels) that looks like a camera view, with the whole camera
/// image fitted into it. May be called from any thread.
QImage cameraPicture(const TrackSnapshotPtr& snapshot, int camera, const CameraViewOptions& look,
                     const QSize& size);

} // namespace dewpoint::ui
