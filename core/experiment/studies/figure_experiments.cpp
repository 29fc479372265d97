// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/studies/figure_experiments.h"

#include "core/experiment/report/report_folder.h"
#include "core/experiment/studies/barrera_figures.h"
#include "core/experiment/studies/drift_figures.h"
#include "core/experiment/studies/dynamics_figures.h"
#include "core/experiment/studies/motion_figures.h"
#include "core/experiment/studies/study_experiments.h"

#include <algorithm>
#include <array>

namespace dewpoint::experiment {
namespace {

/// A figure that is begun only where its report can be written.
template <Status (*Figure)(const ExperimentOptions&)>
Status intoFolder(const ExperimentOptions& options) {
  return prepareReportFolder(options.outputFolder).and_then([&] { return Figure(options); });
}

} // namespace

std::string_view experimentGroupTitle(ExperimentGroup group) {
  switch (group) {
  case ExperimentGroup::Barrera:
    return "Barrera et al. 2005: a ball in space";
  case ExperimentGroup::Sugandi:
    return "Sugandi et al. 2009: boxes in the images of one camera";
  case ExperimentGroup::Mohedano:
    return "Mohedano et al. 2009: people";
  case ExperimentGroup::People:
    break;
  }
  return "More scenes of people";
}

std::span<const FigureExperiment> figureExperiments() {
  static const std::array kAll{
      FigureExperiment{"barrera-fig3", "Particles in both camera images",
                       "Barrera et al. 2005, figure 3: the particles projected into both cameras "
                       "while the cloud finds the ball.",
                       50, &intoFolder<&writeBarreraFigure3>},
      FigureExperiment{"barrera-fig4", "Particles from above",
                       "Barrera et al. 2005, figure 4: the particle cloud of figure 3 from above.",
                       1, &intoFolder<&writeBarreraFigure4>},
      FigureExperiment{"barrera-fig5", "Where a single camera finds the color",
                       "Barrera et al. 2005, figure 5: where a single camera finds the color, and "
                       "why the cloud moves away from the camera.",
                       1, &intoFolder<&writeBarreraFigure5>},
      FigureExperiment{"drift", "Drift of the estimate along the optical axis",
                       "Barrera et al. 2005, section III-B: with one camera, the cloud moves away "
                       "from the camera.",
                       50, &intoFolder<&writeBarreraDrift>},
      FigureExperiment{
          "starts", "From which starting positions the particles still find the target",
          "Barrera et al. 2005, section III-B: the share of runs that converge, for start volumes "
          "of different sizes, and for start points at different distances behind the ball.",
          100, &intoFolder<&writeBarreraStarts>},
      FigureExperiment{"dynamics-fig6", "Error after a jump of the object",
                       "Barrera et al. 2005, figure 6: the object jumps 2 m at iteration 30.", 100,
                       &intoFolder<&writeDynamicsFigure6>},
      FigureExperiment{"dynamics-fig7", "Error after each iteration, for different motion sigmas",
                       "Barrera et al. 2005, figure 7: the error after the jump of figure 6, for "
                       "motion sigmas from 0.001 to 0.3 m, drawn as an image.",
                       20, &intoFolder<&writeDynamicsFigure7>},
      FigureExperiment{"dynamics-fig8", "The particle cloud over time",
                       "Barrera et al. 2005, figure 8: the cloud in six iterations, with a small "
                       "and with a large motion sigma.",
                       1, &intoFolder<&writeDynamicsFigure8>},
      FigureExperiment{.name = "mohedano-fig1",
                       .title = "Motion masks and motion likelihood",
                       .description =
                           "Mohedano et al. 2009, figures 1 and 3: the regions that move in a "
                           "camera's images, and the likelihood of a person at each pixel.",
                       .runCount = 1,
                       .run = &intoFolder<&writeMohedanoMotionFigures>,
                       .group = ExperimentGroup::Mohedano},
  };
  return kAll;
}

std::vector<const FigureExperiment*> listedExperiments() {
  std::vector<const FigureExperiment*> listed;
  for (const auto& some : {figureExperiments(), boxAndPeopleExperiments()}) {
    for (const FigureExperiment& experiment : some) {
      listed.push_back(&experiment);
    }
  }
  std::ranges::stable_sort(listed, {}, &FigureExperiment::group);
  return listed;
}

} // namespace dewpoint::experiment
