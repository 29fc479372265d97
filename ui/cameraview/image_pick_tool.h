// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/cameraview/image_pick_overlay.h"

#include <QObject>

#include <utility>
#include <vector>

namespace dewpoint::ui {

class CameraListModel;

/// The mouse and the keys in all camera images: a click or a dragged box goes to the tool that
/// requested one, and otherwise selects.
class ImagePickTool : public QObject {
  Q_OBJECT
public:
  /// `cameras`: what their images are called.
  explicit ImagePickTool(const CameraListModel& cameras, QObject* parent = nullptr);

  /// From now on the user can point at objects in this view; views that are gone are forgotten.
  void attach(int camera, CameraView* view);
  /// Whether a plain click picks, and what for, as is shown at the lower edge of the images.
  void setPicking(bool picking, const QString& hint);
  /// Picks a pixel of a camera's image in place of a click there with these modifiers.
  void pickAt(int camera, const QPointF& pixel, Qt::KeyboardModifiers modifiers);
  /// Gives the first image the focus: the keys move its cross.
  void takeFocus();
  /// Outlines regions of a camera's image.
  void setRegions(int camera, const std::vector<ImagePickOverlay::Region>& regions);
  void clearRegions();

Q_SIGNALS:
  void attached();
  /// A click (an empty size) or a dragged box in the image of a camera, pixels.
  void picked(int camera, const QRectF& region, Qt::KeyboardModifiers modifiers);
  /// Esc: nothing more is to be picked.
  void cancelled();
  /// A plain click while nothing is being picked: the camera, and where that was, pixels.
  void cameraChosen(int camera);
  void imageClicked(int camera, const QPointF& pixel);

private:
  const CameraListModel& cameras_;
  std::vector<std::pair<int, ImagePickOverlay*>> layers_;
};

} // namespace dewpoint::ui
