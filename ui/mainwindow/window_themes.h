// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/preferences/preferences.h"
#include "ui/workbench/workbench.h"

namespace dewpoint::ui {

class SystemColors;

/// Manages the colors of the window: the colors of the theme selected in the menu, or the system
/// colors, which may change while the program runs.
class WindowThemes : public QObject {
  Q_OBJECT
public:
  /// Connects the theme actions, which must already exist in the workbench.
  explicit WindowThemes(const Workbench& bench);

  void setTheme(Theme theme);
  Theme theme() const { return theme_; }

private:
  Workbench bench_;
  SystemColors* systemColors_;
  Theme theme_ = Theme::System;
};

} // namespace dewpoint::ui
