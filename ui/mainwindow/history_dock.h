// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/workbench/workbench.h"

namespace dewpoint::ui {

/// Dock with the history of changes to the project, and the undo and redo actions.
class HistoryDock : public QObject {
  Q_OBJECT
public:
  explicit HistoryDock(const Workbench& bench);

  /// Names the next step in the texts of the undo and redo actions, so that menus and lists of
  /// actions show their effect.
  void updateActionTexts();

private:
  Workbench bench_;
};

} // namespace dewpoint::ui
