// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/start/camera_table.h"

#include "ui/start/start_colors.h"
#include "ui/style/image.h"
#include "ui/style/theme.h"
#include "ui/text/camera_names.h"
#include "ui/text/error_sentence.h"
#include "ui/text/quantity_text.h"

#include <QEvent>
#include <QFileInfo>
#include <QHeaderView>
#include <QLineEdit>
#include <QPainter>
#include <QSignalBlocker>
#include <QStyledItemDelegate>

#include <algorithm>
#include <utility>

namespace dewpoint::ui {

namespace {

enum CameraParameterColumn { kNameColumn, kSourceColumn, kFoundColumn, kCameraColumns };

// Pixels; chosen.
constexpr QSize kRowPicture(72, 40);
constexpr int kCameraRowHeight = 48;
constexpr int kNarrowestColumn = 160;

/// Shows what an address looks like as long as there is none, and the end of long paths.
class SourceDelegate : public QStyledItemDelegate {
public:
  using QStyledItemDelegate::QStyledItemDelegate;

  QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option,
                        const QModelIndex& index) const override {
    QWidget* editor = QStyledItemDelegate::createEditor(parent, option, index);
    if (auto* line = qobject_cast<QLineEdit*>(editor)) {
      line->setPlaceholderText(example());
    }
    return editor;
  }

protected:
  void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override {
    QStyledItemDelegate::initStyleOption(option, index);
    option->textElideMode = Qt::ElideLeft;
    if (option->text.isEmpty()) {
      option->text = example();
      option->palette.setColor(QPalette::Text, option->palette.color(QPalette::PlaceholderText));
      option->features |= QStyleOptionViewItem::HasDisplay;
    }
  }

private:
  static QString example() {
    return CameraTable::tr("rtsp://192.168.0.10/stream, or a device number such as 0");
  }
};

/// The picture in the middle of a tile of one size, so that rows are alike.
QIcon rowPicture(const cv::Mat& preview, const QPalette& palette, double ratio) {
  QPixmap tile(kRowPicture * ratio);
  tile.setDevicePixelRatio(ratio);
  tile.fill(palette.color(QPalette::Button));
  if (const QImage image = toQImage(preview); !image.isNull()) {
    QPainter painter(&tile);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    QRect area(QPoint(), image.size().scaled(kRowPicture, Qt::KeepAspectRatio));
    area.moveCenter(QRect(QPoint(), kRowPicture).center());
    painter.drawImage(area, image);
  }
  return {tile};
}

} // namespace

CameraTable::CameraTable(QWidget* parent)
    : QTableWidget(parent), jobs_(std::make_unique<JobQueue>()) {
  setObjectName(QStringLiteral("newCameras"));
  setColumnCount(kCameraColumns);
  setItemDelegateForColumn(kSourceColumn, new SourceDelegate(this));
  setIconSize(kRowPicture);
  setShowGrid(false);
  setWordWrap(true);
  verticalHeader()->hide();
  verticalHeader()->setDefaultSectionSize(kCameraRowHeight);
  horizontalHeader()->setHighlightSections(false);
  horizontalHeader()->setMinimumSectionSize(kNarrowestColumn);
  horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  horizontalHeader()->setSectionResizeMode(kNameColumn, QHeaderView::ResizeToContents);
  horizontalHeader()->setSectionResizeMode(kSourceColumn, QHeaderView::Stretch);
  horizontalHeader()->setSectionResizeMode(kFoundColumn, QHeaderView::Stretch);
  setSelectionBehavior(QAbstractItemView::SelectRows);
  setTabKeyNavigation(false);
  connect(this, &QTableWidget::itemSelectionChanged, this, &CameraTable::changed);
  connect(this, &QTableWidget::itemChanged, this, [this](const QTableWidgetItem* item) {
    if (item->column() == kSourceColumn) {
      examine(item->text());
      showKnown();
    }
    Q_EMIT changed();
  });
}

void CameraTable::clearTable() {
  jobs_ = std::make_unique<JobQueue>();
  known_.clear();
  imageFolders_.clear();
  setRowCount(0);
  Q_EMIT changed();
}

void CameraTable::addFootage(const FootageLocation& place) {
  const int row = rowCount();
  const QString location = QString::fromStdString(place.location);
  if (place.isImageFolder) {
    imageFolders_.insert(location);
  }
  {
    const QSignalBlocker known(this); // nothing was typed
    insertRow(row);
    const QString name = place.isFile ? QFileInfo(location).completeBaseName()
                                      : cameraName(std::string(), static_cast<std::size_t>(row));
    setItem(row, kNameColumn, new QTableWidgetItem(name));
    setItem(row, kSourceColumn, new QTableWidgetItem(location));
    auto* found = new QTableWidgetItem;
    found->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable);
    setItem(row, kFoundColumn, found);
  }
  examine(location);
  showKnown();
  Q_EMIT changed();
}

void CameraTable::addAddressRow() {
  addFootage(FootageLocation());
  const int row = rowCount() - 1;
  setCurrentCell(row, kSourceColumn);
  editItem(item(row, kSourceColumn));
}

void CameraTable::removeSelectedRows() {
  while (hasSelection()) {
    removeRow(selectedItems().front()->row());
  }
  Q_EMIT changed();
}

bool CameraTable::isListed(const QString& location) const {
  const auto found = findItems(location, Qt::MatchFixedString | Qt::MatchCaseSensitive);
  return std::ranges::any_of(found, [](auto* item) { return item->column() == kSourceColumn; });
}

QString CameraTable::textAt(int row, int column) const {
  const QTableWidgetItem* one = item(row, column);
  return one == nullptr ? QString() : one->text().trimmed();
}

QString CameraTable::locationAt(int row) const {
  return textAt(row, kSourceColumn);
}

bool CameraTable::hasImageFolders() const {
  for (int row = 0; row < rowCount(); ++row) {
    if (imageFolders_.contains(locationAt(row))) {
      return true;
    }
  }
  return false;
}

std::vector<NewCamera> CameraTable::cameras() const {
  std::vector<NewCamera> cameras;
  cameras.reserve(static_cast<std::size_t>(rowCount()));
  for (int row = 0; row < rowCount(); ++row) {
    cameras.push_back({.name = textAt(row, kNameColumn).toStdString(),
                       .location = locationAt(row).toStdString()});
  }
  return cameras;
}

void CameraTable::examine(const QString& text) {
  const QString location = text.trimmed();
  if (location.isEmpty()) {
    return;
  }
  known_.erase(location); // it may be there by now
  jobs_->add([this, location]() -> std::function<void()> {
    const std::string place = location.toStdString();
    const bool isImageFolder = guessSourceKind(place) == SourceKind::Images;
    SourceInfo known;
    if (auto facts = readFootageFacts(place)) {
      known.facts = std::move(*facts);
    } else {
      known.problem = facts.error();
      known.problem->file.clear(); // it stands beside it
    }
    return [this, location, isImageFolder, known] { applyFound(location, isImageFolder, known); };
  });
}

void CameraTable::applyFound(const QString& location, bool isImageFolder, const SourceInfo& known) {
  if (isImageFolder) {
    imageFolders_.insert(location);
  }
  known_[location] = known;
  showKnown();
  Q_EMIT changed();
}

void CameraTable::showKnown() {
  const QSignalBlocker nothingTyped(this);
  for (int row = 0; row < rowCount(); ++row) {
    showKnown(row);
  }
  viewport()->update();
}

void CameraTable::showKnown(int row) {
  QTableWidgetItem* name = item(row, kNameColumn);
  QTableWidgetItem* found = item(row, kFoundColumn);
  const QString location = locationAt(row);
  item(row, kSourceColumn)->setToolTip(location);
  const auto known = known_.find(location);
  const bool isKnown = known != known_.end();
  const bool isRead = isKnown && known->second.facts.has_value();
  name->setIcon(rowPicture(isRead ? known->second.facts->preview : cv::Mat(), palette(),
                           devicePixelRatioF()));
  QString text;
  QColor color = secondaryTextColor(palette());
  if (location.isEmpty()) {
    text = QString();
  } else if (!isKnown) {
    text = tr("Reading…");
  } else if (isRead) {
    const FootageFacts& facts = *known->second.facts;
    const int frames = static_cast<int>(facts.frameCount);
    text = facts.framesPerSecond > 0.0
               ? tr("✓ %1×%2 · %3 frames per second · %n frames", nullptr, frames)
                     .arg(facts.width)
                     .arg(facts.height)
                     .arg(rateText(facts.framesPerSecond))
               : tr("✓ %1×%2 · %n images", nullptr, frames).arg(facts.width).arg(facts.height);
    color = trackingStateColor(TrackingState::Held, palette());
  } else if (known->second.problem) {
    text = tr("✗ %1").arg(errorText(*known->second.problem));
    color = trackingStateColor(TrackingState::Lost, palette());
  } else {
    text = tr("Live source: it is tested when the project is created");
  }
  found->setText(text);
  found->setToolTip(text);
  found->setForeground(color);
}

QString CameraTable::recordingMismatchText() const {
  std::vector<FootageFacts> recordings;
  for (int row = 0; row < rowCount(); ++row) {
    const auto known = known_.find(locationAt(row));
    if (known != known_.end() && known->second.facts) {
      recordings.push_back(*known->second.facts);
    }
  }
  const FootageDifferences differences = footageDifferences(recordings);
  QStringList sentences;
  if (differences.frameRatesDiffer) {
    sentences << tr("The videos have different frame rates: frame N does not show the same time in "
                    "each of them.");
  }
  if (differences.shortestFrameCount) {
    sentences << tr("The videos differ in length: only the first %n frames are used.", nullptr,
                    static_cast<int>(*differences.shortestFrameCount));
  }
  if (differences.imageSizesDiffer) {
    sentences << tr("The videos differ in size: each camera keeps its own size.");
  }
  return sentences.join(QLatin1Char('\n'));
}

void CameraTable::changeEvent(QEvent* event) {
  QTableWidget::changeEvent(event);
  if (event->type() == QEvent::LanguageChange || event->type() == QEvent::PaletteChange) {
    showKnown();
  }
}

} // namespace dewpoint::ui
