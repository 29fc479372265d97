// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/workbench/image_grid.h"
#include "ui/workbench/view_dock.h"
#include "ui/workbench/view_shares.h"

#include <vector>

class QMainWindow;

namespace dewpoint::ui {

class Document;

/// The arrangement that the window begins with: where each dock stands, and which sizes suit the
/// window. It moves the docks when DockManager calls it.
class DockArrangement {
public:
  DockArrangement(QMainWindow& window, const Document& document)
      : window_(window), document_(document) {}

  /// All docks there are, in the order of the window's children.
  std::vector<ViewDock*> docks() const;
  /// Those of one place, by rank.
  std::vector<ViewDock*> at(DockPlace place) const;
  /// Null: there is none.
  ViewDock* first(DockPlace place) const;

  /// Takes all docks out of the window and puts them where they belong.
  void place();
  /// In how many columns the cameras stand; 0: not placed yet.
  int cameraColumns() const { return cameraColumns_; }
  /// With the next place().
  void setCameraColumns(int columns) { cameraColumns_ = columns; }
  /// The columns in which the images are largest; without cameras those they have.
  int bestCameraColumns() const;
  /// Gives the docks the sizes that suit the window; the cameras stand in the best columns.
  void distributeSizes();

private:
  void placeCameras(ViewDock* scene);
  ViewShares shares() const;
  ImageGrid cameraGrid(const QSize& room) const;
  void distributeCameras(const ImageGrid& grid, int height);

  QMainWindow& window_;
  const Document& document_;
  int cameraColumns_ = 0;
};

} // namespace dewpoint::ui
