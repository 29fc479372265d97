// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/snapshot/snapshot.h"
#include "ui/workbench/workbench.h"

#include <QObject>

#include <vector>

namespace dewpoint::ui {

class CameraView;
class ImagePickOverlay;
class WorldMarks;

/// Mouse and keyboard input for the marks A, B and C of the page "Floor". While marking, a click or
/// a drag in a camera image places the selected mark there, and the other images show the ray
/// through it. All marks are shown with their letters.
class WorldMarkTool : public QObject {
  Q_OBJECT
public:
  WorldMarkTool(const Workbench& bench, WorldMarks& marks, QObject* parent);

  /// Adds a camera view, which may be deleted at any time.
  void attach(int camera, CameraView* view);
  /// Sets the snapshot whose images are shown. Clicks snap to corners in these images.
  void setSnapshot(const TrackSnapshotPtr& snapshot);

private:
  struct Layer {
    int camera;
    ImagePickOverlay* overlay;
  };
  void refresh();
  void showMarks(const Layer& layer) const;

  Workbench bench_;
  WorldMarks& marks_;
  std::vector<Layer> layers_;
  TrackSnapshotPtr snapshot_;
};

} // namespace dewpoint::ui
