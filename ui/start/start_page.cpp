// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/start/start_page.h"

#include "ui/start/recent_projects.h"
#include "ui/style/symbolic_icon.h"
#include "ui/text/retranslation.h"

#include <QEvent>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QToolButton>
#include <QVBoxLayout>

namespace dewpoint::ui {

namespace {

constexpr int kPageWidth = 760;
constexpr QSize kChoice(168, 128);
constexpr int kIcon = 40;

enum Choice { kDemo, kVideos, kCameras, kProject };

} // namespace

StartPage::StartPage(RecentProjects& recent, QWidget* parent)
    : QWidget(parent), projects_(recent), title_(new QLabel(this)), lead_(new QLabel(this)),
      choices_(new QWidget(this)), recentTitle_(new QLabel(this)), recent_(new QListWidget(this)),
      hint_(new QLabel(this)) {
  setObjectName(QStringLiteral("startPage"));
  QFont big = title_->font();
  big.setPointSizeF(big.pointSizeF() * 2.2);
  big.setWeight(QFont::DemiBold);
  title_->setFont(big);
  hint_->setWordWrap(true);
  hint_->setForegroundRole(QPalette::PlaceholderText);
  auto* row = new QHBoxLayout(choices_);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(16);
  connect(addChoice("startDemo", QStringLiteral("play")), &QToolButton::clicked, this,
          &StartPage::demoWanted);
  connect(addChoice("startVideos", QStringLiteral("video")), &QToolButton::clicked, this,
          &StartPage::videosWanted);
  connect(addChoice("startCameras", QStringLiteral("camera")), &QToolButton::clicked, this,
          &StartPage::camerasWanted);
  connect(addChoice("startProject", QStringLiteral("open")), &QToolButton::clicked, this,
          [this] { Q_EMIT projectWanted({}); });
  recent_->setObjectName(QStringLiteral("startRecent"));
  recent_->setFrameShape(QFrame::NoFrame);
  connect(recent_, &QListWidget::itemActivated, this, [this](const QListWidgetItem* item) {
    Q_EMIT projectWanted(item->data(Qt::UserRole).toString());
  });
  connect(&projects_, &RecentProjects::changed, this, &StartPage::list);
  connect(recent_, &QListWidget::itemClicked, recent_, &QListWidget::itemActivated);

  auto* middle = new QWidget(this);
  middle->setMaximumWidth(kPageWidth);
  auto* column = new QVBoxLayout(middle);
  column->setSpacing(16);
  column->addWidget(title_);
  column->addWidget(lead_);
  column->addSpacing(8);
  column->addWidget(choices_);
  column->addSpacing(8);
  column->addWidget(recentTitle_);
  column->addWidget(recent_, 4);
  column->addWidget(hint_);
  column->addStretch(1);
  auto* all = new QHBoxLayout(this);
  all->setContentsMargins(32, 48, 32, 32);
  all->addStretch(1);
  all->addWidget(middle, 8);
  all->addStretch(1);
  onRetranslate(this, [this] { retranslateUi(); });
  drawIcons();
  refresh();
}

QToolButton* StartPage::addChoice(const char* name, const QString& icon) {
  auto* button = new QToolButton(choices_);
  button->setObjectName(QLatin1String(name));
  button->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
  button->setIconSize({kIcon, kIcon});
  button->setFixedSize(kChoice);
  button->setFocusPolicy(Qt::StrongFocus);
  choices_->layout()->addWidget(button);
  buttons_.emplace_back(button, icon);
  return button;
}

void StartPage::retranslateUi() {
  title_->setText(tr("Dewpoint"));
  lead_->setText(tr("Follow colored things in 3D with ordinary cameras."));
  const auto name = [this](Choice choice, const QString& text, const QString& hint) {
    QToolButton* button = buttons_[choice].first;
    button->setText(text);
    button->setToolTip(hint);
    button->setAccessibleName(text);
    button->setAccessibleDescription(hint);
  };
  name(kDemo, tr("Try the demo"), tr("Two simulated cameras follow a moving ball"));
  name(kVideos, tr("Open videos"), tr("Make a project from recorded videos, one per camera"));
  name(kCameras, tr("Cameras"), tr("Make a project from connected cameras or network streams"));
  name(kProject, tr("Open project"), tr("Open a project that was saved before"));
  recentTitle_->setText(tr("Recent projects"));
  recent_->setAccessibleName(tr("Recent projects"));
  hint_->setText(tr("You can also drop a project or videos onto this window."));
}

void StartPage::refresh() {
  list();
  projects_.checkFiles();
}

void StartPage::list() {
  const QListWidgetItem* now = recent_->currentItem();
  const QString chosen = now == nullptr ? QString() : now->data(Qt::UserRole).toString();
  recent_->clear();
  for (const QString& file : projects_.files()) {
    const QFileInfo info(file);
    auto* item = new QListWidgetItem(
        QStringLiteral("%1   –   %2").arg(info.completeBaseName(), info.absolutePath()), recent_);
    item->setData(Qt::UserRole, file);
    item->setToolTip(file);
    if (file == chosen) {
      recent_->setCurrentItem(item);
    }
  }
  recentTitle_->setVisible(recent_->count() > 0);
  recent_->setVisible(recent_->count() > 0);
}

void StartPage::drawIcons() {
  for (const auto& [button, icon] : buttons_) {
    button->setIcon(symbolicIcon(icon, palette()));
  }
}

void StartPage::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) {
    drawIcons();
  }
}

} // namespace dewpoint::ui
