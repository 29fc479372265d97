// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/cameraview/image_pick_overlay.h"

#include <QObject>

#include <utility>
#include <vector>

namespace dewpoint::ui {

class CameraListModel;

/// Mouse and keyboard input of all camera images. A click or a dragged box goes to the tool that
/// requested it. If no tool did, a click selects the camera, or the person at this pixel.
class ImagePickTool : public QObject {
  Q_OBJECT
public:
  /// Creates the tool. `cameras` provides the names of the cameras.
  explicit ImagePickTool(const CameraListModel& cameras, QObject* parent = nullptr);

  /// Lets the user point at objects in this view. Deleted views are removed automatically.
  void attach(int camera, CameraView* view);
  /// Sets whether a plain click picks a pixel for a tool, and which hint is shown at the lower edge
  /// of the images.
  void setPicking(bool picking, const QString& hint);
  /// Picks a pixel of a camera image, as if the user had clicked there with these modifiers.
  void pickAt(int camera, const QPointF& pixel, Qt::KeyboardModifiers modifiers);
  /// Gives the keyboard focus to the first image, so that the keys move its cross.
  void takeFocus();
  /// Outlines regions in a camera image.
  void setRegions(int camera, const std::vector<ImagePickOverlay::Region>& regions);
  void clearRegions();

Q_SIGNALS:
  void viewAttached();
  /// Emitted after a click (`region` has an empty size) or a dragged box in a camera image, in
  /// pixels.
  void picked(int camera, const QRectF& region, Qt::KeyboardModifiers modifiers);
  /// Emitted when Esc is pressed, which ends picking.
  void canceled();
  /// cameraChosen() is emitted when the user presses the mouse button on a camera image, or picks a
  /// pixel with the keyboard. imageClicked() follows for a plain click outside picking mode, with
  /// its position in image pixels.
  void cameraChosen(int camera);
  void imageClicked(int camera, const QPointF& pixel);

private:
  const CameraListModel& cameras_;
  std::vector<std::pair<int, ImagePickOverlay*>> layers_;
};

} // namespace dewpoint::ui
