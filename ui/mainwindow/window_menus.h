// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/actions/command_palette.h"
#include "ui/workbench/workbench.h"

#include <functional>
#include <initializer_list>
#include <vector>

class QMenu;

namespace dewpoint::ui {

/// The menus of the window, and the palette that finds everything in them by its name.
class WindowMenus : public QObject {
  Q_OBJECT
public:
  /// What the menus need of the window.
  struct Owners {
    std::function<void(QMenu*)> fillRecent; ///< with the projects that were open last
    std::function<void(const QString&)> setLanguage;
  };
  WindowMenus(const Workbench& bench, Owners owners);

  /// Makes all menus, and again after a change of language.
  void make();
  void openPalette() { palette_->open(); }
  void openShortcuts();

private:
  QMenu* add(const QString& title, const char* name, std::initializer_list<ActionId> ids);
  void makeFileMenu();
  void makeViewMenu();
  void fillLanguageMenu(QMenu* menu);
  std::vector<CommandPalette::Entry> moreForPalette();

  Workbench bench_;
  Owners owners_;
  CommandPalette* palette_;
  std::vector<QAction*> languages_; ///< of the menu; for the palette
};

} // namespace dewpoint::ui
