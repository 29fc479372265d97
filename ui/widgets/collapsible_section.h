// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QWidget>

class QLabel;
class QToolButton;
class QVBoxLayout;

namespace dewpoint::ui {

/// Section of a form under a heading that opens and closes it, with a dot if something inside
/// deserves notice. Closed at first. The texts keep the language in which it was created.
class CollapsibleSection : public QWidget {
  Q_OBJECT
public:
  explicit CollapsibleSection(const QString& title, QWidget* parent = nullptr);

  /// Adds a widget below the others.
  void addWidget(QWidget* widget);
  bool isOpen() const;
  void setOpen(bool open);
  /// Shows a dot behind the heading, with a hint; an empty hint removes it.
  void setMark(const QString& hint);

Q_SIGNALS:
  /// The user opened or closed the section.
  void openedByUser(bool open);

private:
  QToolButton* head_;
  QLabel* mark_;
  QWidget* body_;
  QVBoxLayout* rows_;
};

} // namespace dewpoint::ui
