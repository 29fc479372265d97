// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/video_dialog.h"

#include "ui/export/export_layout.h"
#include "ui/export/export_outcome.h"
#include "ui/export/video_form.h"
#include "ui/export/video_preview.h"
#include "ui/text/error_sentence.h"
#include "ui/text/quantity_text.h"
#include "ui/text/retranslation.h"
#include "ui/widgets/named.h"

#include <QDir>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTimer>
#include <QVBoxLayout>

#include <utility>

namespace dewpoint::ui {

namespace {

constexpr int kVideoPreviewDelayMs = 200; ///< while fields are still being changed
/// Seconds by which the fields may round a time.
constexpr double kTimeTolerance = 0.00051;

} // namespace

VideoDialog::VideoDialog(std::function<VideoSources()> offer, QWidget* parent)
    : QDialog(parent), offer_(std::move(offer)), exporter_(new VideoExporter(this)),
      previewTimer_(new QTimer(this)) {
  setObjectName(QStringLiteral("videoDialog"));
  previewTimer_->setSingleShot(true);
  previewTimer_->setInterval(kVideoPreviewDelayMs);
  makeFields();
  arrangeFields();
  onRetranslate(this, [this] { retranslateUi(); });
  connectFields();
  setRunning(false);
  resetChoices(QDir::home().filePath(QStringLiteral("video")));
}

void VideoDialog::makeFields() {
  form_ = new VideoForm(this);
  preview_ = new VideoPreview(this);
  summary_ = named(new QLabel(this), "videoSummary");
  summary_->setWordWrap(true);
  outcome_ = new ExportOutcome(this);
  question_ = named(new QLabel(this), "videoQuestion");
  question_->setWordWrap(true);
  question_->hide();
  file_ = named(new QLineEdit(this), "videoFile");
  proposed_.emplace(*file_);
  browse_ = named(new QPushButton(this), "videoBrowse");
  progress_ = named(new QProgressBar(this), "videoProgress");
  progress_->setRange(0, 100);
  cancel_ = named(new QPushButton(this), "videoCancel");
  export_ = named(new QPushButton(this), "videoStart");
  close_ = named(new QPushButton(this), "videoClose");
  // Enter in a field ends typing, no more.
  for (QPushButton* button : {browse_, cancel_, export_, close_}) {
    button->setAutoDefault(false);
  }
}

void VideoDialog::arrangeFields() {
  auto* seen = new QVBoxLayout;
  seen->setSpacing(8);
  seen->addWidget(preview_, 1);
  seen->addWidget(summary_);
  auto* columns = new QHBoxLayout;
  columns->setSpacing(16);
  columns->addWidget(form_, 0, Qt::AlignTop); // its rows stay where they are when a message comes
  columns->addLayout(seen, 1);
  arrangeExportDialog(*this, columns,
                      {file_, browse_, question_, outcome_, progress_, cancel_, {export_}, close_});
}

void VideoDialog::retranslateUi() {
  setWindowTitle(tr("Export video"));
  form_->retranslateUi();
  outcome_->retranslateUi();
  preview_->retranslateUi();
  file_->setAccessibleName(tr("File"));
  file_->setToolTip(tr("File to write"));
  browse_->setText(tr("Browse…"));
  browse_->setToolTip(tr("Choose the file to write"));
  progress_->setAccessibleName(tr("Progress"));
  cancel_->setText(tr("Cancel"));
  cancel_->setToolTip(tr("Stop the export. No file is written"));
  withdrawQuestion(); // in the new language
  export_->setToolTip(tr("Write the video in the background"));
  close_->setText(tr("Close"));
  close_->setToolTip(tr("Close; a running export continues"));
  changed();
}

void VideoDialog::connectFields() {
  connect(form_, &VideoForm::changed, this, &VideoDialog::changed);
  connect(form_, &VideoForm::encodingChanged, this, &VideoDialog::updateSuffix);
  connect(previewTimer_, &QTimer::timeout, this, &VideoDialog::drawPreview);
  connect(preview_, &VideoPreview::frameChosen, this, [this] {
    if (!previewTimer_->isActive()) { // images are drawn while the slider moves
      previewTimer_->start();
    }
  });
  connect(file_, &QLineEdit::textChanged, this, &VideoDialog::withdrawQuestion);
  connect(browse_, &QPushButton::clicked, this, [this] {
    const QString chosen =
        QFileDialog::getSaveFileName(this, tr("Export video"), file_->text(), QString(), nullptr,
                                     QFileDialog::DontConfirmOverwrite); // this dialog asks
    if (!chosen.isEmpty()) {
      file_->setText(chosen);
    }
  });
  connect(export_, &QPushButton::clicked, this, &VideoDialog::start);
  connect(cancel_, &QPushButton::clicked, exporter_, &VideoExporter::cancel);
  connect(exporter_, &VideoExporter::progressChanged, progress_, &QProgressBar::setValue);
  connect(exporter_, &VideoExporter::finished, this, [this](const QString& file) {
    Q_EMIT fileWritten(file);
    report(tr("Saved the video %1.").arg(file), file, false);
  });
  connect(exporter_, &VideoExporter::canceled, this,
          [this] { report(tr("The export was canceled."), {}, false); });
  connect(exporter_, &VideoExporter::failed, this,
          [this](const QString& sentence) { report(sentence, {}, true); });
  connect(exporter_, &VideoExporter::fileExists, this, [this](const QString& file) {
    if (isVisible()) {
      setRunning(false);
      askToReplace(file);
      previewTimer_->start(); // the preview was stopped for it
    } else {                  // nobody sees the question
      report(tr("%1 exists already; nothing was written.").arg(file), {}, true);
    }
  });
}

void VideoDialog::showEvent(QShowEvent* event) {
  QDialog::showEvent(event);
  probeEncodings();
  refresh();
}

void VideoDialog::hideEvent(QHideEvent* event) {
  QDialog::hideEvent(event);
  previewTimer_->stop();
  withdrawQuestion();
  outcome_->clear();
}

void VideoDialog::probeEncodings() {
  if (isProbed_ || probe_.isRunning()) {
    return;
  }
  probe_.start([this](const BackgroundJob::Progress&) -> std::function<void()> {
    const QTemporaryDir folder;
    auto found = writableVideoEncodings(folder.path().toStdString());
    return [this, found = std::move(found)] {
      isProbed_ = true;
      form_->setEncodings(found);
      setRunning(exporter_->isRunning());
      changed();
    };
  });
}

void VideoDialog::setSelectedRange(std::optional<std::pair<double, double>> seconds) {
  form_->setSelectedRange(seconds);
}

void VideoDialog::proposeFile(const QString& file) {
  proposed_->propose(file);
}

void VideoDialog::resetChoices(const QString& file) {
  form_->resetRange();
  proposed_->reset(file);
  updateSuffix();
}

void VideoDialog::refresh() {
  form_->setViews(offer_().views);
  setRunning(exporter_->isRunning());
  changed();
}

void VideoDialog::stop(const QString& reason) {
  previewTimer_->stop();
  if (exporter_->isRunning()) {
    exporter_->abandon(reason);
  } else {
    exporter_->drawer().stop();
  }
}

void VideoDialog::updateSuffix() {
  const QString suffix = form_->fileSuffix();
  if (!suffix.isEmpty()) {
    QStringList known;
    for (const VideoEncoding& encoding : videoEncodings()) {
      known << QString::fromUtf8(encoding.suffix.data());
    }
    proposed_->setSuffix(suffix, known);
  }
  changed();
}

Result<VideoRequest> VideoDialog::request(const VideoSources& offer) const {
  VideoLayout look = form_->videoLayout();
  if (look.views.empty()) {
    return failure(ErrorCode::BadValue, "", tr("Views").toStdString(),
                   tr("no view is checked").toStdString());
  }
  look.recordingName = offer.recordingName;
  const auto from = form_->startSeconds();
  const auto to = form_->endSeconds();
  std::vector<FrameTime> frames = offer.frames ? offer.frames() : std::vector<FrameTime>();
  std::erase_if(frames, [&](const FrameTime& one) {
    const bool isBefore = from && one.timeSeconds < *from - kTimeTolerance;
    const bool isAfter = to ? one.timeSeconds > *to + kTimeTolerance
                            : offer.lastTrackedFrame >= 0 && one.frame > offer.lastTrackedFrame;
    return isBefore || isAfter;
  });
  const VideoTiming timing = form_->timing(offer.framesPerSecond);
  auto shown = chooseVideoFrames(frames, timing);
  if (!shown) {
    return tl::make_unexpected(shown.error());
  }
  VideoRequest wanted;
  wanted.layout = std::make_shared<const VideoLayout>(std::move(look));
  wanted.frames = std::move(*shown);
  wanted.encoding = form_->encoding().value_or(VideoEncoding());
  wanted.framesPerSecond = timing.framesPerSecond;
  wanted.file = file_->text().toStdString();
  wanted.replacesFile = mayReplace_;
  return wanted;
}

void VideoDialog::changed() {
  withdrawQuestion();
  if (isVisible() && !exporter_->isRunning()) {
    previewTimer_->start();
  }
}

void VideoDialog::drawPreview() {
  const VideoSources offer = offer_();
  if (offer.session == nullptr || exporter_->isRunning() || !isVisible()) {
    return;
  }
  const auto wanted = request(offer);
  if (!wanted) {
    preview_->setFrames({});
    preview_->showImage({});
    summary_->setText(errorText(wanted.error()));
    return;
  }
  preview_->setFrames(wanted->frames);
  VideoDrawer& drawer = exporter_->drawer();
  drawer.beginVideo(offer.session, wanted->layout, offer.birdsEyeView);
  const QSize pixels = preview_->imageSize();
  const auto consume = [this, request = *wanted,
                        pixels](Result<QImage> image) -> std::function<void()> {
    if (image) {
      image = image->scaled(pixels, Qt::KeepAspectRatio, Qt::SmoothTransformation);
    }
    return [this, request, image] { showPreview(request, image); };
  };
  drawer.draw(preview_->frame(), consume, [] { return true; });
}

void VideoDialog::showPreview(const VideoRequest& wanted, const Result<QImage>& image) {
  if (!image) {
    preview_->showImage({});
    summary_->setText(errorText(image.error()));
    return;
  }
  preview_->showImage(*image);
  const auto images = static_cast<double>(wanted.frames.size());
  QString text = tr("Images: %1. Length: %2. Size: %3 × %4 pixels.")
                     .arg(wanted.frames.size())
                     .arg(secondsText(images / wanted.framesPerSecond, 1))
                     .arg(wanted.layout->size.width())
                     .arg(wanted.layout->size.height());
  if (exporter_->drawer().isSceneResolutionReduced()) {
    text +=
        QLatin1Char(' ') + tr("This computer draws the bird's-eye view slowly. It is drawn in a "
                              "smaller size and enlarged.");
  }
  summary_->setText(text);
}

void VideoDialog::setRunning(bool running) {
  progress_->setVisible(running);
  cancel_->setVisible(running);
  form_->setEnabled(!running);
  if (!running) {
    progress_->setValue(0);
  }
  export_->setEnabled(!running && form_->hasEncodings() && offer_().session != nullptr);
  if (isProbed_ && !form_->hasEncodings()) {
    outcome_->showResult(tr("This computer has no encoder for videos."));
  }
}

void VideoDialog::askToReplace(const QString& file) {
  question_->setText(tr("%1 exists already. Replace it?").arg(file));
  question_->show();
  export_->setText(tr("Replace"));
  mayReplace_ = true;
}

void VideoDialog::withdrawQuestion() {
  mayReplace_ = false;
  question_->hide();
  export_->setText(tr("Export"));
}

void VideoDialog::start() {
  const VideoSources offer = offer_();
  auto wanted = request(offer);
  withdrawQuestion();
  outcome_->clear();
  if (offer.session == nullptr || exporter_->isRunning()) {
    return;
  }
  if (!wanted) {
    report(errorText(wanted.error()), {}, true);
    return;
  }
  previewTimer_->stop();
  exporter_->start(std::move(*wanted), offer.session, offer.birdsEyeView);
  setRunning(true);
}

void VideoDialog::report(const QString& sentence, const QString& file, bool isFailure) {
  setRunning(false);
  if (isVisible()) {
    outcome_->showResult(sentence, file);
  }
  if (isFailure) {
    Q_EMIT failed(sentence);
  } else {
    Q_EMIT exportEnded(sentence);
  }
}

} // namespace dewpoint::ui
