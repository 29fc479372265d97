// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/footage_facts.h"
#include "core/setup/new_project.h"
#include "ui/jobs/job_queue.h"

#include <QSet>
#include <QTableWidget>

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace dewpoint::ui {

/// What there is at a location, found out in a thread: its disk may be slow.
struct FootagePlace {
  std::string location;
  bool showsImages = false; ///< it can be a camera
  bool isFile = false;      ///< or a folder: there, and no device
  bool isImages = false;    ///< a folder of images
};

/// The cameras of a new project, a row each: name, where its images come from, and what was found
/// there. Each source is read in a thread as soon as it is in the table: a small picture, size,
/// rate and length, or the reason why it cannot be read.
class CameraTable : public QTableWidget {
  Q_OBJECT
public:
  explicit CameraTable(QWidget* parent = nullptr);

  /// Empties it, and forgets what is being read.
  void begin();
  void add(const FootagePlace& place);
  /// A row whose source the user types.
  void addAddress();
  void removeSelected();
  bool isListed(const QString& location) const;
  bool hasSelection() const { return !selectedItems().isEmpty(); }
  /// Whether a folder of images is among the sources.
  bool hasImageFolders() const;
  std::vector<NewCamera> cameras() const;
  /// What the user should know of recordings that differ; empty: nothing.
  QString differenceText() const;

Q_SIGNALS:
  /// Rows, names, sources, what is known of them, or the selection.
  void changed();

protected:
  void changeEvent(QEvent* event) override;

private:
  /// What was found at a location.
  struct Known {
    std::optional<FootageFacts> facts; ///< nothing: of a live camera, or it cannot be read
    std::optional<Error> problem;
  };
  void look(const QString& location);
  void applyFound(const QString& location, bool isImages, const Known& known);
  QString locationAt(int row) const;
  QString textAt(int row, int column) const;
  void showKnown();
  void showKnown(int row);

  std::map<QString, Known> known_; ///< by location
  QSet<QString> imageFolders_;     ///< of the sources; known to be some
  std::unique_ptr<JobQueue> jobs_; ///< of this project; one that is given up is not heard
};

} // namespace dewpoint::ui
