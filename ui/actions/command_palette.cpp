// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/actions/command_palette.h"

#include "ui/actions/action_registry.h"
#include "ui/text/retranslation.h"

#include <QAction>
#include <QKeyEvent>
#include <QLineEdit>
#include <QListWidget>
#include <QPixmap>
#include <QRegularExpression>
#include <QVBoxLayout>

#include <algorithm>
#include <iterator>

namespace dewpoint::ui {

namespace {

constexpr int kPaletteWidth = 520;
constexpr int kRows = 12;
constexpr int kRowHeight = 28;

constexpr int kAtStart = 40; ///< what a word counts that begins one of the text

QString plainText(const QAction& action) {
  return action.text().remove(QLatin1Char('&'));
}

/// Languages without spaces have no other beginnings of words.
bool isWithoutSpaces(QChar letter) {
  switch (letter.script()) {
  case QChar::Script_Han:
  case QChar::Script_Hiragana:
  case QChar::Script_Katakana:
    return true;
  default:
    return false;
  }
}

bool startsWord(const QString& text, qsizetype place) {
  return place == 0 || !text[place - 1].isLetterOrNumber() || isWithoutSpaces(text[place]);
}

/// How well one word fits: best where a word begins; negative when it is not there.
int fitOfWord(const QString& word, const QString& text) {
  constexpr int kInside = 10;
  int fit = -1;
  for (qsizetype place = text.indexOf(word, 0, Qt::CaseInsensitive); place >= 0 && fit < kAtStart;
       place = text.indexOf(word, place + 1, Qt::CaseInsensitive)) {
    fit = startsWord(text, place) ? kAtStart : kInside;
  }
  return fit;
}

/// All letters in order, the better the closer together and the nearer to beginnings of words.
int scatteredFit(const QString& letters, const QString& text) {
  constexpr int kWordStart = 8;
  constexpr int kNeighbor = 5;
  int fit = 0;
  qsizetype from = 0;
  qsizetype previous = -2;
  for (const QChar letter : letters) {
    const qsizetype found = text.indexOf(letter, from, Qt::CaseInsensitive);
    if (found < 0) {
      return kNoMatch;
    }
    fit += 1 + (startsWord(text, found) ? kWordStart : 0) + (found == previous + 1 ? kNeighbor : 0);
    previous = found;
    from = found + 1;
  }
  return fit + kNoMatch / 2;
}

} // namespace

int matchScore(const QString& search, const QString& text) {
  static const QRegularExpression between(QStringLiteral("[\\s›]+"));
  const QStringList words = search.split(between, Qt::SkipEmptyParts);
  constexpr int kAsTyped = 5;
  int fit = text.contains(search.trimmed(), Qt::CaseInsensitive) ? kAsTyped : 0;
  for (const QString& word : words) {
    const int one = fitOfWord(word, text);
    if (one < 0) {
      return scatteredFit(words.join(QString()), text);
    }
    fit += one;
  }
  return fit;
}

void dropScatteredMatches(std::vector<int>& fits) {
  if (std::ranges::any_of(fits, [](int fit) { return fit >= 0; })) {
    std::ranges::replace_if(
        fits, [](int fit) { return fit < 0; }, kNoMatch);
  }
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
  onRetranslate(this, [this] {
    search_->setPlaceholderText(tr("What do you want to do?"));
    search_->setAccessibleName(tr("Search actions"));
    list_->setAccessibleName(tr("Actions found"));
  });
  search_->installEventFilter(this);
  connect(search_, &QLineEdit::textChanged, this, &CommandPalette::filter);
  connect(search_, &QLineEdit::returnPressed, this, &CommandPalette::runCurrent);
  connect(list_, &QListWidget::itemClicked, this, &CommandPalette::runCurrent);
}

std::vector<CommandPalette::Entry> CommandPalette::allEntries() const {
  std::vector<Entry> entries;
  for (QAction* action : registry_.allActions()) {
    if (action->isEnabled() && action->isVisible()) {
      entries.push_back({registry_.groupOf(action), plainText(*action), registry_.hintOf(action),
                         action->shortcut().toString(QKeySequence::NativeText), action->icon(),
                         [action] { action->trigger(); }});
    }
  }
  if (extraEntries_) {
    std::ranges::move(extraEntries_(), std::back_inserter(entries));
  }
  return entries;
}

void CommandPalette::open() {
  entries_ = allEntries();
  search_->clear();
  filter({});
  list_->setFixedHeight(kRows * kRowHeight + 4);
  const QWidget& window = *parentWidget();
  const int width = std::min(kPaletteWidth, window.width() - 32);
  resize(width, sizeHint().height());
  move(window.mapToGlobal(QPoint((window.width() - width) / 2, 64)));
  show();
  search_->setFocus();
}

/// The name counts most, then the group it is in, then what else is known of an action.
int CommandPalette::matchScore(const QString& search, const Entry& entry) {
  const QString path = entry.group + QLatin1Char(' ') + entry.name;
  const int byName = dewpoint::ui::matchScore(search, entry.name);
  const int byPath = dewpoint::ui::matchScore(search, path);
  if (byPath >= 0) {
    return std::max(3 * byName, 2 * byPath);
  }
  const int byHint = dewpoint::ui::matchScore(search, path + QLatin1Char(' ') + entry.hint);
  // Of a whole sentence beginnings of words count, no letters in the midst of one ("this").
  return byHint >= kAtStart ? byHint : byPath;
}

void CommandPalette::filter(const QString& search) {
  std::vector<int> fits;
  for (const Entry& entry : entries_) {
    fits.push_back(matchScore(search, entry));
  }
  dropScatteredMatches(fits);
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < fits.size(); ++i) {
    if (fits[i] != kNoMatch) {
      rows.push_back(i);
    }
  }
  std::ranges::stable_sort(rows, std::greater{}, [&](std::size_t row) { return fits[row]; });
  list_->clear();
  QPixmap nothingDrawn(list_->iconSize());
  nothingDrawn.fill(Qt::transparent); // so that all names begin in one line
  for (const std::size_t row : rows) {
    const Entry& entry = entries_[row];
    auto* item = new QListWidgetItem(
        entry.icon.isNull() ? QIcon(nothingDrawn) : entry.icon,
        entry.group + QStringLiteral(" › ") + entry.name +
            (entry.shortcutText.isEmpty() ? QString() : QStringLiteral("   ") + entry.shortcutText),
        list_);
    item->setSizeHint({0, kRowHeight});
    item->setToolTip(entry.hint);
    item->setData(Qt::UserRole, static_cast<int>(row));
  }
  if (rows.empty()) {
    auto* nothing = new QListWidgetItem(tr("No action is called “%1”.").arg(search), list_);
    nothing->setSizeHint({0, kRowHeight});
    nothing->setFlags(Qt::NoItemFlags);
    return;
  }
  // Enter alone does nothing: something is to be typed, or gone to, first.
  list_->setCurrentRow(search.trimmed().isEmpty() ? -1 : 0);
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

} // namespace dewpoint::ui
