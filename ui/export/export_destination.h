// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <QStringList>

class QLineEdit;

namespace dewpoint::ui {

class Document;
struct Workbench;

/// Proposes a folder for exported files: the folder of the project or, if the project was not saved
/// yet, of its recordings. Once the user has exported to another folder, this folder is proposed in
/// all dialogs until the program ends.
class ExportDestination : public QObject {
  Q_OBJECT
public:
  /// Returns the object that all export dialogs of a window share.
  static ExportDestination* forWorkbench(const Workbench& bench);

  QString folder() const;
  /// Returns the path of a file in the proposed folder, named after the project: "NAME-kind",
  /// without a suffix.
  QString proposedFile(const QString& kind) const;
  /// Makes the folder of a file that was exported the proposed folder.
  void rememberFolder(const QString& file);

private:
  ExportDestination(const Document& document, QObject* parent);
  /// Returns the folder of the project or of its recordings; the home folder if it has neither.
  QString projectFolder() const;

  const Document& document_;
  QString chosen_; ///< other folder to which the user has exported; empty: none
};

/// Content of the field for the file of an export: a proposed file, until the user enters another
/// one.
class ProposedFile {
public:
  explicit ProposedFile(QLineEdit& field) : field_(field) {}

  /// Proposes a file, without its suffix. Does nothing if the user has entered another file.
  void propose(const QString& file);
  /// Proposes a file, without its suffix, even if the user has entered another file.
  void reset(const QString& file);
  /// Sets the suffix of the file. A suffix listed in `known` is replaced.
  void setSuffix(const QString& suffix, const QStringList& known);

private:
  QLineEdit& field_;
  QString proposed_;
  QString suffix_;
};

} // namespace dewpoint::ui
