// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/actions/action_registry.h"

#include "ui/style/symbolic_icon.h"

#include <QAbstractButton>
#include <QAction>
#include <QComboBox>
#include <QCoreApplication>
#include <QGuiApplication>
#include <QKeyEvent>
#include <QPalette>
#include <QSettings>
#include <QWidget>

#include <algorithm>

namespace dewpoint::ui {

namespace {

QString translated(const char* text) {
  return QCoreApplication::translate("Actions", text);
}

QString settingOf(const ActionDeclaration& declaration) {
  return QStringLiteral("shortcuts/") + QLatin1String(declaration.id);
}

/// Whether the space bar presses or opens it.
bool takesSpace(const QObject* watched) {
  const auto* choice = qobject_cast<const QComboBox*>(watched);
  return qobject_cast<const QAbstractButton*>(watched) != nullptr ||
         (choice != nullptr && !choice->isEditable());
}

} // namespace

QString tooltipWithShortcut(const QString& sentence, const QKeySequence& shortcut) {
  return shortcut.isEmpty()
             ? sentence
             : QStringLiteral("%1 (%2)").arg(sentence, shortcut.toString(QKeySequence::NativeText));
}

ActionRegistry::ActionRegistry(QWidget* window) : QObject(window), window_(window) {
  QCoreApplication::instance()->installEventFilter(this);
}

QAction* ActionRegistry::add(const ActionDeclaration& declaration) {
  auto* action = new QAction(this);
  action->setObjectName(QLatin1String(declaration.id));
  action->setCheckable(declaration.checkable);
  const QVariant chosen = QSettings().value(settingOf(declaration));
  action->setShortcut(chosen.isValid() ? QKeySequence(chosen.toString(), QKeySequence::PortableText)
                                       : declaration.shortcut);
  entries_.push_back({declaration, action});
  say(entries_.back());
  if (declaration.icon != nullptr) {
    action->setIcon(symbolicIcon(QLatin1String(declaration.icon), QGuiApplication::palette()));
  }
  window_->addAction(action);
  return action;
}

QAction* ActionRegistry::action(const char* id) const {
  const auto found = std::ranges::find_if(
      entries_, [&](const Entry& entry) { return qstrcmp(entry.declaration.id, id) == 0; });
  Q_ASSERT(found != entries_.end());
  return found->action;
}

std::vector<QAction*> ActionRegistry::all() const {
  std::vector<QAction*> actions;
  std::ranges::transform(entries_, std::back_inserter(actions), &Entry::action);
  return actions;
}

const ActionRegistry::Entry& ActionRegistry::entryOf(const QAction* action) const {
  const auto found = std::ranges::find(entries_, action, &Entry::action);
  Q_ASSERT(found != entries_.end());
  return *found;
}

QString ActionRegistry::groupOf(const QAction* action) const {
  return translated(entryOf(action).declaration.group);
}

QString ActionRegistry::hintOf(const QAction* action) const {
  return translated(entryOf(action).declaration.hint);
}

void ActionRegistry::say(const Entry& entry) {
  entry.action->setText(translated(entry.declaration.text));
  entry.action->setToolTip(
      tooltipWithShortcut(translated(entry.declaration.hint), entry.action->shortcut()));
  entry.action->setStatusTip(QString());
}

void ActionRegistry::rename(QAction* action, const char* text, const char* icon) {
  for (Entry& entry : entries_) {
    if (entry.action == action && entry.declaration.text != text) {
      entry.declaration.text = text;
      entry.declaration.icon = icon;
      say(entry);
      action->setIcon(symbolicIcon(QLatin1String(icon), QGuiApplication::palette()));
    }
  }
}

QKeySequence ActionRegistry::defaultShortcut(const QAction* action) const {
  return entryOf(action).declaration.shortcut;
}

QAction* ActionRegistry::holderOf(const QKeySequence& shortcut, const QAction* except) const {
  const auto found = std::ranges::find_if(entries_, [&](const Entry& entry) {
    return entry.action != except && !shortcut.isEmpty() && entry.action->shortcut() == shortcut;
  });
  return found == entries_.end() ? nullptr : found->action;
}

void ActionRegistry::remember(const Entry& entry) {
  QSettings settings;
  if (entry.action->shortcut() == entry.declaration.shortcut) {
    settings.remove(settingOf(entry.declaration));
  } else {
    settings.setValue(settingOf(entry.declaration),
                      entry.action->shortcut().toString(QKeySequence::PortableText));
  }
  say(entry);
}

void ActionRegistry::setShortcut(QAction* action, const QKeySequence& shortcut) {
  if (QAction* holder = holderOf(shortcut, action)) {
    holder->setShortcut({});
    remember(entryOf(holder));
  }
  action->setShortcut(shortcut);
  remember(entryOf(action));
  Q_EMIT shortcutsChanged();
}

void ActionRegistry::resetShortcuts() {
  for (const Entry& entry : entries_) {
    entry.action->setShortcut(entry.declaration.shortcut);
    remember(entry);
  }
  Q_EMIT shortcutsChanged();
}

void ActionRegistry::drawIcons(const QPalette& palette) {
  for (const Entry& entry : entries_) {
    if (entry.declaration.icon != nullptr) {
      entry.action->setIcon(symbolicIcon(QLatin1String(entry.declaration.icon), palette));
    }
  }
}

void ActionRegistry::retranslate() {
  std::ranges::for_each(entries_, [this](const Entry& entry) { say(entry); });
}

bool ActionRegistry::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride) {
    const auto* key = static_cast<QKeyEvent*>(event);
    if (key->key() == Qt::Key_Space && key->modifiers() == Qt::NoModifier && takesSpace(watched)) {
      event->accept(); // it is pressed, not the action whose shortcut that is
      return true;
    }
    const bool moves = key->matches(QKeySequence::MoveToEndOfLine) ||
                       key->matches(QKeySequence::MoveToStartOfLine) ||
                       key->matches(QKeySequence::DeleteEndOfLine);
    if (moves && key->modifiers() == Qt::ControlModifier &&
        holderOf(QKeySequence(key->key() | Qt::ControlModifier), nullptr) != nullptr) {
      event->ignore();
      return true;
    }
  }
  return QObject::eventFilter(watched, event);
}

} // namespace dewpoint::ui
