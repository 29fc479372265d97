// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/mainwindow/recent_menu.h"

#include "ui/start/recent_projects.h"

#include <QAction>
#include <QFileInfo>
#include <QMenu>

namespace dewpoint::ui {

RecentMenu::RecentMenu(RecentProjects& recent, QObject* parent) : QObject(parent), recent_(recent) {
  // Queued: an entry of the menu may have changed them, and goes with the others.
  connect(
      &recent, &RecentProjects::changed, this,
      [this] {
        if (menu_ != nullptr && menu_->isVisible()) {
          fillEntries();
        }
      },
      Qt::QueuedConnection);
}

void RecentMenu::fill(QMenu* menu) {
  menu_ = menu;
  fillEntries();
  recent_.checkFiles();
}

void RecentMenu::fillEntries() {
  menu_->clear();
  for (const QString& file : recent_.openableFiles()) {
    QAction* entry = menu_->addAction(QFileInfo(file).completeBaseName());
    entry->setObjectName(QStringLiteral("qt_recent")); // a person's word, in no language of ours
    entry->setToolTip(file);
    connect(entry, &QAction::triggered, this, [this, file] { Q_EMIT openRequested(file); });
  }
  if (menu_->isEmpty()) {
    menu_->addAction(tr("No recent projects"))->setEnabled(false);
    return;
  }
  menu_->addSeparator();
  connect(menu_->addAction(tr("Clear list")), &QAction::triggered, &recent_,
          &RecentProjects::clear);
}

} // namespace dewpoint::ui
