// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/dock_title.h"

#include <QDockWidget>
#include <QLabel>
#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

TEST(DockTitle, AReasonAloneStandsInPlaceOfTheState) {
  QDockWidget dock;
  dock.setObjectName(QStringLiteral("dock"));
  DockTitle title(&dock);
  const auto* state = title.findChild<QLabel*>(QStringLiteral("dockTitleState"));
  const auto* reason = title.findChild<QLabel*>(QStringLiteral("dockTitleReason"));
  title.setState(HoldState::Held);
  title.setReason(QStringLiteral("partly hidden"));
  EXPECT_FALSE(state->isHidden());
  const QColor plain = reason->palette().color(QPalette::WindowText);
  title.setReasonAlone(QStringLiteral("◌ hidden here"));
  EXPECT_TRUE(state->isHidden());
  EXPECT_EQ(reason->text(), QStringLiteral("◌ hidden here"));
  EXPECT_EQ(reason->palette().color(QPalette::WindowText),
            holdColor(HoldState::Hidden, title.palette()));
  title.setReason({});
  EXPECT_FALSE(state->isHidden());
  EXPECT_EQ(reason->palette().color(QPalette::WindowText), plain);
}

} // namespace
} // namespace dewpoint::tests
