// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/people/people_parameters.h"

#include <vector>

namespace dewpoint::tracking {
namespace {

using Declarations = std::vector<ParameterDeclaration>;
constexpr auto kInteger = ParameterKind::Integer;
constexpr auto kReal = ParameterKind::Real;

struct Defaults {
  double background;
  double imageWidth;
};

void add(Declarations& all, const Declarations& more) {
  all.insert(all.end(), more.begin(), more.end());
}

Declarations background(const Defaults& defaults) {
  Declarations all{
      {"background", kInteger, "Background model", "", 0.0, 2.0, 1.0, defaults.background,
       "How moving regions are found. 0: one Gaussian for each pixel (fast). 1: MOG2 of OpenCV. 2: "
       "KNN of OpenCV.",
       false},
      {"learning_time", kReal, "Learning time", "s", 0.0, 600.0, 0.1, 1.0,
       "How long the cameras only learn the background at the start. Nobody should be in view "
       "during this time.",
       false},
      {"background_memory", kReal, "Background memory", "s", 0.5, 3600.0, 0.5, 40.0,
       "Time after which a new object that stays in place counts as background.", true},
      {"darkest_shadow", kReal, "Darkest shadow", "", 0.0, 1.0, 0.01, 0.5,
       "Lowest brightness of a shadow, as a share of the background's brightness at the same hue. "
       "Anything darker counts as a moving region.",
       false},
      {"image_width", kInteger, "Image width", "px", 0.0, 10000.0, 10.0, defaults.imageWidth,
       "Images are reduced to at most this width before they are analyzed; 0 keeps them as they "
       "are.",
       false},
  };
  putInGroup(ParameterGroup::Measurement,
             {"background", "learning_time", "background_memory", "darkest_shadow", "image_width"},
             all);
  return all;
}

Declarations place() {
  Declarations all{
      {"area_x", kReal, "Area x", "m", -1000.0, 1000.0, 0.1, 0.0,
       "Coordinate of the center of the tracked floor area along this axis.", false},
      {"area_y", kReal, "Area y", "m", -1000.0, 1000.0, 0.1, 0.0,
       "Coordinate of the center of the tracked floor area along this axis.", false},
      {"area_half_x", kReal, "Half width of the area, x", "m", 0.2, 1000.0, 0.1, 3.4,
       "Half the size of the tracked floor area along this axis. A person who crosses the border "
       "of the area counts as having left.",
       false},
      {"area_half_y", kReal, "Half width of the area, y", "m", 0.2, 1000.0, 0.1, 3.4,
       "Half the size of the tracked floor area along this axis. A person who crosses the border "
       "of the area counts as having left.",
       false},
      {"floor_z", kReal, "Floor z", "m", -1000.0, 1000.0, 0.01, 0.0,
       "Height of the floor in world coordinates.", false},
      {"births", kInteger, "Create tracks", "", 0.0, 1.0, 1.0, 1.0,
       "1 tracks every person that several cameras see. 0 tracks only people that you add by hand.",
       false},
      {"birth_time", kReal, "Confirmation time", "s", 0.0, 10.0, 0.05, 0.2,
       "How long a moving region that belongs to no tracked person must be visible before a new "
       "track is created.",
       false},
      {"survival_time", kReal, "Survival time", "s", 0.05, 60.0, 0.05, 0.6,
       "How long a person still counts as present when fewer than two cameras see the person.",
       true},
  };
  for (ParameterDeclaration& one : all) {
    one.group = ParameterGroup::Area;
  }
  return all;
}

/// Exactly the models of Mohedano et al. 2009; values that the paper does not give are ours.
Declarations mohedano(bool color) {
  Declarations all{
      {"particles", kInteger, "Particles", "", 10.0, 100000.0, 10.0, 500.0,
       "Number of particles of each person.", true},
      {"position_sigma", kReal, "Position noise", "m", 0.0, 1.0, 0.005, 0.03,
       "Standard deviation of the random motion that is added to each coordinate of a particle, "
       "per frame.",
       false},
      {"velocity_sigma", kReal, "Velocity noise", "m/s", 0.0, 10.0, 0.01, 0.25,
       "Standard deviation of the noise on each component of the velocity, per frame.", false},
      {"mask_sigma", kReal, "Mask smoothing", "px", 0.0, 50.0, 0.5, 4.0,
       "Sigma of the Gaussian that smooths the motion masks (the paper: 4 px).", false},
      {"motion_floor", kReal, "Min. motion likelihood", "", 0.001, 1.0, 0.01, 0.2,
       "Smallest likelihood where a camera sees no motion (p_B in the paper: 0.2).", false},
  };
  if (color) {
    add(all, {{"hue_sigma", kReal, "Hue sigma", "", 0.001, 1.0, 0.005, 0.03,
               "Standard deviation of a measured hue; hues range from 0 to 1.", true},
              {"saturation_sigma", kReal, "Saturation sigma", "", 0.001, 1.0, 0.005, 0.06,
               "Standard deviation of a measured saturation; saturations range from 0 to 1.", true},
              {"hue_floor", kReal, "Min. hue likelihood", "", 0.001, 1.0, 0.01, 0.3,
               "Lower limit of the likelihood of a pixel's hue (h_B in the paper); above 0 because "
               "another object may hide the person.",
               false},
              {"saturation_floor", kReal, "Min. saturation likelihood", "", 0.001, 1.0, 0.01, 0.3,
               "Lower limit of the likelihood of a pixel's saturation (s_B in the paper).", false},
              {"color_noise", kReal, "Color noise", "", 0.0, 0.5, 0.001, 0.005,
               "Standard deviation of the noise on hue and saturation, per frame.", false}});
    putInGroup(ParameterGroup::Measurement,
               {"hue_sigma", "saturation_sigma", "hue_floor", "saturation_floor"}, all);
    putInGroup(ParameterGroup::Motion, {"color_noise"}, all);
  }
  putInGroup(ParameterGroup::Measurement, {"mask_sigma", "motion_floor"}, all);
  add(all, background({1.0, 0.0}));
  add(all, place());
  return all;
}

Declarations ours() {
  Declarations all{
      {"particles", kInteger, "Particles", "", 10.0, 100000.0, 10.0, 120.0,
       "Number of particles of each person.", true},
      {"body_points", kInteger, "Body points", "", 10.0, 100000.0, 10.0, 400.0,
       "Number of points that represent the volume of each person.", true},
      // Method dewpoint has a parameter of this name, with another range and default: people change
      // their speed less abruptly than a ball or a hand.
      {"acceleration_sigma", kReal, "Acceleration sigma", "m/s²", 0.05, 50.0, 0.05, 3.0,
       "How strongly people accelerate, brake and turn.", true},
      {"evidence", kReal, "Weight per camera", "", 0.1, 100.0, 0.1, 8.0,
       "How strongly the mask of each camera influences where a person is tracked: larger values "
       "rely more on the masks.",
       true},
      {"color_weight", kReal, "Color weight", "", 0.0, 10.0, 0.05, 1.0,
       "How much the colors of clothes count compared with the masks when people are close to each "
       "other.",
       false},
      {"least_distance", kReal, "Minimum distance", "m", 0.0, 2.0, 0.01, 0.3,
       "Smallest distance between the centers of two people.", false},
      {"usual_height", kReal, "Usual height", "m", 0.3, 3.0, 0.01, 1.72,
       "Assumed height of a person whose height is not known yet.", false},
  };
  putInGroup(ParameterGroup::Measurement, {"color_weight"}, all);
  putInGroup(ParameterGroup::Area, {"least_distance", "usual_height"}, all);
  putInGroup(ParameterGroup::Expert, {"body_points"}, all);
  add(all, background({0.0, 160.0}));
  add(all, place());
  return all;
}

} // namespace

PeopleSettings peopleSettings(const ParameterValues& parameters) {
  PeopleSettings result;
  result.area.center = {parameters.at("area_x"), parameters.at("area_y")};
  result.area.halfSize = {parameters.at("area_half_x"), parameters.at("area_half_y")};
  result.area.floorHeight = parameters.at("floor_z");
  result.foreground.method =
      static_cast<BackgroundMethod>(static_cast<int>(parameters.at("background")));
  result.foreground.darkestShadow = parameters.at("darkest_shadow");
  result.learningSeconds = parameters.at("learning_time");
  result.backgroundMemorySeconds = parameters.at("background_memory");
  result.maxImageWidth = static_cast<int>(parameters.at("image_width"));
  result.confirmationSeconds = parameters.at("birth_time");
  result.survivalSeconds = parameters.at("survival_time");
  result.createsTracks = parameters.at("births") != 0.0;
  return result;
}

std::span<const ParameterDeclaration> mohedanoMsParameters() {
  static const Declarations declarations = mohedano(false);
  return declarations;
}

std::span<const ParameterDeclaration> mohedanoMscParameters() {
  static const Declarations declarations = mohedano(true);
  return declarations;
}

std::span<const ParameterDeclaration> peopleParameters() {
  static const Declarations declarations = ours();
  return declarations;
}

} // namespace dewpoint::tracking
