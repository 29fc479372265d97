// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QFrame>

#include <functional>
#include <optional>
#include <vector>

class QLabel;
class QHBoxLayout;
class QPushButton;
class QTimer;
class QToolButton;

namespace dewpoint::ui {

/// One sentence that floats over the top of the window: what failed, what is worth knowing, or a
/// question with its answers. It blocks and moves nothing. What is only worth knowing goes by
/// itself when there was time to read it; the others stay until closed, answered or replaced.
class MessageBar : public QFrame {
  Q_OBJECT
public:
  explicit MessageBar(QWidget* parent = nullptr);

  void showError(const QString& text);
  void showNotice(const QString& text);
  /// An answer: its text, and what it does.
  using Answer = std::pair<QString, std::function<void()>>;
  /// Asks; closing the bar answers nothing.
  void ask(const QString& question, const std::vector<Answer>& answers);
  /// Asks, and asks again whenever another message that replaced the question has gone, until it
  /// was answered or closed.
  void askUntilAnswered(const QString& question, const std::vector<Answer>& answers);
  QString text() const;
  /// Takes away what it says.
  void dismiss();
  /// Other work has begun: an error is over, and with `notices` so is what was worth knowing.
  /// Questions stay.
  void forget(bool notices);
  /// Keeps it below this sibling, in the center of the window.
  void keepBelow(QWidget* above);

protected:
  void enterEvent(QEnterEvent* event) override; ///< whoever points at it reads it
  void leaveEvent(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;
  void changeEvent(QEvent* event) override;

private:
  void setMessage(const QString& text, bool isError);
  void clearAnswers();
  void applyPalette();
  void place();
  void leaveSoon();

  QLabel* mark_;
  QLabel* text_;
  QToolButton* close_;
  QWidget* above_ = nullptr;
  QTimer* leave_;
  std::vector<QPushButton*> answers_;
  bool isError_ = false;
  struct Question {
    QString text;
    std::vector<Answer> answers;
  };
  std::optional<Question> pending_; ///< to be answered
  bool showsPending_ = false;
};

} // namespace dewpoint::ui
