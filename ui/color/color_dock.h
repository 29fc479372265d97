// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/cameraview/image_menu.h"
#include "ui/workbench/workbench.h"

#include <vector>

namespace dewpoint::ui {

class CameraDocks;
class ColorPanel;
class ImagePickTool;
class TargetPanel;
class ViewDock;
struct TargetDock;

/// The color of the chosen target in the window. What was learned from a click in a camera image
/// is chosen, and the run may begin.
class ColorDock : public QObject {
  Q_OBJECT
public:
  ColorDock(const Workbench& bench, const CameraDocks& cameras, const TargetDock& targets);

  ViewDock* dock() const { return dock_; }
  ColorPanel& panel() const { return *panel_; }

private:
  void connectActions();
  void nameLearning();
  /// What the menu of an image offers at a pixel of it.
  std::vector<ImageMenuEntry> menuEntries(ImagePickTool& pick, int camera, const QPointF& pixel);
  void learned(int target, bool isNew);

  Workbench bench_;
  ViewDock* targetDock_;
  TargetPanel* targets_;
  ColorPanel* panel_;
  ViewDock* dock_;
};

} // namespace dewpoint::ui
