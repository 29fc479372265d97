// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QDialog>

#include <functional>

class QKeySequenceEdit;
class QLabel;
class QLineEdit;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;
class QAction;

namespace dewpoint::ui {

class ActionRegistry;

/// Dialog that lists all actions with their shortcuts. The user presses keys to change a shortcut;
/// changes take effect immediately. Not modal.
class ShortcutEditor : public QDialog {
  Q_OBJECT
public:
  ShortcutEditor(ActionRegistry& registry, QWidget* parent);

private:
  void fill();
  void filter(const QString& search);
  QAction* current() const;
  void showCurrent();
  void assign();
  /// Shows the string returned by `text` below the list. Calls `text` again after a language
  /// change.
  void showHint(std::function<QString()> text);

  ActionRegistry& registry_;
  QLineEdit* search_;
  QTreeWidget* tree_;
  QKeySequenceEdit* keys_;
  QPushButton* clear_;
  QPushButton* resetAll_;
  QPushButton* close_;
  QLabel* note_;
  std::function<QString()> noteText_;
};

} // namespace dewpoint::ui
