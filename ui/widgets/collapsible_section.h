// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QWidget>

class QLabel;
class QToolButton;
class QVBoxLayout;

namespace dewpoint::ui {

/// Form section under a heading that opens and closes it. The heading has a dot if something inside
/// needs attention. Initially closed. The texts keep the language in which the section was created.
class CollapsibleSection : public QWidget {
  Q_OBJECT
public:
  explicit CollapsibleSection(const QString& title, QWidget* parent = nullptr);

  /// Adds a widget to the section, below the widgets added before.
  void addWidget(QWidget* widget);
  bool isOpen() const;
  void setOpen(bool open);
  /// Shows a dot after the heading, with a hint. An empty hint removes the dot.
  void setAttentionHint(const QString& hint);

Q_SIGNALS:
  /// Emitted when the user opens or closes the section.
  void openedByUser(bool open);

private:
  QToolButton* header_;
  QLabel* mark_;
  QWidget* body_;
  QVBoxLayout* rows_;
};

} // namespace dewpoint::ui
