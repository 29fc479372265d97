// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/actions/command_palette.h"
#include "ui/workbench/workbench.h"

#include <functional>
#include <initializer_list>
#include <vector>

class QMenu;

namespace dewpoint::ui {

/// Window menus, and the command palette, which finds every entry by name.
class WindowMenus : public QObject {
  Q_OBJECT
public:
  /// Functions of the window that the menus call.
  struct Callbacks {
    std::function<void(QMenu*)> fillRecent; ///< fills a menu with the recent projects
    std::function<void(const QString&)> setLanguage;
  };
  WindowMenus(const Workbench& bench, Callbacks callbacks);

  /// Creates all menus. Call it again after a language change.
  void makeMenus();
  void openCommandPalette() { palette_->open(); }
  void openShortcuts();

private:
  QMenu* add(const QString& title, const char* name, std::initializer_list<ActionId> ids);
  void makeFileMenu();
  void makeViewMenu();
  void fillLanguageMenu(QMenu* menu);
  std::vector<CommandPalette::Entry> extraPaletteEntries();

  Workbench bench_;
  Callbacks callbacks_;
  CommandPalette* palette_;
  std::vector<QAction*> languages_; ///< actions in the language menu, listed in the palette
};

} // namespace dewpoint::ui
