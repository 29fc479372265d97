// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/actions/action_id.h"

#include <QKeySequence>
#include <QObject>
#include <QString>

#include <array>
#include <utility>
#include <vector>

class QAction;
class QPalette;

namespace dewpoint::ui {

/// Declares one action. Texts are marked for translation with QT_TRANSLATE_NOOP("Actions", "...").
struct ActionDeclaration {
  ActionId id;                ///< also the objectName of the QAction: "actionPlay"
  const char* group;          ///< heading in lists of actions: "Run"
  const char* text;           ///< name in menus: "Play"
  const char* hint;           ///< one sentence for the tooltip
  const char* icon = nullptr; ///< name of an icon in resources/icons; null: none
  QKeySequence shortcut = {}; ///< default shortcut; users can change it
  bool checkable = false;
};

/// All actions of the window. Menus, the toolbar, shortcuts, tooltips and the command palette get
/// their actions here. Users can change the shortcuts; changes are kept in their preferences. The
/// window connects each action to the code that performs it.
class ActionRegistry : public QObject {
  Q_OBJECT
public:
  /// Creates the actions as children of `window`, so that their shortcuts work wherever the focus
  /// is in that window.
  explicit ActionRegistry(QWidget* window);

  QAction* add(const ActionDeclaration& declaration);
  /// Returns the action with this id, or null if it has not been added yet.
  QAction* action(ActionId id) const { return byId_[id.index()]; }
  std::vector<QAction*> all() const;
  /// Returns the translated heading under which an action is listed.
  QString groupOf(const QAction* action) const;
  QString hintOf(const QAction* action) const;

  /// Changes the name and icon of an action to match its current state (Play or Pause).
  void rename(QAction* action, const char* text, const char* icon);

  QKeySequence defaultShortcut(const QAction* action) const;
  /// Returns the other action that already has this shortcut, or null.
  QAction* holderOf(const QKeySequence& shortcut, const QAction* except) const;
  /// Assigns a shortcut to an action (empty: none), removes it from the action that had it, and
  /// saves the change in the preferences.
  void setShortcut(QAction* action, const QKeySequence& shortcut);
  void resetShortcuts();
  /// Adds a second shortcut to an action. It works only while the action has its default shortcut
  /// and no other action uses the second one. It is not listed and not saved in the preferences.
  void addAlternative(ActionId id, const QKeySequence& shortcut);

  /// Redraws all icons in the colors of a palette.
  void drawIcons(const QPalette& palette);
  /// Says everything again after a change of language.
  void retranslateUi();

protected:
  /// Keeps input fields from taking keys that X11 uses to move the cursor (Ctrl+E: end of line), so
  /// that those keys trigger actions.
  bool eventFilter(QObject* watched, QEvent* event) override;

Q_SIGNALS:
  void shortcutsChanged();

private:
  struct Entry {
    ActionDeclaration declaration;
    QAction* action;
  };
  /// Returns null for an action that is not in this registry.
  const Entry* entryOf(const QAction* action) const;
  void setTexts(const Entry& entry);
  void remember(const Entry& entry);
  void useAlternatives();

  QWidget* window_;
  std::vector<Entry> entries_;
  std::vector<std::pair<ActionId, QKeySequence>> alternatives_;
  std::array<QAction*, kActionNames.size()> byId_{};
};

/// Returns the tooltip of an action: its sentence and its shortcut.
QString tooltipWithShortcut(const QString& sentence, const QKeySequence& shortcut);

} // namespace dewpoint::ui
