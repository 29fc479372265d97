// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/export/export_destination.h"
#include "ui/export/video_exporter.h"
#include "ui/jobs/background_job.h"

#include <QDialog>

#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;
class QTimer;

namespace dewpoint::ui {

class BirdsEyeView;
class ExportOutcome;
class VideoForm;
class VideoPreview;

/// What of the window can be exported as a video at present.
struct VideoOffer {
  Session* session = nullptr;   ///< null if no run is open
  std::vector<VideoView> views; ///< as they are shown
  const BirdsEyeView* scene = nullptr;
  QString recording; ///< name of the recording or take
  /// Returns all frames that can be shown, in increasing order; may be empty.
  std::function<std::vector<FrameTime>()> frames;
  std::int64_t lastTracked = -1; ///< -1: none
  double framesPerSecond = 30.0; ///< of the recording
};

/// Exports a run as a video, with a preview of its images. Not modal; an export continues
/// while the dialog is closed.
class VideoDialog : public QDialog {
  Q_OBJECT
public:
  /// `offer` is called whenever the dialog needs to know what can be exported.
  explicit VideoDialog(std::function<VideoOffer()> offer, QWidget* parent = nullptr);

  /// Proposes a time range (seconds); empty: all.
  void setSelectedRange(std::optional<std::pair<double, double>> seconds);
  /// Proposes a file, without its suffix, unless the user has entered another one.
  void proposeFile(const QString& file);
  /// Proposes a file and the whole range, for another project.
  void resetChoices(const QString& file);
  /// Shows what can be exported of another run.
  void refresh();
  /// Stops an export and drops the preview, because the frames of the run are about to be lost.
  /// `reason` is a sentence for the user.
  void stop(const QString& reason);
  bool isExporting() const { return exporter_->isRunning(); }

Q_SIGNALS:
  /// Emitted with a sentence about an export that has ended.
  void done(const QString& sentence);
  void failed(const QString& sentence);
  /// Emitted when this file was written.
  void wrote(const QString& file);

protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

private:
  void makeFields();
  void arrangeFields();
  void connectFields();
  void retranslateUi();
  /// Finds out what this computer can write, once.
  void probeEncodings();
  /// Returns the video that the fields define.
  Result<VideoRequest> request(const VideoOffer& offer) const;
  void changed();
  void updateSuffix();
  void drawPreview();
  void showPreview(const VideoRequest& wanted, const Result<QImage>& image);
  void start();
  void setRunning(bool running);
  void askToReplace(const QString& file);
  void withdrawQuestion();
  void report(const QString& sentence, const QString& file, bool isFailure);

  std::function<VideoOffer()> offer_;
  VideoExporter* exporter_;
  BackgroundJob probe_;
  QTimer* previewTimer_;
  VideoForm* form_ = nullptr;
  VideoPreview* preview_ = nullptr;
  QLabel* summary_ = nullptr;
  QLineEdit* file_ = nullptr;
  std::optional<ProposedFile> proposed_; ///< of `file_`
  QPushButton* browse_ = nullptr;
  QLabel* question_ = nullptr;
  ExportOutcome* outcome_ = nullptr;
  QProgressBar* progress_ = nullptr;
  QPushButton* cancel_ = nullptr;
  QPushButton* export_ = nullptr;
  QPushButton* close_ = nullptr;
  bool mayReplace_ = false; ///< the question was shown and nothing has changed since
  bool isProbed_ = false;
};

} // namespace dewpoint::ui
