// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QToolBar>

namespace dewpoint::ui {

class MessageBar;

/// The row under the toolbar in which messages stand: they push the views down and cover nothing.
/// It has no height while there is no message. A toolbar, so that the window gives it a row; it is
/// always shown, so that no layout that is restored brings or takes a message.
class MessageRow : public QToolBar {
  Q_OBJECT
public:
  /// Takes the bar. To be added to a window below its other toolbars.
  explicit MessageRow(MessageBar* bar, QWidget* parent = nullptr);

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

Q_SIGNALS:
  /// Its height is about to change.
  void heightChanging();
  void heightChanged();

protected:
  void resizeEvent(QResizeEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  int wantedHeight() const;
  void fit();

  MessageBar* bar_;
};

} // namespace dewpoint::ui
