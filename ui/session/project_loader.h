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
/// Null: none.
using MissingFiles = std::shared_ptr<const std::vector<MissingFile>>;

/// Opens a project as the application wires it. Called in a thread.
using ProjectOpener = std::function<Result<SessionInputs>(const SessionRequest&)>;

/// Does what may take long, opening videos and joining threads, away from the window's thread,
/// which never waits for it.
class ProjectLoader : public QObject {
  Q_OBJECT
public:
  explicit ProjectLoader(ProjectOpener opener, QObject* parent = nullptr);
  ~ProjectLoader() override;

  /// Starts opening. While an opening is under way: the last request comes next, and what is under
  /// way is dropped.
  void open(OpenRequest request);
  /// For others that open a project in a thread of theirs.
  const ProjectOpener& opener() const { return opener_; }
  bool isOpening() const { return opening_; }
  /// Whether what will be opened in the end is the document's own project with other inputs.
  bool isReopening() const;
  /// Lets a session end in a thread of its own, however long its cameras take.
  static void destroyInBackground(std::unique_ptr<Session> session);

Q_SIGNALS:
  void openingChanged(bool opening);
  /// What was requested is open. The inputs are the receiver's to move from.
  void opened(const OpenRequest& request, std::shared_ptr<SessionInputs> inputs);
  /// `missing`: files that were looked for and are not there, perhaps the reason.
  void failed(const OpenRequest& request, const QString& sentence, const MissingFiles& missing);

private:
  void finish(const std::shared_ptr<Result<SessionInputs>>& result, const MissingFiles& missing);

  ProjectOpener opener_;
  bool opening_ = false;
  std::unique_ptr<OpenRequest> wanted_; ///< what will be open in the end
  LatestJob job_{LatestJob::Overtaken::Dropped};
};

} // namespace dewpoint::ui
