// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/start/start_page.h"

#include "ui/start/card_grid.h"
#include "ui/start/gallery_card.h"
#include "ui/start/recent_list.h"
#include "ui/start/recent_projects.h"
#include "ui/text/retranslation.h"
#include "ui/widgets/page_title.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QScrollArea>
#include <QVBoxLayout>

#include <array>

namespace dewpoint::ui {

namespace {

// Pixels; chosen on the rhythm of the spacing.
constexpr int kWidestPage = 1280;
constexpr int kPageMargin = 32;
constexpr int kColumnGap = 32;
constexpr int kPartGap = 16;
constexpr int kOwnWidth = 232; ///< at least

/// A card of the gallery: the scene it opens, and its texts.
struct GalleryEntry {
  const char* card;    ///< object name
  const char* scene;   ///< name of the built-in scene; empty: the demo
  const char* picture; ///< in the resources
  bool calibrate;
  const char* title;
  const char* line;
};
constexpr std::array kGallery = std::to_array<GalleryEntry>({
    {"startConverge", "converge", "converge", false,
     QT_TRANSLATE_NOOP("dewpoint::ui::StartPage", "Watch the filter converge"),
     QT_TRANSLATE_NOOP("dewpoint::ui::StartPage",
                       "A cloud of guesses slides along a line of sight and snaps onto the ball.")},
    {"startOccluder", "occluder", "occluder", false,
     QT_TRANSLATE_NOOP("dewpoint::ui::StartPage", "Hidden for a second"),
     QT_TRANSLATE_NOOP(
         "dewpoint::ui::StartPage",
         "A box passes in front of the ball. One camera is enough to keep tracking the ball.")},
    {"startLookAlikes", "look-alikes", "look-alikes", false,
     QT_TRANSLATE_NOOP("dewpoint::ui::StartPage", "Identical balls"),
     QT_TRANSLATE_NOOP("dewpoint::ui::StartPage",
                       "Other balls have the same color, but only one ball moves.")},
    {"startOffice", "office", "office", false,
     QT_TRANSLATE_NOOP("dewpoint::ui::StartPage", "People in an office"),
     QT_TRANSLATE_NOOP("dewpoint::ui::StartPage",
                       "Four cameras find everyone in 3D and give each person a number.")},
    {"startOneCamera", "one-camera", "one-camera", false,
     QT_TRANSLATE_NOOP("dewpoint::ui::StartPage", "One camera, target in a box"),
     QT_TRANSLATE_NOOP(
         "dewpoint::ui::StartPage",
         "Needs no calibration: the target is marked with a rectangle and tracked by its colors.")},
    {"startCalibrate", "", "calibrate", true,
     QT_TRANSLATE_NOOP("dewpoint::ui::StartPage", "Calibrate by hand"),
     QT_TRANSLATE_NOOP("dewpoint::ui::StartPage",
                       "Drag a grid over the images until it matches the floor.")},
});

} // namespace

StartPage::StartPage(RecentProjects& recent, QWidget* parent)
    : QWidget(parent), projects_(recent), page_(new QWidget), title_(new QLabel(page_)),
      intro_(new QLabel(page_)),
      demo_(new GalleryCard("startDemo", GalleryCard::CardLayout::Large, page_)),
      gallery_(new CardGrid(page_)), ownTitle_(makePageTitle(page_)),
      videos_(new GalleryCard("startVideos", GalleryCard::CardLayout::Row, page_)),
      cameras_(new GalleryCard("startCameras", GalleryCard::CardLayout::Row, page_)),
      calibrate_(new GalleryCard("startGuide", GalleryCard::CardLayout::Row, page_)),
      open_(new GalleryCard("startProject", GalleryCard::CardLayout::Row, page_)),
      recentTitle_(makePageTitle(page_)), recent_(new RecentList(recent, page_)),
      hint_(new QLabel(page_)) {
  setObjectName(QStringLiteral("startPage"));
  QFont big = title_->font();
  big.setPointSizeF(big.pointSizeF() * 2.0);
  big.setWeight(QFont::DemiBold);
  title_->setFont(big);
  intro_->setWordWrap(true);
  hint_->setWordWrap(true);
  hint_->setForegroundRole(QPalette::PlaceholderText);
  makeScenes();
  makeOwnRecordingCards();
  arrange();
  onRetranslate(this, [this] { retranslateUi(); });
  refresh();
}

void StartPage::makeScenes() {
  const auto opens = [this](GalleryCard* card, const QString& scene, bool calibrate) {
    connect(card, &QToolButton::clicked, this, [this, card, scene, calibrate] {
      pressed_ = card;
      Q_EMIT builtInSceneRequested(scene, calibrate);
    });
  };
  demo_->setPicture(QStringLiteral("demo"));
  opens(demo_, {}, false);
  for (const GalleryEntry& entry : kGallery) {
    auto* card = new GalleryCard(entry.card, GalleryCard::CardLayout::Tile, gallery_);
    card->setPicture(QLatin1String(entry.picture));
    opens(card, QLatin1String(entry.scene), entry.calibrate);
    gallery_->add(card);
    scenes_.push_back(card);
  }
}

void StartPage::makeOwnRecordingCards() {
  videos_->setSymbol(QStringLiteral("video"));
  cameras_->setSymbol(QStringLiteral("camera"));
  calibrate_->setSymbol(QStringLiteral("mark"));
  open_->setSymbol(QStringLiteral("open"));
  connect(videos_, &QToolButton::clicked, this, &StartPage::startWithVideosRequested);
  connect(cameras_, &QToolButton::clicked, this, &StartPage::startWithCamerasRequested);
  connect(calibrate_, &QToolButton::clicked, this, &StartPage::calibrationRequested);
  connect(open_, &QToolButton::clicked, this, [this] { Q_EMIT projectRequested({}); });
  connect(recent_, &RecentList::openRequested, this, &StartPage::projectRequested);
  connect(&projects_, &RecentProjects::changed, this, &StartPage::showRecentTitle);
  showRecentTitle();
}

void StartPage::arrange() {
  auto* left = new QVBoxLayout;
  left->setSpacing(kPartGap);
  left->addWidget(demo_);
  left->addWidget(gallery_);
  left->addStretch(1);
  auto* right = new QVBoxLayout;
  right->setSpacing(8);
  right->addWidget(ownTitle_);
  right->addWidget(videos_);
  right->addWidget(cameras_);
  right->addWidget(calibrate_);
  right->addWidget(open_);
  right->addWidget(hint_);
  right->addSpacing(kPartGap);
  right->addWidget(recentTitle_);
  right->addWidget(recent_);
  right->addStretch(1);
  videos_->setMinimumWidth(kOwnWidth);
  auto* columns = new QHBoxLayout;
  columns->setSpacing(kColumnGap);
  columns->addLayout(left, 3);
  columns->addLayout(right, 1);
  auto* middle = new QWidget(page_);
  middle->setMaximumWidth(kWidestPage);
  auto* column = new QVBoxLayout(middle);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(title_);
  column->addSpacing(4);
  column->addWidget(intro_);
  column->addSpacing(kPartGap);
  column->addLayout(columns, 1);
  auto* all = new QHBoxLayout(page_);
  all->setContentsMargins(kPageMargin, 24, kPageMargin, 24);
  all->addStretch(1);
  all->addWidget(middle, 100);
  all->addStretch(1);
  auto* scroll = new QScrollArea(this);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setFocusPolicy(Qt::NoFocus);
  scroll->setWidget(page_);
  auto* whole = new QVBoxLayout(this);
  whole->setContentsMargins(0, 0, 0, 0);
  whole->addWidget(scroll);
}

void StartPage::retranslateUi() {
  title_->setText(tr("Dewpoint"));
  intro_->setText(tr("Follow colored objects in 3D with ordinary cameras."));
  demo_->setTexts(
      tr("Try the demo"),
      tr("Two simulated cameras see a pink ball; a particle filter finds it and follows it through "
         "space. Pause, go back, change anything: you cannot break it."));
  for (std::size_t k = 0; k < scenes_.size(); ++k) {
    scenes_[k]->setTexts(tr(kGallery[k].title), tr(kGallery[k].line));
  }
  ownTitle_->setText(tr("Your own data"));
  videos_->setTexts(tr("Open videos…"), tr("One recording per camera"));
  cameras_->setTexts(tr("Use cameras…"), tr("Connected cameras or network streams"));
  calibrate_->setTexts(tr("Calibrate cameras…"),
                       tr("From videos of a board or a ball, step by step"));
  open_->setTexts(tr("Open a project…"), tr("A project saved earlier"));
  hint_->setText(tr("You can also drop a project or videos onto this window."));
  recentTitle_->setText(tr("Recent projects"));
  recent_->setAccessibleName(tr("Recent projects"));
}

void StartPage::showRecentTitle() {
  recentTitle_->setVisible(!projects_.allProjects().empty());
}

void StartPage::refresh() {
  recent_->fill();
  showRecentTitle();
  projects_.checkFiles();
}

void StartPage::setOpening(bool opening) {
  if (pressed_ != nullptr) {
    pressed_->setBusy(opening);
  }
  if (!opening) {
    pressed_ = nullptr;
  }
}

} // namespace dewpoint::ui
