// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/notice_list.h"

#include <QLabel>
#include <QSignalSpy>
#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

class NoticeListTest : public testing::Test {
protected:
  QString text() const {
    const auto* label = list_.findChild<QLabel*>(QStringLiteral("noticesText"));
    return list_.isHidden() ? QString() : label->text();
  }

  NoticeList list_;
};

TEST_F(NoticeListTest, EveryNoticeIsShownAsLongAsItsCauseLasts) {
  EXPECT_TRUE(text().isEmpty());
  QSignalSpy began(&list_, &NoticeList::noticeBegan);
  QSignalSpy ended(&list_, &NoticeList::noticeEnded);
  list_.setNotices({QStringLiteral("left: unplugged"), QStringLiteral("right: unplugged")});
  EXPECT_EQ(text(), QStringLiteral("left: unplugged\nright: unplugged"));
  EXPECT_EQ(began.size(), 2);
  list_.setNotices({QStringLiteral("left: unplugged"), QStringLiteral("right: unplugged")});
  EXPECT_EQ(began.size(), 2); // the same ones are no news
  list_.setNotices({QStringLiteral("right: unplugged"), QStringLiteral("right: unplugged")});
  EXPECT_EQ(text(), QStringLiteral("right: unplugged"));
  ASSERT_EQ(ended.size(), 1);
  EXPECT_EQ(ended.front().front().toString(), QStringLiteral("left: unplugged"));
  list_.setNotices({});
  EXPECT_TRUE(list_.isHidden());
}

TEST_F(NoticeListTest, HiddenNoticesAreCountedAndAReturningOneIsShown) {
  QSignalSpy counted(&list_, &NoticeList::hiddenCountChanged);
  list_.setNotices({QStringLiteral("a"), QStringLiteral("b")});
  list_.hideShown();
  EXPECT_TRUE(list_.isHidden());
  EXPECT_EQ(list_.hiddenCount(), 2);
  list_.setNotices({QStringLiteral("a"), QStringLiteral("b"), QStringLiteral("c")});
  EXPECT_EQ(text(), QStringLiteral("c"));
  list_.setNotices({QStringLiteral("b"), QStringLiteral("c")});
  EXPECT_EQ(list_.hiddenCount(), 1);
  list_.setNotices({QStringLiteral("a"), QStringLiteral("b"), QStringLiteral("c")});
  EXPECT_EQ(text(), QStringLiteral("a\nc")); // it came back
  list_.showAll();
  EXPECT_EQ(text(), QStringLiteral("a\nb\nc"));
  EXPECT_EQ(list_.hiddenCount(), 0);
  EXPECT_EQ(counted.size(), 3);
}

TEST_F(NoticeListTest, MoreThanFitAreCountedInTheLastLine) {
  QStringList many;
  for (int k = 0; k < NoticeList::kMaxNoticeLines + 3; ++k) {
    many += QStringLiteral("notice %1").arg(k);
  }
  list_.setNotices(many);
  EXPECT_EQ(text().split(QLatin1Char('\n')).size(), NoticeList::kMaxNoticeLines + 1);
  EXPECT_TRUE(text().contains(QLatin1Char('3')));
  EXPECT_EQ(list_.findChild<QLabel*>(QStringLiteral("noticesText"))->toolTip(),
            many.join(QLatin1Char('\n')));
}

} // namespace
} // namespace dewpoint::tests
