// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QPointer>
#include <QToolBar>

class QTimer;

namespace dewpoint::ui {

class MessageBar;
class NoticeList;

/// Row under the toolbar of the window, for messages and, below them, notices. A message pushes the
/// views down and covers nothing; without a message, the row has no height. The row is a toolbar so
/// that the window reserves room for it. It is never hidden, so restoring a layout neither shows
/// nor hides a message.
///
/// While the user types in a field or holds a mouse button down, the row keeps its height, so that
/// nothing moves: a message that disappears leaves an empty area, and a new message covers a part
/// of the views. The row adjusts its height when the user has left the field.
class MessageRow : public QToolBar {
  Q_OBJECT
public:
  /// Creates a row with the message bar and the list of notices, which become children of `parent`.
  /// The caller must add the row to the window `parent` below its other toolbars.
  MessageRow(MessageBar* bar, NoticeList* notices, QWidget* parent);

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

Q_SIGNALS:
  /// Emitted when the height of the row is about to change.
  void heightAboutToChange();
  void heightChanged();

protected:
  void showEvent(QShowEvent* event) override;
  void moveEvent(QMoveEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  /// Returns the height that a part needs at the width of the row; 0 while it is hidden.
  int neededHeight(const QWidget* part) const;
  int neededHeight() const;
  void fit();
  /// Returns where the row is in the window, or where it would be if it had a height.
  QRect place() const;
  void placeParts();
  /// Sets the height of the row to the height that its parts need.
  void takeNeededHeight();
  /// Returns whether the row should keep its height for now, although the parts need another one.
  bool keepsHeight(int wanted) const;
  /// Follows the keyboard focus: the user continues typing in the next field of a form, and stops
  /// elsewhere.
  void followFocus(QWidget* before, QWidget* now);
  /// Waits until the row may take its proper height.
  void waitForQuiet(bool waits);

  QPointer<QWidget> bar_; // the window, not the row, ends them
  QPointer<QWidget> notices_;
  QTimer* watch_;
  QPointer<QWidget> typedIn_; ///< field of the form in which the user types
  int quietTicks_ = 0;        ///< ticks of `watch_` since a key was pressed
};

} // namespace dewpoint::ui
