// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>

class QLabel;
class QToolButton;

namespace dewpoint {

/// One sentence across the top of the window: what failed, or what is worth knowing. It asks
/// nothing, blocks nothing, and stays until closed or replaced.
class MessageBar : public QFrame {
  Q_OBJECT
public:
  explicit MessageBar(QWidget* parent = nullptr);

  void showError(const QString& text);
  void showNotice(const QString& text);
  QString text() const;

Q_SIGNALS:
  /// There is something to read, or it was closed.
  void wanted(bool visible);

protected:
  void changeEvent(QEvent* event) override;

private:
  void say(const QString& text, bool isError);
  void applyPalette();

  QLabel* mark_;
  QLabel* text_;
  QToolButton* close_;
  bool isError_ = false;
};

} // namespace dewpoint
