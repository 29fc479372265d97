// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <QStringList>

class QLineEdit;

namespace dewpoint::ui {

class Document;
struct Workbench;

/// Proposes where exported files go: into the folder of the project, or of its recordings if it was
/// not saved yet. Once the user has exported to another folder, it proposes that folder, in all
/// dialogs, until the program ends.
class ExportDestination : public QObject {
  Q_OBJECT
public:
  /// Returns the destination that all dialogs of a window share.
  static ExportDestination* of(const Workbench& bench);

  QString folder() const;
  /// Returns a file in the folder that is named after the project: "NAME-kind", without a suffix.
  QString file(const QString& kind) const;
  /// Remembers the folder of a file that was exported.
  void remember(const QString& file);

private:
  ExportDestination(const Document& document, QObject* parent);
  /// Returns the folder of the project or of its recordings; the home folder if it has neither.
  QString projectFolder() const;

  const Document& document_;
  QString chosen_; ///< other folder to which the user has exported; empty: none
};

/// What the field for the file of an export contains: a proposal, until the user enters another
/// file.
class ProposedFile {
public:
  explicit ProposedFile(QLineEdit& field) : field_(field) {}

  /// Proposes a file, without its suffix. Does nothing if the user has entered another file.
  void propose(const QString& file);
  /// Proposes a file, whatever the user has entered.
  void reset(const QString& file);
  /// Gives the file this suffix. A suffix in `known` is replaced.
  void setSuffix(const QString& suffix, const QStringList& known);

private:
  QLineEdit& field_;
  QString proposed_;
  QString suffix_;
};

} // namespace dewpoint::ui
