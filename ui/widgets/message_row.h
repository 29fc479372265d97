// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QToolBar>

namespace dewpoint::ui {

class MessageBar;
class NoticeList;

/// Row under the toolbar for messages and, below them, notices. A message pushes the views down and
/// covers nothing; without a message, the row has no height. It is a toolbar so that the window
/// gives it a row. It is always shown, so that restoring a layout neither shows nor hides a
/// message.
class MessageRow : public QToolBar {
  Q_OBJECT
public:
  /// Takes ownership of the bar and the list. Add the row to a window below its other toolbars.
  MessageRow(MessageBar* bar, NoticeList* notices, QWidget* parent = nullptr);

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

Q_SIGNALS:
  /// Emitted when the height is about to change.
  void heightChanging();
  void heightChanged();

protected:
  void resizeEvent(QResizeEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  /// Returns the height that a part needs at the width of the row; 0 while it is hidden.
  int neededHeight(const QWidget* part) const;
  void fit();

  QWidget* bar_;
  QWidget* notices_;
};

} // namespace dewpoint::ui
