// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/actions/shortcut_editor.h"

#include "ui/actions/action_registry.h"
#include "ui/actions/command_palette.h"
#include "ui/text/retranslation.h"

#include <QAction>
#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <utility>
#include <vector>

namespace dewpoint::ui {

namespace {

enum ShortcutColumn { kName, kKeys, kHint };

} // namespace

ShortcutEditor::ShortcutEditor(ActionRegistry& registry, QWidget* parent)
    : QDialog(parent), registry_(registry), search_(new QLineEdit(this)),
      tree_(new QTreeWidget(this)), keys_(new QKeySequenceEdit(this)),
      clear_(new QPushButton(this)), resetAll_(new QPushButton(this)),
      close_(new QPushButton(this)), note_(new QLabel(this)) {
  setObjectName(QStringLiteral("shortcutEditor"));
  search_->setObjectName(QStringLiteral("shortcutSearch"));
  search_->setClearButtonEnabled(true);
  tree_->setObjectName(QStringLiteral("shortcutTree"));
  tree_->setColumnCount(3);
  tree_->setRootIsDecorated(false);
  tree_->setAlternatingRowColors(true);
  tree_->setUniformRowHeights(true);
  keys_->setObjectName(QStringLiteral("shortcutKeys"));
  clear_->setObjectName(QStringLiteral("shortcutClear"));
  clear_->setAutoDefault(false);
  resetAll_->setObjectName(QStringLiteral("shortcutResetAll"));
  resetAll_->setAutoDefault(false);
  close_->setObjectName(QStringLiteral("shortcutClose"));
  close_->setAutoDefault(false);
  note_->setObjectName(QStringLiteral("shortcutNote"));
  note_->setWordWrap(true);
  auto* row = new QHBoxLayout;
  row->setSpacing(8);
  row->addWidget(keys_, 1);
  row->addWidget(clear_);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(16, 16, 16, 16);
  layout->setSpacing(8);
  layout->addWidget(search_);
  layout->addWidget(tree_, 1);
  layout->addLayout(row);
  layout->addWidget(note_);
  auto* buttons = new QDialogButtonBox(this);
  buttons->addButton(resetAll_, QDialogButtonBox::ResetRole);
  buttons->addButton(close_, QDialogButtonBox::RejectRole);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
  layout->addWidget(buttons);
  onRetranslate(this, [this] {
    setWindowTitle(tr("Shortcuts"));
    search_->setPlaceholderText(tr("Search"));
    search_->setAccessibleName(tr("Search actions"));
    tree_->setHeaderLabels({tr("Action"), tr("Shortcut"), tr("Description")});
    tree_->setAccessibleName(tr("Actions and their shortcuts"));
    keys_->setToolTip(tr("Click here and press the new keys of the chosen action"));
    keys_->setAccessibleName(tr("New shortcut"));
    clear_->setText(tr("No shortcut"));
    clear_->setToolTip(tr("Remove the shortcut of the selected action"));
    resetAll_->setText(tr("Reset all"));
    resetAll_->setToolTip(tr("Reset all shortcuts to their defaults"));
    close_->setText(tr("Close"));
    close_->setToolTip(tr("Close; changed shortcuts are already saved"));
    fill();
    if (noteText_) {
      note_->setText(noteText_());
    }
  });
  showHint([] { return tr("Choose an action, click the field below and press the new keys."); });
  connect(search_, &QLineEdit::textChanged, this, &ShortcutEditor::filter);
  connect(tree_, &QTreeWidget::currentItemChanged, this, &ShortcutEditor::showCurrent);
  connect(keys_, &QKeySequenceEdit::editingFinished, this, &ShortcutEditor::assign);
  connect(clear_, &QPushButton::clicked, this, [this] {
    if (QAction* action = current()) {
      registry_.setShortcut(action, {});
      showHint([this, action] {
        return tr("“%1” no longer has a shortcut.").arg(registry_.labelOf(action));
      });
    }
  });
  connect(resetAll_, &QPushButton::clicked, this, [this] {
    registry_.resetShortcuts();
    showHint([] { return tr("All shortcuts were reset to their defaults."); });
  });
  connect(&registry_, &ActionRegistry::shortcutsChanged, this, &ShortcutEditor::fill);
  resize(680, 560);
}

void ShortcutEditor::showHint(std::function<QString()> text) {
  noteText_ = std::move(text);
  note_->setText(noteText_());
}

void ShortcutEditor::fill() {
  const QAction* chosen = current();
  tree_->clear();
  for (QAction* action : registry_.allActions()) {
    const QString name =
        registry_.groupOf(action) + QStringLiteral(" › ") + registry_.labelOf(action);
    const QString hint = registry_.hintOf(action);
    auto* item = new QTreeWidgetItem(
        tree_, {name, action->shortcut().toString(QKeySequence::NativeText), hint});
    item->setIcon(kName, registry_.iconOf(action));
    item->setToolTip(kName, hint);
    item->setToolTip(kHint, hint); // often longer than its column
    item->setData(kName, Qt::UserRole, QVariant::fromValue<QObject*>(action));
    if (action == chosen) {
      tree_->setCurrentItem(item);
    }
  }
  tree_->resizeColumnToContents(kName);
  tree_->resizeColumnToContents(kKeys);
  filter(search_->text());
}

void ShortcutEditor::filter(const QString& search) {
  std::vector<int> fits;
  for (int i = 0; i < tree_->topLevelItemCount(); ++i) {
    const QTreeWidgetItem* item = tree_->topLevelItem(i);
    fits.push_back(matchScore(search, item->text(kName) + QLatin1Char(' ') + item->text(kKeys)));
  }
  dropScatteredMatches(fits);
  for (int i = 0; i < tree_->topLevelItemCount(); ++i) {
    tree_->topLevelItem(i)->setHidden(fits[static_cast<std::size_t>(i)] == kNoMatch);
  }
}

QAction* ShortcutEditor::current() const {
  const QTreeWidgetItem* item = tree_->currentItem();
  return item == nullptr
             ? nullptr
             : qobject_cast<QAction*>(item->data(kName, Qt::UserRole).value<QObject*>());
}

void ShortcutEditor::showCurrent() {
  const QAction* action = current();
  keys_->setEnabled(action != nullptr);
  clear_->setEnabled(action != nullptr);
  keys_->setKeySequence(action == nullptr ? QKeySequence() : action->shortcut());
}

void ShortcutEditor::assign() {
  QAction* action = current();
  const QKeySequence keys = keys_->keySequence();
  if (action == nullptr || keys == action->shortcut()) {
    return;
  }
  const QAction* holder = registry_.actionWithShortcut(keys, action);
  const QString shown = keys.toString(QKeySequence::NativeText);
  registry_.setShortcut(action, keys);
  showHint([this, action, holder, shown] {
    const QString name = registry_.labelOf(action);
    return holder == nullptr ? tr("“%1” now has the shortcut %2.").arg(name, shown)
                             : tr("“%1” now has the shortcut %2, which was removed from “%3”.")
                                   .arg(name, shown, registry_.labelOf(holder));
  });
}

} // namespace dewpoint::ui
