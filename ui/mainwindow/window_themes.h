// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/preferences/preferences.h"
#include "ui/workbench/workbench.h"

namespace dewpoint::ui {

class SystemColors;

/// The colors of the window: those of the theme chosen in the menu, or of the system, which may
/// change while the program runs.
class WindowThemes : public QObject {
  Q_OBJECT
public:
  /// The actions are there already.
  explicit WindowThemes(const Workbench& bench);

  void set(Theme theme);
  Theme theme() const { return theme_; }

private:
  Workbench bench_;
  SystemColors* systemColors_;
  Theme theme_ = Theme::System;
};

} // namespace dewpoint::ui
