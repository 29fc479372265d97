// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/calibration/board/board.h"

#include <filesystem>
#include <string>
#include <vector>

namespace dewpoint::calibration {

/// Paper size in portrait orientation, in millimeters.
struct Paper {
  std::string name;
  double width = 0.0;
  double height = 0.0;
};

/// Returns the supported papers: A4, A3 and letter.
const std::vector<Paper>& papers();

/// Returns the paper with a name, ignoring case. BadValue names `field` and the supported papers.
Result<Paper> paperNamed(const std::string& name, const std::string& field = "--paper");

/// Writes the board at its true size to a one-page PDF. The page includes a scale bar for checking
/// the print with a ruler, and the board description that parseBoard() reads. The page has portrait
/// or landscape format, whichever fits. Errors: BadValue if the board does not fit on the paper
/// (the message contains the largest square size that fits), FileUnwritable.
Status printBoard(const BoardDescription& board, const Paper& paper,
                  const std::filesystem::path& file);

} // namespace dewpoint::calibration
