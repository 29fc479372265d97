// SPDX-License-Identifier: GPL-3.0-or-later
// The formats, one file each; export_catalog.h lists them. Text is the same in any locale.
#pragma once

#include "core/trajectory/export/export_formats.h"

namespace dewpoint::trajectory::encoders {

using Files = Result<std::vector<ExportFile>>;

Files tidyCsv(const ExportTable& table, const std::string& name);
Files wideCsv(const ExportTable& table, const std::string& name);
/// One file per target: `timestamp tx ty tz qx qy qz qw`, without rotation, known rows only
/// (https://cvg.cit.tum.de/data/datasets/rgbd-dataset/file_formats).
Files tum(const ExportTable& table, const std::string& name);
/// Motion Analysis's track row column, as OpenSim reads it.
Files trc(const ExportTable& table, const std::string& name);
/// Points only, floating-point, little-endian (the C3D file format user guide, Motion Lab Systems).
Files c3d(const ExportTable& table, const std::string& name);
/// NumPy arrays in a ZIP file without compression (NEP 1; PKWARE's APPNOTE 6.3).
Files npz(const ExportTable& table, const std::string& name);
/// VTK's XML PolyData in ASCII: a line per stretch without gaps, with values at its points.
Files vtp(const ExportTable& table, const std::string& name);
/// A ParaView collection of one PolyData file per row, so that time can be played.
Files pvd(const ExportTable& table, const std::string& name);
/// One JSON object per row.
Files jsonLines(const ExportTable& table, const std::string& name);

/// `# ` lines: what the file is, units and axes, and the table's entries.
std::string commentHeader(const ExportTable& table);
/// Lengths with nine significant digits, times with nine, covariances with six.
std::string lengthText(double value);
std::string timeText(double value);
std::string covarianceText(double value);

} // namespace dewpoint::trajectory::encoders
