// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include <cstddef>

class QLabel;
class QProgressBar;

namespace dewpoint::ui {

class BoardCalibrator;

/// Window that tells the person who holds the board how to hold it next, in letters large enough to
/// be read from across the room. A sound is played when a view is captured. Esc closes the window.
class RoomDisplay : public QWidget {
  Q_OBJECT
public:
  explicit RoomDisplay(BoardCalibrator& calibrator, QWidget* parent);

protected:
  void resizeEvent(QResizeEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

private:
  void refresh();
  void fitText();

  BoardCalibrator& calibrator_;
  QLabel* camera_;
  QLabel* advice_;
  QLabel* count_;
  QProgressBar* held_;
  std::size_t captured_ = 0; ///< number of captured views at the last refresh
};

} // namespace dewpoint::ui
