// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/new_project/footage_facts.h"
#include "core/setup/new_project/new_project.h"
#include "ui/jobs/job_queue.h"

#include <QSet>
#include <QTableWidget>

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace dewpoint::ui {

/// Location of an image source: a file, a folder, a device or an address. Its kind is determined in
/// another thread, because the disk may be slow.
struct FootageLocation {
  std::string location;
  bool canBeImageSource = false; ///< can be used as a camera
  bool isFile = false;           ///< an existing file or folder, not a device
  bool isImageFolder = false;    ///< a folder of images
};

/// Table of a new project's cameras, one row each: name, image source, and what was found there.
/// Each source is read in another thread as soon as it is added. The result is a small image with
/// size, frame rate and length, or the reason why the source cannot be read.
class CameraTable : public QTableWidget {
  Q_OBJECT
public:
  explicit CameraTable(QWidget* parent = nullptr);

  /// Clears the table and discards reads in progress.
  void clearTable();
  void addFootage(const FootageLocation& place);
  /// Adds an empty row in which the user can type the address of a camera.
  void addAddressRow();
  void removeSelectedRows();
  bool isListed(const QString& location) const;
  bool hasSelection() const { return !selectedItems().isEmpty(); }
  /// Returns whether any source is a folder of images.
  bool hasImageFolders() const;
  std::vector<NewCamera> cameras() const;
  /// Returns a hint about recordings that differ from each other, or an empty string if there is
  /// nothing to report.
  QString recordingMismatchText() const;

Q_SIGNALS:
  /// Emitted when rows, names, sources, source information or the selection have changed.
  void changed();

protected:
  void changeEvent(QEvent* event) override;

private:
  /// Information found about a location.
  struct SourceInfo {
    std::optional<FootageFacts> facts; ///< empty for a live camera or an unreadable location
    std::optional<Error> problem;
  };
  void examine(const QString& location);
  void applyFound(const QString& location, bool isImageFolder, const SourceInfo& known);
  QString locationAt(int row) const;
  QString textAt(int row, int column) const;
  void showKnown();
  void showKnown(int row);

  std::map<QString, SourceInfo> known_; ///< what was found about each source, keyed by its location
  QSet<QString> imageFolders_;          ///< sources that are known to be folders of images
  std::unique_ptr<JobQueue> jobs_; ///< for this project; results for an earlier project are ignored
};

} // namespace dewpoint::ui
