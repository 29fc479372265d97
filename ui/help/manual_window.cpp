// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/help/manual_window.h"

#include "ui/help/manual_browser.h"
#include "ui/help/manual_pages.h"
#include "ui/style/symbolic_icon.h"
#include "ui/text/retranslation.h"

#include <QDir>
#include <QEvent>
#include <QFile>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QSplitter>
#include <QToolButton>
#include <QVBoxLayout>

namespace dewpoint::ui {

namespace {

constexpr QSize kManualSize(980, 720);
constexpr int kListWidth = 240;

/// What a page calls itself, in its first line.
QString titleOf(const QString& file) {
  QFile page(file);
  if (!page.open(QIODevice::ReadOnly)) {
    return {};
  }
  QString line = QString::fromUtf8(page.readLine()).trimmed();
  return line.remove(QLatin1Char('#')).remove(QLatin1Char('`')).trimmed();
}

} // namespace

ManualWindow::ManualWindow(const QString& folder, const QString& expected, QWidget* parent)
    : QDialog(parent), folder_(folder), expected_(expected), list_(new QListWidget(this)),
      text_(new ManualBrowser(this)), back_(new QToolButton(this)), forward_(new QToolButton(this)),
      missing_(new QLabel(this)) {
  setObjectName(QStringLiteral("manualWindow"));
  setWindowFlags(Qt::Window);
  list_->setObjectName(QStringLiteral("manualList"));
  list_->setFrameShape(QFrame::NoFrame);
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff); // long titles end with an ellipsis
  list_->setSpacing(2);
  back_->setObjectName(QStringLiteral("manualBack"));
  forward_->setObjectName(QStringLiteral("manualForward"));
  missing_->setObjectName(QStringLiteral("manualMissing"));
  missing_->setWordWrap(true);
  missing_->setAlignment(Qt::AlignCenter);
  missing_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  missing_->setContentsMargins(24, 24, 24, 24);
  auto* left = new QWidget(this);
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(back_);
  buttons->addWidget(forward_);
  buttons->addStretch();
  for (QToolButton* button : {back_, forward_}) {
    button->setAutoRaise(true);
    button->setEnabled(false);
  }
  auto* column = new QVBoxLayout(left);
  column->setContentsMargins(8, 8, 0, 8);
  column->addLayout(buttons);
  column->addWidget(list_);
  auto* split = new QSplitter(this);
  split->addWidget(left);
  split->addWidget(text_);
  split->addWidget(missing_);
  split->setStretchFactor(1, 1);
  split->setStretchFactor(2, 1);
  split->setSizes({kListWidth, kManualSize.width() - kListWidth});
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(0, 0, 0, 0);
  all->addWidget(split);
  left->setVisible(!folder_.isEmpty());
  text_->setVisible(!folder_.isEmpty());
  missing_->setVisible(folder_.isEmpty());
  fillList();
  // Not whenever a row is the current one: the first is as soon as the list has the keys.
  const auto showItem = [this](const QListWidgetItem* item) {
    showPage(item->data(Qt::UserRole).toString());
  };
  connect(list_, &QListWidget::itemClicked, this, showItem);
  connect(list_, &QListWidget::itemActivated, this, showItem);
  connect(text_, &QTextBrowser::sourceChanged, this,
          [this](const QUrl& url) { choose(url.fileName()); });
  connect(text_, &QTextBrowser::backwardAvailable, back_, &QWidget::setEnabled);
  connect(text_, &QTextBrowser::forwardAvailable, forward_, &QWidget::setEnabled);
  connect(back_, &QToolButton::clicked, text_, &QTextBrowser::backward);
  connect(forward_, &QToolButton::clicked, text_, &QTextBrowser::forward);
  drawIcons();
  onRetranslate(this, [this] { retranslateUi(); });
  resize(kManualSize.boundedTo(parent->size()));
  text_->setFocus();
}

void ManualWindow::retranslateUi() {
  setWindowTitle(tr("Manual – Dewpoint"));
  list_->setAccessibleName(tr("Pages of the manual"));
  back_->setToolTip(tr("Go back to the previous page"));
  forward_->setToolTip(tr("Go forward one page"));
  missing_->setText(
      tr("The manual was not found. It is expected in the folder %1.").arg(expected_));
}

void ManualWindow::fillList() {
  for (const QString& page : manualPages()) {
    const QString file = QDir(folder_).filePath(page);
    if (!folder_.isEmpty() && QFile::exists(file)) {
      auto* item = new QListWidgetItem(titleOf(file), list_);
      item->setData(Qt::UserRole, page);
      item->setToolTip(item->text());
    }
  }
}

void ManualWindow::showPage(const QString& page) {
  if (folder_.isEmpty()) {
    return;
  }
  QUrl url = QUrl::fromLocalFile(QDir(folder_).filePath(page.section(QLatin1Char('#'), 0, 0)));
  if (page.contains(QLatin1Char('#'))) {
    url.setFragment(page.section(QLatin1Char('#'), 1));
  }
  text_->setSource(url);
}

QString ManualWindow::shownPage() const {
  return text_->source().fileName();
}

void ManualWindow::choose(const QString& page) {
  const QSignalBlocker quiet(list_);
  list_->setCurrentRow(-1);
  for (int row = 0; row < list_->count(); ++row) {
    if (list_->item(row)->data(Qt::UserRole).toString() == page) {
      list_->setCurrentRow(row);
    }
  }
}

void ManualWindow::changeEvent(QEvent* event) {
  QDialog::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) {
    drawIcons();
  }
}

void ManualWindow::drawIcons() {
  back_->setIcon(symbolicIcon(QStringLiteral("back"), palette()));
  forward_->setIcon(symbolicIcon(QStringLiteral("forward"), palette()));
}

} // namespace dewpoint::ui
