// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QToolBar>

namespace dewpoint::ui {

class MessageBar;

/// Row under the toolbar for messages. A message pushes the views down and covers nothing; without
/// a message, the row has no height. It is a toolbar so that the window gives it a row. It is
/// always shown, so that restoring a layout neither shows nor hides a message.
class MessageRow : public QToolBar {
  Q_OBJECT
public:
  /// Takes ownership of the bar. Add the row to a window below its other toolbars.
  explicit MessageRow(MessageBar* bar, QWidget* parent = nullptr);

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
  int neededHeight() const;
  void fit();

  MessageBar* bar_;
};

} // namespace dewpoint::ui
