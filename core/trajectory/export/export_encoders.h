// SPDX-License-Identifier: GPL-3.0-or-later
// Encoders of the export formats, one file each; export_catalog.h lists them. The text is the same
// in every locale.
#pragma once

#include "core/trajectory/export/export_formats.h"

namespace dewpoint::trajectory::encoders {

using EncodedFiles = Result<std::vector<ExportFile>>;

/// Encodes one row per target and frame, comma-separated.
EncodedFiles encodeTidyCsv(const ExportTable& table, const std::string& name);
/// Encodes one row per frame with columns for all targets, comma-separated.
EncodedFiles encodeWideCsv(const ExportTable& table, const std::string& name);
/// Encodes one file per target with lines `timestamp tx ty tz qx qy qz qw`. Only known positions
/// are written, and the rotation is always the identity
/// (https://cvg.cit.tum.de/data/datasets/rgbd-dataset/file_formats).
EncodedFiles encodeTum(const ExportTable& table, const std::string& name);
/// Encodes TRC (track row column), the format of Motion Analysis that OpenSim reads.
EncodedFiles encodeTrc(const ExportTable& table, const std::string& name);
/// Encodes C3D with points only, floating-point, little-endian (C3D file format user guide, Motion
/// Lab Systems).
EncodedFiles encodeC3d(const ExportTable& table, const std::string& name);
/// Encodes NumPy arrays in a ZIP file without compression (NEP 1; APPNOTE 6.3 of PKWARE).
EncodedFiles encodeNpz(const ExportTable& table, const std::string& name);
/// Encodes VTK XML PolyData in ASCII: one polyline for each sequence of rows without a gap, with
/// values at its points.
EncodedFiles encodeVtp(const ExportTable& table, const std::string& name);
/// Encodes a ParaView collection. It has one PolyData file per row, and ParaView can play these
/// files over time.
EncodedFiles encodePvd(const ExportTable& table, const std::string& name);
/// Encodes one JSON object per row.
EncodedFiles encodeJsonLines(const ExportTable& table, const std::string& name);

/// Returns the header as lines that begin with `# `. It contains a description of the file, the
/// units and axes, and ExportTable::headerEntries.
std::string commentHeader(const ExportTable& table);
/// Returns the text of a length, with nine significant digits.
std::string lengthText(double value);
/// Returns the text of a time, with nine significant digits.
std::string timeText(double value);
/// Returns the text of an element of a covariance, with six significant digits.
std::string covarianceText(double value);

} // namespace dewpoint::trajectory::encoders
