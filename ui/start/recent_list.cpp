// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/start/recent_list.h"

#include "ui/start/recent_projects.h"
#include "ui/start/start_colors.h"
#include "ui/style/spacing.h"
#include "ui/style/symbolic_icon.h"

#include <QDir>
#include <QEvent>
#include <QFileInfo>
#include <QLocale>
#include <QPainter>
#include <QStyledItemDelegate>

namespace dewpoint::ui {

namespace {

// Pixels; chosen.
constexpr QSize kRecentPicture(80, 45);
constexpr int kRecentRow = 61;
constexpr int kRecentSymbol = 24;

enum RecentRole { kRecentFile = Qt::UserRole, kRecentFolder, kRecentState, kRecentImage };

/// Picture at the left; name, folder and date beside it.
class RecentRowDelegate : public QStyledItemDelegate {
public:
  using QStyledItemDelegate::QStyledItemDelegate;

  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& /*index*/) const override {
    const QFontMetrics lines(option.font);
    return {kRecentPicture.width(), std::max(kRecentRow, 3 * lines.height() + kSpacing)};
  }

  void paint(QPainter* painter, const QStyleOptionViewItem& option,
             const QModelIndex& index) const override {
    const QPalette& palette = option.palette;
    const bool open = option.state.testFlag(QStyle::State_Enabled);
    const bool near = open && option.state.testFlag(QStyle::State_MouseOver);
    const bool focused = option.state.testFlag(QStyle::State_HasFocus);
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    const QRectF row = QRectF(option.rect).adjusted(1, 1, -1, -1);
    const QColor accent = palette.color(QPalette::Highlight);
    painter->setPen(focused ? QPen(accent, 2.0) : QPen(Qt::NoPen));
    painter->setBrush(near || focused
                          ? QBrush(mixedColor(palette.color(QPalette::Window), accent, 0.1))
                          : QBrush(Qt::NoBrush));
    painter->drawRoundedRect(row, 6.0, 6.0);
    const QRect picture(
        QPoint(option.rect.left() + kSpacing,
               option.rect.top() + (option.rect.height() - kRecentPicture.height()) / 2),
        kRecentPicture);
    paintPicture(*painter, picture, index, palette, open);
    const QRect texts =
        option.rect.adjusted(picture.right() - option.rect.left() + 12, 0, -kSpacing, 0);
    paintTexts(*painter, texts, index, option, open);
    painter->restore();
  }

private:
  static void paintPicture(QPainter& painter, const QRect& area, const QModelIndex& index,
                           const QPalette& palette, bool open) {
    const QImage image = index.data(kRecentImage).value<QImage>();
    painter.setOpacity(open ? 1.0 : 0.4);
    if (!image.isNull()) {
      painter.setRenderHint(QPainter::SmoothPixmapTransform);
      painter.drawImage(area, image);
    } else {
      painter.setPen(Qt::NoPen);
      painter.setBrush(palette.color(QPalette::Button));
      painter.drawRect(area);
      QRect symbol(QPoint(), QSize(kRecentSymbol, kRecentSymbol));
      symbol.moveCenter(area.center());
      index.data(Qt::DecorationRole).value<QIcon>().paint(&painter, symbol);
    }
    painter.setOpacity(1.0);
  }

  static void paintTexts(QPainter& painter, const QRect& area, const QModelIndex& index,
                         const QStyleOptionViewItem& option, bool open) {
    const QPalette& palette = option.palette;
    const QColor faint = palette.color(QPalette::Disabled, QPalette::Text);
    const QColor second = open ? secondaryTextColor(palette) : faint;
    QFont bold = option.font;
    bold.setWeight(QFont::DemiBold);
    const int line = QFontMetrics(option.font).height();
    int top = area.top() + (area.height() - 3 * line) / 2;
    const auto write = [&](const QString& text, const QFont& font, const QColor& color,
                           Qt::TextElideMode elide) {
      painter.setFont(font);
      painter.setPen(color);
      painter.drawText(QRect(area.left(), top, area.width(), line),
                       Qt::AlignLeft | Qt::AlignVCenter,
                       QFontMetrics(font).elidedText(text, elide, area.width()));
      top += line;
    };
    write(index.data().toString(), bold, open ? palette.color(QPalette::Text) : faint,
          Qt::ElideRight);
    write(index.data(kRecentFolder).toString(), option.font, second, Qt::ElideMiddle);
    write(index.data(kRecentState).toString(), option.font, second, Qt::ElideRight);
  }
};

/// The folder of a file as people write it.
QString folderText(const QString& file) {
  const QString folder = QFileInfo(file).path();
  const QString home = QDir::homePath();
  return folder == home || folder.startsWith(home + QLatin1Char('/'))
             ? QLatin1Char('~') + folder.mid(home.size())
             : folder;
}

} // namespace

RecentList::RecentList(RecentProjects& projects, QWidget* parent)
    : QListWidget(parent), projects_(projects) {
  setObjectName(QStringLiteral("startRecent"));
  setFrameShape(QFrame::NoFrame);
  setItemDelegate(new RecentRowDelegate(this));
  setMouseTracking(true); // rows show that the pointer is there
  viewport()->setAutoFillBackground(false);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  const auto choose = [this](const QListWidgetItem* item) {
    if (item->flags().testFlag(Qt::ItemIsEnabled)) {
      Q_EMIT openRequested(item->data(kRecentFile).toString());
    }
  };
  connect(this, &QListWidget::itemActivated, this, choose);
  connect(this, &QListWidget::itemClicked, this, choose);
  connect(&projects_, &RecentProjects::changed, this, &RecentList::fill);
  fill();
}

void RecentList::fill() {
  const QListWidgetItem* now = currentItem();
  const QString chosen = now == nullptr ? QString() : now->data(kRecentFile).toString();
  clear();
  const QIcon symbol = symbolicIcon(QStringLiteral("video"), palette());
  for (const RecentProject& project : projects_.allProjects()) {
    auto* item = new QListWidgetItem(QFileInfo(project.file).completeBaseName(), this);
    item->setData(kRecentFile, project.file);
    item->setData(kRecentFolder, folderText(project.file));
    const QString date = QLocale().toString(project.lastModified.date(), QLocale::ShortFormat);
    item->setData(kRecentState, project.isMissing ? tr("The file no longer exists") : date);
    item->setData(kRecentImage, project.thumbnail);
    item->setIcon(symbol);
    item->setToolTip(project.file);
    if (project.isMissing) {
      item->setFlags(Qt::ItemNeverHasChildren);
    } else if (project.file == chosen) {
      setCurrentItem(item);
    }
  }
  const int rows = count() == 0 ? 0 : count() * sizeHintForRow(0);
  setFixedHeight(rows);
  setVisible(count() > 0);
}

void RecentList::changeEvent(QEvent* event) {
  QListWidget::changeEvent(event);
  const auto type = event->type();
  if (type == QEvent::LanguageChange || type == QEvent::FontChange ||
      type == QEvent::PaletteChange) {
    fill();
  }
}

} // namespace dewpoint::ui
