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

/// Creates one dock with a camera view for each camera in the project, again for each run. The
/// title of a dock shows the state of its view and the reason for this state. Also connects the
/// actions shared by all camera views.
class CameraDocks : public QObject {
  Q_OBJECT
public:
  explicit CameraDocks(const Workbench& bench);

  /// Returns the tool that handles mouse and keyboard input of all camera images.
  ImagePickTool& pickTool() const { return *pick_; }
  /// Returns the context menu of all camera images. Features add their entries to it.
  ImageMenu& imageMenu() const { return *menu_; }

  /// Replaces all docks by new ones for the project's cameras, and resets the layout.
  void makeDocks();

Q_SIGNALS:
  /// Emitted when a camera view was created, so that overlays can be added to it.
  void viewCreated(int camera, CameraView* view);

private:
  void connectActions();
  void connectZoom();
  /// Returns the view that the zoom actions apply to: the view under the pointer, or else the
  /// selected camera's view, or else the first visible view. Returns null if there is none.
  CameraView* viewToZoom() const;
  void zoom(double factor);
  void updateTitles();

  Workbench bench_;
  ImagePickTool* pick_;
  ImageMenu* menu_;
  std::vector<ViewDock*> docks_;
  std::vector<CameraView*> views_;
  /// Volume of interest in world coordinates (meters); empty while it is hidden.
  std::optional<WorldBox> volume_;
};

} // namespace dewpoint::ui
