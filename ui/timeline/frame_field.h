// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QFrame>

class QLabel;
class QLineEdit;

namespace dewpoint::ui {

class Timeline;

/// Small field on the timeline in which the user enters a frame number or a time. Enter shows this
/// frame, Esc closes the field. If there is no such frame, the field stays open, and a sentence
/// below it states what can be entered.
class FrameField : public QFrame {
  Q_OBJECT
public:
  explicit FrameField(Timeline& timeline);

  /// Opens the field at the current frame, with the keyboard focus. It contains the number of this
  /// frame, selected.
  void open(qint64 currentFrame);

protected:
  /// Handles Esc and the loss of the focus, which close the field.
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  void goToEntered();
  void close(bool returnsFocus);
  void showProblem(const QString& sentence);
  void place();

  Timeline& timeline_;
  QLineEdit* edit_;
  QLabel* problem_;
  qint64 openedAt_ = 0;
};

} // namespace dewpoint::ui
