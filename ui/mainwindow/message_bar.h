// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>

#include <functional>
#include <vector>

class QLabel;
class QHBoxLayout;
class QPushButton;
class QToolButton;

namespace dewpoint {

/// One sentence across the top of the window: what failed, what is worth knowing, or a question
/// with its answers. It blocks nothing, and stays until closed, answered or replaced.
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
  QString text() const;

Q_SIGNALS:
  /// There is something to read, or it was closed.
  void wanted(bool visible);

protected:
  void changeEvent(QEvent* event) override;

private:
  void say(const QString& text, bool isError);
  void close();
  void clearAnswers();
  void applyPalette();

  QLabel* mark_;
  QLabel* text_;
  QToolButton* close_;
  std::vector<QPushButton*> answers_;
  bool isError_ = false;
};

} // namespace dewpoint
