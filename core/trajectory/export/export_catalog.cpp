// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/export/export_catalog.h"

#include "core/trajectory/export/export_encoders.h"

#include <fmt/format.h>

#include <array>
#include <string>

namespace dewpoint::trajectory {
namespace {

constexpr TableDefaults kAsRecorded{};
constexpr TableDefaults kBiomechanics{WorldAxes::YUp, LengthUnit::Meter, true};
constexpr TableDefaults kMotionCapture{WorldAxes::ZUp, LengthUnit::Millimeter, true};

constexpr std::array kFormats{
    ExportFormat{"csv", "CSV, one row per target and time", ".csv",
                 "time, frame, target, position, standard deviations, covariance, cameras, ESS, "
                 "valid, filled",
                 kAsRecorded, true, false, encoders::encodeTidyCsv},
    ExportFormat{"csv-wide", "CSV, one row per time (spreadsheets)", ".csv",
                 "time, frame, then three columns per target; an empty cell is a gap", kAsRecorded,
                 false, false, encoders::encodeWideCsv},
    ExportFormat{"tum", "TUM (evo)", ".tum",
                 "timestamp, position, no rotation; one file per target; gaps are left out",
                 kAsRecorded, false, false, encoders::encodeTum},
    ExportFormat{"trc", "TRC (OpenSim)", ".trc",
                 "frame, time, three columns per marker; an empty cell is a gap", kBiomechanics,
                 false, false, encoders::encodeTrc, false},
    ExportFormat{"c3d", "C3D (motion capture)", ".c3d",
                 "points as floating-point numbers; the residual is the standard deviation",
                 kMotionCapture, false, true, encoders::encodeC3d, false},
    ExportFormat{"npz", "NPZ (NumPy)", ".npz",
                 "arrays t, frame, xyz, cov, filled, cameras, ess, names; NaN is a gap",
                 kAsRecorded, true, true, encoders::encodeNpz},
    ExportFormat{"vtp", "VTP (ParaView, paths)", ".vtp",
                 "a line per path with time, speed, covariance at its points", kAsRecorded, true,
                 false, encoders::encodeVtp},
    ExportFormat{"pvd", "PVD (ParaView, over time)", ".pvd",
                 "a collection of one VTP file per time, with a point per target", kAsRecorded,
                 true, false, encoders::encodePvd},
    ExportFormat{"jsonl", "JSON lines", ".jsonl",
                 "one object per time: t, frame, targets with id, xyz, cov, cams", kAsRecorded,
                 true, false, encoders::encodeJsonLines},
};

} // namespace

std::span<const ExportFormat> exportFormats() {
  return kFormats;
}

Result<const ExportFormat*> findExportFormat(std::string_view id) {
  std::string known;
  for (const ExportFormat& format : kFormats) {
    if (format.id == id) {
      return &format;
    }
    known += fmt::format("{}{}", known.empty() ? "" : ", ", format.id);
  }
  return failure(ErrorCode::NotFound, "", "format", fmt::format("{}; known are {}", id, known));
}

} // namespace dewpoint::trajectory
