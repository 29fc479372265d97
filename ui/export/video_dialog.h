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

/// Data of the window that can currently be exported as a video.
struct VideoSources {
  Session* session = nullptr;   ///< null if no run is open
  std::vector<VideoView> views; ///< the views, as the window shows them
  const BirdsEyeView* birdsEyeView = nullptr;
  QString recordingName; ///< name of the recording
  /// Returns all frames that can be shown, in increasing order; may be empty.
  std::function<std::vector<FrameTime>()> frames;
  std::int64_t lastTrackedFrame = -1; ///< last tracked frame of the run; -1 if there is none
  double framesPerSecond = 30.0;      ///< frame rate of the recording
};

/// Exports a run as a video, with a preview of its images. Not modal; an export continues
/// while the dialog is closed.
class VideoDialog : public QDialog {
  Q_OBJECT
public:
  /// Creates the dialog. `offer` is called whenever the dialog needs to know what can be exported.
  explicit VideoDialog(std::function<VideoSources()> offer, QWidget* parent = nullptr);

  /// Proposes to export only this time range (seconds); if empty, the whole run.
  void setSelectedRange(std::optional<std::pair<double, double>> seconds);
  /// Proposes a file, without its suffix, unless the user has entered another one.
  void proposeFile(const QString& file);
  /// Resets the choices for another project: proposes a file and the whole run.
  void resetChoices(const QString& file);
  /// Updates the dialog after the run or its views have changed.
  void refresh();
  /// Stops an export and drops the preview, because the frames of the run are about to be lost.
  /// `reason` is a sentence for the user.
  void stop(const QString& reason);
  bool isExporting() const { return exporter_->isRunning(); }

Q_SIGNALS:
  /// Emitted with a sentence about the result when an export has ended.
  void exportEnded(const QString& sentence);
  void failed(const QString& sentence);
  /// Emitted when an export has written this file.
  void fileWritten(const QString& file);

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
  Result<VideoRequest> request(const VideoSources& offer) const;
  void changed();
  void updateSuffix();
  void drawPreview();
  void showPreview(const VideoRequest& wanted, const Result<QImage>& image);
  void start();
  void setRunning(bool running);
  void askToReplace(const QString& file);
  void withdrawQuestion();
  void report(const QString& sentence, const QString& file, bool isFailure);

  std::function<VideoSources()> offer_;
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
