// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/actions/action_registry.h"

#include "ui/preferences/preferences.h"
#include "ui/style/symbolic_icon.h"

#include <QAbstractButton>
#include <QAction>
#include <QComboBox>
#include <QCoreApplication>
#include <QGuiApplication>
#include <QIcon>
#include <QKeyEvent>
#include <QPalette>
#include <QWidget>

#include <algorithm>
#include <optional>
#include <string_view>

namespace dewpoint::ui {

namespace {

QString translatedAction(const char* text) {
  return QCoreApplication::translate("Actions", text);
}

QString nameOf(const ActionDeclaration& declaration) {
  const std::string_view name = declaration.id.name();
  return QString::fromLatin1(name.data(), static_cast<qsizetype>(name.size()));
}

/// Whether a key can be a character that the user types, or moves or deletes what is selected.
bool isBareKey(const QKeyEvent& event) {
  if (event.modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier)) {
    return false;
  }
  const int key = event.key();
  return key < Qt::Key_Escape || key == Qt::Key_Delete || key == Qt::Key_Backspace ||
         (key >= Qt::Key_Home && key <= Qt::Key_PageDown);
}

bool isInForm(const QObject* watched) {
  for (auto* widget = qobject_cast<const QWidget*>(watched);
       widget != nullptr && !widget->isWindow(); widget = widget->parentWidget()) {
    if (widget->property(kKeepsKeys).toBool()) {
      return true;
    }
  }
  return false;
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
  action->setObjectName(nameOf(declaration));
  action->setCheckable(declaration.isCheckable);
  action->setShortcut(Preferences().shortcut(nameOf(declaration)).value_or(declaration.shortcut));
  entries_.push_back({declaration, action, declaration.text, declaration.icon});
  byId_[declaration.id.index()] = action;
  setTexts(entries_.back());
  if (declaration.icon != nullptr) {
    action->setIcon(symbolicIcon(QLatin1String(declaration.icon), QGuiApplication::palette()));
  }
  window_->addAction(action);
  return action;
}

std::vector<QAction*> ActionRegistry::allActions() const {
  std::vector<QAction*> actions;
  std::ranges::transform(entries_, std::back_inserter(actions), &Entry::action);
  return actions;
}

const ActionRegistry::Entry* ActionRegistry::entryOf(const QAction* action) const {
  const auto found = std::ranges::find(entries_, action, &Entry::action);
  return found == entries_.end() ? nullptr : &*found;
}

QString ActionRegistry::groupOf(const QAction* action) const {
  const Entry* entry = entryOf(action);
  return entry == nullptr ? QString() : translatedAction(entry->declaration.group);
}

QString ActionRegistry::hintOf(const QAction* action) const {
  const Entry* entry = entryOf(action);
  return entry == nullptr ? QString() : translatedAction(entry->declaration.hint);
}

QString ActionRegistry::labelOf(const QAction* action) const {
  const Entry* entry = entryOf(action);
  return entry == nullptr ? QString()
                          : translatedAction(entry->declaration.text).remove(QLatin1Char('&'));
}

QIcon ActionRegistry::iconOf(const QAction* action) const {
  const Entry* entry = entryOf(action);
  return entry == nullptr || entry->declaration.icon == nullptr
             ? QIcon()
             : symbolicIcon(QLatin1String(entry->declaration.icon), QGuiApplication::palette());
}

void ActionRegistry::setTexts(const Entry& entry) {
  entry.action->setText(translatedAction(entry.text));
  setTooltip(entry);
  entry.action->setStatusTip(QString());
}

void ActionRegistry::setTooltip(const Entry& entry) {
  entry.action->setToolTip(
      tooltipWithShortcut(translatedAction(entry.declaration.hint), entry.action->shortcut()));
}

void ActionRegistry::rename(QAction* action, const char* text, const char* icon) {
  for (Entry& entry : entries_) {
    if (entry.action == action && entry.text != text) {
      entry.text = text;
      entry.icon = icon;
      setTexts(entry);
      action->setIcon(symbolicIcon(QLatin1String(icon), QGuiApplication::palette()));
    }
  }
}

QKeySequence ActionRegistry::defaultShortcut(const QAction* action) const {
  const Entry* entry = entryOf(action);
  return entry == nullptr ? QKeySequence() : entry->declaration.shortcut;
}

QAction* ActionRegistry::actionWithShortcut(const QKeySequence& shortcut,
                                            const QAction* except) const {
  const auto found = std::ranges::find_if(entries_, [&](const Entry& entry) {
    return entry.action != except && !shortcut.isEmpty() && entry.action->shortcut() == shortcut;
  });
  return found == entries_.end() ? nullptr : found->action;
}

void ActionRegistry::saveShortcut(const Entry& entry) {
  const QKeySequence shortcut = entry.action->shortcut();
  Preferences().setShortcut(nameOf(entry.declaration), shortcut == entry.declaration.shortcut
                                                           ? std::nullopt
                                                           : std::optional(shortcut));
  setTooltip(entry); // the text may name what the action would do now
}

void ActionRegistry::setShortcut(QAction* action, const QKeySequence& shortcut) {
  const Entry* entry = entryOf(action);
  if (entry == nullptr) {
    return;
  }
  if (QAction* holder = actionWithShortcut(shortcut, action)) {
    holder->setShortcut({});
    saveShortcut(*entryOf(holder));
  }
  action->setShortcut(shortcut);
  saveShortcut(*entry);
  applyAlternatives();
  Q_EMIT shortcutsChanged();
}

void ActionRegistry::resetShortcuts() {
  for (const Entry& entry : entries_) {
    entry.action->setShortcut(entry.declaration.shortcut);
    saveShortcut(entry);
  }
  applyAlternatives();
  Q_EMIT shortcutsChanged();
}

void ActionRegistry::addAlternativeShortcut(ActionId id, const QKeySequence& shortcut) {
  alternatives_.emplace_back(id, shortcut);
  applyAlternatives();
}

void ActionRegistry::applyAlternatives() {
  for (const auto& [id, shortcut] : alternatives_) {
    QAction* one = action(id);
    QList<QKeySequence> keys = one->shortcuts();
    keys.removeAll(shortcut);
    const bool isDeclared = one->shortcut() == defaultShortcut(one);
    if (isDeclared && actionWithShortcut(shortcut, one) == nullptr) {
      // The declared one stays the first: it is the one that is shown.
      keys.removeAll(one->shortcut());
      keys.prepend(one->shortcut());
      if (shortcut != one->shortcut()) {
        keys.append(shortcut);
      }
      one->setShortcuts(keys);
    } else if (keys.size() != one->shortcuts().size() && shortcut != one->shortcut()) {
      one->setShortcuts(keys);
    }
  }
}

void ActionRegistry::drawIcons(const QPalette& palette) {
  for (const Entry& entry : entries_) {
    if (entry.icon != nullptr) {
      entry.action->setIcon(symbolicIcon(QLatin1String(entry.icon), palette));
    }
  }
}

void ActionRegistry::retranslateUi() {
  std::ranges::for_each(entries_, [this](const Entry& entry) { setTexts(entry); });
}

bool ActionRegistry::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride) {
    const auto* key = static_cast<QKeyEvent*>(event);
    if (key->key() == Qt::Key_Space && key->modifiers() == Qt::NoModifier && takesSpace(watched)) {
      event->accept(); // it is pressed, not the action whose shortcut that is
      return true;
    }
    if (isBareKey(*key) && isInForm(watched)) {
      event->accept(); // meant for the form, even if no field has the focus
      return true;
    }
    const bool moves = key->matches(QKeySequence::MoveToEndOfLine) ||
                       key->matches(QKeySequence::MoveToStartOfLine) ||
                       key->matches(QKeySequence::DeleteEndOfLine);
    if (moves && key->modifiers() == Qt::ControlModifier &&
        actionWithShortcut(QKeySequence(key->key() | Qt::ControlModifier), nullptr) != nullptr) {
      event->ignore();
      return true;
    }
  }
  return QObject::eventFilter(watched, event);
}

} // namespace dewpoint::ui
