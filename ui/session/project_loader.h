// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "ui/jobs/latest_job.h"

#include <QObject>

#include <functional>
#include <memory>
#include <vector>

namespace dewpoint::session {
class Session;
struct SessionInputs;
struct SessionRequest;
} // namespace dewpoint::session

namespace dewpoint::setup {
struct MissingFile;
} // namespace dewpoint::setup

namespace dewpoint::ui {

struct OpenRequest;
/// Files of a project that were not found; null if there are none.
using MissingFiles = std::shared_ptr<const std::vector<MissingFile>>;

/// Function of the application that opens a project. Called from another thread.
using ProjectOpener = std::function<Result<SessionInputs>(const SessionRequest&)>;

/// Opens projects and destroys sessions in other threads, because this can take long: videos are
/// opened and threads are joined.
class ProjectLoader : public QObject {
  Q_OBJECT
public:
  explicit ProjectLoader(ProjectOpener opener, QObject* parent = nullptr);
  ~ProjectLoader() override;

  /// Starts opening a project. If another project is being opened, its result is discarded, and the
  /// newest request comes next.
  void open(OpenRequest request);
  /// Returns the function with which other classes open a project in their own threads.
  const ProjectOpener& opener() const { return opener_; }
  bool isOpening() const { return opening_; }
  /// Returns whether the newest request reopens the document's project with other inputs.
  bool isReopening() const;
  /// Destroys a session in another thread, because closing its cameras may take long.
  static void destroyInBackground(std::unique_ptr<Session> session);

Q_SIGNALS:
  void openingChanged(bool opening);
  /// Emitted when the requested project is open. The receiver may move from the inputs.
  void opened(const OpenRequest& request, std::shared_ptr<SessionInputs> inputs);
  /// Emitted when opening failed, with the reason as a sentence. `missing` lists files that were
  /// not found, which may be the cause.
  void failed(const OpenRequest& request, const QString& sentence, const MissingFiles& missing);

private:
  void finish(const std::shared_ptr<Result<SessionInputs>>& result, const MissingFiles& missing);

  ProjectOpener opener_;
  bool opening_ = false;
  std::unique_ptr<OpenRequest> newestRequest_; ///< newest request, which is opened last
  LatestJob job_{LatestJob::SupersededJob::Dropped};
};

} // namespace dewpoint::ui
