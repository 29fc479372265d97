// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/mainwindow/speed_button.h"

#include "ui/preferences/preferences.h"
#include "ui/text/retranslation.h"

#include <QAction>
#include <QActionGroup>
#include <QMainWindow>
#include <QMenu>
#include <QStyleOptionToolButton>
#include <QStylePainter>

#include <algorithm>
#include <array>
#include <cmath>

namespace dewpoint::ui {

namespace {

constexpr std::array<double, 9> kSpeeds{
    Pace::kSlowest, 1.0 / 16.0, 1.0 / 8.0, 1.0 / 4.0, 1.0 / 2.0, 1.0, 2.0, 4.0, Pace::kFastest};

constexpr int kArrowSide = 9; ///< pixels
constexpr int kArrowMargin = 3;

/// "1/8 ×", "2 ×".
QString playSpeedText(double speed) {
  const bool isPart = speed < 1.0;
  const int number = static_cast<int>(std::lround(isPart ? 1.0 / speed : speed));
  return isPart ? SpeedButton::tr("1/%1 ×", "speed").arg(number)
                : SpeedButton::tr("%1 ×", "speed").arg(number);
}

/// The index of the speed in kSpeeds that is nearest by its ratio.
std::size_t nearestSpeed(double speed) {
  const auto distance = [speed](double one) { return std::abs(std::log(one / speed)); };
  return static_cast<std::size_t>(std::ranges::min_element(kSpeeds, {}, distance) -
                                  kSpeeds.begin());
}

} // namespace

SpeedButton::SpeedButton(const Workbench& bench, QWidget* parent)
    : QToolButton(parent), bench_(bench), speeds_(new QActionGroup(this)) {
  setObjectName(QStringLiteral("speedButton"));
  setPopupMode(QToolButton::InstantPopup);
  setToolButtonStyle(Qt::ToolButtonTextOnly);
  setFocusPolicy(Qt::NoFocus); // Space stays with play
  auto* menu = new QMenu(this);
  menu->setObjectName(QStringLiteral("menuSpeed"));
  for (const double speed : kSpeeds) {
    QAction* one = menu->addAction(QString());
    one->setObjectName(QStringLiteral("qt_speed")); // no action of the window: it has no key
    one->setCheckable(true);
    one->setData(speed);
    speeds_->addAction(one);
    connect(one, &QAction::triggered, this, [this, speed] { setSpeed(speed); });
  }
  menu->addSeparator();
  menu->addAction(bench_.action("actionSlowStart"));
  setMenu(menu);
  connectActions();
  connect(&bench_.session, &SessionController::paceChanged, this, &SpeedButton::showPace);
  onRetranslate(this, [this] {
    setToolTip(
        tr("Playback speed of the recording. Live cameras are always tracked in real time."));
    setAccessibleName(tr("Speed"));
    for (QAction* one : speeds_->actions()) {
      one->setText(playSpeedText(one->data().toDouble()));
    }
    setMinimumWidth(fontMetrics().horizontalAdvance(playSpeedText(Pace::kSlowest)) + 24);
    showPace();
  });
}

void SpeedButton::paintEvent(QPaintEvent* /*event*/) {
  QStylePainter painter(this);
  QStyleOptionToolButton option;
  initStyleOption(&option);
  // The style draws the arrow of a menu as a speck in the corner. Here it stands beside the speed.
  option.features &= ~QStyleOptionToolButton::HasMenu;
  painter.drawComplexControl(QStyle::CC_ToolButton, option);
  QStyleOption arrow = option;
  arrow.rect = QRect(width() - kArrowSide - kArrowMargin, (height() - kArrowSide) / 2 + 1,
                     kArrowSide, kArrowSide);
  painter.drawPrimitive(QStyle::PE_IndicatorArrowDown, arrow);
}

void SpeedButton::connectActions() {
  bench_.onTriggered("actionSlower", this, [this] { step(-1); });
  bench_.onTriggered("actionFaster", this, [this] { step(1); });
  bench_.onTriggered("actionNormalSpeed", this, [this] { setSpeed(1.0); });
  bench_.onToggled("actionSlowStart", this, [this](bool slow) {
    Preferences().setSlowUntilTracking(slow);
    Pace pace = bench_.session.pace();
    pace.slowUntilTracking = slow;
    bench_.session.setPace(pace);
  });
  bench_.action("actionSlowStart")->setChecked(Preferences().isSlowUntilTracking());
}

void SpeedButton::setSpeed(double speed) {
  Pace pace = bench_.session.pace();
  pace.speedFactor = speed;
  bench_.session.setPace(pace);
}

void SpeedButton::step(int direction) {
  const auto now = static_cast<int>(nearestSpeed(bench_.session.pace().speedFactor));
  const int next = std::clamp(now + direction, 0, static_cast<int>(kSpeeds.size()) - 1);
  setSpeed(kSpeeds[static_cast<std::size_t>(next)]);
}

void SpeedButton::showPace() {
  const std::size_t now = nearestSpeed(bench_.session.pace().speedFactor);
  setText(playSpeedText(kSpeeds[now]));
  speeds_->actions().at(static_cast<qsizetype>(now))->setChecked(true);
  bench_.action("actionSlower")->setEnabled(now > 0);
  bench_.action("actionFaster")->setEnabled(now + 1 < kSpeeds.size());
  bench_.action("actionNormalSpeed")->setEnabled(kSpeeds[now] != 1.0);
}

} // namespace dewpoint::ui
