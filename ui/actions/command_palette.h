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

/// Search field for all actions. The user types part of a name, selects an entry with the arrow
/// keys, and presses Enter to run it.
class CommandPalette : public QFrame {
  Q_OBJECT
public:
  CommandPalette(ActionRegistry& registry, QWidget* window);

  /// List entry: an action or another command.
  struct Entry {
    QString group;
    QString name;
    QString hint;
    QString shortcutText = {};
    QIcon icon = {};
    std::function<void()> run;
  };
  /// Sets a function that returns additional commands. The function is called each time the palette
  /// opens.
  void setExtraEntries(std::function<std::vector<Entry>()> more) {
    extraEntries_ = std::move(more);
  }

  /// Opens the palette at the top of the window, with an empty search field.
  void open();

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  void filter(const QString& search);
  static int matchScore(const QString& search, const Entry& entry);
  void runCurrent();
  std::vector<Entry> allEntries() const;

  ActionRegistry& registry_;
  QLineEdit* search_;
  QListWidget* list_;
  std::function<std::vector<Entry>()> extraEntries_;
  std::vector<Entry> entries_; ///< valid while the palette is open
};

/// Score of a text that does not match. A text that contains only the scattered letters of the
/// search scores between this value and 0.
constexpr int kNoMatch = -1'000'000;

/// Returns a score for how well `search` matches `text`, ignoring case. The score is 0 or more if
/// `text` contains all words of `search`, in any order; matches at the start of a word score
/// highest. It is negative but above `kNoMatch` if `text` contains only all letters of `search` in
/// order, as with "sm" for "Show mask".
int matchScore(const QString& search, const QString& text);

/// Sets all negative scores (matches of scattered letters) to `kNoMatch` if at least one score is a
/// word match (0 or more).
void dropScatteredMatches(std::vector<int>& fits);

} // namespace dewpoint::ui
