// SPDX-License-Identifier: GPL-3.0-or-later
// Empty rooms: read beside the window, and given to the run, which goes on.
#include "core/session/run/background_images.h"
#include "core/session/session.h"
#include "ui/document/document.h"
#include "ui/jobs/long_job.h"
#include "ui/mainwindow/main_window.h"
#include "ui/panels/camera_panel.h"
#include "ui/session/session_bridge.h"
#include "ui/text/error_sentence.h"
#include "ui/widgets/message_bar.h"

#include <memory>

namespace dewpoint::ui {

void MainWindow::connectRooms() {
  emptyRoomJob_ = new LongJob(this);
  connect(emptyRoomJob_, &LongJob::ended, this, [this](bool cancelled) {
    if (cancelled) {
      takeEmptyRooms(); // it was changed again meanwhile
    }
  });
  connect(document_, &Document::emptyRoomsChanged, this, &MainWindow::takeEmptyRooms);
  connect(cameras_, &CameraPanel::said, this,
          [this](const QString& sentence) { messages_->showNotice(sentence); });
  connect(cameras_, &CameraPanel::asked, this,
          [this](const QString& question, const QString& yes, const std::function<void()>& act) {
            messages_->ask(question, {{yes, act}});
          });
}

void MainWindow::takeEmptyRooms() {
  if (bridge_ == nullptr) {
    return;
  }
  const auto project = std::make_shared<const Project>(document_->project());
  const bool begun = emptyRoomJob_->start([this, project, bridge = bridge_](const auto&) {
    auto rooms = loadEmptyRooms(*project);
    return std::function<void()>([this, project, bridge, rooms = std::move(rooms)] {
      if (!rooms) {
        messages_->showError(errorSentence(rooms.error()));
      } else if (bridge == bridge_) { // not that of another project
        std::vector<std::string> files;
        for (const ProjectCamera& camera : project->cameras) {
          files.push_back(camera.emptyRoom);
        }
        bridge_->session().setEmptyRooms(files, *rooms);
      }
    });
  });
  if (!begun) {
    emptyRoomJob_->cancel();
  }
}

} // namespace dewpoint::ui
