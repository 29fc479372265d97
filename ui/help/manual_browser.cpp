// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/help/manual_browser.h"

#include <QAbstractTextDocumentLayout>
#include <QFileInfo>
#include <QImageReader>
#include <QScrollBar>
#include <QTextBlock>
#include <QTextDocument>
#include <QTextFrame>
#include <QTextTable>

#include <algorithm>

namespace dewpoint::ui {

namespace {

constexpr int kWidestPicture = 620; ///< pixels; a page is a little wider
constexpr double kManualMargin = 20.0;
constexpr double kAboveHeading = 18.0;
constexpr double kBelowHeading = 6.0;
constexpr double kCellPadding = 5.0;
constexpr double kTableBorder = 0.5;

bool isManualPage(const QUrl& url) {
  return url.path().endsWith(QStringLiteral(".md"));
}

} // namespace

ManualBrowser::ManualBrowser(QWidget* parent) : QTextBrowser(parent) {
  setObjectName(QStringLiteral("manualText"));
  setOpenExternalLinks(true);
  setFrameShape(QFrame::NoFrame);
  document()->setDocumentMargin(kManualMargin);
}

QString ManualBrowser::slugOf(const QString& heading) {
  QString slug;
  for (const QChar letter : heading.trimmed().toLower()) {
    if (letter.isLetterOrNumber() || letter == u'_' || letter == u'-') {
      slug += letter;
    } else if (letter.isSpace()) {
      slug += u'-';
    }
  }
  return slug;
}

void ManualBrowser::doSetSource(const QUrl& url, QTextDocument::ResourceType /*type*/) {
  if (url.isLocalFile() && !QFileInfo(url.toLocalFile()).isFile()) {
    return; // a folder of the sources, say: there is nothing to read
  }
  const QUrl page = url.adjusted(QUrl::RemoveFragment);
  const bool isSame = page == source().adjusted(QUrl::RemoveFragment);
  QTextBrowser::doSetSource(url, isManualPage(url) ? QTextDocument::MarkdownResource
                                                   : QTextDocument::UnknownResource);
  if (!isSame) {
    layOutPage();
  }
  if (url.hasFragment()) {
    scrollToHeading(url.fragment());
  } else if (!isSame) {
    verticalScrollBar()->setValue(0);
  }
}

void ManualBrowser::layOutPage() {
  document()->setDocumentMargin(kManualMargin);
  QTextCursor cursor(document());
  cursor.beginEditBlock();
  for (QTextBlock block = document()->begin(); block.isValid(); block = block.next()) {
    if (block.blockFormat().headingLevel() > 0) {
      QTextBlockFormat format;
      format.setTopMargin(kAboveHeading);
      format.setBottomMargin(kBelowHeading);
      QTextCursor(block).mergeBlockFormat(format);
    }
  }
  for (QTextFrame* frame : document()->rootFrame()->childFrames()) {
    if (auto* table = qobject_cast<QTextTable*>(frame)) {
      QTextTableFormat format = table->format();
      format.setCellPadding(kCellPadding);
      format.setCellSpacing(0.0);
      format.setBorderCollapse(true);
      format.setBorder(kTableBorder);
      format.setBorderBrush(palette().color(QPalette::Mid));
      table->setFormat(format);
    }
  }
  cursor.endEditBlock();
}

void ManualBrowser::scrollToHeading(const QString& slug) {
  for (QTextBlock block = document()->begin(); block.isValid(); block = block.next()) {
    if (block.blockFormat().headingLevel() > 0 && slugOf(block.text()) == slug) {
      const QRectF place = document()->documentLayout()->blockBoundingRect(block);
      verticalScrollBar()->setValue(static_cast<int>(place.top()) - 8);
      setTextCursor(QTextCursor(block));
      return;
    }
  }
}

QVariant ManualBrowser::loadResource(int type, const QUrl& name) {
  if (type != QTextDocument::ImageResource) {
    return QTextBrowser::loadResource(type, name);
  }
  const QString file = name.toLocalFile(); // the address of the page is in it
  const QSize whole = QImageReader(file).size();
  if (whole.isEmpty()) {
    return {};
  }
  const int width = std::min(kWidestPicture, whole.width());
  const QSize shown(width, std::max(1, whole.height() * width / whole.width()));
  ++waiting_;
  pictures_.add([this, file, shown, name]() -> std::function<void()> {
    const QImage picture =
        QImage(file).scaled(shown, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
    return [this, picture, name] {
      --waiting_;
      if (!picture.isNull()) { // of another page by now: it does no harm
        document()->addResource(QTextDocument::ImageResource, name, picture);
        viewport()->update();
      }
    };
  });
  QImage room(shown, QImage::Format_ARGB32_Premultiplied); // as large as what comes
  room.fill(Qt::transparent);
  return room;
}

} // namespace dewpoint::ui
