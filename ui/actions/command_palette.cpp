// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/actions/command_palette.h"

#include "ui/actions/action_registry.h"
#include "ui/settings/retranslation.h"

#include <QAction>
#include <QKeyEvent>
#include <QLineEdit>
#include <QListWidget>
#include <QPixmap>
#include <QVBoxLayout>

#include <algorithm>
#include <iterator>

namespace dewpoint {

namespace {

constexpr int kWidth = 520;
constexpr int kRows = 12;
constexpr int kRowHeight = 28;

QString plainText(const QAction& action) {
  return action.text().remove(QLatin1Char('&'));
}

} // namespace

int fitOf(const QString& search, const QString& text) {
  constexpr int kWordStart = 8;
  constexpr int kNeighbor = 5;
  int fit = 0;
  qsizetype from = 0;
  qsizetype previous = -2;
  for (const QChar letter : search) {
    if (letter.isSpace()) {
      continue;
    }
    const qsizetype found = text.indexOf(letter, from, Qt::CaseInsensitive);
    if (found < 0) {
      return -1;
    }
    const bool startsWord = found == 0 || !text[found - 1].isLetterOrNumber();
    fit += 1 + (startsWord ? kWordStart : 0) + (found == previous + 1 ? kNeighbor : 0);
    previous = found;
    from = found + 1;
  }
  const bool whole = !search.isEmpty() && text.contains(search.trimmed(), Qt::CaseInsensitive);
  return whole ? fit + 100 : fit;
}

CommandPalette::CommandPalette(ActionRegistry& registry, QWidget* window)
    : QFrame(window, Qt::Popup), registry_(registry), search_(new QLineEdit(this)),
      list_(new QListWidget(this)) {
  setObjectName(QStringLiteral("commandPalette"));
  setFrameShape(QFrame::StyledPanel);
  search_->setObjectName(QStringLiteral("paletteSearch"));
  search_->setClearButtonEnabled(true);
  list_->setObjectName(QStringLiteral("paletteList"));
  list_->setFrameShape(QFrame::NoFrame);
  list_->setUniformItemSizes(true);
  list_->setFocusPolicy(Qt::NoFocus);
  list_->setIconSize({18, 18});
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(8, 8, 8, 8);
  layout->setSpacing(8);
  layout->addWidget(search_);
  layout->addWidget(list_);
  inEveryLanguage(this, [this] {
    search_->setPlaceholderText(tr("What do you want to do?"));
    search_->setAccessibleName(tr("Search actions"));
    list_->setAccessibleName(tr("Actions found"));
  });
  search_->installEventFilter(this);
  connect(search_, &QLineEdit::textChanged, this, &CommandPalette::filter);
  connect(search_, &QLineEdit::returnPressed, this, &CommandPalette::runCurrent);
  connect(list_, &QListWidget::itemClicked, this, &CommandPalette::runCurrent);
}

std::vector<CommandPalette::Entry> CommandPalette::everything() const {
  std::vector<Entry> entries;
  for (QAction* action : registry_.all()) {
    if (action->isEnabled() && action->isVisible()) {
      entries.push_back({registry_.groupOf(action), plainText(*action), registry_.hintOf(action),
                         action->shortcut().toString(QKeySequence::NativeText), action->icon(),
                         [action] { action->trigger(); }});
    }
  }
  if (more_) {
    std::ranges::move(more_(), std::back_inserter(entries));
  }
  return entries;
}

void CommandPalette::open() {
  entries_ = everything();
  search_->clear();
  filter({});
  list_->setFixedHeight(kRows * kRowHeight + 4);
  const QWidget& window = *parentWidget();
  const int width = std::min(kWidth, window.width() - 32);
  resize(width, sizeHint().height());
  move(window.mapToGlobal(QPoint((window.width() - width) / 2, 64)));
  show();
  search_->setFocus();
}

void CommandPalette::filter(const QString& search) {
  struct Row {
    int fit;
    int entry;
  };
  std::vector<Row> rows;
  for (int i = 0; i < static_cast<int>(entries_.size()); ++i) {
    const Entry& entry = entries_[static_cast<std::size_t>(i)];
    // The name counts twice as much as what else is known of an action.
    const int byHint = fitOf(search, entry.group + QLatin1Char(' ') + entry.hint);
    if (const int fit = std::max(2 * fitOf(search, entry.name), byHint); fit >= 0) {
      rows.push_back({fit, i});
    }
  }
  std::ranges::stable_sort(rows, std::greater{}, &Row::fit);
  list_->clear();
  QPixmap nothingDrawn(list_->iconSize());
  nothingDrawn.fill(Qt::transparent); // so that all names begin in one line
  for (const Row& row : rows) {
    const Entry& entry = entries_[static_cast<std::size_t>(row.entry)];
    auto* item = new QListWidgetItem(
        entry.icon.isNull() ? QIcon(nothingDrawn) : entry.icon,
        entry.group + QStringLiteral(" › ") + entry.name +
            (entry.keys.isEmpty() ? QString() : QStringLiteral("   ") + entry.keys),
        list_);
    item->setSizeHint({0, kRowHeight});
    item->setToolTip(entry.hint);
    item->setData(Qt::UserRole, row.entry);
  }
  if (rows.empty()) {
    auto* nothing = new QListWidgetItem(tr("Nothing here is called “%1”.").arg(search), list_);
    nothing->setSizeHint({0, kRowHeight});
    nothing->setFlags(Qt::NoItemFlags);
    return;
  }
  list_->setCurrentRow(0);
}

void CommandPalette::runCurrent() {
  const QListWidgetItem* item = list_->currentItem();
  if (item == nullptr || !item->flags().testFlag(Qt::ItemIsEnabled)) {
    search_->selectAll(); // nothing was found: ready for another word
    return;
  }
  const auto run = entries_[static_cast<std::size_t>(item->data(Qt::UserRole).toInt())].run;
  hide(); // first: the action may open something of its own
  run();
}

bool CommandPalette::eventFilter(QObject* watched, QEvent* event) {
  if (watched == search_ && event->type() == QEvent::KeyPress) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    const int step = key == Qt::Key_Down       ? 1
                     : key == Qt::Key_Up       ? -1
                     : key == Qt::Key_PageDown ? kRows
                     : key == Qt::Key_PageUp   ? -kRows
                                               : 0;
    if (step != 0 && list_->count() > 0) {
      list_->setCurrentRow(std::clamp(list_->currentRow() + step, 0, list_->count() - 1));
      return true;
    }
  }
  return QFrame::eventFilter(watched, event);
}

} // namespace dewpoint
