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

/// Creates one dock with a camera view for each camera of the project, again for each run. The
/// title of a dock shows the state of the view and the reason for it. Also connects the actions
/// that all camera views share.
class CameraDocks : public QObject {
  Q_OBJECT
public:
  explicit CameraDocks(const Workbench& bench);

  /// Mouse and key input of all camera images.
  ImagePickTool& pick() const { return *pick_; }
  /// Context menu of all camera images; features add their entries to it.
  ImageMenu& menu() const { return *menu_; }

  /// Replaces all docks by new ones for the cameras of the project, and resets the layout.
  void make();

Q_SIGNALS:
  /// The view of a camera was created; overlays are added to it now.
  void viewMade(int camera, CameraView* view);

private:
  void connectActions();
  void connectZoom();
  /// Returns the view that the zoom actions apply to: the view under the pointer, else that of the
  /// selected camera, else the first visible one. Null if there is none.
  CameraView* viewToZoom() const;
  void zoom(double factor);
  void explain();

  Workbench bench_;
  ImagePickTool* pick_;
  ImageMenu* menu_;
  std::vector<ViewDock*> docks_;
  std::vector<CameraView*> views_;
  /// Volume of interest, world coordinates in meters; empty while it is hidden.
  std::optional<WorldBox> volume_;
};

} // namespace dewpoint::ui
