// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/tracking_state_text.h"
#include "ui/widgets/dock_title.h"

#include <QDockWidget>
#include <QLabel>
#include <QLayout>
#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

TEST(DockTitle, AReasonAloneStandsInPlaceOfTheState) {
  QDockWidget dock;
  dock.setObjectName(QStringLiteral("dock"));
  DockTitle title(&dock);
  const auto* state = title.findChild<QLabel*>(QStringLiteral("dockTitleState"));
  const auto* reason = title.findChild<QLabel*>(QStringLiteral("dockTitleReason"));
  title.setState(TrackingState::Held);
  title.setReason(QStringLiteral("partly hidden"));
  EXPECT_FALSE(state->isHidden());
  const QColor plain = reason->palette().color(QPalette::WindowText);
  title.showReasonInsteadOfState(QStringLiteral("◌ hidden here"));
  EXPECT_TRUE(state->isHidden());
  EXPECT_EQ(reason->text(), QStringLiteral("◌ hidden here"));
  EXPECT_EQ(reason->palette().color(QPalette::WindowText),
            trackingStateColor(TrackingState::Hidden, title.palette()));
  title.setReason({});
  EXPECT_FALSE(state->isHidden());
  EXPECT_EQ(reason->palette().color(QPalette::WindowText), plain);
}

TEST(DockTitle, InANarrowViewTheStateGivesWayToTheName) {
  QDockWidget dock(QStringLiteral("camera 2"));
  dock.setObjectName(QStringLiteral("dock"));
  DockTitle title(&dock);
  const auto* name = title.findChild<QLabel*>(QStringLiteral("dockTitleName"));
  const auto* state = title.findChild<QLabel*>(QStringLiteral("dockTitleState"));
  dock.resize(500, 200);
  dock.show(); // else it is not resized
  title.setState(TrackingState::Searching);
  const int whole = title.sizeHint().width();
  title.resize(whole - state->sizeHint().width() / 2, title.sizeHint().height());
  title.layout()->activate();
  EXPECT_GE(name->width(), name->sizeHint().width());
  EXPECT_LT(state->width(), state->sizeHint().width());
  EXPECT_EQ(state->text(),
            trackingStateText(TrackingState::Searching)); // the whole text for screen readers
  // The words never keep the view from being narrower.
  EXPECT_LT(title.minimumSizeHint().width(), title.width());
}

} // namespace
} // namespace dewpoint::tests
