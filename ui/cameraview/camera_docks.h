// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/world_box.h"
#include "ui/workbench/workbench.h"

#include <QObject>

#include <optional>
#include <vector>

namespace dewpoint::ui {

class CameraView;
class ImageMenu;
class ImagePickTool;
class ViewDock;

/// One dock for each camera of the project, made again with each run: its view, in the title the
/// state of what it shows and why, and the actions that all camera views share.
class CameraDocks : public QObject {
  Q_OBJECT
public:
  explicit CameraDocks(const Workbench& bench);

  /// The mouse and the keys in all the images.
  ImagePickTool& pick() const { return *pick_; }
  /// The menu of all the images: features add what they offer.
  ImageMenu& menu() const { return *menu_; }

  /// Docks for the cameras of the project, in place of those there are, and a fresh layout.
  void make();

Q_SIGNALS:
  /// There is a new view of this camera: what lies over the image is added now.
  void viewMade(int camera, CameraView* view);

private:
  void connectActions();
  void connectZoom();
  /// What the zoom actions are about: the view under the pointer, else that of the selected camera,
  /// else the first one that is seen; null: there is none.
  CameraView* viewToZoom() const;
  void zoom(double factor);
  void explain();

  Workbench bench_;
  ImagePickTool* pick_;
  ImageMenu* menu_;
  std::vector<ViewDock*> docks_;
  std::vector<CameraView*> views_;
  std::optional<WorldBox> volume_; ///< of interest, while it is shown
};

} // namespace dewpoint::ui
