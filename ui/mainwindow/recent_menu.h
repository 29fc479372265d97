// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QObject>
#include <QPointer>
#include <QString>

class QMenu;

namespace dewpoint::ui {

class RecentProjects;

/// Menu of recent projects.
class RecentMenu : public QObject {
  Q_OBJECT
public:
  explicit RecentMenu(RecentProjects& recent, QObject* parent = nullptr);

  /// Fills a menu that is about to be shown. Entries whose files turn out to be missing disappear
  /// while the menu is open.
  void fill(QMenu* menu);

Q_SIGNALS:
  void openRequested(const QString& file);

private:
  void fillEntries();

  RecentProjects& recent_;
  QPointer<QMenu> menu_; ///< menus are recreated after a language change
};

} // namespace dewpoint::ui
