// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>

class QLineEdit;
class QListWidget;

namespace dewpoint {

class ActionRegistry;

/// A search field over all actions: type a part of a name, choose with the arrows, run with Enter.
class CommandPalette : public QFrame {
  Q_OBJECT
public:
  CommandPalette(ActionRegistry& registry, QWidget* window);

  /// Opens over the top of the window, with an empty search.
  void open();

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  void filter(const QString& search);
  void runCurrent();

  ActionRegistry& registry_;
  QLineEdit* search_;
  QListWidget* list_;
};

/// How well `search` fits `text`: every letter in order, better the closer together and the nearer
/// to beginnings of words; negative when it does not fit. Case does not count.
int fitOf(const QString& search, const QString& text);

} // namespace dewpoint
