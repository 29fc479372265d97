// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/workbench/image_grid.h"
#include "ui/workbench/view_dock.h"
#include "ui/workbench/view_sizes.h"

#include <vector>

class QMainWindow;

namespace dewpoint::ui {

class Document;

/// Default arrangement of the docks in the window: the position of each dock, and the sizes that
/// suit the window. DockManager decides when to apply it.
class DockArrangement {
public:
  DockArrangement(QMainWindow& window, const Document& document)
      : window_(window), document_(document) {}

  /// Returns all docks, in the order of the window's children.
  std::vector<ViewDock*> docks() const;
  /// Returns the docks at one position, in their order in this area.
  std::vector<ViewDock*> docksAt(DockArea place) const;
  /// Returns the first dock at a position, or null if there is none.
  ViewDock* firstDockAt(DockArea place) const;

  /// Removes all docks from the window and adds them at their default positions.
  void placeDocks();
  /// Returns the number of columns of camera views, or 0 if they have not been placed yet.
  int cameraColumnCount() const { return cameraColumnCount_; }
  /// Sets the number of columns of camera views that the next `placeDocks()` uses.
  void setCameraColumnCount(int columns) { cameraColumnCount_ = columns; }
  /// Returns the number of columns of camera views with which the images are largest. If there are
  /// no cameras, returns the current number.
  int bestCameraColumnCount() const;
  /// Resizes the docks to suit the window. The camera views must already be placed in
  /// bestCameraColumnCount() columns.
  void distributeSizes();

private:
  void placeCameras(ViewDock* scene);
  ViewSizes viewSizes() const;
  ImageGrid cameraGrid(const QSize& room) const;
  void distributeCameras(const ImageGrid& grid, int height);

  QMainWindow& window_;
  const Document& document_;
  int cameraColumnCount_ = 0;
};

} // namespace dewpoint::ui
