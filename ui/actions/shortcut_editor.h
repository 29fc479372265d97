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

/// All actions with their shortcuts; press the keys to change one. Not modal, takes effect at once.
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
  /// Writes below what `words` returns, and again in every other language.
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
