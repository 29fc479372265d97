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

/// What an action is, declared once. Texts are marked with QT_TRANSLATE_NOOP("Actions", "...").
struct ActionDeclaration {
  ActionId id;                ///< objectName of the action: "actionPlay"
  const char* group;          ///< heading in lists of actions: "Run"
  const char* text;           ///< "Play"
  const char* hint;           ///< one sentence for the tooltip
  const char* icon = nullptr; ///< of resources/icons
  QKeySequence shortcut = {}; ///< unless the user chose another
  bool checkable = false;
};

/// All actions of the window: menus, toolbar, shortcuts, tooltips and the command palette come from
/// here. Shortcuts can be changed and are kept in the user's preferences. What an action does is
/// connected by the window.
class ActionRegistry : public QObject {
  Q_OBJECT
public:
  /// Actions belong to `window`, so that their shortcuts work wherever the focus is in it.
  explicit ActionRegistry(QWidget* window);

  QAction* add(const ActionDeclaration& declaration);
  /// The action with this id; null as long as it was not added.
  QAction* action(ActionId id) const { return byId_[id.index()]; }
  std::vector<QAction*> all() const;
  /// Heading under which an action is listed, in the user's language.
  QString groupOf(const QAction* action) const;
  QString hintOf(const QAction* action) const;

  /// Another name and icon for the present state of an action (Play, Pause).
  void rename(QAction* action, const char* text, const char* icon);

  QKeySequence defaultShortcut(const QAction* action) const;
  /// The other action that has this shortcut already, or none.
  QAction* holderOf(const QKeySequence& shortcut, const QAction* except) const;
  /// Gives an action a shortcut (empty: none), taking it away from its holder, and remembers it.
  void setShortcut(QAction* action, const QKeySequence& shortcut);
  void resetShortcuts();
  /// One more key for an action, as long as it has the shortcut it was declared with and the key is
  /// no other's. It is not listed, and not kept in the preferences.
  void addAlternative(ActionId id, const QKeySequence& shortcut);

  /// Redraws all icons in the colors of a palette.
  void drawIcons(const QPalette& palette);
  /// Says everything again after a change of language.
  void retranslate();

protected:
  /// Fields leave keys to actions that X11 gives them for moving about (Ctrl+E: end of line).
  bool eventFilter(QObject* watched, QEvent* event) override;

Q_SIGNALS:
  void shortcutsChanged();

private:
  struct Entry {
    ActionDeclaration declaration;
    QAction* action;
  };
  /// Null for an action that is not of this registry.
  const Entry* entryOf(const QAction* action) const;
  void setTexts(const Entry& entry);
  void remember(const Entry& entry);
  void useAlternatives();

  QWidget* window_;
  std::vector<Entry> entries_;
  std::vector<std::pair<ActionId, QKeySequence>> alternatives_;
  std::array<QAction*, kActionNames.size()> byId_{};
};

/// Tooltip of an action: its sentence and its shortcut.
QString tooltipWithShortcut(const QString& sentence, const QKeySequence& shortcut);

} // namespace dewpoint::ui
