// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QFrame>
#include <QIcon>
#include <QString>

#include <functional>
#include <vector>

class QLineEdit;
class QListWidget;

namespace dewpoint::ui {

class ActionRegistry;

/// A search field over all actions: type a part of a name, choose with the arrows, run with Enter.
class CommandPalette : public QFrame {
  Q_OBJECT
public:
  CommandPalette(ActionRegistry& registry, QWidget* window);

  /// One action or other command, as it is listed.
  struct Entry {
    QString group;
    QString name;
    QString hint;
    QString keys = {};
    QIcon icon = {};
    std::function<void()> run;
  };
  /// What can be done besides the actions, requested each time the palette opens.
  void setMore(std::function<std::vector<Entry>()> more) { more_ = std::move(more); }

  /// Opens over the top of the window, with an empty search.
  void open();

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  void filter(const QString& search);
  static int fitOf(const QString& search, const Entry& entry);
  void runCurrent();
  std::vector<Entry> everything() const;

  ActionRegistry& registry_;
  QLineEdit* search_;
  QListWidget* list_;
  std::function<std::vector<Entry>()> more_;
  std::vector<Entry> entries_; ///< while it is open
};

/// No fit at all; one whose letters are scattered over the text is above it and below 0.
constexpr int kNoFit = -1'000'000;

/// How well `search` fits `text`. From 0 on: all words of it are found, in any order, best at
/// beginnings of words. Below: all its letters are found in order, as in "sm" for "Show mask".
/// Case does not count.
int fitOf(const QString& search, const QString& text);

/// Where words were found, scattered letters are no fit.
void dropScattered(std::vector<int>& fits);

} // namespace dewpoint::ui
