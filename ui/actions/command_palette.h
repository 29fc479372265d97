// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <QIcon>
#include <QString>

#include <functional>
#include <vector>

class QLineEdit;
class QListWidget;

namespace dewpoint {

class ActionRegistry;

/// A search field over all actions: type a part of a name, choose with the arrows, run with Enter.
class CommandPalette : public QFrame {
  Q_OBJECT
public:
  CommandPalette(ActionRegistry& registry, QWidget* window);

  /// One thing that can be done, as it is listed.
  struct Entry {
    QString group;
    QString name;
    QString hint;
    QString keys = {};
    QIcon icon = {};
    std::function<void()> run;
  };
  /// What can be done besides the actions, asked for each time the palette opens.
  void setMore(std::function<std::vector<Entry>()> more) { more_ = std::move(more); }

  /// Opens over the top of the window, with an empty search.
  void open();

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  void filter(const QString& search);
  void runCurrent();
  std::vector<Entry> everything() const;

  ActionRegistry& registry_;
  QLineEdit* search_;
  QListWidget* list_;
  std::function<std::vector<Entry>()> more_;
  std::vector<Entry> entries_; ///< while it is open
};

/// How well `search` fits `text`: every letter in order, better the closer together and the nearer
/// to beginnings of words; negative when it does not fit. Case does not count.
int fitOf(const QString& search, const QString& text);

} // namespace dewpoint
