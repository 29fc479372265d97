// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/workbench/workbench.h"

namespace dewpoint::ui {

/// The history of changes in the window, and the actions that go back and forth in it.
class HistoryDock : public QObject {
  Q_OBJECT
public:
  explicit HistoryDock(const Workbench& bench);

  /// Names the step that would be taken back, or made again, in the actions: menus and lists of
  /// actions say what would happen.
  void nameSteps();

private:
  Workbench bench_;
};

} // namespace dewpoint::ui
