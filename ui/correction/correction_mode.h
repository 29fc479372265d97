// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/cameraview/image_menu.h"
#include "ui/workbench/workbench.h"

#include <QObject>
#include <QString>

#include <cstdint>
#include <vector>

namespace dewpoint::project {
struct PositionCorrection;
} // namespace dewpoint::project

namespace dewpoint::ui {

class BackwardTracker;
class BirdsEyeView;
class CameraDocks;
class CorrectionTool;
class TrajectoryPanel;

/// Mode for correcting positions. The user drags targets in the images ("Correct position") and
/// removes corrections. Each correction is an undoable step of the document, after which all
/// results that depend on the correction are computed again.
class CorrectionMode : public QObject {
  Q_OBJECT
public:
  CorrectionMode(const Workbench& bench, const CameraDocks& cameras, BirdsEyeView& birdsEye,
                 TrajectoryPanel& trajectory);

private:
  void connectActions();
  /// Returns the menu entries offered at a pixel of a camera image.
  std::vector<ImageMenuEntry> menuEntries(int camera, const QPointF& pixel);
  void end();
  void setActive(bool active);
  void storeCorrection(const PositionCorrection& correction);
  /// Removes the corrections at a frame, for one target or for all targets (-1).
  void remove(std::int64_t frame, int target);

  Workbench bench_;
  CorrectionTool* tool_;
  BackwardTracker* backwardTracker_;
  /// Number of corrections so far; steps merge only within one correction.
  int correctionCount_ = 0;
};

} // namespace dewpoint::ui
