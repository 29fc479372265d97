// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/calibration/board/room_display.h"

#include "ui/calibration/board/board_calibrator.h"
#include "ui/calibration/board/board_text.h"
#include "ui/text/retranslation.h"

#include <QApplication>
#include <QKeyEvent>
#include <QLabel>
#include <QProgressBar>
#include <QVBoxLayout>

#include <algorithm>

namespace dewpoint::ui {
namespace {

constexpr int kScreenSteps = 100;
/// Letters are this part of the height of the window: five lines of advice fit.
constexpr int kLinesPerHeight = 10;
constexpr int kSmallestLetters = 16; ///< pixels
constexpr int kLetterStep = 2;       ///< pixels
constexpr QSize kSmallestWindow(640, 480);

std::size_t viewsIn(const BoardGuideState& state) {
  std::size_t views = 0;
  for (const auto& camera : state.cameras) {
    views += camera.capturedOutlines.size();
  }
  return views;
}

/// The camera that the board is shown to: the one that sees it, else the first that lacks views.
std::size_t shownCamera(const BoardGuideState& state) {
  const auto seeing = std::ranges::find_if(
      state.cameras, [](const auto& camera) { return camera.detection.has_value(); });
  if (seeing != state.cameras.end()) {
    return static_cast<std::size_t>(seeing - state.cameras.begin());
  }
  const auto fewest = std::ranges::min_element(
      state.cameras, {}, [](const auto& camera) { return camera.capturedOutlines.size(); });
  return static_cast<std::size_t>(fewest - state.cameras.begin());
}

} // namespace

RoomDisplay::RoomDisplay(BoardCalibrator& calibrator, QWidget* parent)
    : QWidget(parent, Qt::Window), calibrator_(calibrator), camera_(new QLabel(this)),
      advice_(new QLabel(this)), count_(new QLabel(this)), held_(new QProgressBar(this)),
      captured_(viewsIn(*calibrator.guideState())) {
  setObjectName(QStringLiteral("roomDisplay"));
  setAttribute(Qt::WA_DeleteOnClose);
  camera_->setObjectName(QStringLiteral("roomCamera"));
  advice_->setObjectName(QStringLiteral("roomAdvice"));
  count_->setObjectName(QStringLiteral("roomCount"));
  for (QLabel* label : {camera_, advice_, count_}) {
    label->setAlignment(Qt::AlignCenter);
    label->setWordWrap(true);
  }
  held_->setRange(0, kScreenSteps);
  held_->setTextVisible(false);
  setMinimumSize(kSmallestWindow);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(32, 32, 32, 32);
  column->setSpacing(24);
  column->addWidget(camera_);
  column->addWidget(advice_, 1);
  column->addWidget(held_);
  column->addWidget(count_);
  connect(&calibrator_, &BoardCalibrator::guideChanged, this, &RoomDisplay::refresh);
  connect(&calibrator_, &BoardCalibrator::changed, this, &RoomDisplay::refresh);
  onRetranslate(this, [this] {
    setWindowTitle(tr("What to show next – Dewpoint"));
    held_->setAccessibleName(tr("Time for which the board was held still"));
    refresh();
  });
}

void RoomDisplay::refresh() {
  const BoardGuideStatePtr state = calibrator_.guideState();
  const std::size_t views = viewsIn(*state);
  if (views > captured_) {
    QApplication::beep(); // the person looks at the board, not at the screen
  }
  captured_ = views;
  count_->setText(tr("%n views captured", nullptr, static_cast<int>(views)));
  double held = 0.0;
  if (!calibrator_.isGuiding()) {
    camera_->clear();
    advice_->setText(calibrator_.hasCapturedViews() ? tr("Done.")
                                                    : tr("Press Start on the page Board."));
  } else if (state->frame < 0 || state->cameras.empty()) {
    camera_->clear();
    advice_->setText(tr("Waiting for images…"));
  } else if (state->phase == BoardGuideState::Phase::Lenses) {
    const std::size_t shown = shownCamera(*state);
    camera_->setText(calibrator_.nameOf(shown));
    advice_->setText(adviceText(state->cameras[shown]));
    held = state->cameras[shown].lensGuidance.holdProgress;
  } else {
    camera_->clear();
    advice_->setText(cameraPairText(calibrator_, state->rigGuidance));
    held = state->rigGuidance.holdProgress;
  }
  held_->setValue(static_cast<int>(kScreenSteps * held));
  fitText(); // a longer advice has smaller letters
}

void RoomDisplay::fitText() {
  QFont letters = font();
  int size = std::max(kSmallestLetters, height() / kLinesPerHeight);
  letters.setPixelSize(size);
  const auto fits = [&] {
    const QRect place(0, 0, advice_->width(), height() / 2);
    const QRect needed =
        QFontMetrics(letters).boundingRect(place, Qt::TextWordWrap, advice_->text());
    return needed.width() <= place.width() && needed.height() <= place.height();
  };
  while (size > kSmallestLetters && !fits()) {
    size -= kLetterStep;
    letters.setPixelSize(size);
  }
  advice_->setFont(letters);
  letters.setBold(true);
  camera_->setFont(letters);
  letters.setBold(false);
  letters.setPixelSize(std::max(kSmallestLetters, height() / (2 * kLinesPerHeight)));
  count_->setFont(letters);
  held_->setFixedHeight(std::max(kSmallestLetters, height() / (2 * kLinesPerHeight)));
}

void RoomDisplay::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  fitText();
}

void RoomDisplay::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape) {
    close();
    return;
  }
  QWidget::keyPressEvent(event);
}

} // namespace dewpoint::ui
