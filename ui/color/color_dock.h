// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/cameraview/image_menu.h"
#include "ui/workbench/workbench.h"

#include <QElapsedTimer>

#include <vector>

namespace dewpoint::ui {

class CameraDocks;
class ColorPanel;
class ImagePickTool;
class TargetPanel;
class ViewDock;
struct TargetDock;

/// Dock for the color of the selected target. After a color is learned from a click in a camera
/// image, the dock selects the learned target, and the run starts if the target is new.
class ColorDock : public QObject {
  Q_OBJECT
public:
  ColorDock(const Workbench& bench, const CameraDocks& cameras, const TargetDock& targets);

  ViewDock* dock() const { return dock_; }
  ColorPanel& panel() const { return *panel_; }

private:
  void connectActions();
  void updateLearnActionText();
  /// Starts or ends waiting for a click that teaches the color of the selected target.
  void learn(bool starts);
  /// Starts or ends waiting for a click that adds a target.
  void addTarget(bool starts);
  /// Shows as pressed the action whose click is awaited. While calibration by hand is on, *Learn
  /// the color* also appears pressed if a target is being added, because this action
  /// takes the clicks from the calibration page.
  void showAwaited();
  /// Returns the menu entries offered at a pixel of a camera image.
  std::vector<ImageMenuEntry> menuEntries(ImagePickTool& pick, int camera, const QPointF& pixel);
  void colorLearned(int target, bool isNew);
  /// Shows what was learned. If the mask was not shown before, it is hidden again when the run has
  /// played for a while, because it dims what is tracked.
  void showLearned();
  void hideLearned(const TrackSnapshotPtr& snapshot);

  Workbench bench_;
  ViewDock* targetDock_;
  TargetPanel* targets_;
  ColorPanel* panel_;
  ViewDock* dock_;
  /// True while showAwaited() runs, so that its changes do not count as presses by the user.
  bool showsAwaited_ = false;
  bool isMaskOfLearning_ = false; ///< the mask is shown because a color was learned
  QElapsedTimer playing_;         ///< since the run plays with this mask; invalid while it does not
};

} // namespace dewpoint::ui
