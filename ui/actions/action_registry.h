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
class QIcon;
class QPalette;

namespace dewpoint::ui {

/// Name of a widget property. In a widget with this property, and in all widgets inside it, keys
/// without Ctrl, Alt or Meta trigger no action, so that typing a name or a number cannot restart
/// the run by accident. Function keys and Esc still trigger actions.
inline constexpr auto kKeepsKeys = "keepsKeys";

/// Declaration of one action. Mark its strings for translation with QT_TRANSLATE_NOOP("Actions",
/// "...").
struct ActionDeclaration {
  ActionId id;                ///< also the objectName of the QAction, for example "actionPlay"
  const char* group;          ///< group heading in lists of actions, for example "Run"
  const char* text;           ///< name in menus, for example "Play"
  const char* hint;           ///< one sentence for the tooltip
  const char* icon = nullptr; ///< name of an icon in resources/icons; null for no icon
  QKeySequence shortcut = {}; ///< default shortcut; users can change it
  bool isCheckable = false;
};

/// Registry of all actions in the window, from which menus, the toolbar, shortcuts, tooltips and
/// the command palette get their actions. Users can change the shortcuts; the preferences store the
/// changes. Features connect each action to the code that performs it.
class ActionRegistry : public QObject {
  Q_OBJECT
public:
  /// Creates the actions as children of `window`, so that their shortcuts work wherever the
  /// keyboard focus is in that window.
  explicit ActionRegistry(QWidget* window);

  QAction* add(const ActionDeclaration& declaration);
  /// Returns the action with this id, or null if it has not been added yet.
  QAction* action(ActionId id) const { return byId_[id.index()]; }
  std::vector<QAction*> allActions() const;
  /// Returns the translated heading under which an action is listed.
  QString groupOf(const QAction* action) const;
  QString hintOf(const QAction* action) const;
  /// Returns the translated name of an action as declared. This name does not change with the
  /// current text of the action, such as "Undo: Rename target".
  QString labelOf(const QAction* action) const;
  /// Returns the icon of an action as declared, which is null if it has none.
  QIcon iconOf(const QAction* action) const;

  /// Changes the name and icon of an action to match its current state (Play or Pause).
  void rename(QAction* action, const char* text, const char* icon);

  QKeySequence defaultShortcut(const QAction* action) const;
  /// Returns the action, other than `except`, that already has this shortcut, or null if there is
  /// none.
  QAction* actionWithShortcut(const QKeySequence& shortcut, const QAction* except) const;
  /// Assigns a shortcut to an action. An empty shortcut removes the current one. If another action
  /// had this shortcut, that action loses it. Saves the change in the preferences.
  void setShortcut(QAction* action, const QKeySequence& shortcut);
  void resetShortcuts();
  /// Adds a second shortcut to an action. The second shortcut works only while the action has its
  /// default shortcut and no other action uses the second one. It is neither listed nor saved in
  /// the preferences.
  void addAlternativeShortcut(ActionId id, const QKeySequence& shortcut);

  /// Redraws the icons of all actions in the colors of `palette`.
  void drawIcons(const QPalette& palette);
  /// Translates all texts again after a language change.
  void retranslateUi();

protected:
  /// Prevents input fields from handling keys that X11 uses to move the cursor (such as Ctrl+E for
  /// end of line), so that those keys trigger actions. Prevents keys that are pressed in a form
  /// (kKeepsKeys) from triggering actions.
  bool eventFilter(QObject* watched, QEvent* event) override;

Q_SIGNALS:
  void shortcutsChanged();

private:
  struct Entry {
    ActionDeclaration declaration;
    QAction* action;
    const char* text; ///< now; differs from the declaration once the action is renamed
    const char* icon; ///< likewise; null for no icon
  };
  /// Returns the entry for an action, or null if the action is not in this registry.
  const Entry* entryOf(const QAction* action) const;
  static void setTexts(const Entry& entry);
  static void setTooltip(const Entry& entry);
  void saveShortcut(const Entry& entry);
  void applyAlternatives();

  QWidget* window_;
  std::vector<Entry> entries_;
  std::vector<std::pair<ActionId, QKeySequence>> alternatives_;
  std::array<QAction*, kActionNames.size()> byId_{};
};

/// Returns the tooltip for an action: its sentence followed by its shortcut.
QString tooltipWithShortcut(const QString& sentence, const QKeySequence& shortcut);

} // namespace dewpoint::ui
