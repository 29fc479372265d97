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

/// Corrections of positions in the window: a mode in which targets are dragged in the images
/// ("It is here"), and how corrections are taken away. Each is a step of the document, from which
/// the machine takes up what to track again.
class CorrectionMode : public QObject {
  Q_OBJECT
public:
  CorrectionMode(const Workbench& bench, const CameraDocks& cameras, BirdsEyeView& birdsEye,
                 TrajectoryPanel& trajectory);

private:
  void connectActions();
  /// What the menu of an image offers at a pixel of it.
  std::vector<ImageMenuEntry> menuEntries(int camera, const QPointF& pixel);
  void end();
  void setActive(bool active);
  void keep(const PositionCorrection& correction);
  /// Takes away the corrections at a frame; of one target, or of all (-1).
  void remove(std::int64_t frame, int target);

  Workbench bench_;
  CorrectionTool* tool_;
  BackwardTracker* backwards_;
  int kept_ = 0; ///< corrections so far: steps of each merge with it alone
};

} // namespace dewpoint::ui
