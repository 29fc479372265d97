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

/// Lists all actions with their shortcuts; the user presses keys to change one. The dialog is not
/// modal, and changes take effect at once.
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
  /// Shows the text that `text` returns below the list, and calls `text` again after a change of
  /// language.
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
