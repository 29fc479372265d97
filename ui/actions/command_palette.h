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

/// Search field over all actions. The user types a part of a name, selects with the arrow keys, and
/// presses Enter to run the action.
class CommandPalette : public QFrame {
  Q_OBJECT
public:
  CommandPalette(ActionRegistry& registry, QWidget* window);

  /// An action or another command, as the list shows it.
  struct Entry {
    QString group;
    QString name;
    QString hint;
    QString keys = {};
    QIcon icon = {};
    std::function<void()> run;
  };
  /// Sets a function that returns commands beyond the actions. It is called each time the palette
  /// opens.
  void setMore(std::function<std::vector<Entry>()> more) { more_ = std::move(more); }

  /// Opens the palette at the top of the window, with an empty search field.
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
  std::vector<Entry> entries_; ///< valid while the palette is open
};

/// Score for no match at all. Matches of scattered letters score between this value and 0.
constexpr int kNoFit = -1'000'000;

/// Returns how well `search` matches `text`. A score of 0 or more: `text` contains all words of
/// `search`, in any order; matches at the start of a word score highest. A negative score: `text`
/// contains all letters in order, as in "sm" for "Show mask". Case is ignored.
int fitOf(const QString& search, const QString& text);

/// Sets all scattered-letter matches to `kNoFit` if at least one match is a word match.
void dropScattered(std::vector<int>& fits);

} // namespace dewpoint::ui
